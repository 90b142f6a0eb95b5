//! Dimension lines and angles of the side view.

use glam::{DVec2, DVec3};

use super::facet_class::FacetClass;
use super::figure::Figure;
use super::font;
use super::measures::BodyMeasures;
use super::rect::Rect;
use super::sheet::{Anchor, Ink, Mark, Sheet, Words};
use super::title_block::shortened;

/// Size of the letters, in mm.
const EM_MM: f64 = 2.7;
/// Least distance between the lines of two neighbouring texts, in mm.
const LINE_MM: f64 = 1.3 * EM_MM;
const PEN_MM: f64 = 0.15;
/// Distance of the first dimension line from the outline, in mm.
const NEAR_MM: f64 = 6.0;
/// Length of the level line that a slope is measured from, and radius of the arc, in mm.
const LEVEL_MM: f64 = 14.0;
const ARC_MM: f64 = 9.0;
/// Least distance of a text from the rim of the paper, in mm.
const RIM_MM: f64 = 6.0;
/// How far a short dimension line reaches beyond its ends, in mm.
const ARROW_TAIL_MM: f64 = 3.2;
/// Two heights closer than this have no dimension line between them, in mm of paper.
const SHORTEST_MM: f64 = 0.05;

/// Draws the dimensions of the side view, and says what room they take.
pub(super) fn draw(
    sheet: &mut Sheet,
    figure: &Figure,
    classes: &[FacetClass],
    measures: &BodyMeasures,
) -> Vec<Rect> {
    let first = sheet.marks.len();
    widths(sheet, figure, measures);
    heights(sheet, figure, measures);
    for from_top in [true, false] {
        slope(sheet, figure, classes, from_top);
    }
    let added = Sheet { marks: sheet.marks[first..].to_vec(), ..Sheet::default() };
    let lines = added.strokes().filter_map(|stroke| Rect::about(stroke.points.iter().copied()));
    let lines: Vec<Rect> = lines.map(|rect| rect.grown(0.3)).collect();
    added.words().map(|words| words.bounds().grown(0.5)).chain(lines).collect()
}

/// The table's width above, the stone's below.
fn widths(sheet: &mut Sheet, figure: &Figure, measures: &BodyMeasures) {
    let bounds = figure.bounds;
    let at = |x: f64, z: f64| figure.place(DVec3::new(x, 0.0, z));
    if let Some([[left, right], _]) = measures.table {
        let ends = [at(left, measures.z[1]).x, at(right, measures.z[1]).x];
        let is_reference = measures.width <= measures.length;
        let size =
            if is_reference { percent(right - left, measures) } else { millimetres(right - left) };
        across(sheet, ends, bounds.min.y, -NEAR_MM, &format!("table {size}"));
    }
    let ends = [bounds.min.x, bounds.max.x];
    let text = millimetres(measures.width);
    let level = figure.place(DVec3::ZERO).y.clamp(bounds.min.y, bounds.max.y);
    across(sheet, ends, level, bounds.max.y + NEAR_MM - level, &text);
}

/// A dimension line from left to right, `offset` below what it measures.
fn across(sheet: &mut Sheet, [left, right]: [f64; 2], from_y: f64, offset: f64, text: &str) {
    let y = from_y + offset;
    for x in [left, right] {
        let ends = [DVec2::new(x, from_y + offset.signum()), DVec2::new(x, y + offset.signum())];
        sheet.stroke(ends, PEN_MM, Ink::Fine);
    }
    dimension_line(sheet, DVec2::new(left, y), DVec2::new(right, y));
    let cap_height = font::CAP_HEIGHT * EM_MM;
    if right - left < font::width(text, EM_MM) + 1.0 {
        let beside = DVec2::new(right + ARROW_TAIL_MM + 1.0, y + 0.5 * cap_height);
        sheet.write(text, beside, Anchor::Start, EM_MM, Ink::Main);
        return;
    }
    let baseline = if offset < 0.0 { y - 1.2 } else { y + 1.2 + cap_height };
    let at = DVec2::new(0.5 * (left + right), baseline);
    sheet.write(text, at, Anchor::Middle, EM_MM, Ink::Main);
}

/// Crown, girdle and pavilion in a chain at the right, and the whole beside it.
fn heights(sheet: &mut Sheet, figure: &Figure, measures: &BodyMeasures) {
    let Some([lower, upper]) = measures.girdle else { return };
    let [bottom, top] = measures.z;
    let x = figure.bounds.max.x + NEAR_MM;
    let y = |z: f64| figure.place(DVec3::new(0.0, 0.0, z)).y;
    let parts = [("crown", upper, top), ("girdle", lower, upper), ("pavilion", bottom, lower)];
    let parts = parts.map(|(name, low, high)| (name, high - low, y(high), y(low)));
    let parts: Vec<_> = parts.into_iter().filter(|(.., a, b)| b - a > SHORTEST_MM).collect();
    let mut texts = Vec::new();
    for &(name, height, from, to) in &parts {
        dimension_line(sheet, DVec2::new(x, from), DVec2::new(x, to));
        texts.push((format!("{name} {}", percent(height, measures)), 0.5 * (from + to)));
    }
    let mut ends: Vec<f64> = parts.iter().flat_map(|(.., from, to)| [*from, *to]).collect();
    ends.dedup();
    let near = figure.bounds.center().x;
    for end in ends {
        let reach = figure.reach(1.0, [end - 0.2, end + 0.2]).unwrap_or(near);
        sheet.stroke([DVec2::new(reach + 1.0, end), DVec2::new(x + 1.0, end)], PEN_MM, Ink::Fine);
    }
    let mut widest = 0.0_f64;
    let places = spread(&texts.iter().map(|(_, y)| *y).collect::<Vec<_>>(), LINE_MM);
    for ((text, middle), place) in texts.iter().zip(&places) {
        let start = DVec2::new(x + 3.4, *place);
        sheet.stroke([DVec2::new(x, *middle), start - DVec2::new(0.6, 0.0)], PEN_MM, Ink::Fine);
        let baseline = start + DVec2::new(0.0, 0.5 * font::CAP_HEIGHT * EM_MM);
        sheet.write(text, baseline, Anchor::Start, EM_MM, Ink::Main);
        widest = widest.max(font::width(text, EM_MM));
    }
    // Its lines pass above and below the texts of the chain, or it stays with the title block.
    let half_line = 0.5 * LINE_MM;
    let is_clear = |place: &f64| *place - half_line > y(top) && *place + half_line < y(bottom);
    if parts.len() > 1 && places.iter().all(is_clear) {
        let text = percent(measures.depth, measures);
        whole(sheet, x + 6.4 + widest, [y(top), y(bottom)], x, &text);
    }
}

/// The whole height at `x`, with lines from the chain at `chain_x`.
fn whole(sheet: &mut Sheet, x: f64, [top, bottom]: [f64; 2], chain_x: f64, text: &str) {
    for y in [top, bottom] {
        let ends = [DVec2::new(chain_x + 1.0, y), DVec2::new(x + 1.0, y)];
        sheet.stroke(ends, PEN_MM, Ink::Fine);
    }
    dimension_line(sheet, DVec2::new(x, top), DVec2::new(x, bottom));
    let middle = 0.5 * (top + bottom) + 0.5 * font::CAP_HEIGHT * EM_MM;
    sheet.write(text, DVec2::new(x + 1.4, middle), Anchor::Start, EM_MM, Ink::Main);
}

/// A line with arrow heads inside, or outside where it is too short for them.
fn dimension_line(sheet: &mut Sheet, from: DVec2, to: DVec2) {
    const SHORTEST_INSIDE_MM: f64 = 5.0;
    let along = (to - from).normalize_or_zero();
    let (outward, tail) =
        if from.distance(to) > SHORTEST_INSIDE_MM { (1.0, 0.0) } else { (-1.0, ARROW_TAIL_MM) };
    sheet.stroke([from - tail * along, to + tail * along], PEN_MM, Ink::Fine);
    sheet.arrow_head(from, -outward * along, Ink::Fine);
    sheet.arrow_head(to, outward * along, Ink::Fine);
}

/// The slope of the outline at the left, from its highest or lowest point outwards, if a facet
/// that is seen edge-on makes it.
fn slope(sheet: &mut Sheet, figure: &Figure, classes: &[FacetClass], from_top: bool) -> Option<()> {
    let (body, view) = (figure.body, figure.view);
    let rise = if from_top { -1.0 } else { 1.0 };
    let points = body.vertices.iter().map(|vertex| figure.place(*vertex));
    let extreme = if from_top { figure.bounds.min.y } else { figure.bounds.max.y };
    let corner = points
        .filter(|point| (point.y - extreme).abs() < 1e-6)
        .min_by(|a, b| a.x.total_cmp(&b.x))?;
    // The flattest way from the corner to the left.
    let (facet, other) = (0..body.facets.len())
        .filter(|&facet| body.facets[facet].normal.dot(view.toward).abs() < 1e-6)
        .filter_map(|facet| {
            let ends = figure.rim(facet);
            let touches = ends.iter().flatten().any(|end| end.distance(corner) < 1e-6);
            let other = ends.into_iter().flatten().min_by(|a, b| a.x.total_cmp(&b.x))?;
            let leads_on = other.x < corner.x - 1e-6 && (other.y - corner.y) * rise < -1e-6;
            (touches && leads_on).then_some((facet, other))
        })
        .min_by(|(_, a), (_, b)| a.x.total_cmp(&b.x))?;
    let class = classes.iter().find(|class| class.facets.contains(&facet))?;
    angle(sheet, corner, other - corner, class);
    Some(())
}

/// The angle between the level through `corner` towards the left and the way to `along`, if there
/// is room to say what it is.
fn angle(sheet: &mut Sheet, corner: DVec2, along: DVec2, class: &FacetClass) {
    const PIECES: u32 = 12;
    let first = sheet.marks.len();
    let level = corner - DVec2::new(LEVEL_MM, 0.0);
    sheet.stroke([corner - DVec2::new(1.0, 0.0), level], PEN_MM, Ink::Fine);
    let turn = DVec2::NEG_X.angle_to(along);
    let point = |k: u32| {
        let turned =
            DVec2::from_angle(turn * f64::from(k) / f64::from(PIECES)).rotate(DVec2::NEG_X);
        corner + ARC_MM * turned
    };
    sheet.stroke((0..=PIECES).map(point).collect::<Vec<_>>(), PEN_MM, Ink::Fine);
    let middle = point(PIECES / 2);
    let half_height = 0.5 * font::CAP_HEIGHT * EM_MM;
    let x = corner.x - ARC_MM - 1.6;
    let value = format!(" {}", class.angle_text());
    let name = shortened(&class.name, EM_MM, x - RIM_MM - font::width(&value, EM_MM));
    let text = name + &value;
    // Inside the angle, or on the other side of its level line.
    let beyond = corner.y - along.y.signum() * (2.0 + half_height);
    let near = corner.y + along.y.signum() * (1.2 + half_height);
    let inside = if along.y > 0.0 { middle.y.max(near) } else { middle.y.min(near) };
    for y in [inside, beyond] {
        let (text, at) = (text.clone(), DVec2::new(x, y + half_height));
        let words = Words { text, at, anchor: Anchor::End, em_mm: EM_MM, ink: Ink::Main };
        if sheet.is_blank(&words.bounds().grown(0.4)) {
            sheet.marks.push(Mark::Words(words));
            return;
        }
    }
    sheet.marks.truncate(first);
}

/// A length as a part of the stone's width.
pub(super) fn percent(length: f64, measures: &BodyMeasures) -> String {
    format!("{:.1} %", 100.0 * length / measures.reference())
}

/// A length as a gauge shows it.
pub(super) fn millimetres(length: f64) -> String {
    format!("{length:.2} mm")
}

/// Heights near `wanted`, which ascend, at least `apart` from each other.
fn spread(wanted: &[f64], apart: f64) -> Vec<f64> {
    let mut places = wanted.to_vec();
    // Each round pushes neighbours apart by what they lack; the chain has three texts at most.
    for _ in 0..64 {
        for i in 1..places.len() {
            let lack = apart - (places[i] - places[i - 1]);
            if lack > 0.0 {
                places[i - 1] -= 0.5 * lack;
                places[i] += 0.5 * lack;
            }
        }
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_pushed_apart_and_no_farther() {
        let places = spread(&[10.0, 10.5, 10.6], 3.0);
        for pair in places.windows(2) {
            assert!(pair[1] - pair[0] > 2.999, "{places:?}");
        }
        assert_eq!(spread(&[0.0, 5.0, 9.0], 3.0), [0.0, 5.0, 9.0]);
    }
}
