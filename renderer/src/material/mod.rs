//! What an object is made of.

mod dispersion;
mod image;
mod library;
mod print;

pub use dispersion::{Dispersion, SellmeierTerm};
pub use image::{Alpha, Image, ImageOrigin, TexelBudget};
pub use library::{Category, Figures, LibraryMaterial, Measurement, find, library};
pub use print::{Layout, Outside, Planar, Print};

use crate::spectrum::Spectrum;

/// The optical behaviour of an object's surface and interior.
#[derive(Clone, Debug, PartialEq)]
pub enum Material {
    /// A clear solid with smooth surfaces: refracts, reflects, may absorb.
    Dielectric(Dielectric),
    /// A matte opaque surface.
    Diffuse(Diffuse),
}

/// A clear solid.
#[derive(Clone, Debug, PartialEq)]
pub struct Dielectric {
    /// Name of the material, for the user.
    pub name: String,
    /// Index of refraction over wavelength.
    pub dispersion: Dispersion,
    /// Absorption coefficient α per millimetre (Beer–Lambert: transmittance e^(−α·d)).
    pub absorption_per_mm: Option<Spectrum>,
}

/// A Lambertian surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Diffuse {
    /// Reflectance in 0..=1.
    pub reflectance: Spectrum,
    /// What is printed on it.
    pub print: Option<Print>,
}
