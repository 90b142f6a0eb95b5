//! The turntable: how the mouse and the keys move the camera around the stone.

use std::f32::consts::{FRAC_PI_2, PI};

use brilliance_renderer::camera::Camera;
use glam::Vec3;

use crate::bounds::Bounds;

/// The views a gemologist asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StandardView {
    /// Straight down on the table.
    FaceUp,
    /// Along the girdle plane.
    Side,
    /// Straight up at the culet.
    Pavilion,
}

/// A camera on a sphere about its target, in spherical coordinates with +z as the axis.
///
/// The picture's upward direction is the derivative of the eye's direction by elevation, so that
/// it stays defined where the view is along the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbit {
    target: Vec3,
    distance: f32,
    azimuth_radians: f32,
    elevation_radians: f32,
    roll_radians: f32,
    fov_y_radians: f32,
}

/// Turn per point of drag, in radians: a drag over 420 points is half a turn.
const RADIANS_PER_POINT: f32 = PI / 420.0;
/// The eye stays this factor outside the bounds.
const CLEARANCE: f32 = 1.02;
/// Farthest eye and farthest target from the centre of the bounds, in radii.
const FARTHEST_EYE: f32 = 100.0;
const FARTHEST_TARGET: f32 = 10.0;

impl Orbit {
    /// The orbit that shows what `camera` shows.
    pub fn from_camera(camera: &Camera) -> Self {
        let offset = camera.position - camera.target;
        let direction = offset.try_normalize().unwrap_or(Vec3::Z);
        let elevation_radians = direction.z.clamp(-1.0, 1.0).asin();
        // Seen along the axis, only the upward direction tells the azimuth.
        let horizontal =
            if direction.z.abs() < 0.9999 { direction } else { -camera.up * direction.z.signum() };
        let azimuth_radians = horizontal.y.atan2(horizontal.x);
        let mut orbit = Self {
            target: camera.target,
            distance: offset.length().max(f32::MIN_POSITIVE),
            azimuth_radians,
            elevation_radians,
            roll_radians: 0.0,
            fov_y_radians: camera.fov_y_radians,
        };
        let (right, up) = orbit.axes();
        let rolled = camera.up - direction * camera.up.dot(direction);
        if let Some(rolled) = rolled.try_normalize() {
            orbit.roll_radians = (-rolled.dot(right)).atan2(rolled.dot(up));
        }
        orbit
    }

    /// The camera of this orbit.
    pub fn camera(&self) -> Camera {
        let (right, up) = self.axes();
        let (sin_roll, cos_roll) = self.roll_radians.sin_cos();
        Camera {
            position: self.target + self.direction() * self.distance,
            target: self.target,
            up: up * cos_roll - right * sin_roll,
            fov_y_radians: self.fov_y_radians,
        }
    }

    /// Turns by a drag of `delta` points to the right and down, as if the stone were grabbed.
    pub fn rotate(&mut self, delta: [f32; 2], bounds: &Bounds) {
        self.azimuth_radians =
            (self.azimuth_radians - delta[0] * RADIANS_PER_POINT).rem_euclid(2.0 * PI);
        self.elevation_radians =
            (self.elevation_radians + delta[1] * RADIANS_PER_POINT).clamp(-FRAC_PI_2, FRAC_PI_2);
        self.keep_outside(bounds);
    }

    /// Moves sideways by a drag of `delta` points to the right and down in a picture
    /// `height` points high, so that what is grabbed stays under the cursor.
    pub fn pan(&mut self, delta: [f32; 2], height: f32, bounds: &Bounds) {
        let (right, up) = self.picture_axes();
        let per_point = 2.0 * self.half_height() / height.max(1.0);
        self.target += (up * delta[1] - right * delta[0]) * per_point;
        let from_center = self.target - bounds.center;
        self.target = bounds.center + from_center.clamp_length_max(FARTHEST_TARGET * bounds.radius);
        self.keep_outside(bounds);
    }

    /// Comes nearer by `factor` (above 1) or backs away (below 1), keeping in place what is under
    /// the cursor: `at` is its offset from the middle of the picture to the right and up, in
    /// half heights.
    pub fn zoom(&mut self, factor: f32, at: [f32; 2], bounds: &Bounds) {
        if !(factor.is_finite() && factor > 0.0) {
            return;
        }
        let before = self.half_height();
        self.distance /= factor;
        self.keep_outside(bounds);
        let (right, up) = self.picture_axes();
        let shift = before - self.half_height();
        self.target += (right * at[0] + up * at[1]) * shift;
        self.keep_outside(bounds);
    }

    /// Turns to a standard view, upright, at the present distance, about the middle of `bounds`.
    pub fn look(&mut self, view: StandardView, bounds: &Bounds) {
        self.elevation_radians = match view {
            StandardView::FaceUp => FRAC_PI_2,
            StandardView::Side => 0.0,
            StandardView::Pavilion => -FRAC_PI_2,
        };
        self.azimuth_radians = -FRAC_PI_2;
        self.roll_radians = 0.0;
        self.target = bounds.center;
        self.keep_outside(bounds);
    }

    /// Unit vector from the target to the eye.
    fn direction(&self) -> Vec3 {
        let (sin_elevation, cos_elevation) = self.elevation_radians.sin_cos();
        let (sin_azimuth, cos_azimuth) = self.azimuth_radians.sin_cos();
        Vec3::new(cos_elevation * cos_azimuth, cos_elevation * sin_azimuth, sin_elevation)
    }

    /// Unit vectors to the right and upwards in the picture, before roll.
    fn axes(&self) -> (Vec3, Vec3) {
        let (sin_elevation, cos_elevation) = self.elevation_radians.sin_cos();
        let (sin_azimuth, cos_azimuth) = self.azimuth_radians.sin_cos();
        let right = Vec3::new(-sin_azimuth, cos_azimuth, 0.0);
        let up =
            Vec3::new(-sin_elevation * cos_azimuth, -sin_elevation * sin_azimuth, cos_elevation);
        (right, up)
    }

    /// Unit vectors to the right and upwards in the picture.
    fn picture_axes(&self) -> (Vec3, Vec3) {
        let (right, up) = self.axes();
        let (sin_roll, cos_roll) = self.roll_radians.sin_cos();
        (right * cos_roll + up * sin_roll, up * cos_roll - right * sin_roll)
    }

    /// Half the height of what is seen in the plane of the target, in millimetres.
    fn half_height(&self) -> f32 {
        self.distance * (0.5 * self.fov_y_radians).tan()
    }

    /// Backs the eye away along its line of sight until it is outside `bounds`.
    fn keep_outside(&mut self, bounds: &Bounds) {
        let radius = bounds.radius * CLEARANCE;
        let from_center = self.target - bounds.center;
        // The far crossing of the line target + t · direction with the sphere.
        let along = from_center.dot(self.direction());
        let discriminant = along * along - from_center.length_squared() + radius * radius;
        let exit = if discriminant > 0.0 { discriminant.sqrt() - along } else { 0.0 };
        let nearest = exit.max(0.01 * radius);
        self.distance = self.distance.clamp(nearest, nearest.max(FARTHEST_EYE * radius));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOUNDS: Bounds = Bounds { center: Vec3::new(0.5, -0.25, 1.0), radius: 4.0 };

    fn default_orbit() -> Orbit {
        Orbit::from_camera(&Camera::default())
    }

    fn assert_same_view(a: &Camera, b: &Camera) {
        let (a, b) = (a.frame(300, 200), b.frame(300, 200));
        for (a, b) in [(a.position, b.position), (a.right, b.right), (a.up, b.up)] {
            assert!(a.abs_diff_eq(b, 2e-5), "{a} is not {b}");
        }
    }

    #[test]
    fn a_camera_survives_the_round_trip() {
        let rolled = Camera { up: Vec3::new(0.3, 0.2, 0.8), ..Camera::default() };
        let face_up = Camera {
            position: Vec3::new(0.0, 0.0, 30.0),
            up: Vec3::new(0.6, 0.8, 0.0),
            ..Camera::default()
        };
        let pavilion = Camera { position: Vec3::new(0.0, 0.0, -30.0), ..face_up };
        for camera in [Camera::default(), rolled, face_up, pavilion] {
            assert_same_view(&Orbit::from_camera(&camera).camera(), &camera);
        }
    }

    #[test]
    fn standard_views_are_upright_and_free_of_degeneracy() {
        for (view, eye, up) in [
            (StandardView::FaceUp, Vec3::Z, Vec3::Y),
            (StandardView::Side, Vec3::NEG_Y, Vec3::Z),
            (StandardView::Pavilion, Vec3::NEG_Z, Vec3::NEG_Y),
        ] {
            let mut orbit = default_orbit();
            orbit.look(view, &BOUNDS);
            let camera = orbit.camera();
            let offset = (camera.position - camera.target).normalize_or_zero();
            assert!(offset.abs_diff_eq(eye, 1e-6), "{view:?}: eye along {offset}");
            assert!(camera.up.abs_diff_eq(up, 1e-6), "{view:?}: up is {}", camera.up);
            assert!(camera.up.dot(offset).abs() < 1e-6);
        }
    }

    #[test]
    fn dragging_through_the_pole_stops_there_and_the_picture_never_flips() {
        let mut orbit = default_orbit();
        let mut before = orbit.camera().frame(1, 1).up;
        for _ in 0..400 {
            orbit.rotate([0.7, 3.0], &BOUNDS);
            let up = orbit.camera().frame(1, 1).up;
            assert!(up.is_finite() && (up - before).length() < 0.02, "{before} to {up}");
            before = up;
        }
        let camera = orbit.camera();
        assert!((camera.position - camera.target).normalize_or_zero().z > 0.999_99);
    }

    #[test]
    fn dragging_to_the_right_turns_the_front_of_the_stone_to_the_right() {
        let mut orbit = default_orbit();
        let front = orbit.camera().position * 0.1;
        let to_the_right = |orbit: &Orbit| {
            let frame = orbit.camera().frame(1, 1);
            (front - frame.position).dot(frame.right)
        };
        let before = to_the_right(&orbit);
        orbit.rotate([20.0, 0.0], &BOUNDS);
        assert!(to_the_right(&orbit) > before + 1e-3);
    }

    #[test]
    fn the_eye_stays_outside_the_scene_whatever_is_done() {
        let mut orbit = default_orbit();
        let outside = |orbit: &Orbit| {
            let eye = orbit.camera().position;
            assert!((eye - BOUNDS.center).length() >= BOUNDS.radius * 1.01, "eye at {eye}");
        };
        for step in 0..200 {
            let sway = (step as f32 * 0.7).sin();
            orbit.zoom(1.3, [sway, -sway], &BOUNDS);
            outside(&orbit);
            orbit.pan([90.0 * sway, 60.0], 800.0, &BOUNDS);
            outside(&orbit);
            orbit.rotate([35.0, 50.0 * sway], &BOUNDS);
            outside(&orbit);
        }
        for factor in [0.0, f32::NAN, f32::INFINITY, 1e-30, 1e30] {
            orbit.zoom(factor, [0.0, 0.0], &BOUNDS);
            outside(&orbit);
            assert!(orbit.camera().position.is_finite());
        }
    }

    #[test]
    fn zooming_keeps_the_point_under_the_cursor() {
        let mut orbit = default_orbit();
        let at = [0.4, -0.3];
        let under_cursor = |orbit: &Orbit| {
            let frame = orbit.camera().frame(1, 1);
            let ray = frame.forward + frame.right * at[0] + frame.up * at[1];
            frame.position + ray * orbit.distance
        };
        let before = under_cursor(&orbit);
        orbit.zoom(1.5, at, &BOUNDS);
        assert!(under_cursor(&orbit).abs_diff_eq(before, 1e-4));
    }

    #[test]
    fn panning_keeps_what_is_grabbed_under_the_cursor() {
        let mut orbit = default_orbit();
        let grabbed = orbit.camera().target;
        orbit.pan([40.0, 25.0], 400.0, &BOUNDS);
        let frame = orbit.camera().frame(1, 1);
        let offset = grabbed - frame.position;
        let depth = offset.dot(frame.forward);
        let right = offset.dot(frame.right) / frame.right.length_squared() / depth;
        let up = offset.dot(frame.up) / frame.up.length_squared() / depth;
        // 400 points are two half heights.
        assert!((right - 40.0 / 200.0).abs() < 1e-3, "{right}");
        assert!((up + 25.0 / 200.0).abs() < 1e-3, "{up}");
    }
}
