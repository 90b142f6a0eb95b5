//! How rays of each kind are drawn, and the words for it.

use brilliance_renderer::inspect::RayKind;
use eframe::egui::epaint::Mesh;
use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Shape, pos2, vec2};

use super::brush::{self, Dashes, Stripe};
use crate::theme;

/// Length of a sample of a line, in points.
pub(super) const SAMPLE: f32 = 26.0;

/// What a kind is called.
pub(super) fn name(kind: RayKind) -> &'static str {
    match kind {
        RayKind::Camera => "camera",
        RayKind::Refracted => "refracted",
        RayKind::TotallyReflected => "total",
        RayKind::Reflected => "reflected",
    }
}

/// What a kind is.
pub(super) fn explanation(kind: RayKind) -> &'static str {
    match kind {
        RayKind::Camera => "The ray from the eye.",
        RayKind::Refracted => "Rays that went through a facet.",
        RayKind::TotallyReflected => {
            "Rays beyond the critical angle: all of their light is reflected."
        }
        RayKind::Reflected => "The part that a facet throws back of light that goes through it.",
    }
}

/// How its line is broken.
pub(super) fn dashes(kind: RayKind) -> Option<Dashes> {
    match kind {
        RayKind::Camera | RayKind::Refracted => None,
        RayKind::TotallyReflected => Some(Dashes::LONG),
        RayKind::Reflected => Some(Dashes::SHORT),
    }
}

/// A short line as rays of this kind have it, centred on `middle`.
pub(super) fn sample(painter: &Painter, middle: Pos2, kind: RayKind, color: Color32) {
    let half = vec2(0.5 * SAMPLE, 0.0);
    let stripe = Stripe { ends: [middle - half, middle + half], colors: [color; 2], width: 1.4 };
    let mut mesh = Mesh::default();
    brush::stripe(&mut mesh, &stripe, dashes(kind));
    painter.add(Shape::mesh(mesh));
}

/// Explains the lines in the lower left corner of the picture, with `note` below.
pub(super) fn paint(painter: &Painter, room: Rect, note: &str) {
    let lines = [
        (RayKind::Refracted, "refracted"),
        (RayKind::TotallyReflected, "totally reflected"),
        (RayKind::Reflected, "reflected in part"),
    ];
    let font = FontId::proportional(11.5);
    let rows = lines.len() + usize::from(!note.is_empty());
    let mut at = pos2(room.left() + 14.0, room.bottom() - 8.0 - 17.0 * rows as f32);
    for (kind, text) in lines {
        let middle = at + vec2(0.5 * SAMPLE, 8.0);
        sample(painter, middle, kind, theme::TEXT);
        let text_at = at + vec2(SAMPLE + 8.0, 8.0);
        painter.text(text_at, Align2::LEFT_CENTER, text, font.clone(), theme::TEXT_WEAK);
        at.y += 17.0;
    }
    painter.text(at + vec2(0.0, 8.0), Align2::LEFT_CENTER, note, font, theme::TEXT_WEAK);
}
