//! Light as a function of wavelength: the traced range, the film's bins, spectra, the standard
//! observer and the standard illuminants.

mod bins;

pub use bins::Bins;

use serde::{Deserialize, Serialize};

/// Shortest traced wavelength, in nm.
pub const LAMBDA_MIN_NM: f32 = 380.0;
/// Longest traced wavelength, in nm.
pub const LAMBDA_MAX_NM: f32 = 730.0;

/// The Fraunhofer B line as the paper rounds it, in nm.
pub const LAMBDA_B_NM: f64 = 687.0;
/// The sodium D line as the paper rounds it, in nm.
pub const LAMBDA_D_NM: f64 = 589.0;
/// The Fraunhofer G line as the paper rounds it, in nm.
pub const LAMBDA_G_NM: f64 = 431.0;

/// A quantity per wavelength: a radiance, a reflectance or an absorption coefficient.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Spectrum {
    /// The same value at every wavelength.
    Flat(f32),
    /// Straight lines between samples, constant beyond the ends.
    Tabulated {
        /// Wavelengths in nm, strictly increasing.
        lambda_nm: Vec<f32>,
        /// One value per wavelength.
        value: Vec<f32>,
    },
    /// A standard illuminant scaled to luminance 1.
    Illuminant(Illuminant),
    /// A black body scaled to luminance 1.
    BlackBody {
        /// Temperature in kelvin.
        kelvin: f32,
    },
    /// A smooth reflectance that develops to this linear sRGB colour under the equal-energy white.
    Rgb([f32; 3]),
}

/// A CIE standard illuminant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Illuminant {
    /// Daylight, 6504 K.
    D65,
    /// Daylight, 5003 K.
    D50,
    /// Incandescent, 2856 K.
    A,
    /// Equal energy.
    E,
    /// Fluorescent F2.
    F2,
    /// Fluorescent F11.
    F11,
    /// White LED B3.
    LedB3,
}
