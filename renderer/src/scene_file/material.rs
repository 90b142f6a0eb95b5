//! Materials in a scene file.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::check::{choose, exactly_one};
use super::fault::{Fault, Under, quoted, suggestion};
use super::print::{ImageFiles, PrintEntry};
use super::spectrum::{Quantity, SpectrumEntry};
use crate::material::{
    Dielectric, Diffuse, Dispersion, LibraryMaterial, Material, SellmeierTerm, find, library,
};

/// A material as written: a clear one by `library`, `curve` or coefficients, or a `diffuse` one.
#[derive(Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MaterialEntry {
    name: Option<String>,
    /// Name of a library material.
    library: Option<String>,
    /// `measured`, `linear` or `cauchy`.
    curve: Option<String>,
    /// Index at 589 nm, instead of the curve's.
    n_d: Option<f64>,
    /// `n_G − n_B`, instead of the curve's.
    dispersion_bg: Option<f64>,
    cauchy: Option<CauchyEntry>,
    sellmeier: Option<SellmeierEntry>,
    tabulated: Option<TabulatedEntry>,
    absorption_per_mm: Option<SpectrumEntry>,
    diffuse: Option<SpectrumEntry>,
    /// An image on a `diffuse` surface.
    print: Option<PrintEntry>,
}

#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct CauchyEntry {
    a: f64,
    b_nm2: f64,
}

#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct SellmeierEntry {
    #[serde(default)]
    constant: f64,
    terms: Vec<SellmeierTermEntry>,
}

#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct SellmeierTermEntry {
    strength: f64,
    resonance_um2: f64,
}

#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct TabulatedEntry {
    lambda_nm: Vec<f64>,
    n: Vec<f64>,
}

/// The form of n(λ) that `curve` asks for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Curve {
    Measured,
    Linear,
    Cauchy,
}

const CURVES: [(&str, Curve); 3] =
    [("measured", Curve::Measured), ("linear", Curve::Linear), ("cauchy", Curve::Cauchy)];

impl MaterialEntry {
    pub(super) fn read(mut self, images: &mut ImageFiles) -> Result<Material, Fault> {
        if let Some(reflectance) = self.diffuse.take() {
            self.refuse_clear_keys()?;
            let reflectance = reflectance.read(Quantity::Reflectance).under("diffuse")?;
            let print = self.print.map(|print| print.read(images)).transpose().under("print")?;
            return Ok(Material::Diffuse(Diffuse { reflectance, print }));
        }
        if self.print.is_some() {
            return Err(Fault::at("print", "only what is matte is printed on; give `diffuse` too"));
        }
        let absorption_per_mm = self
            .absorption_per_mm
            .take()
            .map(|absorption| absorption.read(Quantity::Absorption).under("absorption_per_mm"))
            .transpose()?;
        let library_material = self.library.take().map(|name| named(&name)).transpose()?;
        let name = match (self.name.take(), library_material) {
            (Some(name), _) => name,
            (None, Some(material)) => material.name.clone(),
            (None, None) => "Custom".to_owned(),
        };
        let dispersion = self.read_dispersion(library_material)?;
        dispersion.validate().map_err(Fault::new)?;
        Ok(Material::Dielectric(Dielectric { name, dispersion, absorption_per_mm }))
    }

    /// A matte surface has no keys of a clear solid.
    fn refuse_clear_keys(&self) -> Result<(), Fault> {
        let keys = [
            ("name", self.name.is_some()),
            ("library", self.library.is_some()),
            ("curve", self.curve.is_some()),
            ("n_d", self.n_d.is_some()),
            ("dispersion_bg", self.dispersion_bg.is_some()),
            ("cauchy", self.cauchy.is_some()),
            ("sellmeier", self.sellmeier.is_some()),
            ("tabulated", self.tabulated.is_some()),
            ("absorption_per_mm", self.absorption_per_mm.is_some()),
        ];
        match keys.iter().find(|(_, is_there)| *is_there) {
            Some((key, _)) => Err(Fault::at(
                key,
                "this is for clear materials; beside `diffuse` only `print` may stand",
            )),
            None => Ok(()),
        }
    }

    fn read_dispersion(self, library: Option<&LibraryMaterial>) -> Result<Dispersion, Fault> {
        let curve = match &self.curve {
            Some(text) => Some(choose(text, &CURVES).under("curve")?),
            None => None,
        };
        let is_figures = library.is_none() && curve.is_some();
        exactly_one(&[
            ("library", library.is_some()),
            ("curve", is_figures),
            ("cauchy", self.cauchy.is_some()),
            ("sellmeier", self.sellmeier.is_some()),
            ("tabulated", self.tabulated.is_some()),
            ("diffuse", false),
        ])?;
        let (n_d, dispersion_bg) = (self.n_d, self.dispersion_bg);
        if is_figures {
            let figure = |key: &str, value: Option<f64>| {
                value.ok_or_else(|| {
                    Fault::at(key, "this key is missing; a curve without a library needs it")
                })
            };
            let (n_d, dispersion_bg) =
                (figure("n_d", n_d)?, figure("dispersion_bg", dispersion_bg)?);
            return match curve {
                Some(Curve::Linear) => Ok(Dispersion::Linear { n_d, dispersion_bg }),
                Some(Curve::Cauchy) => Ok(Dispersion::cauchy_from(n_d, dispersion_bg)),
                Some(Curve::Measured) | None => Err(Fault::at(
                    "curve",
                    "a measured curve is one of the library; give `library`, or \"linear\" or \
                     \"cauchy\" here",
                )),
            };
        }
        let base = match library {
            Some(material) => of_library(material, curve.unwrap_or(Curve::Measured)),
            None => self.read_coefficients()?,
        };
        Ok(with_figures(&base, n_d, dispersion_bg))
    }

    fn read_coefficients(self) -> Result<Dispersion, Fault> {
        if let Some(CauchyEntry { a, b_nm2 }) = self.cauchy {
            return Ok(Dispersion::Cauchy { a, b_nm2 });
        }
        let (key, dispersion) = match (self.sellmeier, self.tabulated) {
            (Some(SellmeierEntry { constant, terms }), _) => {
                let terms = terms.into_iter().map(SellmeierTermEntry::read).collect();
                ("sellmeier", Dispersion::Sellmeier { constant, terms })
            }
            (None, Some(TabulatedEntry { lambda_nm, n })) => {
                ("tabulated", Dispersion::Tabulated { lambda_nm, n })
            }
            (None, None) => return Err(Fault::new("the material has no index of refraction")),
        };
        // A malformed table must be found before it is rescaled.
        dispersion.validate().map_err(|message| Fault::at(key, message))?;
        Ok(dispersion)
    }

    /// Paths are written relative to `base`.
    pub(super) fn write(material: &Material, base: &Path) -> Self {
        match material {
            Material::Diffuse(Diffuse { reflectance, print }) => Self {
                diffuse: Some(SpectrumEntry::write(reflectance)),
                print: print.as_ref().and_then(|print| PrintEntry::write(print, base)),
                ..Self::default()
            },
            Material::Dielectric(Dielectric { name, dispersion, absorption_per_mm }) => Self {
                absorption_per_mm: absorption_per_mm.as_ref().map(SpectrumEntry::write),
                ..Self::write_clear(name, dispersion)
            },
        }
    }

    fn write_clear(name: &str, dispersion: &Dispersion) -> Self {
        let entry = Self { name: Some(name.to_owned()), ..Self::default() };
        match (find(name), dispersion) {
            (Some(material), _) if material.name == name && material.dispersion == *dispersion => {
                Self { library: Some(name.to_owned()), ..Self::default() }
            }
            (_, Dispersion::Linear { n_d, dispersion_bg }) => Self {
                curve: Some("linear".to_owned()),
                n_d: Some(*n_d),
                dispersion_bg: Some(*dispersion_bg),
                ..entry
            },
            (_, Dispersion::Cauchy { a, b_nm2 }) => {
                Self { cauchy: Some(CauchyEntry { a: *a, b_nm2: *b_nm2 }), ..entry }
            }
            (_, Dispersion::Sellmeier { constant, terms }) => {
                let terms = terms.iter().map(SellmeierTermEntry::write).collect();
                Self { sellmeier: Some(SellmeierEntry { constant: *constant, terms }), ..entry }
            }
            (material, Dispersion::Tabulated { lambda_nm, n }) => {
                let stretched = material
                    .filter(|material| material.name == name)
                    .and_then(|material| stretched_figures(material, dispersion));
                if let Some((n_d, dispersion_bg)) = stretched {
                    let (n_d, dispersion_bg) = (Some(n_d), Some(dispersion_bg));
                    Self { library: Some(name.to_owned()), n_d, dispersion_bg, ..Self::default() }
                } else {
                    let (lambda_nm, n) = (lambda_nm.clone(), n.clone());
                    Self { tabulated: Some(TabulatedEntry { lambda_nm, n }), ..entry }
                }
            }
        }
    }
}

impl SellmeierTermEntry {
    fn read(self) -> SellmeierTerm {
        SellmeierTerm { strength: self.strength, resonance_um2: self.resonance_um2 }
    }

    fn write(term: &SellmeierTerm) -> Self {
        Self { strength: term.strength, resonance_um2: term.resonance_um2 }
    }
}

fn named(name: &str) -> Result<&'static LibraryMaterial, Fault> {
    find(name).ok_or_else(|| {
        let names: Vec<&str> = library().iter().map(|material| material.name.as_str()).collect();
        Fault::at(
            "library",
            format!("the library has no {}; {}", quoted(name), suggestion(name, &names)),
        )
    })
}

fn of_library(material: &LibraryMaterial, curve: Curve) -> Dispersion {
    match curve {
        Curve::Measured => material.dispersion.clone(),
        Curve::Linear => material.linear(),
        Curve::Cauchy => {
            Dispersion::cauchy_from(material.figures.n_d(), material.figures.dispersion_bg)
        }
    }
}

/// The curve through those figures that are given; its own where they are not.
fn with_figures(base: &Dispersion, n_d: Option<f64>, dispersion_bg: Option<f64>) -> Dispersion {
    if n_d.is_none() && dispersion_bg.is_none() {
        return base.clone();
    }
    base.rescaled(
        n_d.unwrap_or_else(|| base.n_d()),
        dispersion_bg.unwrap_or_else(|| base.dispersion_bg()),
    )
}

/// The shortest figures to which the library's curve must be rescaled to give exactly `table`.
fn stretched_figures(material: &LibraryMaterial, table: &Dispersion) -> Option<(f64, f64)> {
    let (n_d, dispersion_bg) = (table.n_d(), table.dispersion_bg());
    // Rounding in the table hides the last digits of its dispersion.
    (2..=15)
        .map(|decimals| round_to(dispersion_bg, decimals))
        .find(|&candidate| material.dispersion.rescaled(n_d, candidate) == *table)
        .map(|dispersion_bg| (n_d, dispersion_bg))
}

fn round_to(value: f64, decimals: i32) -> f64 {
    let scale = 10.0_f64.powi(decimals);
    (value * scale).round() / scale
}
