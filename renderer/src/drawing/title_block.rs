//! The corner of a drawing that says in words what it shows.

use glam::DVec2;

use super::dimensions::{millimetres, percent};
use super::facet_class::{FacetClass, Zone, trimmed};
use super::measures::BodyMeasures;
use super::rect::Rect;
use super::sheet::{Anchor, Ink, Sheet};
use crate::cuts::{RoundBrilliant, StandardProportions};
use crate::scene::{Object, Shape};

const TITLE_EM_MM: f64 = 5.2;
const EM_MM: f64 = 2.9;
const LINE_MM: f64 = 4.5;
const PEN_MM: f64 = 0.15;

/// Writes the name, the proportions and the table of facets into `room`.
pub(super) fn draw(
    sheet: &mut Sheet,
    room: Rect,
    object: &Object,
    classes: &[FacetClass],
    measures: &BodyMeasures,
    scale: f64,
) {
    let name = shortened(&object.name, TITLE_EM_MM, room.size().x);
    let left = room.min.x;
    let title = DVec2::new(left, room.min.y + TITLE_EM_MM);
    sheet.write(name, title, Anchor::Start, TITLE_EM_MM, Ink::Main);
    let cut = shortened(&cut_name(object), EM_MM, room.size().x);
    let below = title + DVec2::new(0.0, LINE_MM + 1.0);
    sheet.write(cut, below, Anchor::Start, EM_MM, Ink::Fine);
    let top = below.y + 3.0;
    sheet.stroke([DVec2::new(left, top), DVec2::new(room.max.x, top)], PEN_MM, Ink::Fine);

    let gutter = 8.0;
    let middle = room.center().x;
    let lists = Rect { min: DVec2::new(left, top), max: room.max };
    let of_stone = Rect { max: DVec2::new(middle - 0.5 * gutter, room.max.y), ..lists };
    let of_facets = Rect { min: DVec2::new(middle + 0.5 * gutter, top), ..lists };
    rows(sheet, of_stone, &stone_rows(object, classes, measures, scale));
    rows(sheet, of_facets, &facet_rows(classes));
}

/// Writes rows of a name at the left and a value at the right; what has no room is counted.
fn rows(sheet: &mut Sheet, room: Rect, rows: &[[String; 2]]) {
    let count = (room.size().y / LINE_MM).floor() as usize;
    let written = if rows.len() <= count { rows.len() } else { count.saturating_sub(1) };
    let baseline = |row: usize| room.min.y + LINE_MM * (row as f64 + 1.0) + 0.6;
    for (row, [name, value]) in rows.iter().take(written).enumerate() {
        let y = baseline(row);
        let name = shortened(name, EM_MM, 0.68 * room.size().x);
        sheet.write(name, DVec2::new(room.min.x, y), Anchor::Start, EM_MM, Ink::Fine);
        sheet.write(value, DVec2::new(room.max.x, y), Anchor::End, EM_MM, Ink::Main);
    }
    if written < rows.len() {
        let more = format!("and {} more", rows.len() - written);
        let at = DVec2::new(room.min.x, baseline(written));
        sheet.write(more, at, Anchor::Start, EM_MM, Ink::Fine);
    }
}

fn cut_name(object: &Object) -> String {
    match &object.shape {
        Shape::RoundBrilliant(cut) => {
            let named = StandardProportions::ALL
                .into_iter()
                .find(|set| set.of_diameter(cut.diameter_mm) == *cut);
            named.map_or("Round brilliant".to_owned(), |set| {
                format!("Round brilliant, {}", set.name())
            })
        }
        Shape::Polyhedron(_) => "Polyhedron".to_owned(),
        Shape::Mesh(source) => {
            let file = source.path.file_name().unwrap_or_default().to_string_lossy();
            format!("Mesh from {file}")
        }
    }
}

fn stone_rows(
    object: &Object,
    classes: &[FacetClass],
    measures: &BodyMeasures,
    scale: f64,
) -> Vec<[String; 2]> {
    let percent = |length: f64| percent(length, measures);
    let mut rows = Vec::new();
    let mut row = |name: &str, value: String| rows.push([name.to_owned(), value]);
    if let Shape::RoundBrilliant(_) = &object.shape {
        row("Diameter", millimetres(measures.width));
    } else {
        row("Length", millimetres(measures.width.max(measures.length)));
        row("Width", millimetres(measures.reference()));
        let ratio = measures.width.max(measures.length) / measures.reference();
        row("Length : width", format!("{ratio:.2}"));
    }
    row("Depth", millimetres(measures.depth));
    row("Total depth", percent(measures.depth));
    if let Some(size) = measures.table_size() {
        row("Table", percent(size));
    }
    for (name, height) in
        [("Crown height", measures.crown_height()), ("Pavilion depth", measures.pavilion_depth())]
    {
        if let Some(height) = height.filter(|height| *height > 0.0) {
            row(name, percent(height));
        }
    }
    if let Shape::RoundBrilliant(cut) = &object.shape {
        rows.extend(brilliant_rows(cut));
    }
    rows.push(["Facets".to_owned(), count_text(classes)]);
    rows.push(["Scale".to_owned(), format!("{scale:.1} : 1")]);
    rows
}

fn brilliant_rows(cut: &RoundBrilliant) -> Vec<[String; 2]> {
    let percent = |part: f32| format!("{} %", trimmed(100.0 * f64::from(part)));
    let degrees = |angle: f32| format!("{}°", trimmed(f64::from(angle)));
    [
        ("Crown angle", degrees(cut.crown_angle_degrees)),
        ("Pavilion angle", degrees(cut.pavilion_angle_degrees)),
        ("Star length", percent(cut.star_length)),
        ("Lower halves", percent(cut.lower_half_length)),
        ("Girdle", percent(cut.girdle_thickness)),
        ("Culet", if cut.culet > 0.0 { percent(cut.culet) } else { "pointed".to_owned() }),
    ]
    .map(|(name, value)| [name.to_owned(), value])
    .into()
}

/// Facets are counted without those of the girdle, as the trade does.
fn count_text(classes: &[FacetClass]) -> String {
    let count = |is_counted: fn(&Zone) -> bool| -> usize {
        let counted = classes.iter().filter(|class| is_counted(&class.zone));
        counted.map(|class| class.facets.len()).sum()
    };
    let (polished, girdle) =
        (count(|zone| *zone != Zone::Girdle), count(|zone| *zone == Zone::Girdle));
    if girdle == 0 { polished.to_string() } else { format!("{polished} + {girdle} at the girdle") }
}

fn facet_rows(classes: &[FacetClass]) -> Vec<[String; 2]> {
    let row =
        |class: &FacetClass| [format!("{} {}", class.facets.len(), class.name), class.angle_text()];
    classes.iter().map(row).collect()
}

/// The beginning of `text` that has room, with an ellipsis where something is left out.
pub(super) fn shortened(text: &str, em_mm: f64, width_mm: f64) -> String {
    let fits = |text: &str| super::font::width(text, em_mm) <= width_mm;
    if fits(text) {
        return text.to_owned();
    }
    // Longer texts can't fit: no letter is this narrow.
    let mut letters: Vec<char> = text.chars().take((width_mm / (0.1 * em_mm)) as usize).collect();
    loop {
        let shorter = letters.iter().collect::<String>().trim_end().to_owned() + "…";
        if letters.pop().is_none() || fits(&shorter) {
            return shorter;
        }
    }
}
