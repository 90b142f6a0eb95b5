//! What the stone is made of.

use brilliance_renderer::material::{
    Dielectric, Dispersion, ImageOrigin, Layout, LibraryMaterial, Material, Planar, Print, find,
    library,
};
use eframe::egui::{ComboBox, Key, PopupCloseBehavior, RichText, ScrollArea, TextEdit, Ui};

use super::curve::{self, Form, curve_ui};
use crate::row::{SliderRow, labelled, readout};
use crate::theme;

/// Shows the section; `filter` is what is typed above the list.
pub(super) fn show(ui: &mut Ui, material: &mut Material, filter: &mut String) {
    if let Some(chosen) = library_ui(ui, &shown_name(material), filter) {
        *material = Material::Dielectric(chosen.dielectric());
    }
    match material {
        Material::Dielectric(dielectric) => index_ui(ui, dielectric),
        Material::Diffuse(diffuse) => {
            let text = RichText::new("A matte surface: nothing enters it.").color(theme::TEXT_WEAK);
            ui.label(text);
            if let Some(print) = &diffuse.print {
                print_ui(ui, print);
            }
        }
    }
}

/// What is printed on a matte surface, and how large.
fn print_ui(ui: &mut Ui, print: &Print) {
    let [columns, rows] = print.image.size;
    let place = match &print.image.origin {
        ImageOrigin::File(path) => path.display().to_string(),
        ImageOrigin::Library(_) => "An image that ships with the program.".to_owned(),
        ImageOrigin::Mesh(_) => "The texture that the mesh brings from its own file.".to_owned(),
    };
    readout(ui, "Print", &place, &print.image.name());
    let size = match print.layout {
        Layout::Planar(Planar { size_mm: [width, height], .. }) => {
            format!("{width} \u{d7} {height} mm")
        }
        Layout::Coordinates => "As the mesh says".to_owned(),
    };
    let tooltip = format!("On the object, before it is scaled. {columns} \u{d7} {rows} texels.");
    readout(ui, "Print size", &tooltip, &size);
}

fn shown_name(material: &Material) -> String {
    match material {
        Material::Diffuse(_) => "Matte".to_owned(),
        Material::Dielectric(stone) => match find(&stone.name) {
            Some(known) if !curve::is_standard(stone, known) => {
                format!("{}, changed", stone.name)
            }
            _ => stone.name.clone(),
        },
    }
}

/// The list of the library with a search field; gives what is chosen.
fn library_ui(ui: &mut Ui, shown: &str, filter: &mut String) -> Option<&'static LibraryMaterial> {
    let tooltip = "Makes the stone of another material.";
    labelled(ui, "Material", tooltip, |ui, label| {
        let combo = ComboBox::from_id_salt("material")
            .width(ui.available_width())
            .height(380.0)
            .truncate()
            .selected_text(shown)
            .close_behavior(PopupCloseBehavior::CloseOnClickOutside)
            .show_ui(ui, |ui| choices_ui(ui, shown, filter));
        combo.response.labelled_by(label.id).on_hover_text(tooltip);
        combo.inner.flatten()
    })
}

fn choices_ui(ui: &mut Ui, shown: &str, filter: &mut String) -> Option<&'static LibraryMaterial> {
    let search = TextEdit::singleline(filter).hint_text("Search").desired_width(f32::INFINITY);
    let search = ui.add(search);
    if ui.memory(|memory| memory.focused().is_none()) && !search.lost_focus() {
        search.request_focus();
    }
    let wanted = filter.trim().to_lowercase();
    let matches =
        |known: &LibraryMaterial| known.names().any(|name| name.to_lowercase().contains(&wanted));
    let entered = search.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
    let mut chosen = library().iter().find(|known| entered && matches(known));
    ScrollArea::vertical().max_height(320.0).show(ui, |ui| {
        for known in library().iter().filter(|known| matches(known)) {
            let label = ui.selectable_label(known.name == shown, &known.name);
            if label.on_hover_text(figures(known)).clicked() {
                chosen = Some(known);
            }
        }
    });
    if chosen.is_some() {
        filter.clear();
        ui.close();
    }
    chosen
}

/// What is known of a material, and by whom.
fn figures(known: &LibraryMaterial) -> String {
    let [low, high] = known.figures.index;
    let index =
        if low == high { format!("{low:.3}") } else { format!("{low:.3}\u{2013}{high:.3}") };
    let mut text = format!(
        "Index {index}, dispersion B\u{2013}G {:.3} ({})",
        known.figures.dispersion_bg, known.figures.source
    );
    if let Some(note) = &known.note {
        text.push('\n');
        text.push_str(note);
    }
    if let Some(measurement) = &known.measurement {
        text.push_str("\nCurve: ");
        text.push_str(&measurement.source);
    }
    text
}

fn index_ui(ui: &mut Ui, dielectric: &mut Dielectric) {
    let form = Form::of(dielectric);
    let default = find(&dielectric.name).and_then(|known| form.standard(known));
    let default = default.unwrap_or_else(|| dielectric.dispersion.clone());
    let (mut n_d, mut dispersion_bg) =
        (dielectric.dispersion.n_d(), dielectric.dispersion.dispersion_bg());
    let index_changed = SliderRow::new(
        "Refractive index",
        "How strongly light bends on entering, at the yellow D line (589 nm).",
        1.0..=3.5,
        default.n_d(),
    )
    .decimals(3)
    .show(ui, &mut n_d);
    let dispersion_changed = SliderRow::new(
        "Dispersion B\u{2013}G",
        "How far the index differs between violet (G, 431 nm) and red (B, 687 nm): the fire.",
        0.0..=0.4,
        default.dispersion_bg(),
    )
    .decimals(4)
    .show(ui, &mut dispersion_bg);
    if index_changed || dispersion_changed {
        dielectric.dispersion = form.through(dielectric, n_d, dispersion_bg);
    }
    curve_ui(ui, dielectric);
    abbe_ui(ui, &dielectric.dispersion);
}

fn abbe_ui(ui: &mut Ui, dispersion: &Dispersion) {
    let abbe = dispersion.abbe_number();
    let text = if abbe.is_finite() { format!("{abbe:.1}") } else { "\u{2013}".to_owned() };
    let tooltip = "The optician's measure, index minus one over dispersion: low means much fire.";
    readout(ui, "Abbe number", tooltip, &text);
}
