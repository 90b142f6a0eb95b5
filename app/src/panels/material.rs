//! What the stone is made of.

use brilliance_renderer::material::{Dielectric, Material};
use eframe::egui::{ComboBox, PopupCloseBehavior, RichText, ScrollArea, TextEdit, Ui};

use crate::catalogue::{self, Choice, IndexFigures};
use crate::row::{SliderRow, labelled, readout};
use crate::theme;

/// Diamond, for a material that is not in the library.
const FALLBACK: IndexFigures = IndexFigures { n_d: 2.417, dispersion_bg: 0.044, abbe_number: 48.0 };

/// Shows the section; `filter` is what is typed above the list.
pub(super) fn show(ui: &mut Ui, material: &mut Material, filter: &mut String) {
    let library = catalogue::materials();
    let shown = shown_name(material, &library);
    if let Some(chosen) = preset_ui(ui, &library, &shown, filter) {
        *material = Material::Dielectric(chosen);
    }
    match material {
        Material::Dielectric(dielectric) => index_ui(ui, dielectric, &library),
        Material::Diffuse(_) => {
            let text = RichText::new("A matte surface: nothing enters it.").color(theme::TEXT_WEAK);
            ui.label(text);
        }
    }
}

fn shown_name(material: &Material, library: &[Choice<Dielectric>]) -> String {
    match material {
        Material::Diffuse(_) => "Matte".to_owned(),
        Material::Dielectric(dielectric) => {
            match library.iter().find(|choice| choice.name == dielectric.name) {
                Some(choice) if choice.value.dispersion != dielectric.dispersion => {
                    format!("{}, changed", dielectric.name)
                }
                _ => dielectric.name.clone(),
            }
        }
    }
}

/// The list of the library with a search field; gives what is chosen.
fn preset_ui(
    ui: &mut Ui,
    library: &[Choice<Dielectric>],
    shown: &str,
    filter: &mut String,
) -> Option<Dielectric> {
    let tooltip = "Makes the stone of another material.";
    labelled(ui, "Material", tooltip, |ui, label| {
        let combo = ComboBox::from_id_salt("material")
            .width(ui.available_width())
            .height(380.0)
            .truncate()
            .selected_text(shown)
            .close_behavior(PopupCloseBehavior::CloseOnClickOutside)
            .show_ui(ui, |ui| choices_ui(ui, library, shown, filter));
        combo.response.labelled_by(label.id).on_hover_text(tooltip);
        combo.inner.flatten()
    })
}

fn choices_ui(
    ui: &mut Ui,
    library: &[Choice<Dielectric>],
    shown: &str,
    filter: &mut String,
) -> Option<Dielectric> {
    let search = TextEdit::singleline(filter).hint_text("Search").desired_width(f32::INFINITY);
    let search = ui.add(search);
    if ui.memory(|memory| memory.focused().is_none()) {
        search.request_focus();
    }
    let wanted = filter.trim().to_lowercase();
    let mut chosen = None;
    ScrollArea::vertical().max_height(300.0).show(ui, |ui| {
        let matching = library.iter().filter(|choice| choice.name.to_lowercase().contains(&wanted));
        for choice in matching {
            let label = ui.selectable_label(choice.name == shown, &choice.name);
            if label.on_hover_text(&choice.description).clicked() {
                chosen = Some(choice.value.clone());
                filter.clear();
                ui.close();
            }
        }
    });
    chosen
}

fn index_ui(ui: &mut Ui, dielectric: &mut Dielectric, library: &[Choice<Dielectric>]) {
    let default = library
        .iter()
        .find(|choice| choice.name == dielectric.name)
        .map_or(FALLBACK, |choice| catalogue::index_figures(&choice.value.dispersion));
    let figures = catalogue::index_figures(&dielectric.dispersion);
    let (mut n_d, mut dispersion_bg) = (figures.n_d, figures.dispersion_bg);
    let index_changed = SliderRow::new(
        "Refractive index",
        "How strongly light bends on entering, at the yellow D line (589 nm).",
        1.0..=3.5,
        default.n_d,
    )
    .decimals(3)
    .show(ui, &mut n_d);
    let dispersion_changed = SliderRow::new(
        "Dispersion B\u{2013}G",
        "How far the index differs between violet (G, 431 nm) and red (B, 687 nm): the fire.",
        0.0..=0.4,
        default.dispersion_bg,
    )
    .decimals(4)
    .show(ui, &mut dispersion_bg);
    if index_changed || dispersion_changed {
        dielectric.dispersion = catalogue::with_index(&dielectric.dispersion, n_d, dispersion_bg);
    }
    let abbe = if figures.abbe_number.is_finite() {
        format!("{:.1}", figures.abbe_number)
    } else {
        "\u{2013}".to_owned()
    };
    let tooltip = "The optician's measure, index minus one over dispersion: low means much fire.";
    readout(ui, "Abbe number", tooltip, &abbe);
}
