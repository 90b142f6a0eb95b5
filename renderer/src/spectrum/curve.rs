//! A spectrum ready to be evaluated.

use std::borrow::Cow;

use super::black_body::BlackBody;
use super::observer::Observer;
use super::polyline::Polyline;
use super::{Bins, Spectrum, rgb};

/// A [`Spectrum`] with everything solved that does not depend on the wavelength.
#[derive(Clone, Debug)]
pub(super) enum Curve {
    Flat(f32),
    Straight(Cow<'static, Polyline>),
    BlackBody(BlackBody),
}

impl Curve {
    pub(super) fn new(spectrum: &Spectrum) -> Self {
        match spectrum {
            Spectrum::Flat(value) => Self::Flat(*value),
            Spectrum::Tabulated { lambda_nm, value } => {
                let samples = lambda_nm.iter().zip(value);
                let samples = samples.map(|(&lambda_nm, &value)| (lambda_nm.into(), value.into()));
                Self::Straight(Cow::Owned(Polyline::new(samples)))
            }
            Spectrum::Illuminant(illuminant) => Self::Straight(Cow::Borrowed(illuminant.power())),
            Spectrum::BlackBody { kelvin } => Self::BlackBody(BlackBody::new(*kelvin)),
            Spectrum::Rgb(rgb) => Self::Straight(Cow::Owned(rgb::reflectance(*rgb))),
        }
    }

    /// The value at a wavelength in nm.
    pub(super) fn at(&self, lambda_nm: f64) -> f64 {
        match self {
            Self::Flat(value) => f64::from(*value),
            Self::Straight(line) => line.at(lambda_nm),
            Self::BlackBody(body) => body.at(lambda_nm),
        }
    }

    /// The mean over each bin.
    pub(super) fn bin_means(&self, bins: Bins) -> Vec<f32> {
        match self {
            Self::Flat(value) => vec![*value; bins.count()],
            Self::Straight(line) => Self::means(line, bins),
            Self::BlackBody(_) => {
                let knots = Observer::knots().iter();
                let line = Polyline::new(knots.map(|&(lambda, _)| (lambda, self.at(lambda))));
                Self::means(&line, bins)
            }
        }
    }

    fn means(line: &Polyline, bins: Bins) -> Vec<f32> {
        let mean = |(low, high)| (line.integral(low, high) / (high - low)) as f32;
        bins.ranges_nm().map(mean).collect()
    }
}
