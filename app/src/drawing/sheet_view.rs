//! A sheet that can be moved and magnified.

use brilliance_renderer::drawing::Sheet;
use eframe::egui::accesskit::Role;
use eframe::egui::{
    CornerRadius, CursorIcon, Rect, Response, Sense, Ui, Vec2, WidgetInfo, pos2, vec2,
};
use glam::DVec2;

use super::paint::paint_sheet;
use crate::theme;

/// Magnifications over that at which the whole sheet is seen.
const LEAST: f32 = 1.0;
const MOST: f32 = 24.0;
/// Wheel travel, in points, that doubles the size.
const POINTS_PER_DOUBLING: f32 = 300.0;

/// Which part of a sheet is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SheetView {
    /// Over the size at which the whole sheet is seen.
    magnification: f32,
    /// What is in the middle, in mm of the sheet; `None` is the sheet's middle.
    center_mm: Option<Vec2>,
}

impl Default for SheetView {
    fn default() -> Self {
        Self { magnification: 1.0, center_mm: None }
    }
}

impl SheetView {
    /// Shows `sheet` in a room of this size. The wheel magnifies, a drag moves, a double click shows
    /// all of it again.
    pub fn show(&mut self, ui: &mut Ui, sheet: &Sheet, size: Vec2) -> Response {
        let (room, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
        let label = format!("Drawing: {}", sheet.title);
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &label));
        let size_mm = points(sheet.size_mm);
        let whole = (room.width() / size_mm.x).min(room.height() / size_mm.y);
        self.steer(ui, &response, size_mm, whole);
        let points_per_mm = whole * self.magnification;
        let center = self.center(size_mm);
        let painter = ui.painter_at(room);
        painter.rect_filled(room, CornerRadius::same(4), theme::BACKDROP);
        paint_sheet(&painter, sheet, room.center() - center * points_per_mm, points_per_mm);
        response
    }

    fn steer(&mut self, ui: &Ui, response: &Response, size_mm: Vec2, whole: f32) {
        if response.double_clicked() {
            *self = Self::default();
        }
        let mut center =
            self.center(size_mm) - response.drag_delta() / (whole * self.magnification);
        if let Some(cursor) = response.hover_pos() {
            let (scroll, pinch) =
                ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
            let before = self.magnification;
            let factor = pinch * (scroll / POINTS_PER_DOUBLING).exp2();
            self.magnification = (before * factor).clamp(LEAST, MOST);
            // What is under the cursor stays there.
            let offset = (cursor - response.rect.center()) / whole;
            center += offset / before - offset / self.magnification;
        }
        let seen = response.rect.size() / (whole * self.magnification);
        self.center_mm = Some(confined(center, seen, size_mm));
        if response.dragged() {
            ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
        }
    }

    fn center(&self, size_mm: Vec2) -> Vec2 {
        self.center_mm.unwrap_or(0.5 * size_mm)
    }
}

/// The nearest middle at which `seen` shows no more than it must beside the sheet.
fn confined(center: Vec2, seen: Vec2, size_mm: Vec2) -> Vec2 {
    let slack = (0.5 * (size_mm - seen)).max(Vec2::ZERO);
    let middle = 0.5 * size_mm;
    let allowed = Rect::from_center_size(middle.to_pos2(), 2.0 * slack);
    allowed.clamp(pos2(center.x, center.y)).to_vec2()
}

fn points(size_mm: DVec2) -> Vec2 {
    vec2(size_mm.x as f32, size_mm.y as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_whole_sheet_stays_in_the_middle_and_a_part_stays_on_it() {
        let size = vec2(200.0, 100.0);
        let whole = confined(vec2(10.0, 10.0), vec2(200.0, 150.0), size);
        assert_eq!(whole, vec2(100.0, 50.0));
        let part = confined(vec2(10.0, 10.0), vec2(50.0, 40.0), size);
        assert_eq!(part, vec2(25.0, 20.0));
    }
}
