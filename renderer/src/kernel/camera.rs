//! Camera rays.

use crate::camera::CameraFrame;
use crate::kernel::ray::Ray;
use crate::kernel::rng;

/// The ray through a point of pixel (`x`, `y`), row 0 at the top, that moves evenly over the
/// pixel from pass to pass.
#[inline]
pub fn camera_ray(frame: &CameraFrame, size: [u32; 2], x: u32, y: u32, pass_index: u32) -> Ray {
    let [jitter_x, jitter_y] = rng::pixel_sample(pixel_seed(x, y), pass_index);
    let across = 2.0 * (x as f32 + jitter_x) / size[0] as f32 - 1.0;
    let upwards = 1.0 - 2.0 * (y as f32 + jitter_y) / size[1] as f32;
    let direction = frame.forward + frame.right * across + frame.up * upwards;
    Ray::white(frame.position, direction.normalize_or_zero())
}

/// A random word that is the pixel's own.
#[inline]
pub fn pixel_seed(x: u32, y: u32) -> u32 {
    rng::hash(x ^ rng::hash(y))
}
