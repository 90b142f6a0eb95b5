//! The ray of the paper: an interval of wavelengths, a direction and a spread vector.

use glam::Vec3;

use crate::packed::NONE;
use crate::spectrum::{LAMBDA_MAX_NM, LAMBDA_MIN_NM};

/// A ray that carries the wavelengths from `lambda_low_nm` to `lambda_high_nm`.
///
/// The directions at the ends of the interval are `direction ∓ spread`; the length of `spread` is
/// tan(angular spread / 2) (Thomas 1986, "Implementation").
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Where the ray starts, in mm.
    pub origin: Vec3,
    /// Shortest wavelength carried.
    pub lambda_low_nm: f32,
    /// Unit direction at the middle of the interval.
    pub direction: Vec3,
    /// Longest wavelength carried.
    pub lambda_high_nm: f32,
    /// From the middle direction to that of the longest wavelength.
    pub spread: Vec3,
    /// Product of the Fresnel factors so far: what the ray's radiance counts in the pixel.
    pub significance: f32,
    /// The instance whose surface the ray has left, or [`NONE`].
    pub instance: u32,
    /// The facet of `instance` that the ray has left.
    pub facet: u32,
    /// The body that the ray runs in, or [`NONE`] for air.
    pub medium: u32,
    /// The body that `medium` lies in, or [`NONE`]; deeper nesting is not kept.
    pub enclosing: u32,
    /// Interfaces met so far.
    pub depth: u32,
    /// The absorbing material that `path_mm` was run through, or [`NONE`].
    pub absorber: u32,
    /// Length run inside `absorber`, not yet applied to the significance.
    pub path_mm: f32,
}

impl Ray {
    /// An undispersed ray of weight 1 over the whole spectrum, outside of everything.
    #[inline]
    pub fn white(origin: Vec3, direction: Vec3) -> Self {
        Self {
            origin,
            lambda_low_nm: LAMBDA_MIN_NM,
            direction,
            lambda_high_nm: LAMBDA_MAX_NM,
            spread: Vec3::ZERO,
            significance: 1.0,
            instance: NONE,
            facet: NONE,
            medium: NONE,
            enclosing: NONE,
            depth: 0,
            absorber: NONE,
            path_mm: 0.0,
        }
    }

    /// The part of the traced spectrum that the ray carries, in 0..=1.
    #[inline]
    pub fn bandwidth(&self) -> f32 {
        (self.lambda_high_nm - self.lambda_low_nm) / (LAMBDA_MAX_NM - LAMBDA_MIN_NM)
    }
}

/// The distance of what is not there: as far as a finite number can tell, since a shader may
/// suppose that there are no infinities.
pub const FAR: f32 = f32::MAX;

/// A surface this close to another, in mm, touches it: rounding must not decide which is met.
pub const TOUCHING_MM: f32 = 1e-4;

/// The nearest surface along a ray.
#[derive(Clone, Copy, Debug)]
pub struct Hit {
    /// Distance in units of the ray's direction; [`FAR`] for a miss.
    pub distance: f32,
    /// The body, [`GROUND`] or [`NONE`].
    pub instance: u32,
    /// Facet of the body.
    pub facet: u32,
    /// Outward unit normal of the body's surface.
    pub normal: Vec3,
}

/// [`Hit::instance`] of the ground plane.
pub const GROUND: u32 = NONE - 1;

impl Hit {
    /// No surface.
    pub const MISS: Self = Self { distance: FAR, instance: NONE, facet: NONE, normal: Vec3::Z };
}
