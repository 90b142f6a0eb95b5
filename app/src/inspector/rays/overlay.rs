//! The tree drawn over the picture.

use brilliance_renderer::inspect::{RayEnd, RecordedRay};
use eframe::egui::epaint::Mesh;
use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, StrokeKind, vec2};

use super::brush::{self, Stripe, faded};
use super::fan_shape::FanShape;
use super::palette;
use super::projection::{Projection, ScreenLine};
use super::table::title_of;
use super::traced::{Traced, sees_lamp};
use super::{Focus, legend};
use crate::theme;

/// Most rays that are drawn in a frame.
pub(super) const MOST_RAYS: usize = 4000;
/// The strongest of them are drawn with all they have, the others as plain lines.
const MOST_DETAILED: usize = 300;
/// A pointer this near to a ray, in points, points to it.
const NEARNESS: f32 = 7.0;
/// A ray that looks shorter than this, in points, can't be pointed at: seen end on, as the camera ray
/// is when it has just been picked, it would be pointed at all the time.
const SHORTEST: f32 = 3.0;
/// Width of a slice of a fan's colours, in nm.
const SLICE_NM: f32 = 12.0;

/// How a ray is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Emphasis {
    /// Like all the others.
    Plain,
    /// It is on the path that is looked at.
    OnPath,
    /// It is not, while there is one.
    Aside,
}

impl Emphasis {
    /// What its brightness is multiplied by.
    fn strength(self) -> f32 {
        match self {
            Self::Plain => 1.0,
            Self::OnPath => 1.7,
            Self::Aside => 0.16,
        }
    }

    /// Brightness and width of the glow about it, over those of the line.
    fn halo(self) -> [f32; 2] {
        if self == Self::OnPath { [0.4, 5.0] } else { [0.16, 3.0] }
    }
}

/// What is drawn.
pub(super) struct Drawing<'a> {
    pub(super) traced: &'a Traced,
    /// Rays that the filter lets through, the most significant first.
    pub(super) rays: &'a [u32],
    pub(super) focus: Focus,
    /// How much of the picture is covered, 0..=1.
    pub(super) veil: f32,
    pub(super) projection: Projection,
    pub(super) room: Rect,
}

/// A ray as it lies on the screen.
struct Placed {
    id: u32,
    line: ScreenLine,
}

impl Drawing<'_> {
    /// Draws veil, edges, rays and legend; the ray next to `pointer`, if one is near.
    pub(super) fn paint(&self, painter: &Painter, pointer: Option<Pos2>) -> Option<u32> {
        painter.rect_filled(self.room, 0.0, faded(theme::BACKDROP, self.veil));
        painter.add(Shape::mesh(self.outline()));
        let drawn = &self.rays[..self.rays.len().min(MOST_RAYS)];
        let placed: Vec<_> = drawn.iter().filter_map(|&id| self.place(id)).collect();
        let path: Vec<u32> = self.path();
        let mut mesh = Mesh::default();
        for (rank, placed) in placed.iter().enumerate().rev() {
            if !path.contains(&placed.id) {
                let is_detailed = path.is_empty() && rank < MOST_DETAILED;
                let emphasis = if path.is_empty() { Emphasis::Plain } else { Emphasis::Aside };
                self.add_ray(&mut mesh, placed, emphasis, is_detailed);
            }
        }
        // The path that is looked at lies on top, whether the filter shows it or not.
        for placed in path.iter().rev().filter_map(|&id| self.place(id)) {
            self.add_ray(&mut mesh, &placed, Emphasis::OnPath, true);
        }
        painter.add(Shape::mesh(mesh));
        self.paint_ends(painter, &placed, &path);
        let beyond = self.rays.len() - drawn.len();
        let note = if beyond == 0 {
            String::new()
        } else {
            format!("the {MOST_RAYS} strongest of {} rays are drawn", self.rays.len())
        };
        legend::paint(painter, self.room, &note);
        pointer.and_then(|pointer| nearest(&placed, pointer))
    }

    /// The ids from the ray that is looked at up to the camera ray.
    fn path(&self) -> Vec<u32> {
        let looked_at = self.focus.looked_at();
        looked_at.map_or_else(Vec::new, |id| {
            self.traced.tree.path_to_camera(id).map(|ray| ray.id).collect()
        })
    }

    fn outline(&self) -> Mesh {
        let mut mesh = Mesh::default();
        for front in [false, true] {
            let color = faded(theme::TEXT_STRONG, if front { 0.34 } else { 0.11 });
            for edge in &self.traced.outline {
                if edge.faces(self.projection.eye()) == front
                    && let Some(line) = self.projection.line(edge.ends)
                {
                    let stripe = Stripe { ends: line.ends, colors: [color; 2], width: 0.4 };
                    brush::stripe(&mut mesh, &stripe, None);
                }
            }
        }
        mesh
    }

    fn place(&self, id: u32) -> Option<Placed> {
        let ray = self.traced.ray(id);
        let end = ray.origin_mm + ray.direction * self.traced.length_mm(ray);
        let end = ray.end_mm.unwrap_or(end);
        self.projection.line([ray.origin_mm, end]).map(|line| Placed { id, line })
    }

    fn add_ray(&self, mesh: &mut Mesh, placed: &Placed, emphasis: Emphasis, is_detailed: bool) {
        let ray = self.traced.ray(placed.id);
        let strength = strength(ray.significance) * emphasis.strength();
        let strength = strength * palette::share([ray.lambda_low_nm, ray.lambda_high_nm]);
        self.add_fan(mesh, ray, 0.55 * strength);
        let color = faded(self.traced.color(placed.id), strength);
        // Light that goes to no lamp is lost in the distance.
        let fades = ray.end_mm.is_none() && !sees_lamp(ray);
        let colors = placed
            .line
            .parts
            .map(|part| if fades { faded(color, 1.0 - 0.95 * part) } else { color });
        let width = 0.5 + 1.3 * ray.significance.clamp(0.0, 1.0).sqrt();
        let [glow, widening] = emphasis.halo();
        let core = Stripe { ends: placed.line.ends, colors, width };
        if is_detailed {
            let colors = colors.map(|color| faded(color, glow));
            let halo = Stripe { colors, width: widening * width + 1.0, ..core };
            brush::stripe(mesh, &halo, None);
        }
        brush::stripe(mesh, &core, legend::dashes(ray.kind).filter(|_| is_detailed));
    }

    /// The directions of all wavelengths of the ray, where they can be told apart.
    fn add_fan(&self, mesh: &mut Mesh, ray: &RecordedRay, strength: f32) {
        let fan = FanShape::new(ray, self.traced.length_mm(ray));
        let on_screen = |position: f32| {
            let [start, end] = fan.ray_at(position);
            Some([self.projection.point(start)?, self.projection.point(end)?])
        };
        let (Some(low), Some(high)) = (on_screen(-1.0), on_screen(1.0)) else { return };
        if low[0].distance(high[0]).max(low[1].distance(high[1])) < 1.0 {
            return;
        }
        let width_nm = ray.lambda_high_nm - ray.lambda_low_nm;
        let slices = (width_nm / SLICE_NM).ceil().clamp(1.0, 32.0) as u32;
        let ribs: Vec<_> = (0..=slices)
            .filter_map(|i| {
                let position = 2.0 * i as f32 / slices as f32 - 1.0;
                let color = palette::color_at(fan.lambda_nm_at(position));
                Some((on_screen(position)?, faded(color, strength)))
            })
            .collect();
        brush::fan(mesh, &ribs);
    }

    /// Marks lamps, and tells what ends the ray that is looked at.
    fn paint_ends(&self, painter: &Painter, placed: &[Placed], path: &[u32]) {
        for placed in placed {
            let ray = self.traced.ray(placed.id);
            if placed.line.parts[1] < 1.0 || !sees_lamp(ray) {
                continue;
            }
            let is_plain = path.is_empty() || path.contains(&placed.id);
            let emphasis = if is_plain { Emphasis::Plain } else { Emphasis::Aside };
            let strength = strength(ray.significance) * emphasis.strength();
            let strength = strength * palette::share([ray.lambda_low_nm, ray.lambda_high_nm]);
            let color = brush::light(faded(self.traced.color(placed.id), strength));
            painter.circle_filled(placed.line.ends[1], 2.6, color);
        }
        let Some(id) = path.first() else { return };
        if let Some(placed) = self.place(*id) {
            self.paint_label(painter, &placed);
        }
    }

    fn paint_label(&self, painter: &Painter, placed: &Placed) {
        let ray = self.traced.ray(placed.id);
        let mut words = title_of(ray);
        if let RayEnd::Interface(event) = &ray.end {
            words = format!("{words}  {:.1}\u{b0}", event.incidence_degrees);
        }
        let galley = painter.layout_no_wrap(words, FontId::proportional(12.0), theme::TEXT_STRONG);
        let size = galley.size() + vec2(12.0, 6.0);
        let beside = placed.line.ends[1] + vec2(10.0, -0.5 * size.y);
        let most = (self.room.max - size - vec2(4.0, 4.0)).max(self.room.min);
        let corner = beside.clamp(self.room.min + vec2(4.0, 4.0), most);
        let rect = Rect::from_min_size(corner, size);
        painter.rect(
            rect,
            4.0,
            faded(theme::RAISED, 0.92),
            Stroke::new(1.0, faded(self.traced.color(placed.id), 0.6)),
            StrokeKind::Inside,
        );
        let text_at = Align2::CENTER_CENTER.align_size_within_rect(galley.size(), rect).min;
        painter.galley(text_at, galley, Color32::WHITE);
    }
}

/// How bright a ray is drawn: by the decades of its significance.
fn strength(significance: f32) -> f32 {
    (1.0 + 0.27 * significance.max(1e-9).log10()).clamp(0.09, 1.0)
}

/// The ray that lies next to `pointer`; among those equally near the strongest, which comes first.
fn nearest(placed: &[Placed], pointer: Pos2) -> Option<u32> {
    let mut nearest = None;
    let mut least = NEARNESS;
    for placed in placed {
        let [a, b] = placed.line.ends;
        let distance = distance([a, b], pointer);
        if a.distance(b) >= SHORTEST && distance < least - 0.5 {
            (nearest, least) = (Some(placed.id), distance);
        }
    }
    nearest
}

fn distance([a, b]: [Pos2; 2], point: Pos2) -> f32 {
    let along = b - a;
    let part = (point - a).dot(along) / along.length_sq().max(f32::MIN_POSITIVE);
    point.distance(a + along * part.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::pos2;

    fn placed(id: u32, y: f32) -> Placed {
        let ends = [pos2(0.0, y), pos2(100.0, y)];
        Placed { id, line: ScreenLine { ends, parts: [0.0, 1.0] } }
    }

    #[test]
    fn the_nearest_ray_is_pointed_at_and_of_equals_the_strongest() {
        let rays = [placed(7, 10.0), placed(3, 10.2), placed(5, 20.0)];
        assert_eq!(nearest(&rays, pos2(50.0, 11.0)), Some(7));
        assert_eq!(nearest(&rays, pos2(50.0, 18.0)), Some(5));
        assert_eq!(nearest(&rays, pos2(120.0, 18.0)), None);
        let mut end_on = placed(1, 10.0);
        end_on.line.ends[1] = end_on.line.ends[0];
        assert_eq!(nearest(&[end_on], pos2(0.0, 10.0)), None);
    }
}
