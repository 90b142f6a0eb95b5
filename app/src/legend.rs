//! The legend of a heat map: which colour stands for which number.

use brilliance_renderer::develop::{HeatMap, NOTHING, Shown};
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, Color32, FontId, Mesh, Painter, Pos2, Rect, Sense, Shape, Stroke, Ui, WidgetInfo, pos2,
    vec2,
};

use crate::{shown, theme};

/// Distance from the edges of the picture, in points.
const MARGIN: f32 = 12.0;
const PADDING: f32 = 10.0;
const WIDTH: f32 = 300.0;
const BAR_HEIGHT: f32 = 12.0;
/// Room for half a number beyond the ends of the bar.
const OVERHANG: f32 = 14.0;
/// From the swatch of nothing to the bar.
const SWATCH_ADVANCE: f32 = 44.0;
const TITLE_HEIGHT: f32 = 18.0;
const LINE_HEIGHT: f32 = 15.0;
/// Pieces of the bar, between which colours run straight.
const PIECES: u32 = 60;

/// Shows the legend of `map` in the lower left corner of `room`, if there is space for it.
/// `is_draft` says that the numbers are those of a draft.
pub fn show(ui: &Ui, room: Rect, map: HeatMap, is_draft: bool) {
    let size = vec2(
        WIDTH,
        TITLE_HEIGHT + LINE_HEIGHT + 6.0 + BAR_HEIGHT + 3.0 + LINE_HEIGHT + 2.0 * PADDING,
    );
    let corner = room.left_bottom() + vec2(MARGIN, -MARGIN - size.y);
    let rect = Rect::from_min_size(corner, size);
    if !room.contains_rect(rect.expand(MARGIN)) {
        return;
    }
    let title = shown::name(Shown::Heat(map));
    let response = ui.interact(rect, ui.scope_id().with("legend"), Sense::hover());
    response.widget_info(|| {
        let of = if is_draft { " of a draft" } else { "" };
        WidgetInfo::labeled(Role::Legend, true, format!("Legend: {title}{of}"))
    });

    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 6.0, theme::PANEL.gamma_multiply(0.88));
    let mut at = rect.min + vec2(PADDING, PADDING);
    painter.text(at, Align2::LEFT_TOP, title, FontId::proportional(13.0), theme::TEXT_STRONG);
    if is_draft {
        let corner = rect.right_top() + vec2(-PADDING, PADDING);
        text(&painter, corner, Align2::RIGHT_TOP, "of a draft", theme::WARNING);
    }
    at.y += TITLE_HEIGHT;
    let description = shown::description(Shown::Heat(map));
    text(&painter, at, Align2::LEFT_TOP, description, theme::TEXT_WEAK);
    at.y += LINE_HEIGHT + 6.0;
    let mut bar = Rect::from_min_size(at, vec2(WIDTH - 2.0 * PADDING - OVERHANG, BAR_HEIGHT));
    if map == HeatMap::Rays {
        // Each pixel takes a ray.
        bar.min.x += OVERHANG;
    } else {
        swatch_ui(&painter, at);
        bar.min.x += SWATCH_ADVANCE;
    }
    bar_ui(&painter, bar, map);
}

/// The colour of pixels for which there is nothing to count.
fn swatch_ui(painter: &Painter, at: Pos2) {
    let swatch = Rect::from_min_size(at, vec2(2.0 * BAR_HEIGHT, BAR_HEIGHT));
    let [r, g, b] = NOTHING;
    painter.rect_filled(swatch, 0.0, Color32::from_rgb(r, g, b));
    let below = swatch.center_bottom() + vec2(0.0, 3.0);
    text(painter, below, Align2::CENTER_TOP, "0", theme::TEXT);
}

/// The scale with its numbers.
fn bar_ui(painter: &Painter, bar: Rect, map: HeatMap) {
    let [low, high] = map.scale_ends();
    let mut mesh = Mesh::default();
    for piece in 0..=PIECES {
        let share = piece as f32 / PIECES as f32;
        let [r, g, b] = map.color(low * (high / low).powf(share));
        let x = bar.left() + share * bar.width();
        for y in [bar.top(), bar.bottom()] {
            mesh.colored_vertex(pos2(x, y), Color32::from_rgb(r, g, b));
        }
    }
    for corner in (0..2 * PIECES).step_by(2) {
        mesh.add_triangle(corner, corner + 1, corner + 2);
        mesh.add_triangle(corner + 1, corner + 2, corner + 3);
    }
    painter.add(Shape::mesh(mesh));

    let below = bar.bottom();
    for &(value, label) in ticks(map) {
        let share = (value / low).ln() / (high / low).ln();
        let x = bar.left() + share * bar.width();
        painter.vline(x, below - 4.0..=below, Stroke::new(1.0, theme::PANEL));
        text(painter, pos2(x, below + 3.0), Align2::CENTER_TOP, label, theme::TEXT);
    }
}

/// Round numbers of a scale.
fn ticks(map: HeatMap) -> &'static [(f32, &'static str)] {
    match map {
        HeatMap::Rays => {
            &[(1.0, "1"), (10.0, "10"), (100.0, "100"), (1e3, "1,000"), (1e4, "10,000")]
        }
        HeatMap::Depth => &[(1.0, "1"), (4.0, "4"), (16.0, "16"), (64.0, "64"), (256.0, "256")],
        HeatMap::Pruned => &[
            (1e-5, "0.001"),
            (1e-4, "0.01"),
            (1e-3, "0.1"),
            (1e-2, "1"),
            (1e-1, "10"),
            (1.0, "100 %"),
        ],
    }
}

fn text(painter: &Painter, at: Pos2, align: Align2, text: &str, color: Color32) {
    painter.text(at, align, text, FontId::proportional(11.5), color);
}
