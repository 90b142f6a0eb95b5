//! The shape of the stone.

use brilliance_renderer::cuts::{RoundBrilliant, StandardProportions};
use brilliance_renderer::material::Material;
use brilliance_renderer::scene::{MeshSource, Object, Shape};
use eframe::egui::Ui;

use crate::row::{SliderRow, combo, labelled, readout, switch, wide};

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
        Shape::Mesh(source) => {
            mesh_ui(ui, source);
            return;
        }
    }
    throwing_ui(ui, object);
}

fn throwing_ui(ui: &mut Ui, object: &mut Object) {
    // Only through what is clear does light get; what asks for it in vain may still take that back.
    if object.throws_light || matches!(object.material, Material::Dielectric(_)) {
        switch(
            ui,
            "Throws light",
            "Throws light on matte surfaces: the lamps' light that goes straight through two facets \
             brightens and colours the stone's shadow. Light reflected inside of the stone, light of \
             the sky, and light through a second stone do not arrive.",
            &mut object.throws_light,
        );
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
    let default = RoundBrilliant::default();
    SliderRow::new(
        "Diameter",
        "Width of the stone at the girdle; it matters where the material absorbs light.",
        wide(&RoundBrilliant::DIAMETER_MM),
        default.diameter_mm,
    )
    .unit(" mm")
    .logarithmic()
    .decimals(3)
    .show_f32(ui, &mut cut.diameter_mm);
    SliderRow::new(
        "Table",
        "Width of the large flat facet on top, as a part of the diameter.",
        wide(&RoundBrilliant::TABLE),
        default.table,
    )
    .percent()
    .decimals(1)
    .show_f32(ui, &mut cut.table);
    SliderRow::new(
        "Crown angle",
        "Slope of the bezel facets above the girdle: steeper gives more fire.",
        wide(&RoundBrilliant::CROWN_ANGLE_DEGREES),
        default.crown_angle_degrees,
    )
    .unit("°")
    .show_f32(ui, &mut cut.crown_angle_degrees);
    SliderRow::new(
        "Pavilion angle",
        "Slope of the main facets below the girdle: it decides whether light returns or leaks.",
        wide(&RoundBrilliant::PAVILION_ANGLE_DEGREES),
        default.pavilion_angle_degrees,
    )
    .unit("°")
    .show_f32(ui, &mut cut.pavilion_angle_degrees);
    minor_facets_ui(ui, cut, &default);
}

fn minor_facets_ui(ui: &mut Ui, cut: &mut RoundBrilliant, default: &RoundBrilliant) {
    for (label, tooltip, range, default, value) in [
        (
            "Star length",
            "How far the star facets reach from the table towards the girdle.",
            RoundBrilliant::STAR_LENGTH,
            default.star_length,
            &mut cut.star_length,
        ),
        (
            "Lower halves",
            "How far the lower half facets reach from the girdle towards the culet: longer ones \
             make the mains narrower.",
            RoundBrilliant::LOWER_HALF_LENGTH,
            default.lower_half_length,
            &mut cut.lower_half_length,
        ),
        (
            "Girdle",
            "Thickness of the girdle at its thinnest places, as a part of the diameter.",
            RoundBrilliant::GIRDLE_THICKNESS,
            default.girdle_thickness,
            &mut cut.girdle_thickness,
        ),
        (
            "Culet",
            "Width of the flat at the bottom point, as a part of the diameter; zero is a point.",
            RoundBrilliant::CULET,
            default.culet,
            &mut cut.culet,
        ),
    ] {
        SliderRow::new(label, tooltip, wide(&range), default)
            .percent()
            .decimals(1)
            .show_f32(ui, value);
    }
}

/// The published sets of proportions. The diameter stays.
fn proportions_ui(ui: &mut Ui, cut: &mut RoundBrilliant) {
    let tooltip = "Sets all proportions at once to a published ideal.";
    let diameter = cut.diameter_mm;
    let sets = StandardProportions::ALL;
    let current = sets.into_iter().find(|set| set.of_diameter(diameter) == *cut);
    labelled(ui, "Proportions", tooltip, |ui, label| {
        // The author is in the list; here the name alone has room.
        let name = current.map_or("Custom", StandardProportions::name);
        let shown = name.split_once(" (").map_or(name, |(name, _)| name);
        combo(ui, "proportions", shown, |ui| {
            for set in sets {
                let item = ui.selectable_label(current == Some(set), set.name());
                if item.on_hover_text(set.source()).clicked() {
                    *cut = set.of_diameter(diameter);
                }
            }
        })
        .labelled_by(label.id)
        .on_hover_text(tooltip);
    });
}

#[cfg(test)]
mod tests {
    #[test]
    fn digits_are_grouped() {
        assert_eq!(super::grouped(7), "7");
        assert_eq!(super::grouped(1_234_567), "1\u{2009}234\u{2009}567");
    }
}
