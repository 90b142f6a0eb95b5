//! The plot of a spectrum: a step per bin, filled with the colours of its wavelengths, under the
//! colour-matching functions.

use std::sync::LazyLock;

use brilliance_renderer::develop::brightest_srgb8;
use brilliance_renderer::session::Reading;
use brilliance_renderer::spectrum::{LAMBDA_MAX_NM, LAMBDA_MIN_NM, Observer};
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, Color32, FontId, Mesh, Painter, Pos2, Rect, Response, Sense, Shape, Stroke, Ui,
    WidgetInfo, pos2, vec2,
};

use super::axis::{Axis, round_up_to};
use crate::theme;

/// What a kept spectrum is drawn with, here and in the diagram.
pub(super) const KEPT: Color32 = theme::WARNING;

/// Room for the numbers at the axes, in points.
const LEFT: f32 = 40.0;
const BOTTOM: f32 = 20.0;
const TOP: f32 = 8.0;
/// Powers of ten that a logarithmic axis spans.
const DECADES: i32 = 4;
/// Where the axis ends, times a power of ten: few, so that it stands still while passes come.
const TOPS: [f64; 6] = [1.0, 1.5, 2.0, 3.0, 4.0, 6.0];
/// The top of the axis where there is no light.
const DARK_TOP: f64 = 1.0;

/// The colour of each whole nanometre, darker where the eye sees less.
static HUES: LazyLock<Vec<Color32>> = LazyLock::new(|| {
    let lambdas_nm = LAMBDA_MIN_NM as u32..=LAMBDA_MAX_NM as u32;
    lambdas_nm
        .map(|lambda_nm| {
            let lambda_nm = f64::from(lambda_nm);
            let [r, g, b] = brightest_srgb8(Observer::color_matching_at(lambda_nm));
            let ends = ((lambda_nm - 370.0) / 60.0).min((750.0 - lambda_nm) / 90.0);
            Color32::from_rgb(r, g, b).gamma_multiply(ends.clamp(0.3, 1.0) as f32)
        })
        .collect()
});

/// Where the axes of the plot are.
struct Axes {
    lambda_nm: Axis,
    radiance: Axis,
}

/// Plots what was read, and what was kept as an outline over it.
pub(super) fn plot_ui(
    ui: &mut Ui,
    current: &Reading,
    kept: Option<&Reading>,
    is_logarithmic: bool,
) -> Response {
    let width = ui.available_width();
    let size = vec2(width, (0.5 * width).clamp(150.0, 260.0));
    let (room, response) = ui.allocate_exact_size(size, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, "Spectrum of what is picked"));
    let area = Rect::from_min_max(room.min + vec2(LEFT, TOP), room.max - vec2(6.0, BOTTOM));
    let readings = [Some(current), kept].into_iter().flatten();
    let brightest = readings
        .flat_map(|reading| reading.spectrum.iter())
        .fold(0.0, |brightest: f64, &radiance| brightest.max(radiance.into()));
    let axes = Axes::new(area, brightest, is_logarithmic);
    let painter = ui.painter_at(room);
    painter.rect_filled(area, 0.0, theme::BACKDROP);
    axes.paint_grid(&painter, area);
    painter.add(axes.filled(current));
    axes.paint_matching_functions(&painter, area);
    painter.add(axes.steps(current, Stroke::new(1.0, theme::TEXT.gamma_multiply(0.7))));
    if let Some(kept) = kept {
        painter.add(axes.steps(kept, Stroke::new(1.4, KEPT)));
    }
    if let Some(pointer) = response.hover_pos().filter(|pointer| area.contains(*pointer)) {
        axes.paint_pointed(&painter, area, pointer, current, kept);
    }
    response
}

impl Axes {
    fn new(area: Rect, brightest: f64, is_logarithmic: bool) -> Self {
        let top = if brightest > 0.0 { round_up_to(&TOPS, 1.02 * brightest) } else { DARK_TOP };
        let bottom = if is_logarithmic { top * 10_f64.powi(-DECADES) } else { 0.0 };
        let radiance = Axis::linear(bottom..=top, [area.bottom(), area.top()]);
        let range_nm = LAMBDA_MIN_NM.into()..=LAMBDA_MAX_NM.into();
        Self {
            lambda_nm: Axis::linear(range_nm, [area.left(), area.right()]),
            radiance: Axis { is_logarithmic, ..radiance },
        }
    }

    fn paint_grid(&self, painter: &Painter, area: Rect) {
        let font = FontId::proportional(10.5);
        let line = Stroke::new(1.0, theme::LINE);
        for (radiance, text) in self.radiance.ticks(4) {
            let y = self.radiance.at(radiance);
            painter.hline(area.x_range(), y, line);
            let at = pos2(area.left() - 5.0, y);
            painter.text(at, Align2::RIGHT_CENTER, text, font.clone(), theme::TEXT_WEAK);
        }
        for (lambda_nm, text) in self.lambda_nm.ticks(8) {
            let x = self.lambda_nm.at(lambda_nm);
            painter.vline(x, area.bottom()..=area.bottom() + 3.0, line);
            let at = pos2(x, area.bottom() + 4.0);
            painter.text(at, Align2::CENTER_TOP, text, font.clone(), theme::TEXT_WEAK);
        }
        let corner = pos2(area.right(), area.bottom() + 4.0);
        painter.text(corner, Align2::RIGHT_TOP, "nm", font, theme::TEXT_WEAK);
    }

    /// The area under the steps.
    fn filled(&self, reading: &Reading) -> Shape {
        let mut mesh = Mesh::default();
        let base = self.radiance.ends[0];
        for (bin, &radiance) in reading.spectrum.iter().enumerate() {
            let (low, high) = reading.bins.range_nm(bin);
            let top = self.radiance.at(radiance.into());
            let inner = (low.ceil() as u32..=high.floor() as u32).map(|nm| nm as f32);
            for (number, lambda_nm) in [low].into_iter().chain(inner).chain([high]).enumerate() {
                let (x, color) = (self.lambda_nm.at(lambda_nm.into()), hue(lambda_nm));
                if number > 0 {
                    let last = mesh.vertices.len() as u32;
                    mesh.add_triangle(last - 2, last - 1, last);
                    mesh.add_triangle(last - 1, last, last + 1);
                }
                mesh.colored_vertex(pos2(x, base), color);
                mesh.colored_vertex(pos2(x, top), color);
            }
        }
        Shape::mesh(mesh)
    }

    fn steps(&self, reading: &Reading, stroke: Stroke) -> Shape {
        let ends = reading.spectrum.iter().enumerate().flat_map(|(bin, &radiance)| {
            let (low, high) = reading.bins.range_nm(bin);
            let y = self.radiance.at(radiance.into());
            [low, high].map(|lambda_nm| pos2(self.lambda_nm.at(lambda_nm.into()), y))
        });
        Shape::line(ends.collect(), stroke)
    }

    /// The functions x\u{304}, y\u{304}, z\u{304} to one scale, which is not that of the radiance.
    fn paint_matching_functions(&self, painter: &Painter, area: Rect) {
        let lambdas_nm = || (LAMBDA_MIN_NM as u32..=LAMBDA_MAX_NM as u32).map(f64::from);
        let highest = lambdas_nm()
            .map(|lambda_nm| Observer::color_matching_at(lambda_nm).max_element())
            .fold(0.0, f64::max);
        let height = Axis::linear(0.0..=1.12 * highest, [area.bottom(), area.top()]);
        let at = |function: usize, lambda_nm: f64| {
            let value = Observer::color_matching_at(lambda_nm)[function];
            pos2(self.lambda_nm.at(lambda_nm), height.at(value))
        };
        let curves = [
            ("x", 599.0, Color32::from_rgb(255, 130, 120)),
            ("y", 555.0, Color32::from_rgb(130, 225, 140)),
            ("z", 446.0, Color32::from_rgb(130, 160, 255)),
        ];
        for (function, (name, peak_nm, color)) in curves.into_iter().enumerate() {
            let points = lambdas_nm().step_by(2).map(|lambda_nm| at(function, lambda_nm));
            let points: Vec<_> = points.collect();
            // Dark beside the line, so that it is seen on light of its own colour.
            painter.line(points.clone(), Stroke::new(3.0, Color32::from_black_alpha(90)));
            painter.line(points, Stroke::new(1.2, color.gamma_multiply(0.55)));
            paint_barred(painter, at(function, peak_nm) - vec2(0.0, 3.0), name, color);
        }
    }

    /// Marks the bin under the pointer and says what it holds.
    fn paint_pointed(
        &self,
        painter: &Painter,
        area: Rect,
        pointer: Pos2,
        current: &Reading,
        kept: Option<&Reading>,
    ) {
        let lambda_nm = self.lambda_nm.value_at(pointer.x);
        let bin = bin_at(current, lambda_nm);
        let (low, high) = current.bins.range_nm(bin);
        let sides = [low, high].map(|lambda_nm| self.lambda_nm.at(lambda_nm.into()));
        let marked = Rect::from_x_y_ranges(sides[0]..=sides[1], area.y_range());
        painter.rect_filled(marked, 0.0, Color32::from_white_alpha(22));
        let kept = kept.map_or_else(String::new, |kept| {
            format!("   kept {:.4}", kept.spectrum[bin_at(kept, lambda_nm)])
        });
        let text = format!("{low:.0}\u{2013}{high:.0} nm   {:.4}{kept}", current.spectrum[bin]);
        let galley = painter.layout_no_wrap(text, FontId::proportional(12.0), theme::TEXT_STRONG);
        let corner = area.right_top() + vec2(-galley.size().x - 6.0, 4.0);
        let plate = Rect::from_min_size(corner, galley.size()).expand(3.0);
        painter.rect_filled(plate, 3.0, theme::BACKDROP.gamma_multiply(0.8));
        painter.galley(corner, galley, theme::TEXT_STRONG);
    }
}

fn bin_at(reading: &Reading, lambda_nm: f64) -> usize {
    let part = (lambda_nm - f64::from(LAMBDA_MIN_NM)) / f64::from(reading.bins.width_nm());
    (part.max(0.0) as usize).min(reading.bins.count() - 1)
}

fn hue(lambda_nm: f32) -> Color32 {
    let number = (lambda_nm - LAMBDA_MIN_NM).round().max(0.0) as usize;
    HUES[number.min(HUES.len() - 1)]
}

/// A letter with a bar over it, its foot at `foot`, on a dark plate: it lies on light of its own colour.
fn paint_barred(painter: &Painter, foot: Pos2, letter: &str, color: Color32) {
    let galley = painter.layout_no_wrap(letter.to_owned(), FontId::proportional(12.0), color);
    let letter = Align2::CENTER_BOTTOM.anchor_size(foot, galley.size());
    painter.rect_filled(letter.expand2(vec2(3.0, 0.0)), 3.0, theme::BACKDROP.gamma_multiply(0.8));
    painter.galley(letter.min, galley, color);
    painter.hline(letter.x_range(), letter.top() + 2.5, Stroke::new(1.0, color));
}
