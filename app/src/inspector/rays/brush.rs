//! Lines and fans of light, as triangles with soft edges. Light adds: where rays of all colours lie on
//! each other it is white.

use eframe::egui::epaint::{Mesh, Vertex, WHITE_UV};
use eframe::egui::{Color32, Pos2, Vec2};

/// How a line is broken: how long it is drawn and how long not, in points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Dashes {
    drawn: f32,
    gap: f32,
}

impl Dashes {
    /// For rays that were reflected in part.
    pub(super) const SHORT: Self = Self { drawn: 2.5, gap: 4.0 };
    /// For rays that were totally reflected.
    pub(super) const LONG: Self = Self { drawn: 10.0, gap: 4.0 };
}

/// A line to be drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stripe {
    pub(super) ends: [Pos2; 2],
    /// The colours at its ends.
    pub(super) colors: [Color32; 2],
    /// In points, its soft edges not counted.
    pub(super) width: f32,
}

/// Width of an edge that fades out, in points.
const FEATHER: f32 = 0.7;

/// Adds a line; with `dashes` a broken one.
pub(super) fn stripe(mesh: &mut Mesh, stripe: &Stripe, dashes: Option<Dashes>) {
    let along = stripe.ends[1] - stripe.ends[0];
    let length = along.length();
    if length < 0.05 {
        return;
    }
    let Some(dashes) = dashes else {
        solid(mesh, stripe, along / length, [0.0, 1.0]);
        return;
    };
    let mut start = 0.0;
    while start < length {
        let end = (start + dashes.drawn).min(length);
        solid(mesh, stripe, along / length, [start / length, end / length]);
        start += dashes.drawn + dashes.gap;
    }
}

/// The part of a line between two places on it, 0 at its beginning and 1 at its end.
fn solid(mesh: &mut Mesh, stripe: &Stripe, direction: Vec2, parts: [f32; 2]) {
    let half = 0.5 * stripe.width;
    let across = direction.rot90();
    let first = mesh.vertices.len() as u32;
    for part in parts {
        let at = stripe.ends[0].lerp(stripe.ends[1], part);
        let color = light(stripe.colors[0].lerp_to_gamma(stripe.colors[1], part));
        for (offset, color) in [
            (-half - FEATHER, Color32::TRANSPARENT),
            (-half, color),
            (half, color),
            (half + FEATHER, Color32::TRANSPARENT),
        ] {
            mesh.vertices.push(Vertex { pos: at + across * offset, uv: WHITE_UV, color });
        }
    }
    for i in first..first + 3 {
        mesh.add_triangle(i, i + 1, i + 4);
        mesh.add_triangle(i + 1, i + 5, i + 4);
    }
}

/// A line of a fan: its two ends and its colour.
pub(super) type Rib = ([Pos2; 2], Color32);

/// Adds a fan between lines that follow each other.
pub(super) fn fan(mesh: &mut Mesh, ribs: &[Rib]) {
    let first = mesh.vertices.len() as u32;
    for (ends, color) in ribs {
        for pos in *ends {
            mesh.vertices.push(Vertex { pos, uv: WHITE_UV, color: light(*color) });
        }
    }
    for rib in 1..ribs.len() as u32 {
        let i = first + 2 * rib;
        mesh.add_triangle(i - 2, i - 1, i);
        mesh.add_triangle(i - 1, i + 1, i);
    }
}

/// The colour as light that is added to what it is drawn over, and covers none of it.
pub(super) fn light(color: Color32) -> Color32 {
    // Colours are premultiplied: without opacity nothing is taken away behind them.
    let [r, g, b, _] = color.to_array();
    Color32::from_rgba_premultiplied(r, g, b, 0)
}

/// The colour at a part of its strength, 0..=1.
pub(super) fn faded(color: Color32, strength: f32) -> Color32 {
    color.gamma_multiply(strength.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use brilliance_renderer::spectrum::{LAMBDA_MAX_NM, LAMBDA_MIN_NM};
    use eframe::egui::pos2;

    use crate::inspector::rays::palette;

    /// What is seen in the middle of lines of `intervals_nm` on each other, over `behind`: each pixel
    /// is that of the line and what its opacity leaves of the one below (Porter and Duff 1984).
    fn blended(intervals_nm: &[[f32; 2]], behind: [f32; 3]) -> [f32; 3] {
        let mut seen = behind;
        for &interval_nm in intervals_nm {
            let mut mesh = Mesh::default();
            let color = faded(palette::color(interval_nm), palette::share(interval_nm));
            let ends = [pos2(0.0, 0.0), pos2(100.0, 0.0)];
            stripe(&mut mesh, &Stripe { ends, colors: [color; 2], width: 2.0 }, None);
            let [r, g, b, a] =
                mesh.vertices[1].color.to_array().map(|value| f32::from(value) / 255.0);
            for (seen, added) in seen.iter_mut().zip([r, g, b]) {
                *seen = (added + (1.0 - a) * *seen).min(1.0);
            }
        }
        seen
    }

    fn intervals_nm(count: u32) -> Vec<[f32; 2]> {
        let edge =
            |i: u32| LAMBDA_MIN_NM + (LAMBDA_MAX_NM - LAMBDA_MIN_NM) * i as f32 / count as f32;
        (0..count).map(|i| [edge(i), edge(i + 1)]).collect()
    }

    #[test]
    fn rays_of_all_colours_on_one_path_are_white_in_any_order() {
        let mut all = intervals_nm(16);
        for _ in 0..2 {
            let seen = blended(&all, [0.05; 3]);
            assert!(seen.iter().all(|&channel| channel > 0.98), "{seen:?}");
            all.reverse();
        }
        let violet = blended(&all[14..], [0.05; 3]);
        assert!(violet[2] > violet[1] + 0.2, "{violet:?}");
    }

    #[test]
    fn a_narrow_ray_alone_is_well_visible_and_hides_nothing() {
        for interval_nm in intervals_nm(16 * 8) {
            let seen = blended(&[interval_nm], [0.0; 3]);
            assert!(seen.iter().any(|&channel| channel > 0.15), "{interval_nm:?}: {seen:?}");
        }
        let over = blended(&intervals_nm(16)[..1], [0.5; 3]);
        assert!(over.iter().all(|&channel| channel >= 0.5), "{over:?}");
    }
}
