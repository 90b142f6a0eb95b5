//! The shape of the stone.

use brilliance_renderer::cuts::RoundBrilliant;
use brilliance_renderer::scene::{MeshSource, Object, Shape};
use eframe::egui::{RichText, Ui};

use crate::row::{SliderRow, combo, labelled, readout};
use crate::{catalogue, theme};

/// Which object of the scene is edited.
pub(super) fn object_ui(ui: &mut Ui, objects: &[Object], selected: &mut usize) {
    let tooltip = "The object that the stone and the material section change.";
    labelled(ui, "Object", tooltip, |ui, label| {
        let shown = objects.get(*selected).map_or("", |object| object.name.as_str());
        combo(ui, "object", shown, |ui| {
            for (index, object) in objects.iter().enumerate() {
                ui.push_id(index, |ui| ui.selectable_value(selected, index, &object.name));
            }
        })
        .labelled_by(label.id);
    });
}

/// Shows the section.
pub(super) fn show(ui: &mut Ui, object: &mut Object) {
    match &mut object.shape {
        Shape::RoundBrilliant(cut) => round_brilliant_ui(ui, cut),
        Shape::Polyhedron(facets) => {
            readout(ui, "Facets", "Planes that cut this stone.", &facets.len().to_string());
        }
        Shape::Mesh(source) => mesh_ui(ui, source),
    }
}

fn mesh_ui(ui: &mut Ui, source: &MeshSource) {
    let name = source.path.file_name().unwrap_or(source.path.as_os_str()).to_string_lossy();
    readout(ui, "File", &source.path.display().to_string(), &name);
    let triangles = grouped(source.mesh.triangles.len());
    readout(ui, "Triangles", "Triangles of the mesh.", &triangles);
}

/// Digits in groups of three.
fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push('\u{2009}');
        }
        text.push(digit);
    }
    text
}

fn round_brilliant_ui(ui: &mut Ui, cut: &mut RoundBrilliant) {
    proportions_ui(ui, cut);
    let default = catalogue::default_brilliant();
    SliderRow::new(
        "Diameter",
        "Width of the stone at the girdle; it matters where the material absorbs light.",
        0.5..=30.0,
        default.diameter_mm,
    )
    .unit(" mm")
    .show_f32(ui, &mut cut.diameter_mm);
    SliderRow::new(
        "Table",
        "Width of the large flat facet on top, as a part of the diameter.",
        0.4..=0.8,
        default.table,
    )
    .percent()
    .decimals(1)
    .show_f32(ui, &mut cut.table);
    SliderRow::new(
        "Crown angle",
        "Slope of the bezel facets above the girdle: steeper gives more fire.",
        15.0..=50.0,
        default.crown_angle_degrees,
    )
    .unit("°")
    .show_f32(ui, &mut cut.crown_angle_degrees);
    SliderRow::new(
        "Pavilion angle",
        "Slope of the main facets below the girdle: it decides whether light returns or leaks.",
        30.0..=55.0,
        default.pavilion_angle_degrees,
    )
    .unit("°")
    .show_f32(ui, &mut cut.pavilion_angle_degrees);
    minor_facets_ui(ui, cut, &default);
}

fn minor_facets_ui(ui: &mut Ui, cut: &mut RoundBrilliant, default: &RoundBrilliant) {
    SliderRow::new(
        "Star length",
        "How far the star facets reach from the table towards the girdle.",
        0.3..=0.8,
        default.star_length,
    )
    .percent()
    .decimals(1)
    .show_f32(ui, &mut cut.star_length);
    SliderRow::new(
        "Lower halves",
        "How far the lower half facets reach from the girdle towards the culet: longer ones make \
         the mains narrower.",
        0.4..=0.95,
        default.lower_half_length,
    )
    .percent()
    .decimals(1)
    .show_f32(ui, &mut cut.lower_half_length);
    SliderRow::new(
        "Girdle",
        "Thickness of the girdle at its thinnest places, as a part of the diameter.",
        0.0..=0.1,
        default.girdle_thickness,
    )
    .percent()
    .decimals(1)
    .show_f32(ui, &mut cut.girdle_thickness);
    SliderRow::new(
        "Culet",
        "Width of the flat at the bottom point, as a part of the diameter; zero is a point.",
        0.0..=0.2,
        default.culet,
    )
    .percent()
    .decimals(1)
    .show_f32(ui, &mut cut.culet);
}

/// The named sets of proportions. The diameter stays.
fn proportions_ui(ui: &mut Ui, cut: &mut RoundBrilliant) {
    let tooltip = "Sets all proportions at once to a published ideal.";
    let sets = catalogue::brilliants();
    let at_size = |set: &RoundBrilliant| RoundBrilliant { diameter_mm: cut.diameter_mm, ..*set };
    let current = sets.iter().find(|set| at_size(&set.value) == *cut);
    let shown = current.map_or("Custom", |set| set.name.as_str());
    let chosen = labelled(ui, "Proportions", tooltip, |ui, label| {
        let mut chosen = None;
        combo(ui, "proportions", shown, |ui| {
            for set in &sets {
                let is_current = set.name == shown;
                if ui
                    .selectable_label(is_current, &set.name)
                    .on_hover_text(&set.description)
                    .clicked()
                {
                    chosen = Some(at_size(&set.value));
                }
            }
            ui.label(
                RichText::new("All angles and lengths follow.").small().color(theme::TEXT_WEAK),
            );
        })
        .labelled_by(label.id)
        .on_hover_text(tooltip);
        chosen
    });
    if let Some(chosen) = chosen {
        *cut = chosen;
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn digits_are_grouped() {
        assert_eq!(super::grouped(7), "7");
        assert_eq!(super::grouped(1_234_567), "1\u{2009}234\u{2009}567");
    }
}
