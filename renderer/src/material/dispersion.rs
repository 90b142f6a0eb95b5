//! Index of refraction as a function of wavelength.

use std::cmp::Ordering::Greater;

use serde::{Deserialize, Serialize};

use crate::spectrum::{LAMBDA_B_NM, LAMBDA_D_NM, LAMBDA_G_NM, LAMBDA_MAX_NM, LAMBDA_MIN_NM};

/// The helium d line, in nm.
const LAMBDA_HELIUM_D_NM: f64 = 587.56;
/// The Fraunhofer F line, in nm.
const LAMBDA_F_NM: f64 = 486.13;
/// The Fraunhofer C line, in nm.
const LAMBDA_C_NM: f64 = 656.27;

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
    /// `n = n_D − δ·(λ − λ_D)/(λ_B − λ_G)` (Thomas 1986).
    Linear {
        /// Index at the D line.
        n_d: f64,
        /// δ, the difference `n_G − n_B`.
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

impl Dispersion {
    /// Lowest and highest index that [`validate`](Self::validate) lets pass.
    pub const INDEX: std::ops::RangeInclusive<f64> = 1.0..=5.0;

    /// Index of refraction at `lambda_nm`. Finite over 380–730 nm for a validated model.
    pub fn n(&self, lambda_nm: f64) -> f64 {
        match self {
            Self::Linear { n_d, dispersion_bg } => {
                n_d - dispersion_bg * (lambda_nm - LAMBDA_D_NM) / (LAMBDA_B_NM - LAMBDA_G_NM)
            }
            Self::Cauchy { a, b_nm2 } => a + b_nm2 / (lambda_nm * lambda_nm),
            Self::Sellmeier { constant, terms } => {
                let lambda_um2 = (lambda_nm * 1e-3).powi(2);
                let sum: f64 = terms
                    .iter()
                    .map(|term| term.strength * lambda_um2 / (lambda_um2 - term.resonance_um2))
                    .sum();
                (1.0 + constant + sum).sqrt()
            }
            Self::Tabulated { lambda_nm: nodes, n } => interpolate(nodes, n, lambda_nm),
        }
    }

    /// Index at the sodium D line (589 nm).
    pub fn n_d(&self) -> f64 {
        self.n(LAMBDA_D_NM)
    }

    /// The gemmologist's dispersion `n_G − n_B`, at the paper's rounded lines (431 and 687 nm).
    pub fn dispersion_bg(&self) -> f64 {
        match self {
            // The figure itself, not what rounding leaves of it.
            Self::Linear { dispersion_bg, .. } => *dispersion_bg,
            _ => self.n(LAMBDA_G_NM) - self.n(LAMBDA_B_NM),
        }
    }

    /// The Abbe number `V_d = (n_d − 1)/(n_F − n_C)`, with d 587.56, F 486.13 and C 656.27 nm;
    /// infinite without dispersion.
    pub fn abbe_number(&self) -> f64 {
        let mean_dispersion = self.n(LAMBDA_F_NM) - self.n(LAMBDA_C_NM);
        if mean_dispersion == 0.0 {
            f64::INFINITY
        } else {
            (self.n(LAMBDA_HELIUM_D_NM) - 1.0) / mean_dispersion
        }
    }

    /// The two-term Cauchy curve that has the index `n_d` at 589 nm and the difference
    /// `dispersion_bg` between 431 and 687 nm.
    pub fn cauchy_from(n_d: f64, dispersion_bg: f64) -> Self {
        let b_nm2 = dispersion_bg / (LAMBDA_G_NM.powi(-2) - LAMBDA_B_NM.powi(-2));
        Self::Cauchy { a: n_d - b_nm2 / LAMBDA_D_NM.powi(2), b_nm2 }
    }

    /// This curve moved to the index `n_d` and stretched to `n_G − n_B = dispersion_bg`.
    ///
    /// Linear and Cauchy curves stay what they are. A measured curve keeps its shape:
    /// `n(λ) = n_D′ + (n(λ) − n_D)·δ′/δ`, sampled every nanometre; one without any dispersion has
    /// no shape to keep and becomes a Cauchy curve.
    #[must_use]
    pub fn rescaled(&self, n_d: f64, dispersion_bg: f64) -> Self {
        match self {
            Self::Linear { .. } => Self::Linear { n_d, dispersion_bg },
            Self::Sellmeier { .. } | Self::Tabulated { .. } if self.dispersion_bg() != 0.0 => {
                let (old_n_d, stretch) = (self.n_d(), dispersion_bg / self.dispersion_bg());
                let lambda_nm: Vec<f64> = traced_nanometres().collect();
                let n = lambda_nm.iter().map(|&l| n_d + (self.n(l) - old_n_d) * stretch).collect();
                Self::Tabulated { lambda_nm, n }
            }
            Self::Cauchy { .. } | Self::Sellmeier { .. } | Self::Tabulated { .. } => {
                Self::cauchy_from(n_d, dispersion_bg)
            }
        }
    }

    /// Checks that the index is finite and in 1..=5 at every traced wavelength, and that a table
    /// is well formed.
    ///
    /// # Errors
    /// What is wrong, where, and what is allowed.
    pub fn validate(&self) -> Result<(), String> {
        match self {
            Self::Linear { .. } | Self::Cauchy { .. } => {}
            Self::Sellmeier { terms, .. } => validate_resonances(terms)?,
            Self::Tabulated { lambda_nm, n } => validate_table(lambda_nm, n)?,
        }
        let (low, high) = (f64::from(LAMBDA_MIN_NM), f64::from(LAMBDA_MAX_NM));
        let nodes = match self {
            Self::Tabulated { lambda_nm, .. } => lambda_nm.as_slice(),
            _ => &[],
        };
        let inner_nodes = nodes.iter().copied().filter(|node| (low..=high).contains(node));
        for lambda_nm in traced_nanometres().chain(inner_nodes) {
            let n = self.n(lambda_nm);
            if !Self::INDEX.contains(&n) {
                return Err(format!(
                    "the index of refraction is {n:.4} at {lambda_nm} nm; it must be from {} to \
                     {} all over {low}–{high} nm",
                    Self::INDEX.start(),
                    Self::INDEX.end(),
                ));
            }
        }
        Ok(())
    }
}

/// Every whole nanometre of the traced range.
fn traced_nanometres() -> impl Iterator<Item = f64> {
    (LAMBDA_MIN_NM as u32..=LAMBDA_MAX_NM as u32).map(f64::from)
}

/// Straight lines between the nodes, extended straight beyond the ends. A table too short to be
/// valid gives its one value, or 1.
fn interpolate(lambda_nm: &[f64], n: &[f64], at_nm: f64) -> f64 {
    let count = lambda_nm.len().min(n.len());
    if count < 2 {
        return n.first().copied().unwrap_or(1.0);
    }
    let upper = lambda_nm[..count].partition_point(|&node| node <= at_nm).clamp(1, count - 1);
    let t = (at_nm - lambda_nm[upper - 1]) / (lambda_nm[upper] - lambda_nm[upper - 1]);
    n[upper - 1] + (n[upper] - n[upper - 1]) * t
}

/// A resonance inside the traced range would be a pole of the index.
fn validate_resonances(terms: &[SellmeierTerm]) -> Result<(), String> {
    let um2 = |lambda_nm: f32| (f64::from(lambda_nm) * 1e-3).powi(2);
    let traced = um2(LAMBDA_MIN_NM)..=um2(LAMBDA_MAX_NM);
    match terms.iter().find(|term| traced.contains(&term.resonance_um2)) {
        Some(term) => Err(format!(
            "a Sellmeier resonance of {} µm² lies inside the visible range; it must be below \
             {:.4} or above {:.4} µm² (the square of a wavelength in µm)",
            term.resonance_um2,
            traced.start(),
            traced.end(),
        )),
        None => Ok(()),
    }
}

fn validate_table(lambda_nm: &[f64], n: &[f64]) -> Result<(), String> {
    if lambda_nm.len() != n.len() {
        return Err(format!(
            "the table has {} wavelengths but {} indices; give one index per wavelength",
            lambda_nm.len(),
            n.len()
        ));
    }
    if lambda_nm.len() < 2 {
        return Err("the table needs at least two wavelengths".to_owned());
    }
    // A difference that is not greater than zero is also one that is NaN.
    match lambda_nm.windows(2).find(|pair| pair[1].partial_cmp(&pair[0]) != Some(Greater)) {
        Some(pair) => {
            Err(format!("the wavelengths must increase, but {} nm follows {} nm", pair[1], pair[0]))
        }
        None => Ok(()),
    }
}
