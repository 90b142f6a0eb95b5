//! The CIE 1976 diagram: where a colour lies among all there are, and where the screen shows it.

use std::sync::LazyLock;

use brilliance_renderer::color;
use brilliance_renderer::develop::{ColorPath, brightest_srgb8};
use brilliance_renderer::spectrum::{Observer, Spectrum};
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, Color32, FontId, Mesh, Painter, Pos2, Rect, Response, Sense, Shape, Stroke, Ui,
    WidgetInfo, pos2, vec2,
};
use glam::{DVec2, DVec3};

use super::axis::Axis;
use super::plot::KEPT;
use crate::theme;

/// What of u′ and v′ is seen.
const SMALLEST: DVec2 = DVec2::new(-0.06, -0.01);
const LARGEST: DVec2 = DVec2::new(0.66, 0.63);
/// Room for the numbers at the axes, in points.
const LEFT: f32 = 30.0;
const BOTTOM: f32 = 20.0;
/// Wavelengths of the locus, and how far apart its points are, in nm.
const LOCUS_NM: [u32; 2] = [380, 700];
const LOCUS_STEP_NM: usize = 4;
/// Wavelengths that are written at the locus, in nm.
const LABELLED_NM: [u32; 13] = [440, 460, 470, 480, 490, 500, 520, 540, 560, 580, 600, 620, 650];
/// Rings of the coloured area around the white.
const RINGS: usize = 14;
/// Temperatures along the Planckian locus in K, and those that are written.
const PLANCKIAN_K: [f32; 11] =
    [1500.0, 1750.0, 2000.0, 2500.0, 3000.0, 4000.0, 5000.0, 6500.0, 8000.0, 12_000.0, 20_000.0];
const LABELLED_K: [f32; 2] = [3000.0, 5000.0];
/// Distance in the diagram from which on a move is drawn.
const VISIBLE_MOVE: f64 = 0.004;

/// Chromaticities of single wavelengths, each step of the locus.
static LOCUS: LazyLock<Vec<DVec2>> = LazyLock::new(|| {
    let lambdas_nm = (LOCUS_NM[0]..=LOCUS_NM[1]).step_by(LOCUS_STEP_NM);
    lambdas_nm.map(|lambda_nm| uv_of_wavelength(lambda_nm.into())).collect()
});

/// The chromaticities of black bodies.
static PLANCKIAN: LazyLock<Vec<(f32, DVec2)>> = LazyLock::new(|| {
    let uv = |kelvin| color::uv_prime(Observer::xyz(&Spectrum::BlackBody { kelvin }));
    PLANCKIAN_K.iter().map(|&kelvin| (kelvin, uv(kelvin))).collect()
});

/// The area of all colours: points in rings from the white to the locus, with their colours.
static RINGS_OF_COLOR: LazyLock<Vec<Vec<(DVec2, Color32)>>> = LazyLock::new(|| {
    let white = color::uv_prime(color::d65_white());
    let closing = (1..16).filter_map(|step| {
        let (violet, red) = (LOCUS.first()?, LOCUS.last()?);
        Some(red.lerp(*violet, f64::from(step) / 16.0))
    });
    let rim: Vec<_> = LOCUS.iter().copied().chain(closing).collect();
    let ring = |number: usize| {
        let at = |rim: &DVec2| white.lerp(*rim, number as f64 / RINGS as f64);
        rim.iter().map(|rim| (at(rim), color_at(at(rim)))).collect()
    };
    (0..=RINGS).map(ring).collect()
});

/// Both axes, to one scale.
struct Plane {
    u: Axis,
    v: Axis,
}

/// Draws the diagram with the colour and its way to the screen, and the colour that was kept.
pub(super) fn diagram_ui(ui: &mut Ui, current: &ColorPath, kept: Option<&ColorPath>) -> Response {
    let width = ui.available_width().min(520.0);
    let range = LARGEST - SMALLEST;
    let inner = vec2(width - LEFT - 6.0, (width - LEFT - 6.0) * (range.y / range.x) as f32);
    let (room, response) =
        ui.allocate_exact_size(vec2(width, inner.y + BOTTOM + 6.0), Sense::hover());
    response
        .widget_info(|| WidgetInfo::labeled(Role::Image, true, "Chromaticity in the u'v' diagram"));
    let area = Rect::from_min_size(room.min + vec2(LEFT, 6.0), inner);
    let plane = Plane {
        u: Axis::linear(SMALLEST.x..=LARGEST.x, [area.left(), area.right()]),
        v: Axis::linear(SMALLEST.y..=LARGEST.y, [area.bottom(), area.top()]),
    };
    let painter = ui.painter_at(room);
    painter.rect_filled(area, 0.0, theme::BACKDROP);
    plane.paint_grid(&painter, area);
    painter.add(plane.colors());
    plane.paint_locus(&painter);
    plane.paint_planckian(&painter);
    plane.paint_screen(&painter);
    if let Some(kept) = kept {
        plane.paint_path(&painter, kept, KEPT);
    }
    plane.paint_path(&painter, current, Color32::WHITE);
    response
}

impl Plane {
    fn at(&self, uv: DVec2) -> Pos2 {
        pos2(self.u.at(uv.x), self.v.at(uv.y))
    }

    fn paint_grid(&self, painter: &Painter, area: Rect) {
        let font = FontId::proportional(10.5);
        let line = Stroke::new(1.0, theme::LINE.gamma_multiply(0.7));
        for (u, text) in self.u.ticks(8) {
            painter.vline(self.u.at(u), area.y_range(), line);
            let at = pos2(self.u.at(u), area.bottom() + 4.0);
            painter.text(at, Align2::CENTER_TOP, text, font.clone(), theme::TEXT_WEAK);
        }
        for (v, text) in self.v.ticks(7) {
            painter.hline(area.x_range(), self.v.at(v), line);
            let at = pos2(area.left() - 5.0, self.v.at(v));
            painter.text(at, Align2::RIGHT_CENTER, text, font.clone(), theme::TEXT_WEAK);
        }
        let corner = area.right_bottom();
        let name = FontId::proportional(12.0);
        let at = corner + vec2(-4.0, -4.0);
        painter.text(at, Align2::RIGHT_BOTTOM, "u'", name.clone(), theme::TEXT_WEAK);
        let at = area.left_top() + vec2(5.0, 3.0);
        painter.text(at, Align2::LEFT_TOP, "v'", name, theme::TEXT_WEAK);
    }

    fn colors(&self) -> Shape {
        let mut mesh = Mesh::default();
        for ring in RINGS_OF_COLOR.iter() {
            for (uv, color) in ring {
                mesh.colored_vertex(self.at(*uv), *color);
            }
        }
        let count = RINGS_OF_COLOR[0].len() as u32;
        for ring in 0..RINGS as u32 {
            for point in 0..count {
                let [here, next] = [point, (point + 1) % count].map(|point| ring * count + point);
                mesh.add_triangle(here, next, here + count);
                mesh.add_triangle(next, here + count, next + count);
            }
        }
        Shape::mesh(mesh)
    }

    fn paint_locus(&self, painter: &Painter) {
        let stroke = Stroke::new(1.0, theme::TEXT_WEAK);
        painter.add(Shape::closed_line(LOCUS.iter().map(|uv| self.at(*uv)).collect(), stroke));
        let middle = self.at(DVec2::new(0.22, 0.42));
        for lambda_nm in LABELLED_NM {
            let at = self.at(uv_of_wavelength(lambda_nm.into()));
            let [before, after] =
                [-2.0, 2.0].map(|step| self.at(uv_of_wavelength(f64::from(lambda_nm) + step)));
            let across = (after - before).normalized().rot90();
            let outwards = if across.dot(at - middle) < 0.0 { -across } else { across };
            painter.line_segment([at, at + 4.0 * outwards], stroke);
            let font = FontId::proportional(10.0);
            let text = at + outwards * vec2(14.0, 10.0);
            painter.text(text, Align2::CENTER_CENTER, lambda_nm, font, theme::TEXT_WEAK);
        }
    }

    fn paint_planckian(&self, painter: &Painter) {
        let color = Color32::from_black_alpha(140);
        let line = PLANCKIAN.iter().map(|(_, uv)| self.at(*uv)).collect();
        painter.add(Shape::line(line, Stroke::new(1.0, color)));
        for (kelvin, uv) in PLANCKIAN.iter().filter(|(kelvin, _)| LABELLED_K.contains(kelvin)) {
            let at = self.at(*uv);
            painter.circle_filled(at, 1.6, color);
            let (text, font) = (format!("{kelvin:.0} K"), FontId::proportional(9.5));
            painter.text(at + vec2(3.0, 1.0), Align2::LEFT_TOP, text, font, color);
        }
    }

    /// The screen's gamut and white.
    fn paint_screen(&self, painter: &Painter) {
        let corners = color::REC709_PRIMARIES_XY
            .map(|xy| self.at(color::uv_prime(color::xyz_from_xy(xy, 1.0))));
        let stroke = Stroke::new(1.2, Color32::from_black_alpha(190));
        painter.add(Shape::closed_line(corners.to_vec(), stroke));
        let font = FontId::proportional(10.5);
        let label = corners[1] + vec2(8.0, 12.0);
        painter.text(label, Align2::LEFT_TOP, "sRGB", font.clone(), stroke.color);
        let white = self.at(color::uv_prime(color::d65_white()));
        for arm in [vec2(4.0, 0.0), vec2(0.0, 4.0)] {
            painter.line_segment([white - arm, white + arm], stroke);
        }
        painter.text(white + vec2(-4.0, -3.0), Align2::RIGHT_BOTTOM, "D65", font, stroke.color);
    }

    /// A ring where the light is in the scene, a thin line to where white balance puts it, and an
    /// arrow to where the screen shows it.
    fn paint_path(&self, painter: &Painter, path: &ColorPath, color: Color32) {
        let stages = [path.scene_xyz, path.exposed_xyz(), path.shown_xyz()].map(color::uv_prime);
        if !path.is_color() || !stages.iter().all(|uv| uv.is_finite()) {
            return;
        }
        let [scene, wanted, shown] = stages;
        let shade = Color32::from_black_alpha(170);
        if scene.distance(wanted) > VISIBLE_MOVE {
            let dashes =
                |stroke| Shape::dashed_line(&[self.at(scene), self.at(wanted)], stroke, 3.0, 3.0);
            painter.extend(dashes(Stroke::new(1.4, color)));
        }
        if wanted.distance(shown) > VISIBLE_MOVE {
            let (from, to) = (self.at(wanted), self.at(shown));
            painter.arrow(from, to - from, Stroke::new(3.4, shade));
            painter.arrow(from, to - from, Stroke::new(1.8, color));
        }
        painter.circle_stroke(self.at(scene), 4.5, Stroke::new(3.6, shade));
        painter.circle_stroke(self.at(scene), 4.5, Stroke::new(1.8, color));
        painter.circle(self.at(shown), 3.0, color, Stroke::new(1.0, shade));
    }
}

fn uv_of_wavelength(lambda_nm: f64) -> DVec2 {
    color::uv_prime(Observer::color_matching_at(lambda_nm))
}

/// What a chromaticity looks like, dark enough that marks stand out on it.
fn color_at(uv: DVec2) -> Color32 {
    // The inverse of u′ = 4X/(X + 15Y + 3Z), v′ = 9Y/(X + 15Y + 3Z), at Y = 1.
    let x = 9.0 * uv.x / (4.0 * uv.y);
    let z = (12.0 - 3.0 * uv.x - 20.0 * uv.y) / (4.0 * uv.y);
    let [r, g, b] = brightest_srgb8(DVec3::new(x, 1.0, z));
    Color32::from_rgb(r, g, b).gamma_multiply(0.72)
}
