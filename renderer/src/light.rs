//! Lights: distant discs, the hemisphere, the uniform environment and the observer's shadow.

use std::f32::consts::TAU;

use glam::Vec3;
use serde::{Deserialize, Serialize};

use crate::spectrum::{Illuminant, Spectrum};

/// A distant round light, seen as a disc of `angular_radius_radians` about `direction`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DiscLight {
    /// What the user calls it.
    pub name: String,
    /// Unit vector towards the light.
    pub direction: Vec3,
    /// Angular radius in radians, in (0, π/2].
    pub angular_radius_radians: f32,
    /// Radiance of the disc; multiplies `spectrum`.
    pub radiance: f32,
    /// Spectral shape.
    pub spectrum: Spectrum,
}

impl DiscLight {
    /// The solid angle 2π(1 − √(1 − s²)), s the sine of the angular radius, in steradians
    /// (Thomas 1986, "Modeling dispersion").
    pub fn solid_angle_steradians(&self) -> f32 {
        // The same as 2π(1 − cos r), without the cancellation that would cost a small disc its digits.
        let half_sine = (0.5 * self.angular_radius_radians).sin();
        2.0 * TAU * half_sine * half_sine
    }
}

/// A light that fills the upper hemisphere (+z) or every direction with one radiance.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SkyLight {
    /// Radiance; multiplies `spectrum`.
    pub radiance: f32,
    /// Spectral shape.
    pub spectrum: Spectrum,
}

/// All lights of a scene.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Lights {
    /// Distant discs.
    pub discs: Vec<DiscLight>,
    /// The hemispherical light of the paper: one radiance over the upper half.
    pub hemisphere: Option<SkyLight>,
    /// One radiance from every direction.
    pub environment: Option<SkyLight>,
    /// Half-angle, in radians, of the black cone that the observer's head cuts out of the sky about
    /// the direction towards the camera, as stones see it; matte surfaces see the whole sky. 0 is off.
    pub observer_shadow_radians: f32,
    /// What a camera ray that meets nothing shows instead of the lights.
    pub backdrop: Option<SkyLight>,
}

impl SkyLight {
    /// A sky of D65 spectrum.
    pub fn daylight(radiance: f32) -> Self {
        Self { radiance, spectrum: Spectrum::Illuminant(Illuminant::D65) }
    }
}
