//! The pinhole camera.

use glam::Vec3;
use serde::{Deserialize, Serialize};

/// A pinhole camera. Lengths are in millimetres, +z is up through the table of a stone.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Camera {
    /// The eye.
    pub position: Vec3,
    /// The point in the middle of the picture.
    pub target: Vec3,
    /// A direction that points upwards in the picture; not parallel to the view.
    pub up: Vec3,
    /// Vertical field of view in radians, in (0, π).
    pub fov_y_radians: f32,
}

impl Default for Camera {
    /// Looks down on a 6.5 mm stone at 28° from the vertical.
    fn default() -> Self {
        let tilt = 28.0_f32.to_radians();
        Self {
            position: Vec3::new(0.0, -tilt.sin(), tilt.cos()) * 30.0,
            target: Vec3::new(0.0, 0.0, -0.3),
            up: Vec3::Z,
            fov_y_radians: 15.0_f32.to_radians(),
        }
    }
}

/// The camera's orthonormal axes in world space, scaled to the image plane at distance 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraFrame {
    /// The eye.
    pub position: Vec3,
    /// Unit vector towards the middle of the picture.
    pub forward: Vec3,
    /// From the middle to the right edge of the image plane.
    pub right: Vec3,
    /// From the middle to the upper edge of the image plane.
    pub up: Vec3,
}

impl Camera {
    /// The frame for a picture of `width` × `height` pixels.
    ///
    /// A degenerate camera (eye on the target, up along the view) falls back to any valid frame
    /// rather than producing NaN.
    pub fn frame(&self, width: u32, height: u32) -> CameraFrame {
        let forward = (self.target - self.position).try_normalize().unwrap_or(Vec3::NEG_Z);
        let right = forward
            .cross(self.up)
            .try_normalize()
            .unwrap_or_else(|| forward.any_orthonormal_vector());
        let up = right.cross(forward);
        let half_height = (0.5 * self.fov_y_radians).tan();
        let aspect = width.max(1) as f32 / height.max(1) as f32;
        CameraFrame {
            position: self.position,
            forward,
            right: right * half_height * aspect,
            up: up * half_height,
        }
    }
}
