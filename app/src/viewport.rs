//! The picture in the middle of the window, and the mouse on it.

use std::sync::Arc;

use brilliance_renderer::develop::Shown;
use brilliance_renderer::film::PixelRect;
use brilliance_renderer::session::{Activity, Picture, Progress};
use eframe::egui::accesskit::Role;
use eframe::egui::{
    self, Align2, FontId, Frame, Painter, PointerButton, Pos2, Rect, Response, RichText, Sense,
    Shape, Stroke, Ui, WidgetInfo, pos2, vec2,
};

use crate::bounds::Bounds;
use crate::inspector::pixels_between;
use crate::legend;
use crate::orbit::Orbit;
use crate::picture_painter::paint_picture;
use crate::theme;

/// Largest picture the window asks for, in pixels per side.
const LARGEST_SIDE: f32 = 8192.0;
/// Wheel travel, in points, that doubles the size of the stone.
const POINTS_PER_DOUBLING: f32 = 400.0;

/// What the viewport found out in this frame.
#[derive(Debug)]
pub struct ViewportResponse {
    /// Size in physical pixels: the size the picture should have.
    pub size: [u32; 2],
    /// The stone was double-clicked, where clicks do not pick: the camera goes back to where the scene put it.
    pub reset: bool,
    /// Pixels that were clicked on or dragged over, where that picks.
    pub picked: Option<PixelRect>,
    /// The widget, for focus.
    pub response: Response,
}

/// Shows `picture` in all of the room that is left and moves the camera by the mouse. With `picks`
/// a click picks a pixel and a drag with the command key a region.
pub fn show(
    ui: &mut Ui,
    picture: Option<&Arc<Picture>>,
    progress: &Progress,
    orbit: &mut Orbit,
    bounds: &Bounds,
    picks: bool,
) -> ViewportResponse {
    let pixels_per_point = ui.pixels_per_point();
    let room = ui.available_rect_before_wrap();
    let response = ui.allocate_rect(room, Sense::click_and_drag());
    response.widget_info(|| {
        WidgetInfo::labeled(Role::Image, true, "Picture of the stone: drag to turn it")
    });
    let size = [room.width(), room.height()]
        .map(|side| (side * pixels_per_point).round().clamp(1.0, LARGEST_SIDE) as u32);

    let painter = ui.painter_at(room);
    if let Some(picture) = picture {
        paint(&painter, picture, room, size, pixels_per_point);
    } else {
        painter.rect_filled(room, 0.0, theme::BACKDROP);
        empty_ui(&painter, room, progress);
    }
    let picked = if picks { picked(ui, &response, size) } else { None };
    if picked.is_none() {
        steer(ui, &response, orbit, bounds);
    }
    ViewportResponse { size, reset: response.double_clicked() && !picks, picked, response }
}

/// Says in `room` what the colours of the picture mean, and why there is no newer one: after all that
/// is drawn over the picture.
pub fn notes_ui(ui: &mut Ui, room: Rect, picture: Option<&Arc<Picture>>, progress: &Progress) {
    if let Some(Shown::Heat(map)) = picture.map(|picture| picture.shown) {
        legend::show(ui, room, map, progress.activity == Activity::Preview);
    }
    if let Some(error) = &progress.error {
        banner_ui(ui, room, error);
    }
}

/// The pixels that are clicked on, or being dragged over with the command key.
fn picked(ui: &Ui, response: &Response, size: [u32; 2]) -> Option<PixelRect> {
    let at = response.interact_pointer_pos()?;
    let corners = if response.clicked_by(PointerButton::Primary) {
        [at, at]
    } else {
        let (command, origin) =
            ui.input(|input| (input.modifiers.command, input.pointer.press_origin()));
        let drags = command && response.dragged_by(PointerButton::Primary);
        [origin.filter(|_| drags)?, at]
    };
    Some(pixels_between(corners, response.rect, size))
}

fn paint(
    painter: &Painter,
    picture: &Arc<Picture>,
    room: Rect,
    wanted: [u32; 2],
    pixels_per_point: f32,
) {
    let is_exact = picture.size == wanted;
    let rect = if is_exact {
        // One pixel of the picture on one of the screen.
        let corner = (room.min.to_vec2() * pixels_per_point).round() / pixels_per_point;
        let [width, height] = wanted.map(|side| side as f32 / pixels_per_point);
        Rect::from_min_size(corner.to_pos2(), vec2(width, height))
    } else {
        fitted(room, picture.size)
    };
    // Where drawing is done by the processor, no pixel should be filled twice.
    if !rect.expand(1.0).contains_rect(room) {
        painter.rect_filled(room, 0.0, theme::BACKDROP);
    }
    painter.add(paint_picture(rect, picture, !is_exact));
}

/// All of `room`, or as much of it as keeps the proportions of a picture that was made for
/// another.
fn fitted(room: Rect, size: [u32; 2]) -> Rect {
    let aspect = size[0] as f32 / size[1].max(1) as f32;
    let room_aspect = room.width() / room.height().max(1.0);
    // A preview is rounded to whole pixels, which is no other proportion.
    if (aspect / room_aspect - 1.0).abs() < 0.05 {
        return room;
    }
    let size = if aspect > room_aspect {
        vec2(room.width(), room.width() / aspect)
    } else {
        vec2(room.height() * aspect, room.height())
    };
    Rect::from_center_size(room.center(), size)
}

/// Turns, moves and zooms by the mouse and the trackpad.
fn steer(ui: &Ui, response: &Response, orbit: &mut Orbit, bounds: &Bounds) {
    let delta = response.drag_delta();
    if delta != egui::Vec2::ZERO {
        let pans = response.dragged_by(PointerButton::Middle)
            || ui.input(|input| input.modifiers.shift && !input.modifiers.command);
        if pans {
            orbit.pan([delta.x, delta.y], response.rect.height(), bounds);
        } else if response.dragged_by(PointerButton::Primary) {
            orbit.rotate([delta.x, delta.y], bounds);
        }
    }
    if let Some(cursor) = response.hover_pos() {
        let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
        let factor = pinch * (scroll / POINTS_PER_DOUBLING).exp2();
        if factor != 1.0 {
            let offset = (cursor - response.rect.center()) / (0.5 * response.rect.height());
            orbit.zoom(factor, [offset.x, -offset.y], bounds);
        }
    }
    if response.dragged() {
        ui.ctx().set_cursor_icon(egui::CursorIcon::Grabbing);
    }
}

/// What is seen before there is a picture.
fn empty_ui(painter: &Painter, room: Rect, progress: &Progress) {
    let center = room.center();
    outline(painter, center - vec2(0.0, 40.0), 44.0);
    let (title, hint) = match progress.activity {
        Activity::Idle | Activity::Done => {
            ("Nothing to show yet", "Open a scene or a glTF file, or drop one here")
        }
        Activity::Preview | Activity::Accumulating => ("Tracing the first picture\u{2026}", ""),
        Activity::Failed => ("This scene can't be traced", ""),
    };
    let title_at = center + vec2(0.0, 36.0);
    painter.text(title_at, Align2::CENTER_CENTER, title, FontId::proportional(15.0), theme::TEXT);
    let hint_at = center + vec2(0.0, 60.0);
    painter.text(
        hint_at,
        Align2::CENTER_CENTER,
        hint,
        FontId::proportional(13.0),
        theme::TEXT_WEAK,
    );
}

/// The profile of a brilliant, in thin lines.
fn outline(painter: &Painter, center: Pos2, half_width: f32) {
    let at = |x: f32, y: f32| center + vec2(x, y) * half_width;
    let stroke = Stroke::new(1.2, theme::TEXT_WEAK);
    let silhouette =
        vec![at(-0.56, -0.5), at(0.56, -0.5), at(1.0, -0.2), at(0.0, 0.72), at(-1.0, -0.2)];
    painter.add(Shape::closed_line(silhouette, stroke));
    for line in [
        vec![at(-1.0, -0.2), at(1.0, -0.2)],
        vec![at(-0.56, -0.5), at(-0.36, -0.2), at(0.0, -0.5), at(0.36, -0.2), at(0.56, -0.5)],
        vec![at(-0.36, -0.2), at(0.0, 0.72), at(0.36, -0.2)],
    ] {
        painter.add(Shape::line(line, stroke));
    }
}

/// Says over the last good picture why there is no newer one.
fn banner_ui(ui: &mut Ui, room: Rect, error: &str) {
    let width = (room.width() - 32.0).clamp(120.0, 560.0);
    let top = Rect::from_center_size(pos2(room.center().x, room.top() + 36.0), vec2(width, 40.0));
    ui.scope_builder(egui::UiBuilder::new().max_rect(top), |ui| {
        Frame::popup(ui.style()).stroke(Stroke::new(1.0, theme::ERROR)).show(ui, |ui| {
            ui.set_width(width - 24.0);
            ui.label(RichText::new("Not traced").strong().color(theme::ERROR));
            ui.label(error);
        });
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_of_other_proportions_is_fitted_not_stretched() {
        let room = Rect::from_min_size(pos2(10.0, 20.0), vec2(400.0, 200.0));
        assert_eq!(fitted(room, [201, 100]), room);
        let square = fitted(room, [100, 100]);
        assert_eq!(square, Rect::from_center_size(room.center(), vec2(200.0, 200.0)));
        let wide = fitted(room, [400, 100]);
        assert_eq!(wide.size(), vec2(400.0, 100.0));
    }
}
