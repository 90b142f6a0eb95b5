//! Pixels picked in the picture.

use brilliance_renderer::camera::Camera;
use brilliance_renderer::film::{PixelRect, Region};
use eframe::egui::{Color32, Painter, Pos2, Rect, Stroke, StrokeKind, vec2};

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
    /// The part that the pixels cover of a picture of `size`, which sees as far up and down as the one
    /// that they were picked from; none where that does not reach so far to the side.
    pub fn region(&self, size: [u32; 2]) -> Option<Region> {
        let [min, max] = self.corners_in(size);
        let is_beside = max[0] <= 0.0 || min[0] >= 1.0;
        (!is_beside).then(|| Region::between(min, max))
    }

    /// The corners of the pixels in fractions of a picture of `size`.
    fn corners_in(&self, size: [u32; 2]) -> [[f64; 2]; 2] {
        let PixelRect { min, size: extent } = self.pixels;
        let beyond = [0, 1].map(|axis| min[axis] + extent[axis]);
        let [width, height] = self.size.map(f64::from);
        let aspect = f64::from(size[0]) / f64::from(size[1].max(1));
        [min, beyond].map(|[x, y]| {
            [0.5 + (f64::from(x) - 0.5 * width) / (height * aspect), f64::from(y) / height]
        })
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
    let [min, max] = pick.corners_in(size).map(|corner| {
        let [x, y] = corner.map(|fraction| fraction as f32);
        room.min + vec2(x, y) * room.size()
    });
    // A pixel alone is too small a frame to see.
    let margin = if pick.pixels.count() == 1 { 4.0 } else { 1.0 };
    let rect = Rect::from_min_max(min, max).expand(margin);
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
    use eframe::egui::pos2;

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
    #[test]
    fn a_picture_of_other_proportions_shows_what_was_picked_about_its_middle() {
        let pixels = PixelRect { min: [300, 50], size: [1, 1] };
        let pick = Pick { pixels, size: [400, 200], camera: Camera::default() };
        assert_eq!(pick.region([400, 200]), Some(Region::of(pixels, [400, 200])));
        // Twice as high and half as wide in proportion: 100 pixels beside the middle become 200.
        let region = pick.region([500, 400]).expect("it is in sight");
        assert_eq!((region.min()[0] * 500.0, region.min()[1] * 400.0), (450.0, 100.0));
        assert_eq!(pick.region([200, 200]), None);
    }
}
