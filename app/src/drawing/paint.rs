//! Sheets on the screen.

use brilliance_renderer::drawing::{Anchor, Ink, Mark, Sheet, Stroke as SheetStroke, Words};
use eframe::egui::{Color32, FontId, Painter, Pos2, Shape, Stroke, pos2, vec2};
use glam::DVec2;

use crate::theme;

/// Smaller letters than this, in points, are left out: they would be grey dust.
const SMALLEST_LETTERS: f32 = 2.0;

/// Paints `sheet` with its upper left corner at `corner`, one millimetre `points_per_mm` wide, in the
/// colours of the dark window. Strokes and letters are as sharp as the screen at any scale.
pub fn paint_sheet(painter: &Painter, sheet: &Sheet, corner: Pos2, points_per_mm: f32) {
    let place = |at: &DVec2| corner + vec2(at.x as f32, at.y as f32) * points_per_mm;
    for mark in &sheet.marks {
        match mark {
            Mark::Stroke(stroke) => {
                let points = stroke.points.iter().map(place).collect();
                paint_stroke(painter, stroke, points, points_per_mm);
            }
            Mark::Fill(fill) => {
                let points = fill.points.iter().map(place).collect();
                painter.add(Shape::convex_polygon(points, color(fill.ink), Stroke::NONE));
            }
            Mark::Words(words) => paint_words(painter, words, place(&words.at), points_per_mm),
        }
    }
}

fn paint_stroke(painter: &Painter, stroke: &SheetStroke, points: Vec<Pos2>, points_per_mm: f32) {
    // A thinner line would only be a paler one.
    let thinnest = 1.0 / painter.pixels_per_point();
    let width = (stroke.width_mm as f32 * points_per_mm).max(thinnest);
    let pen = Stroke::new(width, color(stroke.ink));
    match stroke.dash_mm {
        Some([dash, gap]) => {
            let [dash, gap] = [dash, gap].map(|length| length as f32 * points_per_mm);
            painter.extend(Shape::dashed_line(&points, pen, dash, gap));
        }
        None => {
            painter.add(Shape::line(points, pen));
        }
    }
}

fn paint_words(painter: &Painter, words: &Words, at: Pos2, points_per_mm: f32) {
    let em = words.em_mm as f32 * points_per_mm;
    if em < SMALLEST_LETTERS {
        return;
    }
    let font = FontId::proportional(em);
    let galley = painter.layout_no_wrap(words.text.clone(), font, color(words.ink));
    let Some(row) = galley.rows.first() else { return };
    let Some(letter) = row.glyphs.first() else { return };
    let before = match words.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => 0.5,
        Anchor::End => 1.0,
    };
    let baseline = row.pos.y + letter.pos.y;
    let corner = pos2(at.x - before * galley.size().x, at.y - baseline);
    painter.galley(corner, galley, Color32::PLACEHOLDER);
}

/// What an ink is in the dark window.
fn color(ink: Ink) -> Color32 {
    match ink {
        Ink::Main => theme::TEXT_STRONG,
        Ink::Fine | Ink::Pale => theme::TEXT_WEAK,
        Ink::Tint => theme::RAISED,
        Ink::Dark => Color32::BLACK,
        Ink::Light([red, green, blue]) => Color32::from_rgb(red, green, blue),
    }
}
