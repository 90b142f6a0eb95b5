//! The facet diagram: a stone from above, from the side and from below.

use glam::DVec2;

use super::body::FacetedBody;
use super::dimensions;
use super::facet_class::{FacetClass, Zone};
use super::figure::Figure;
use super::labels::Labels;
use super::measures::BodyMeasures;
use super::rect::Rect;
use super::sheet::{Anchor, Ink, Sheet};
use super::title_block;
use super::view::View;
use crate::error::RendererError;
use crate::scene::Object;

/// A4, lying.
const SIZE_MM: DVec2 = DVec2::new(297.0, 210.0);
/// Largest size of a stone on paper, across and high.
const WIDTH_MM: f64 = 72.0;
const HEIGHT_MM: f64 = 58.0;
/// Where the middles of the figures are: the side view below the face-up view, as in third-angle
/// projection.
const FACE_UP_AT: DVec2 = DVec2::new(82.0, 52.0);
const PAVILION_AT: DVec2 = DVec2::new(218.0, 52.0);
const SIDE_AT: DVec2 = DVec2::new(82.0, 152.0);
const TITLE_BLOCK: Rect = Rect { min: DVec2::new(172.0, 106.0), max: DVec2::new(285.0, 200.0) };
const CAPTION_EM_MM: f64 = 3.1;

/// The line drawing of `object`: face-up, side and pavilion, with the names of the facets and their
/// angles from the girdle plane, and the proportions.
///
/// # Errors
/// As [`FacetedBody::of`].
pub fn facet_diagram(object: &Object) -> Result<Sheet, RendererError> {
    let body = FacetedBody::of(object)?;
    let classes = FacetClass::all(&body);
    let measures = BodyMeasures::of(&body, &classes);
    let across = measures.width.max(measures.length);
    let scale = (WIDTH_MM / across).min(HEIGHT_MM / measures.depth);
    if !(scale.is_finite() && scale > 0.0) {
        return Err(RendererError::Invalid(format!(
            "{}: it has no size that could be drawn; check its dimensions",
            object.name
        )));
    }

    let mut sheet = Sheet::new(format!("{}: facets and angles", object.name), SIZE_MM);
    for (view, center, zone) in
        [(View::FACE_UP, FACE_UP_AT, Zone::Crown), (View::PAVILION, PAVILION_AT, Zone::Pavilion)]
    {
        let figure = Figure::new(&body, view, scale, center);
        figure.draw(&mut sheet);
        let caption = caption(&mut sheet, &figure, 6.5);
        let mut labels = Labels::new(&figure, vec![caption]);
        let room = Rect::centered(center, DVec2::new(132.0, WIDTH_MM + 10.0));
        labels.place(classes.iter().filter(|class| class.zone == zone), room);
        labels.draw(&mut sheet);
    }
    let figure = Figure::new(&body, View::SIDE, scale, SIDE_AT);
    figure.draw(&mut sheet);
    let mut taken = dimensions::draw(&mut sheet, &figure, &classes, &measures);
    taken.push(caption(&mut sheet, &figure, 16.0));
    let mut labels = Labels::new(&figure, taken);
    let left = Rect {
        min: DVec2::new(12.0, figure.bounds.min.y),
        max: DVec2::new(SIDE_AT.x, figure.bounds.max.y),
    };
    labels.place(classes.iter().filter(|class| class.zone == Zone::Girdle), left);
    labels.draw(&mut sheet);
    title_block::draw(&mut sheet, TITLE_BLOCK, object, &classes, &measures, scale);
    Ok(sheet)
}

/// Writes the name of the view `below_mm` under it; says where.
fn caption(sheet: &mut Sheet, figure: &Figure, below_mm: f64) -> Rect {
    let at = DVec2::new(figure.bounds.center().x, figure.bounds.max.y + below_mm);
    sheet.write(figure.view.caption, at, Anchor::Middle, CAPTION_EM_MM, Ink::Fine);
    sheet.words().last().map_or(Rect { min: at, max: at }, |words| words.bounds().grown(0.5))
}
