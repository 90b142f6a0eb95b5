//! The standard illuminants.

use std::sync::LazyLock;

use serde::{Deserialize, Serialize};

use super::observer::Observer;
use super::polyline::Polyline;

/// A CIE standard illuminant.
///
/// Relative powers every 5 nm from CIE 15:2018 (`assets/spectra/README.md`), joined by straight
/// lines and scaled to luminance 1 for [`Observer`].
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

impl Illuminant {
    /// Every illuminant, for lists.
    pub const ALL: [Self; 7] =
        [Self::D65, Self::D50, Self::A, Self::E, Self::F2, Self::F11, Self::LedB3];

    /// The illuminant's power over wavelength, scaled to luminance 1.
    pub(super) fn power(self) -> &'static Polyline {
        static POWERS: LazyLock<[Polyline; 7]> =
            LazyLock::new(|| Illuminant::ALL.map(Illuminant::scaled_power));
        &POWERS[self as usize]
    }

    fn scaled_power(self) -> Polyline {
        let table = match self {
            Self::D65 => include_str!("../../../assets/spectra/illuminant_D65.csv"),
            Self::D50 => include_str!("../../../assets/spectra/illuminant_D50.csv"),
            Self::A => include_str!("../../../assets/spectra/illuminant_A.csv"),
            Self::E => "560,1",
            Self::F2 => include_str!("../../../assets/spectra/illuminant_FL2.csv"),
            Self::F11 => include_str!("../../../assets/spectra/illuminant_FL11.csv"),
            Self::LedB3 => include_str!("../../../assets/spectra/illuminant_LED_B3.csv"),
        };
        let [power] = Polyline::from_csv(table);
        let luminance = Observer::xyz_of(|lambda_nm| power.at(lambda_nm)).y;
        power.scaled(1.0 / luminance)
    }
}
