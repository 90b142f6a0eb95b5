//! The materials that ship, read once from `assets/materials/materials.toml`.

use std::sync::LazyLock;

use serde::Deserialize;

use super::{Dielectric, Dispersion, SellmeierTerm};

const MATERIALS_TOML: &str = include_str!("../../../assets/materials/materials.toml");

static LIBRARY: LazyLock<Vec<LibraryMaterial>> = LazyLock::new(|| {
    // The text is part of the program, and `shipped_file_parses` reads it.
    parse(MATERIALS_TOML).unwrap_or_else(|fault| unreachable!("materials.toml: {fault}"))
});

/// The materials that ship, in the order of the menu; diamond is the first.
pub fn library() -> &'static [LibraryMaterial] {
    &LIBRARY
}

/// The material of this name or alias; upper and lower case are the same.
pub fn find(name: &str) -> Option<&'static LibraryMaterial> {
    let wanted = name.trim().to_lowercase();
    library()
        .iter()
        .find(|material| material.names().any(|candidate| candidate.to_lowercase() == wanted))
}

/// A material that ships, with what is known of it and by whom.
#[derive(Clone, Debug, PartialEq)]
pub struct LibraryMaterial {
    /// Its name in the menu.
    pub name: String,
    /// Other names that [`find`] accepts.
    pub aliases: Vec<String>,
    /// What kind of thing it is.
    pub category: Category,
    /// Index over wavelength: the measured curve, or a Cauchy curve through the figures.
    pub dispersion: Dispersion,
    /// Where `dispersion` was measured; `None` for a curve through the figures.
    pub measurement: Option<Measurement>,
    /// What gemmologists quote.
    pub figures: Figures,
    /// Variety, ray or temperature, for the user.
    pub note: Option<String>,
}

/// The kind of a library material.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Category {
    /// Found in nature and cut as a gem.
    Gemstone,
    /// Made by people, and cut as a gem.
    Synthetic,
    /// Optical glass.
    Glass,
    /// A liquid.
    Liquid,
}

/// The source of a measured curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    /// Authors, journal, year.
    pub source: String,
    /// The file of the refractiveindex.info database (CC0 1.0) that the coefficients are from.
    pub file: String,
    /// Shortest and longest measured wavelength in nm; the formula carries on beyond.
    pub range_nm: [f64; 2],
}

/// The figures by which gemmologists know a stone.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Figures {
    /// Lowest and highest index at 589 nm; different in a birefringent stone.
    pub index: [f64; 2],
    /// `n_G − n_B`. Handbooks differ.
    pub dispersion_bg: f64,
    /// Where the dispersion is printed.
    pub source: String,
}

impl Figures {
    /// The middle of the two indices.
    pub fn n_d(&self) -> f64 {
        0.5 * (self.index[0] + self.index[1])
    }
}

impl LibraryMaterial {
    /// The solid with the curve of the library, colourless.
    pub fn dielectric(&self) -> Dielectric {
        Dielectric {
            name: self.name.clone(),
            dispersion: self.dispersion.clone(),
            absorption_per_mm: None,
        }
    }

    /// The paper's straight line through the gemmologists' figures.
    pub fn linear(&self) -> Dispersion {
        Dispersion::Linear { n_d: self.figures.n_d(), dispersion_bg: self.figures.dispersion_bg }
    }

    /// The name and the aliases.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        std::iter::once(self.name.as_str()).chain(self.aliases.iter().map(String::as_str))
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct LibraryFile {
    materials: Vec<Entry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    name: String,
    #[serde(default)]
    aliases: Vec<String>,
    category: Category,
    sellmeier: Option<Sellmeier>,
    measured_nm: Option<[f64; 2]>,
    curve_source: Option<String>,
    file: Option<String>,
    note: Option<String>,
    figures: Figures,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Sellmeier {
    constant: f64,
    terms: Vec<SellmeierTerm>,
}

impl TryFrom<Entry> for LibraryMaterial {
    type Error = String;

    fn try_from(entry: Entry) -> Result<Self, String> {
        let in_entry = |fault: &str| format!("{}: {fault}", entry.name);
        let (dispersion, measurement) =
            match (entry.sellmeier, entry.measured_nm, entry.curve_source, entry.file) {
                (Some(Sellmeier { constant, terms }), Some(range_nm), Some(source), Some(file)) => {
                    (
                        Dispersion::Sellmeier { constant, terms },
                        Some(Measurement { source, file, range_nm }),
                    )
                }
                (None, None, None, None) => {
                    let figures = &entry.figures;
                    (Dispersion::cauchy_from(figures.n_d(), figures.dispersion_bg), None)
                }
                _ => return Err(in_entry("a curve needs its range, its source and its file")),
            };
        dispersion.validate().map_err(|fault| in_entry(&fault))?;
        Ok(Self {
            name: entry.name,
            aliases: entry.aliases,
            category: entry.category,
            dispersion,
            measurement,
            figures: entry.figures,
            note: entry.note,
        })
    }
}

fn parse(text: &str) -> Result<Vec<LibraryMaterial>, String> {
    let file: LibraryFile = toml::from_str(text).map_err(|fault| fault.to_string())?;
    file.materials.into_iter().map(LibraryMaterial::try_from).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shipped_file_parses() {
        let materials = parse(MATERIALS_TOML).unwrap();
        assert!(materials.len() >= 25);
        assert_eq!(materials[0].name, "Diamond");
    }

    #[test]
    fn a_curve_without_its_source_is_refused() {
        let text = MATERIALS_TOML.replacen("curve_source = \"F. Peter", "#", 1);
        assert!(parse(&text).unwrap_err().starts_with("Diamond: a curve needs"));
    }
}
