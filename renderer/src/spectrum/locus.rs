//! The spectrum locus: where the colours of single wavelengths lie among all chromaticities.

use std::sync::LazyLock;

use glam::{DVec2, DVec3};

use super::{LAMBDA_MIN_NM, Observer};
use crate::color;

/// Longest wavelength, in nm, that makes a colour of its own: those beyond all look like it.
const LONGEST_OF_ITS_OWN_NM: u32 = 700;

/// Least distance in x, y from white at which a colour has a hue to speak of.
const LEAST_CHROMA: f64 = 1e-3;

/// Share of a line by which rounding may put a meeting point beyond its end: without it a ray through
/// a corner could slip between two lines.
const ROUNDING: f64 = 1e-9;

/// Each whole nanometre and its chromaticity x, y.
static LOCUS_XY: LazyLock<Vec<(f64, DVec2)>> = LazyLock::new(|| {
    let lambdas_nm = (LAMBDA_MIN_NM as u32..=LONGEST_OF_ITS_OWN_NM).map(f64::from);
    lambdas_nm
        .map(|lambda_nm| (lambda_nm, color::xy(Observer::color_matching_at(lambda_nm))))
        .collect()
});

/// A colour as a mixture of white and one wavelength.
///
/// CIE 15:2004, 9.1; purity in x, y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DominantWavelength {
    /// The wavelength that makes the colour together with white, or for a purple, which no single
    /// wavelength makes, the complementary one that makes white together with the colour, in nm.
    pub lambda_nm: f64,
    /// Whether it is the complementary one.
    pub is_complementary: bool,
    /// Excitation purity: 0 for white, 1 on the spectrum locus or on the line of purples.
    pub purity: f64,
}

impl DominantWavelength {
    /// Of the colour `xyz` beside the white `white`. None for black, and where the colour is so
    /// close to white that it has no hue.
    pub fn of(xyz: DVec3, white: DVec3) -> Option<Self> {
        let white = color::xy(white);
        let offset = color::xy(xyz) - white;
        if !offset.is_finite() || offset.length() < LEAST_CHROMA {
            return None;
        }
        let (violet, red) = (LOCUS_XY.first()?.1, LOCUS_XY.last()?.1);
        if let Some((lambda_nm, reach)) = meet_locus(white, offset) {
            return Some(Self { lambda_nm, is_complementary: false, purity: 1.0 / reach });
        }
        let (reach, _) = meet(white, offset, violet, red)?;
        let (lambda_nm, _) = meet_locus(white, -offset)?;
        Some(Self { lambda_nm, is_complementary: true, purity: 1.0 / reach })
    }
}

/// The wavelength in nm at which the ray from `origin` meets the locus, and how many times
/// `direction` that is away. The farthest, where the ends of the locus are not quite convex.
fn meet_locus(origin: DVec2, direction: DVec2) -> Option<(f64, f64)> {
    let segments = LOCUS_XY.windows(2).filter_map(|ends| {
        let (reach, share) = meet(origin, direction, ends[0].1, ends[1].1)?;
        Some((ends[0].0 + share * (ends[1].0 - ends[0].0), reach))
    });
    segments.max_by(|a, b| a.1.total_cmp(&b.1))
}

/// Where the ray from `origin` meets the line from `start` to `end`: how many times `direction`
/// away, and at which share of the line.
fn meet(origin: DVec2, direction: DVec2, start: DVec2, end: DVec2) -> Option<(f64, f64)> {
    let along = end - start;
    let determinant = direction.perp_dot(along);
    if determinant == 0.0 {
        return None;
    }
    let reach = (start - origin).perp_dot(along) / determinant;
    let share = (start - origin).perp_dot(direction) / determinant;
    let is_on_it = (-ROUNDING..=1.0 + ROUNDING).contains(&share);
    (reach > 0.0 && is_on_it).then(|| (reach, share.clamp(0.0, 1.0)))
}
