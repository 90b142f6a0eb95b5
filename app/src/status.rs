//! The status line: what the session is doing and what it cost.

use brilliance_renderer::develop::Shown;
use brilliance_renderer::session::{Activity, Progress};
use eframe::egui::{Align, Color32, Frame, Layout, Margin, Panel, RichText, Sense, Ui, vec2};

use crate::shown;
use crate::theme;
use crate::tracers::{self, Tracers};

/// Shows the line at the bottom edge.
pub fn show(ui: &mut Ui, progress: &Progress, shown: Shown, tracers: &Tracers) {
    let frame = Frame::new().fill(theme::PANEL).inner_margin(Margin::symmetric(12, 4));
    Panel::bottom("status").frame(frame).show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                tracers::status_ui(ui, tracers);
                ui.add_space(12.0);
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    ui.shrink_clip_rect(ui.max_rect());
                    progress_ui(ui, progress, shown);
                });
            });
        });
    });
}

fn progress_ui(ui: &mut Ui, progress: &Progress, shown: Shown) {
    activity_ui(ui, progress);
    if shown != Shown::Color {
        value(ui, shown::name(shown), "shown", "View \u{203a} Show goes back to the picture.");
    }
    if progress.statistics.camera_rays == 0 {
        return;
    }
    let statistics = &progress.statistics;
    value(
        ui,
        &format!("{} / {}", progress.passes, progress.pass_limit),
        "passes",
        "Rays per pixel traced so far, of those asked for: the picture gets smoother with each.",
    );
    if let Some(noise) = progress.noise {
        value(
            ui,
            &percent(noise.into()),
            "noise",
            "What 98 of 100 pixels may still be off, as part of their light and the picture's.",
        );
    }
    value(
        ui,
        &format!(
            "{:.1} mean  {} max",
            statistics.mean_segments_per_camera_ray(),
            statistics.max_segments_per_camera_ray
        ),
        "rays/pixel",
        "Ray segments that one camera ray needed: refracted, reflected and shadow rays.",
    );
    if progress.tracing_seconds > 0.0 {
        let rate = statistics.segments as f64 / progress.tracing_seconds;
        value(ui, &with_prefix(rate), "rays/s", "Ray segments traced per second of tracing.");
    }
    ledger_ui(ui, progress);
    value(
        ui,
        &duration(progress.tracing_seconds),
        "",
        "Time spent on tracing the picture that is shown.",
    );
}

fn activity_ui(ui: &mut Ui, progress: &Progress) {
    let (text, color, tooltip) = match progress.activity {
        Activity::Idle => ("Idle", theme::TEXT_WEAK, "There is nothing to trace."),
        Activity::Preview => ("Preview", theme::WARNING, "A coarser picture while things change."),
        Activity::Accumulating => {
            ("Tracing", theme::ACCENT, "Passes at full resolution are being added.")
        }
        Activity::Done if progress.has_reached_noise_target() => {
            ("Finished: noise target", theme::TEXT, "The noise is no more than was asked for.")
        }
        Activity::Done => {
            ("Finished: all passes", theme::TEXT, "All passes asked for are in the picture.")
        }
        Activity::Failed => ("Failed", theme::ERROR, "The scene could not be traced."),
    };
    dot(ui, color);
    item(ui, text, tooltip);
}

fn dot(ui: &mut Ui, color: Color32) {
    let (rect, _) = ui.allocate_exact_size(vec2(8.0, 8.0), Sense::hover());
    ui.painter().circle_filled(rect.center(), 3.5, color);
}

/// The energy ledger, each account in percent of what entered.
/// What is pruned.
const PRUNED: &str = "Energy of rays that ended for being weak. By exact splitting chance ends them, \
                      and those that live carry as much more: in the mean nothing is lost.";

fn ledger_ui(ui: &mut Ui, progress: &Progress) {
    let ledger = &progress.statistics.ledger;
    if ledger.entered <= 0.0 {
        return;
    }
    let mut accounts = vec![
        (ledger.returned, "returned", "Energy that reached a light, the sky or the ground."),
        (ledger.absorbed, "absorbed", "Energy that the colour of the stone swallowed."),
        (ledger.pruned, "pruned", PRUNED),
        (ledger.cut_off, "cut off", "Energy of rays that ended at the maximum depth."),
    ];
    if ledger.lost > 0.0 {
        accounts.push((ledger.lost, "lost", "Energy that slipped through a hole in a mesh."));
    }
    for (energy, name, tooltip) in accounts {
        value(ui, &percent(energy / ledger.entered), name, tooltip);
    }
}

/// A value and, weaker, what it counts.
fn value(ui: &mut Ui, value: &str, name: &str, tooltip: &str) {
    ui.add_space(8.0);
    item(ui, value, tooltip);
    if !name.is_empty() {
        let name = RichText::new(name).small().color(theme::TEXT_WEAK);
        ui.label(name).on_hover_text(tooltip);
    }
}

fn item(ui: &mut Ui, text: &str, tooltip: &str) {
    ui.label(RichText::new(text).small()).on_hover_text(tooltip);
}

fn percent(part: f64) -> String {
    let percent = 100.0 * part;
    if percent != 0.0 && percent.abs() < 0.1 {
        format!("{percent:.3} %")
    } else {
        format!("{percent:.1} %")
    }
}

/// A rate with an SI prefix and three digits.
fn with_prefix(rate: f64) -> String {
    match rate {
        r if r >= 1e9 => format!("{:.2} G", r / 1e9),
        r if r >= 1e6 => format!("{:.1} M", r / 1e6),
        r if r >= 1e3 => format!("{:.0} k", r / 1e3),
        r => format!("{r:.0}"),
    }
}

/// Seconds as people say them.
pub(crate) fn duration(seconds: f64) -> String {
    let whole = seconds.max(0.0).round() as u64;
    match whole {
        0..60 => format!("{:.1} s", seconds.max(0.0)),
        60..3600 => format!("{} min {:02} s", whole / 60, whole % 60),
        _ => format!("{} h {:02} min", whole / 3600, whole / 60 % 60),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!(with_prefix(4_120_000.0), "4.1 M");
        assert_eq!(with_prefix(950.0), "950");
        assert_eq!(percent(0.971), "97.1 %");
        assert_eq!(percent(0.000_04), "0.004 %");
        assert_eq!(percent(0.0), "0.0 %");
        assert_eq!(duration(3.21), "3.2 s");
        assert_eq!(duration(59.97), "1 min 00 s");
        assert_eq!(duration(3671.0), "1 h 01 min");
    }
}
