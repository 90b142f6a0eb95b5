//! Index of refraction as a function of wavelength.

use serde::{Deserialize, Serialize};

/// One term B·λ²/(λ² − C²) of a Sellmeier formula, λ in µm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SellmeierTerm {
    /// Strength B.
    pub strength: f64,
    /// Resonance wavelength squared, C², in µm².
    pub resonance_um2: f64,
}

/// A dispersion model n(λ).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Dispersion {
    /// n = n_D − δ·(λ − λ_D)/(λ_B − λ_G) (Thomas 1986).
    Linear {
        /// Index at the D line.
        n_d: f64,
        /// n_G − n_B.
        dispersion_bg: f64,
    },
    /// n = A + B/λ², λ in nm.
    Cauchy {
        /// A.
        a: f64,
        /// B in nm².
        b_nm2: f64,
    },
    /// n² = 1 + constant + Σ B·λ²/(λ² − C²), λ in µm.
    Sellmeier {
        /// The constant beside the 1.
        constant: f64,
        /// The terms.
        terms: Vec<SellmeierTerm>,
    },
    /// Straight lines between measured values, extended straight beyond the ends.
    Tabulated {
        /// Wavelengths in nm, strictly increasing, at least two.
        lambda_nm: Vec<f64>,
        /// Index per wavelength.
        n: Vec<f64>,
    },
}
