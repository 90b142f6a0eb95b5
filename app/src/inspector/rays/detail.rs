//! One ray: the way of its light to the camera, and all that is known of it.

use brilliance_renderer::inspect::{RayEnd, RecordedRay};
use eframe::egui::{
    Frame, Grid, Link, Margin, Panel, RichText, ScrollArea, Sense, Ui, WidgetText, vec2,
};

use super::table::{number, title_of};
use super::traced::Traced;
use super::{Focus, legend};
use crate::ray_words;
use crate::theme;

/// A longer path is scrolled, in points.
const MOST_PATH_HEIGHT: f32 = 120.0;

/// Shows the ray that is selected, at the foot of the panel.
pub(super) fn show(ui: &mut Ui, traced: &Traced, focus: &mut Focus) {
    let Some(id) = focus.selected else { return };
    let frame = Frame::new().fill(theme::RAISED).corner_radius(4).inner_margin(Margin::same(8));
    Panel::bottom("ray").frame(frame).resizable(false).show(ui, |ui| {
        ui.set_width(ui.available_width());
        ScrollArea::vertical()
            .id_salt("path")
            .max_height(MOST_PATH_HEIGHT)
            .show(ui, |ui| path_ui(ui, traced, id, focus));
        ui.separator();
        figures_ui(ui, traced.ray(id));
    });
}

/// The surfaces from the camera to the ray's end; each is a link to the ray that met it.
fn path_ui(ui: &mut Ui, traced: &Traced, id: u32, focus: &mut Focus) {
    let mut path: Vec<_> = traced.tree.path_to_camera(id).collect();
    path.reverse();
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.label(RichText::new("eye").color(theme::TEXT_WEAK));
        for ray in path {
            let (sample, response) =
                ui.allocate_exact_size(vec2(legend::SAMPLE, 14.0), Sense::hover());
            legend::sample(ui.painter(), sample.center(), ray.kind, traced.color(ray.id));
            response.on_hover_text(ray_words::kind(ray.kind));
            let name: WidgetText = RichText::new(title_of(ray)).into();
            if ui.add(Link::new(name)).clicked() {
                focus.selected = Some(ray.id);
            }
        }
    });
}

fn figures_ui(ui: &mut Ui, ray: &RecordedRay) {
    Grid::new("figures").num_columns(2).spacing([12.0, 2.0]).show(ui, |ui| {
        let mut row = |name: &str, value: String| {
            ui.label(RichText::new(name).small().color(theme::TEXT_WEAK));
            ui.label(RichText::new(value).small());
            ui.end_row();
        };
        row(
            "Interval",
            format!(
                "{:.2}\u{2013}{:.2} nm, middle ray {:.2} nm",
                ray.lambda_low_nm, ray.lambda_high_nm, ray.central_nm
            ),
        );
        row("Spread", format!("{:.4}\u{b0}", ray.spread_degrees));
        if let Some(path_mm) = ray.path_mm {
            row("Length", format!("{path_mm:.3} mm"));
        }
        row("Significance", number(ray.significance));
        if ray.energy_gained > 0.0 {
            let factor = ray.energy / (ray.energy - ray.energy_gained).max(f32::MIN_POSITIVE);
            row("By chance", format!("lives, and carries {factor:.2} times its light"));
        }
        if let RayEnd::Interface(event) = &ray.end {
            row("Interface", ray_words::interface(event));
        } else {
            row("Ends", ray_words::end(&ray.end));
            row("Energy", ray_words::percent(ray.energy_at_end));
            row("Adds", number(ray.mean_radiance() as f32));
        }
        if ray.unrecorded_children > 0 {
            row("Not listed", format!("{} rays that came of it", ray.unrecorded_children));
        }
    });
}
