//! Light as a function of wavelength: the traced range, the film's bins, spectra, the standard
//! observer and the standard illuminants.

mod bins;
mod black_body;
mod curve;
mod illuminant;
mod locus;
mod observer;
mod polyline;
mod rgb;

pub use bins::Bins;
pub use illuminant::Illuminant;
pub use locus::DominantWavelength;
pub use observer::Observer;

use serde::{Deserialize, Serialize};

use black_body::BlackBody;
use curve::Curve;

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
    /// A smooth reflectance that develops to this linear sRGB colour under the equal-energy white;
    /// linear in the colour.
    Rgb([f32; 3]),
}

impl Spectrum {
    /// The value at a wavelength in nm.
    ///
    /// A black body or a colour is made ready anew in each call (well under a millisecond); for many
    /// wavelengths use [`bin_means`](Self::bin_means).
    pub fn at(&self, lambda_nm: f32) -> f32 {
        self.curve().at(f64::from(lambda_nm)) as f32
    }

    /// The mean over each bin, exact for straight lines and colours; a black body is taken straight
    /// between whole nanometres.
    pub fn bin_means(&self, bins: Bins) -> Vec<f32> {
        self.curve().bin_means(bins)
    }

    /// Checks that the spectrum means something.
    ///
    /// # Errors
    /// Names the fault and the remedy: a number that is not finite or is negative, wavelengths that
    /// do not increase or do not match the values, an impossible temperature or colour.
    pub fn validate(&self) -> Result<(), String> {
        match self {
            Self::Flat(value) if is_quantity(*value) => Ok(()),
            Self::Flat(value) => Err(format!("the value {value} must be a number of 0 or more")),
            Self::Tabulated { lambda_nm, value } => validate_table(lambda_nm, value),
            Self::Illuminant(_) => Ok(()),
            Self::BlackBody { kelvin } if BlackBody::KELVIN.contains(kelvin) => Ok(()),
            Self::BlackBody { kelvin } => Err(format!(
                "the temperature {kelvin} K must lie between {} and {} K",
                BlackBody::KELVIN.start(),
                BlackBody::KELVIN.end()
            )),
            Self::Rgb(rgb) if rgb.iter().all(|channel| (0.0..=1.0).contains(channel)) => Ok(()),
            Self::Rgb(rgb) => {
                Err(format!("each channel of the reflectance {rgb:?} must lie between 0 and 1"))
            }
        }
    }

    /// The spectrum with everything solved that does not depend on the wavelength.
    fn curve(&self) -> Curve {
        Curve::new(self)
    }
}

fn is_quantity(value: f32) -> bool {
    value.is_finite() && value >= 0.0
}

fn validate_table(lambda_nm: &[f32], value: &[f32]) -> Result<(), String> {
    if lambda_nm.len() != value.len() {
        return Err(format!(
            "{} wavelengths but {} values; give one value per wavelength",
            lambda_nm.len(),
            value.len()
        ));
    }
    if lambda_nm.is_empty() {
        return Err("the table is empty; give at least one wavelength and its value".into());
    }
    if let Some(&wrong) = lambda_nm.iter().find(|&&lambda_nm| !is_quantity(lambda_nm)) {
        return Err(format!("the wavelength {wrong} must be a number of nanometres"));
    }
    let mut neighbours = lambda_nm.iter().zip(&lambda_nm[1..]);
    if let Some((before, after)) = neighbours.find(|(before, after)| before >= after) {
        return Err(format!("the wavelength {after} follows {before}; wavelengths must increase"));
    }
    match lambda_nm.iter().zip(value).find(|&(_, &value)| !is_quantity(value)) {
        Some((lambda_nm, wrong)) => {
            Err(format!("the value {wrong} at {lambda_nm} nm must be a number of 0 or more"))
        }
        None => Ok(()),
    }
}
