//! How rays of each kind are drawn, and the words for it.

use brilliance_renderer::inspect::RayKind;
use eframe::egui::epaint::Mesh;
use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Shape, Vec2, vec2};

use super::brush::{self, Dashes, Stripe};
use crate::theme;

/// Length of a sample of a line, in points.
pub(super) const SAMPLE: f32 = 26.0;
/// From a sample to its name.
const GAP: f32 = 8.0;
const ROW_HEIGHT: f32 = 17.0;
const PADDING: f32 = 8.0;
/// Distance from the edges of the picture.
const MARGIN: f32 = 12.0;

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

/// Explains the lines in the lower right corner of the picture, with `note` below: the legend of a
/// heat map has the left one.
pub(super) fn paint(painter: &Painter, room: Rect, note: &str) {
    let lines = [
        (RayKind::Refracted, "refracted"),
        (RayKind::TotallyReflected, "totally reflected"),
        (RayKind::Reflected, "reflected in part"),
    ];
    let font = FontId::proportional(11.5);
    let lay_out =
        |text: &str| painter.layout_no_wrap(text.to_owned(), font.clone(), theme::TEXT_WEAK);
    let named = lines.map(|(kind, text)| (kind, lay_out(text)));
    let note = Some(note).filter(|note| !note.is_empty()).map(lay_out);
    let named_width = named.iter().map(|(_, text)| text.size().x).fold(0.0, f32::max);
    let note_width = note.as_ref().map_or(0.0, |note| note.size().x);
    let rows = lines.len() + usize::from(note.is_some());
    let size = vec2((SAMPLE + GAP + named_width).max(note_width), ROW_HEIGHT * rows as f32);
    let plate = Align2::RIGHT_BOTTOM
        .align_size_within_rect(size + Vec2::splat(2.0 * PADDING), room.shrink(MARGIN));
    painter.rect_filled(plate, 6.0, theme::PANEL.gamma_multiply(0.88));
    let mut at = plate.min + Vec2::splat(PADDING);
    for (kind, text) in named {
        sample(painter, at + vec2(0.5 * SAMPLE, 0.5 * ROW_HEIGHT), kind, theme::TEXT);
        let text_at = at + vec2(SAMPLE + GAP, 0.5 * (ROW_HEIGHT - text.size().y));
        painter.galley(text_at, text, theme::TEXT_WEAK);
        at.y += ROW_HEIGHT;
    }
    if let Some(note) = note {
        painter.galley(at, note, theme::TEXT_WEAK);
    }
}
