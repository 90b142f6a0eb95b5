//! Lines and fans of light, as triangles with soft edges.

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
        let color = stripe.colors[0].lerp_to_gamma(stripe.colors[1], part);
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

/// Adds a fan from `apex` to `rim`, whose points have colours.
pub(super) fn fan(mesh: &mut Mesh, apex: Pos2, rim: &[(Pos2, Color32)]) {
    for pair in rim.windows(2) {
        let first = mesh.vertices.len() as u32;
        for (pos, color) in [(apex, pair[0].1), pair[0], pair[1]] {
            mesh.vertices.push(Vertex { pos, uv: WHITE_UV, color });
        }
        mesh.add_triangle(first, first + 1, first + 2);
    }
}

/// The colour at a part of its strength, 0..=1.
pub(super) fn faded(color: Color32, strength: f32) -> Color32 {
    color.gamma_multiply(strength.clamp(0.0, 1.0))
}
