//! Pixels picked in the picture.

use brilliance_renderer::camera::Camera;
use brilliance_renderer::film::{PixelRect, Region};
use eframe::egui::{Color32, Painter, Pos2, Rect, Stroke, StrokeKind, pos2};

/// What was picked, and what it was picked from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pick {
    /// The pixels.
    pub pixels: PixelRect,
    /// Width and height of the picture in pixels.
    pub size: [u32; 2],
    /// What the picture was seen by.
    pub camera: Camera,
}

impl Pick {
    /// The part of the picture that the pixels cover.
    pub fn region(&self) -> Region {
        Region::of(self.pixels, self.size)
    }
}

/// The pixels between two corners in `room`, which shows a picture of `size`.
pub fn pixels_between(corners: [Pos2; 2], room: Rect, size: [u32; 2]) -> PixelRect {
    let [a, b] = corners.map(|corner| pixel_at(corner, room, size));
    PixelRect {
        min: [0, 1].map(|axis| a[axis].min(b[axis])),
        size: [0, 1].map(|axis| a[axis].abs_diff(b[axis]) + 1),
    }
}

/// Marks what is picked in `room`, which shows a picture of `size`.
pub(super) fn paint_pick(pick: &Pick, painter: &Painter, room: Rect, size: [u32; 2]) {
    let scale = |axis: usize| size[axis] as f32 / pick.size[axis].max(1) as f32;
    let at = |pixel: [f32; 2]| {
        let x = room.left() + pixel[0] * scale(0) * room.width() / size[0].max(1) as f32;
        let y = room.top() + pixel[1] * scale(1) * room.height() / size[1].max(1) as f32;
        pos2(x, y)
    };
    let PixelRect { min, size: extent } = pick.pixels;
    let beyond = [0, 1].map(|axis| (min[axis] + extent[axis]) as f32);
    // A pixel alone is too small a frame to see.
    let margin = if pick.pixels.count() == 1 { 4.0 } else { 1.0 };
    let rect = Rect::from_two_pos(at(min.map(|pixel| pixel as f32)), at(beyond)).expand(margin);
    for (width, color) in [(3.0, Color32::from_black_alpha(160)), (1.2, Color32::WHITE)] {
        painter.rect_stroke(rect, 1.0, Stroke::new(width, color), StrokeKind::Middle);
    }
}

/// The pixel under a point, the nearest one where the point lies outside.
fn pixel_at(point: Pos2, room: Rect, size: [u32; 2]) -> [u32; 2] {
    let offset = (point - room.min) / room.size();
    let pixel = |part: f32, count: u32| {
        ((part * count as f32).max(0.0) as u32).min(count.saturating_sub(1))
    };
    [pixel(offset.x, size[0]), pixel(offset.y, size[1])]
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::vec2;

    #[test]
    fn corners_in_any_order_pick_the_pixels_between() {
        let room = Rect::from_min_size(pos2(100.0, 50.0), vec2(200.0, 100.0));
        let size = [400, 200];
        let picked = pixels_between([pos2(110.4, 60.0), pos2(105.0, 55.1)], room, size);
        assert_eq!(picked, PixelRect { min: [10, 10], size: [11, 11] });
        assert_eq!(picked.count(), 121);
        assert_eq!(picked.middle(), [15, 15]);
        let outside = pixels_between([pos2(0.0, 0.0), pos2(900.0, 900.0)], room, size);
        assert_eq!(outside, PixelRect { min: [0, 0], size });
    }
}
