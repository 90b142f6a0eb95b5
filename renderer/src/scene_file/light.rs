//! Lights in a scene file.

use glam::Vec3;
use serde::{Deserialize, Serialize};

use super::angle;
use super::check::{choose, exactly_one, in_range, not_negative, unit_vector};
use super::fault::{Fault, Under};
use super::spectrum::{Quantity, SpectrumEntry};
use crate::light::{DiscLight, Lights, SkyLight};
use crate::rigs::rigs;
use crate::spectrum::{Illuminant, Spectrum};

/// Allowed angular radius of a disc, in degrees.
const RADIUS_DEGREES: std::ops::RangeInclusive<f64> = 0.001..=90.0;
/// Allowed half-angle of the observer's shadow, in degrees.
const SHADOW_DEGREES: std::ops::RangeInclusive<f64> = 0.0..=90.0;

/// All lights as written: a rig by name, or each light.
#[derive(Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct LightsEntry {
    rig: Option<String>,
    observer_shadow_degrees: Option<f64>,
    hemisphere: Option<SkyEntry>,
    environment: Option<SkyEntry>,
    backdrop: Option<SkyEntry>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    discs: Vec<DiscEntry>,
}

#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct SkyEntry {
    #[serde(default = "one")]
    radiance: f32,
    #[serde(default = "daylight")]
    spectrum: SpectrumEntry,
}

#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct DiscEntry {
    name: Option<String>,
    azimuth_degrees: Option<f64>,
    elevation_degrees: Option<f64>,
    direction: Option<[f32; 3]>,
    radius_degrees: f64,
    radiance: Option<f32>,
    irradiance: Option<f32>,
    #[serde(default = "daylight")]
    spectrum: SpectrumEntry,
}

fn one() -> f32 {
    1.0
}

fn daylight() -> SpectrumEntry {
    SpectrumEntry::write(&Spectrum::Illuminant(Illuminant::D65))
}

impl LightsEntry {
    pub(super) fn read(self) -> Result<Lights, Fault> {
        if let Some(rig) = &self.rig {
            let is_alone = self.observer_shadow_degrees.is_none()
                && self.hemisphere.is_none()
                && self.environment.is_none()
                && self.backdrop.is_none()
                && self.discs.is_empty();
            if !is_alone {
                return Err(Fault::at("rig", "a rig is all the lights; give no others beside it"));
            }
            let rigs: Vec<_> = rigs().iter().map(|rig| (rig.name, rig.lights)).collect();
            return choose(rig, &rigs).under("rig").map(|lights| lights());
        }
        let sky = |key: &str, entry: Option<SkyEntry>| {
            entry.map(|entry| entry.read().under(key)).transpose()
        };
        let shadow = self.observer_shadow_degrees.unwrap_or(0.0);
        let shadow = in_range("observer_shadow_degrees", shadow, &SHADOW_DEGREES)?;
        Ok(Lights {
            discs: self
                .discs
                .into_iter()
                .enumerate()
                .map(|(index, disc)| disc.read(index).under(index).under("discs"))
                .collect::<Result<_, _>>()?,
            hemisphere: sky("hemisphere", self.hemisphere)?,
            environment: sky("environment", self.environment)?,
            observer_shadow_radians: angle::radians(shadow),
            backdrop: sky("backdrop", self.backdrop)?,
        })
    }

    pub(super) fn write(lights: &Lights) -> Self {
        let Lights { discs, hemisphere, environment, observer_shadow_radians, backdrop } = lights;
        Self {
            rig: None,
            observer_shadow_degrees: Some(angle::degrees(*observer_shadow_radians)),
            hemisphere: hemisphere.as_ref().map(SkyEntry::write),
            environment: environment.as_ref().map(SkyEntry::write),
            backdrop: backdrop.as_ref().map(SkyEntry::write),
            discs: discs.iter().map(DiscEntry::write).collect(),
        }
    }
}

impl SkyEntry {
    fn read(self) -> Result<SkyLight, Fault> {
        Ok(SkyLight {
            radiance: not_negative("radiance", self.radiance)?,
            spectrum: self.spectrum.read(Quantity::Light).under("spectrum")?,
        })
    }

    fn write(sky: &SkyLight) -> Self {
        Self { radiance: sky.radiance, spectrum: SpectrumEntry::write(&sky.spectrum) }
    }
}

impl DiscEntry {
    fn read(self, index: usize) -> Result<DiscLight, Fault> {
        exactly_one(&[
            ("radiance", self.radiance.is_some()),
            ("irradiance", self.irradiance.is_some()),
        ])?;
        let radius = in_range("radius_degrees", self.radius_degrees, &RADIUS_DEGREES)?;
        let direction = self.read_direction()?;
        let mut disc = DiscLight {
            name: self.name.unwrap_or_else(|| format!("Light {}", index + 1)),
            direction,
            angular_radius_radians: angle::radians(radius),
            radiance: not_negative("radiance", self.radiance.unwrap_or(0.0))?,
            spectrum: self.spectrum.read(Quantity::Light).under("spectrum")?,
        };
        if let Some(irradiance) = self.irradiance {
            let irradiance = not_negative("irradiance", irradiance)?;
            disc.radiance = irradiance / disc.solid_angle_steradians();
            if !disc.radiance.is_finite() {
                return Err(Fault::at("irradiance", format!("{irradiance} is too large a number")));
            }
        }
        Ok(disc)
    }

    fn read_direction(&self) -> Result<Vec3, Fault> {
        let has_angles = self.azimuth_degrees.is_some() || self.elevation_degrees.is_some();
        exactly_one(&[("direction", self.direction.is_some()), ("elevation_degrees", has_angles)])?;
        if let Some(direction) = self.direction {
            return unit_vector("direction", direction);
        }
        let elevation = self
            .elevation_degrees
            .ok_or_else(|| Fault::at("elevation_degrees", "this key is missing"))?;
        let elevation = in_range("elevation_degrees", elevation, &(-90.0..=90.0))?;
        let azimuth = self.azimuth_degrees.unwrap_or(0.0);
        let azimuth = in_range("azimuth_degrees", azimuth, &(-360.0..=360.0))?;
        Ok(angle::direction(azimuth, elevation))
    }

    fn write(disc: &DiscLight) -> Self {
        let angles = angle::azimuth_elevation(disc.direction);
        Self {
            name: Some(disc.name.clone()),
            azimuth_degrees: angles.map(|(azimuth, _)| azimuth),
            elevation_degrees: angles.map(|(_, elevation)| elevation),
            direction: if angles.is_some() { None } else { Some(disc.direction.to_array()) },
            radius_degrees: angle::degrees(disc.angular_radius_radians),
            radiance: Some(disc.radiance),
            irradiance: None,
            spectrum: SpectrumEntry::write(&disc.spectrum),
        }
    }
}
