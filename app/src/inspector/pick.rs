//! Pixels picked in the picture.

use std::fmt;

use brilliance_renderer::camera::Camera;
use brilliance_renderer::film::{self, Region};
use eframe::egui::{Color32, Painter, Pos2, Rect, Stroke, StrokeKind, pos2};

/// A rectangle of whole pixels, at least one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelRect {
    /// Column and row of the first pixel, from the top left.
    pub first: [u32; 2],
    /// Column and row of the last pixel.
    pub last: [u32; 2],
}

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
        let PixelRect { first, last } = self.pixels;
        let size = [0, 1].map(|axis| last[axis] - first[axis] + 1);
        Region::of(film::PixelRect { min: first, size }, self.size)
    }
}

impl PixelRect {
    /// The pixels between two corners in `room`, which shows a picture of `size`.
    pub fn between(corners: [Pos2; 2], room: Rect, size: [u32; 2]) -> Self {
        let [a, b] = corners.map(|corner| pixel_at(corner, room, size));
        let least = |axis: usize| a[axis].min(b[axis]);
        let most = |axis: usize| a[axis].max(b[axis]);
        Self { first: [least(0), least(1)], last: [most(0), most(1)] }
    }

    /// The pixel in the middle.
    pub fn middle(&self) -> [u32; 2] {
        [0, 1].map(|axis| self.first[axis].midpoint(self.last[axis]))
    }

    /// Number of pixels.
    pub fn count(&self) -> u64 {
        let side = |axis: usize| u64::from(self.last[axis] - self.first[axis]) + 1;
        side(0) * side(1)
    }

    /// Marks the pixels, picked from a picture of `picked_size`, in `room`, which shows another of
    /// `size`.
    pub fn paint(&self, painter: &Painter, room: Rect, picked_size: [u32; 2], size: [u32; 2]) {
        let scale = |axis: usize| size[axis] as f32 / picked_size[axis].max(1) as f32;
        let at = |pixel: [f32; 2]| {
            let x = room.left() + pixel[0] * scale(0) * room.width() / size[0].max(1) as f32;
            let y = room.top() + pixel[1] * scale(1) * room.height() / size[1].max(1) as f32;
            pos2(x, y)
        };
        let first = self.first.map(|pixel| pixel as f32);
        let beyond = self.last.map(|pixel| pixel as f32 + 1.0);
        // A pixel alone is too small a frame to see.
        let rect = Rect::from_two_pos(at(first), at(beyond)).expand(if self.count() == 1 {
            4.0
        } else {
            1.0
        });
        for (width, color) in [(3.0, Color32::from_black_alpha(160)), (1.2, Color32::WHITE)] {
            painter.rect_stroke(rect, 1.0, Stroke::new(width, color), StrokeKind::Middle);
        }
    }
}

impl fmt::Display for PixelRect {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y] = self.first;
        if self.count() == 1 {
            return write!(formatter, "pixel {x}, {y}");
        }
        let [width, height] = [0, 1].map(|axis| self.last[axis] - self.first[axis] + 1);
        write!(formatter, "{width} \u{d7} {height} pixels at {x}, {y}")
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
        let picked = PixelRect::between([pos2(110.4, 60.0), pos2(105.0, 55.1)], room, size);
        assert_eq!(picked, PixelRect { first: [10, 10], last: [20, 20] });
        assert_eq!(picked.count(), 121);
        assert_eq!(picked.middle(), [15, 15]);
        let outside = PixelRect::between([pos2(0.0, 0.0), pos2(900.0, 900.0)], room, size);
        assert_eq!(outside, PixelRect { first: [0, 0], last: [399, 199] });
    }
}
