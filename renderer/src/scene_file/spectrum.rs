//! Spectra in a scene file: a number, the name of an illuminant, or a table.

use serde::de::value::MapAccessDeserializer;
use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use super::check::{choose, exactly_one};
use super::fault::Fault;
use crate::spectrum::{Illuminant, Spectrum};

/// Names of the illuminants.
const ILLUMINANTS: [(&str, Illuminant); 7] = [
    ("D65", Illuminant::D65),
    ("D50", Illuminant::D50),
    ("A", Illuminant::A),
    ("E", Illuminant::E),
    ("F2", Illuminant::F2),
    ("F11", Illuminant::F11),
    ("LED-B3", Illuminant::LedB3),
];

/// What a spectrum stands for, which bounds its values.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Quantity {
    /// The spectrum of a light, 0 or greater.
    Light,
    /// A reflectance, 0..=1.
    Reflectance,
    /// An absorption coefficient, 0 or greater.
    Absorption,
}

/// A spectrum as written.
#[derive(Serialize)]
#[serde(untagged)]
pub(super) enum SpectrumEntry {
    /// The same at every wavelength.
    Flat(f32),
    /// The name of an illuminant.
    Named(String),
    /// Anything else.
    Table(SpectrumTable),
}

/// The forms that need a table; exactly one of them.
#[derive(Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SpectrumTable {
    kelvin: Option<f32>,
    linear_srgb: Option<[f32; 3]>,
    lambda_nm: Option<Vec<f32>>,
    value: Option<Vec<f32>>,
}

impl<'de> Deserialize<'de> for SpectrumEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Forms;

        impl<'de> Visitor<'de> for Forms {
            type Value = SpectrumEntry;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str(
                    "a number, the name of an illuminant, or a table with `kelvin`, \
                     `linear_srgb`, or `lambda_nm` and `value`",
                )
            }

            fn visit_f64<E: Error>(self, value: f64) -> Result<SpectrumEntry, E> {
                let single = value as f32;
                if single.is_finite() {
                    Ok(SpectrumEntry::Flat(single))
                } else {
                    Err(E::custom(format!("{value:?} is too large a number")))
                }
            }

            fn visit_i64<E: Error>(self, value: i64) -> Result<SpectrumEntry, E> {
                Ok(SpectrumEntry::Flat(value as f32))
            }

            fn visit_str<E>(self, name: &str) -> Result<SpectrumEntry, E> {
                Ok(SpectrumEntry::Named(name.to_owned()))
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<SpectrumEntry, A::Error> {
                SpectrumTable::deserialize(MapAccessDeserializer::new(map))
                    .map(SpectrumEntry::Table)
            }
        }

        deserializer.deserialize_any(Forms)
    }
}

impl SpectrumEntry {
    pub(super) fn read(self, quantity: Quantity) -> Result<Spectrum, Fault> {
        let spectrum = match self {
            Self::Flat(value) => Spectrum::Flat(value),
            Self::Named(name) => Spectrum::Illuminant(choose(&name, &ILLUMINANTS)?),
            Self::Table(table) => table.read()?,
        };
        spectrum.validate().map_err(Fault::new)?;
        let values = match &spectrum {
            Spectrum::Flat(value) => std::slice::from_ref(value),
            Spectrum::Tabulated { value, .. } => value.as_slice(),
            Spectrum::Rgb(rgb) => rgb.as_slice(),
            Spectrum::Illuminant(_) | Spectrum::BlackBody { .. } if quantity == Quantity::Light => {
                &[]
            }
            Spectrum::Illuminant(_) | Spectrum::BlackBody { .. } => {
                return Err(Fault::new(
                    "this is the spectrum of a light; give a number or a table of values",
                ));
            }
        };
        match values.iter().find(|&&value| quantity == Quantity::Reflectance && value > 1.0) {
            Some(value) => Err(Fault::new(format!("found {value}; a reflectance is 0 to 1"))),
            None => Ok(spectrum),
        }
    }

    pub(super) fn write(spectrum: &Spectrum) -> Self {
        match spectrum {
            Spectrum::Flat(value) => Self::Flat(*value),
            Spectrum::Illuminant(illuminant) => Self::Named(illuminant_name(*illuminant).into()),
            Spectrum::BlackBody { kelvin } => {
                Self::Table(SpectrumTable { kelvin: Some(*kelvin), ..SpectrumTable::default() })
            }
            Spectrum::Rgb(rgb) => {
                Self::Table(SpectrumTable { linear_srgb: Some(*rgb), ..SpectrumTable::default() })
            }
            Spectrum::Tabulated { lambda_nm, value } => Self::Table(SpectrumTable {
                lambda_nm: Some(lambda_nm.clone()),
                value: Some(value.clone()),
                ..SpectrumTable::default()
            }),
        }
    }
}

impl SpectrumTable {
    fn read(self) -> Result<Spectrum, Fault> {
        let has_samples = self.lambda_nm.is_some() || self.value.is_some();
        exactly_one(&[
            ("kelvin", self.kelvin.is_some()),
            ("linear_srgb", self.linear_srgb.is_some()),
            ("lambda_nm", has_samples),
        ])?;
        if let Some(kelvin) = self.kelvin {
            return Ok(Spectrum::BlackBody { kelvin });
        }
        if let Some(rgb) = self.linear_srgb {
            return Ok(Spectrum::Rgb(rgb));
        }
        let samples = |key: &str, samples: Option<Vec<f32>>| {
            samples.ok_or_else(|| Fault::at(key, "this key is missing"))
        };
        Ok(Spectrum::Tabulated {
            lambda_nm: samples("lambda_nm", self.lambda_nm)?,
            value: samples("value", self.value)?,
        })
    }
}

fn illuminant_name(illuminant: Illuminant) -> &'static str {
    match illuminant {
        Illuminant::D65 => "D65",
        Illuminant::D50 => "D50",
        Illuminant::A => "A",
        Illuminant::E => "E",
        Illuminant::F2 => "F2",
        Illuminant::F11 => "F11",
        Illuminant::LedB3 => "LED-B3",
    }
}
