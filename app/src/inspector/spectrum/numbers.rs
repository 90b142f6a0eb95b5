//! The numbers of a colour, and in words what the screen made of it.

use brilliance_renderer::color;
use brilliance_renderer::develop::{ColorPath, GamutFault};
use brilliance_renderer::session::Reading;
use brilliance_renderer::settings::DisplaySettings;
use brilliance_renderer::spectrum::{DominantWavelength, Observer};
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, Color32, CornerRadius, FontId, Grid, RichText, Sense, Stroke, StrokeKind, Ui,
    WidgetInfo, vec2,
};
use glam::DVec3;

use super::plot::KEPT;
use crate::theme;

/// Moves that nobody can see are not worth telling.
const INVISIBLE_DELTA_E: f64 = 0.1;

/// A reading as a colour.
pub(super) struct Seen {
    /// The way of the colour to the screen.
    pub(super) path: ColorPath,
    dominant: Option<DominantWavelength>,
    is_mapped: bool,
}

impl Seen {
    pub(super) fn new(reading: &Reading, display: &DisplaySettings) -> Self {
        let xyz = Observer::xyz_of_means(&reading.spectrum, reading.bins);
        let white = Observer::binned_xyz(&display.white_point.spectrum(), reading.bins);
        Self {
            path: ColorPath::new(xyz, reading.bins, display),
            dominant: DominantWavelength::of(xyz, white),
            is_mapped: display.gamut_mapping,
        }
    }

    /// What the screen made of the colour, and whether it could not show it as it is.
    pub(super) fn verdict(&self) -> (String, bool) {
        if !self.path.is_color() {
            return ("No light: shown as black.".to_owned(), false);
        }
        let shift = self.path.gamut_shift().filter(|shift| shift.delta_e_2000 > INVISIBLE_DELTA_E);
        let Some(shift) = shift else {
            return ("Inside the screen\u{2019}s gamut: shown as it is.".to_owned(), false);
        };
        let fault = match shift.fault {
            GamutFault::TooPure => "Outside the screen\u{2019}s gamut",
            GamutFault::TooBright => "Too bright for the screen in this colour",
            GamutFault::BeyondWhite => "As bright as the screen\u{2019}s white or brighter",
        };
        let percent = 100.0 * shift.towards_white;
        let done = match shift.fault {
            GamutFault::BeyondWhite if self.is_mapped => "shown as white".to_owned(),
            _ if self.is_mapped => format!("moved towards white by {percent:.0} %"),
            _ => "its channels are cut off, since gamut mapping is off".to_owned(),
        };
        let distances =
            format!("\u{394}u'v' {:.3}, \u{394}E2000 {:.1}", shift.uv_prime, shift.delta_e_2000);
        (format!("{fault}: {done} ({distances})."), true)
    }

    /// A name and a value per line; the value is empty where there is no light.
    fn lines(&self) -> Vec<(&'static str, String)> {
        let xyz = self.path.scene_xyz;
        let pair = |[a, b]: [f64; 2]| {
            if a.is_finite() && b.is_finite() { format!("{a:.4}, {b:.4}") } else { String::new() }
        };
        let dominant = self.dominant.map_or_else(Default::default, |dominant| {
            let kind = if dominant.is_complementary { ", compl." } else { "" };
            format!("{:.0} nm{kind}", dominant.lambda_nm)
        });
        let purity =
            self.dominant.map_or_else(Default::default, |it| format!("{:.0} %", 100.0 * it.purity));
        vec![
            ("X", significant(xyz.x)),
            ("Y", significant(xyz.y)),
            ("Z", significant(xyz.z)),
            ("x, y", pair(color::xy(xyz).to_array())),
            ("u', v'", pair(color::uv_prime(xyz).to_array())),
            ("Dominant \u{3bb}", dominant),
            ("Purity", purity),
            ("Linear RGB wanted", triple(self.path.toned)),
            ("Linear RGB shown", triple(self.path.shown)),
            ("sRGB code", hex(self.path.srgb8)),
        ]
    }

    /// The colour with its channels cut off.
    fn clipped(&self) -> [u8; 3] {
        let encode = |channel: f32| {
            let channel = if channel.is_nan() { 0.0 } else { channel.clamp(0.0, 1.0) };
            (255.0 * color::srgb_encode(channel.into())).round() as u8
        };
        if self.path.is_color() { self.path.toned.map(encode) } else { [0; 3] }
    }
}

/// The colour as a screen without gamut mapping would show it, and as it is shown.
pub(super) fn swatches_ui(ui: &mut Ui, seen: &Seen) {
    let width = 0.5 * ui.available_width();
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 0.0;
        let sides = [("without mapping", seen.clipped()), ("shown", seen.path.srgb8)];
        for (number, (name, code)) in sides.into_iter().enumerate() {
            let (rect, response) = ui.allocate_exact_size(vec2(width, 26.0), Sense::hover());
            let round = if number == 0 {
                CornerRadius { nw: 4, sw: 4, ne: 0, se: 0 }
            } else {
                CornerRadius { ne: 4, se: 4, nw: 0, sw: 0 }
            };
            let [r, g, b] = code;
            let stroke = Stroke::new(1.0, theme::LINE);
            let fill = Color32::from_rgb(r, g, b);
            ui.painter().rect(rect, round, fill, stroke, StrokeKind::Inside);
            let ink = if fill.intensity() > 0.5 { Color32::BLACK } else { Color32::WHITE };
            let font = FontId::proportional(11.5);
            ui.painter().text(rect.center(), Align2::CENTER_CENTER, name, font, ink);
            let label = format!("{name}: {}", hex(code));
            response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &label));
            response.on_hover_text(label);
        }
    });
}

/// A table of the numbers, beside those of the colour that was kept.
pub(super) fn numbers_ui(ui: &mut Ui, seen: &Seen, kept: Option<&Seen>) {
    let kept_lines = kept.map(Seen::lines);
    let grid = Grid::new("numbers of the colour").num_columns(3).spacing(vec2(16.0, 3.0));
    grid.min_row_height(16.0).show(ui, |ui| {
        if kept.is_some() {
            ui.label("");
            ui.label(RichText::new("Picked").color(theme::TEXT_WEAK));
            ui.label(RichText::new("Kept").color(KEPT));
            ui.end_row();
        }
        for (number, (name, value)) in seen.lines().into_iter().enumerate() {
            ui.label(RichText::new(name).color(theme::TEXT_WEAK));
            ui.label(or_dash(&value));
            if let Some(lines) = &kept_lines {
                ui.label(RichText::new(or_dash(&lines[number].1)).color(KEPT));
            }
            ui.end_row();
        }
    });
}

/// The colour's tristimulus values, for a note.
pub(super) fn xyz_text(xyz: DVec3) -> String {
    let [x, y, z] = xyz.to_array().map(significant);
    format!("X {x} Y {y} Z {z}")
}

fn or_dash(text: &str) -> &str {
    if text.is_empty() { "\u{2013}" } else { text }
}

fn triple(rgb: [f32; 3]) -> String {
    rgb.map(|channel| format!("{channel:.3}")).join("  ")
}

fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02X}{g:02X}{b:02X}")
}

/// Four significant digits.
fn significant(value: f64) -> String {
    let magnitude = value.abs().log10().floor();
    if value == 0.0 || !value.is_finite() {
        "0".to_owned()
    } else if (-4.0..6.0).contains(&magnitude) {
        format!("{value:.*}", (3.0 - magnitude).max(0.0) as usize)
    } else {
        format!("{value:.3e}")
    }
}
