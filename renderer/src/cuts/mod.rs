//! Parametric cuts, each a function from the proportions a cutter states to half-spaces.
//!
//! Angles and azimuths follow GemCad: a facet of angle a from the girdle plane at azimuth φ has the
//! normal (sin a·sin φ, sin a·cos φ, ±cos a), + on the crown, − on the pavilion.

mod proportions;
mod round_brilliant;

pub use proportions::StandardProportions;
pub use round_brilliant::{RoundBrilliant, RoundBrilliantMeasures};

use glam::DVec3;

use crate::solid::HalfSpace;

/// Which half of the stone a facet belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Half {
    Crown,
    Pavilion,
}

impl Half {
    /// The sign of the normal's z component.
    fn sign(self) -> f64 {
        match self {
            Self::Crown => 1.0,
            Self::Pavilion => -1.0,
        }
    }
}

/// The facet of angle `angle` and azimuth `azimuth`, both in radians, that passes at height `z` and
/// at `radius` from the axis, measured along its own azimuth.
fn facet(name: String, half: Half, angle: f64, azimuth: f64, (radius, z): (f64, f64)) -> HalfSpace {
    let (sin, cos) = angle.sin_cos();
    let normal = DVec3::new(sin * azimuth.sin(), sin * azimuth.cos(), half.sign() * cos);
    HalfSpace { normal, distance: radius * sin + half.sign() * z * cos, name }
}
