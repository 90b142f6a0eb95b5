//! Round brilliants in a scene file.

use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

use super::check::in_range;
use super::fault::{Fault, Under, quoted, suggestion};
use crate::cuts::{RoundBrilliant, StandardProportions};

/// A round brilliant as written: a published set of proportions, and what differs from it.
#[derive(Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct BrilliantEntry {
    proportions: Option<String>,
    diameter_mm: Option<f32>,
    table: Option<f32>,
    crown_angle_degrees: Option<f32>,
    pavilion_angle_degrees: Option<f32>,
    star_length: Option<f32>,
    lower_half_length: Option<f32>,
    girdle_thickness: Option<f32>,
    culet: Option<f32>,
}

impl BrilliantEntry {
    pub(super) fn read(self) -> Result<RoundBrilliant, Fault> {
        let default = RoundBrilliant::default();
        let start = match &self.proportions {
            Some(name) => named(name).under("proportions")?.of_diameter(default.diameter_mm),
            None => default,
        };
        let value = |key: &str, given: Option<f32>, start: f32, range: RangeInclusive<f32>| {
            in_range(key, given.unwrap_or(start), &range)
        };
        let cut = RoundBrilliant {
            diameter_mm: value(
                "diameter_mm",
                self.diameter_mm,
                start.diameter_mm,
                RoundBrilliant::DIAMETER_MM,
            )?,
            table: value("table", self.table, start.table, RoundBrilliant::TABLE)?,
            crown_angle_degrees: value(
                "crown_angle_degrees",
                self.crown_angle_degrees,
                start.crown_angle_degrees,
                RoundBrilliant::CROWN_ANGLE_DEGREES,
            )?,
            pavilion_angle_degrees: value(
                "pavilion_angle_degrees",
                self.pavilion_angle_degrees,
                start.pavilion_angle_degrees,
                RoundBrilliant::PAVILION_ANGLE_DEGREES,
            )?,
            star_length: value(
                "star_length",
                self.star_length,
                start.star_length,
                RoundBrilliant::STAR_LENGTH,
            )?,
            lower_half_length: value(
                "lower_half_length",
                self.lower_half_length,
                start.lower_half_length,
                RoundBrilliant::LOWER_HALF_LENGTH,
            )?,
            girdle_thickness: value(
                "girdle_thickness",
                self.girdle_thickness,
                start.girdle_thickness,
                RoundBrilliant::GIRDLE_THICKNESS,
            )?,
            culet: value("culet", self.culet, start.culet, RoundBrilliant::CULET)?,
        };
        // Proportions can each be possible and yet not close together.
        cut.half_spaces().map_err(|error| Fault::new(error.to_string()))?;
        Ok(cut)
    }

    pub(super) fn write(cut: &RoundBrilliant) -> Self {
        let RoundBrilliant {
            diameter_mm,
            table,
            crown_angle_degrees,
            pavilion_angle_degrees,
            star_length,
            lower_half_length,
            girdle_thickness,
            culet,
        } = cut;
        Self {
            proportions: None,
            diameter_mm: Some(*diameter_mm),
            table: Some(*table),
            crown_angle_degrees: Some(*crown_angle_degrees),
            pavilion_angle_degrees: Some(*pavilion_angle_degrees),
            star_length: Some(*star_length),
            lower_half_length: Some(*lower_half_length),
            girdle_thickness: Some(*girdle_thickness),
            culet: Some(*culet),
        }
    }
}

/// The published set whose name is `name`, or starts with it.
fn named(name: &str) -> Result<StandardProportions, Fault> {
    let wanted = name.trim().to_lowercase();
    let is_named = |set: &StandardProportions| set.name().to_lowercase().starts_with(&wanted);
    StandardProportions::ALL.into_iter().find(is_named).filter(|_| !wanted.is_empty()).ok_or_else(
        || {
            let names = StandardProportions::ALL.map(StandardProportions::name);
            Fault::new(format!("there is no {}; {}", quoted(name), suggestion(name, &names)))
        },
    )
}
