//! From the scene to the screen.

use brilliance_renderer::camera::{Camera, CameraFrame};
use eframe::egui::{Pos2, Rect, pos2};
use glam::Vec3;

/// What is nearer to the eye than this, in mm, is not drawn.
const NEAR_MM: f32 = 0.05;
/// How far beyond the picture's edge lines are drawn, in points.
const MARGIN: f32 = 8.0;

/// How the picture in `room` shows the scene.
#[derive(Clone, Copy, Debug)]
pub(super) struct Projection {
    frame: CameraFrame,
    room: Rect,
}

/// The visible part of a line, on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ScreenLine {
    /// Its ends.
    pub(super) ends: [Pos2; 2],
    /// Where on the whole line these lie: 0 at its beginning, 1 at its end.
    pub(super) parts: [f32; 2],
}

impl Projection {
    pub(super) fn new(camera: &Camera, size: [u32; 2], room: Rect) -> Self {
        Self { frame: camera.frame(size[0], size[1]), room }
    }

    /// The eye.
    pub(super) fn eye(&self) -> Vec3 {
        self.frame.position
    }

    /// The point on the screen; none behind the eye.
    pub(super) fn point(&self, point: Vec3) -> Option<Pos2> {
        let offset = point - self.frame.position;
        let depth = offset.dot(self.frame.forward);
        (depth >= NEAR_MM).then(|| self.on_screen(offset, depth))
    }

    /// What the picture shows of the line between two points.
    pub(super) fn line(&self, [a, b]: [Vec3; 2]) -> Option<ScreenLine> {
        let depth = |point: Vec3| (point - self.frame.position).dot(self.frame.forward);
        let (depth_a, depth_b) = (depth(a), depth(b));
        if depth_a < NEAR_MM && depth_b < NEAR_MM {
            return None;
        }
        let at_near = (NEAR_MM - depth_a) / (depth_b - depth_a);
        let from = if depth_a < NEAR_MM { at_near } else { 0.0 };
        let to = if depth_b < NEAR_MM { at_near } else { 1.0 };
        let [start, end] = [from, to].map(|part| {
            let offset = a + (b - a) * part - self.frame.position;
            self.on_screen(offset, offset.dot(self.frame.forward).max(NEAR_MM))
        });
        let [enter, leave] = clip([start, end], self.room.expand(MARGIN))?;
        let whole = end - start;
        Some(ScreenLine {
            ends: [start + whole * enter, start + whole * leave],
            parts: [enter, leave].map(|part| from + (to - from) * part),
        })
    }

    fn on_screen(&self, offset: Vec3, depth: f32) -> Pos2 {
        let CameraFrame { right, up, .. } = self.frame;
        let across = offset.dot(right) / (right.length_squared() * depth);
        let upwards = offset.dot(up) / (up.length_squared() * depth);
        let center = self.room.center();
        pos2(
            center.x + 0.5 * across * self.room.width(),
            center.y - 0.5 * upwards * self.room.height(),
        )
    }
}

/// Where a line enters and leaves `rect`, as parts of it (Liang and Barsky 1984).
fn clip([start, end]: [Pos2; 2], rect: Rect) -> Option<[f32; 2]> {
    let along = end - start;
    let (mut enter, mut leave) = (0.0_f32, 1.0_f32);
    for (speed, room) in [
        (-along.x, start.x - rect.left()),
        (along.x, rect.right() - start.x),
        (-along.y, start.y - rect.top()),
        (along.y, rect.bottom() - start.y),
    ] {
        if speed == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if speed < 0.0 {
            enter = enter.max(room / speed);
        } else {
            leave = leave.min(room / speed);
        }
    }
    (enter < leave).then_some([enter, leave])
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::vec2;

    fn room() -> Rect {
        Rect::from_min_size(pos2(100.0, 50.0), vec2(400.0, 200.0))
    }

    fn projection() -> Projection {
        let camera = Camera {
            position: Vec3::Z * 10.0,
            target: Vec3::ZERO,
            up: Vec3::Y,
            fov_y_radians: 2.0 * 0.1_f32.atan(),
        };
        Projection::new(&camera, [800, 400], room())
    }

    #[test]
    fn the_target_is_in_the_middle_and_half_the_height_at_the_edge() {
        let projection = projection();
        assert_eq!(projection.point(Vec3::ZERO), Some(room().center()));
        let top = projection.point(Vec3::Y).expect("it is before the eye");
        assert!((top - pos2(300.0, 50.0)).length() < 1e-3, "{top:?}");
        assert_eq!(projection.point(Vec3::Z * 11.0), None);
    }

    #[test]
    fn a_line_through_the_eye_is_cut_off_before_it() {
        let projection = projection();
        let line = projection.line([Vec3::new(0.5, 0.0, 0.0), Vec3::new(0.5, 0.0, 20.0)]);
        let line = line.expect("a part of it is seen");
        assert_eq!(line.parts[0], 0.0);
        assert!(line.parts[1] < 0.5);
        let edge = line.ends[1];
        assert!(edge.is_finite() && (edge.x - (500.0 + MARGIN)).abs() < 0.1, "{edge:?}");
        assert_eq!(projection.line([Vec3::Z * 11.0, Vec3::Z * 12.0]), None);
        let beside = [Vec3::new(-9.0, 5.0, 0.0), Vec3::new(9.0, 5.0, 0.0)];
        assert_eq!(projection.line(beside), None);
    }
}
