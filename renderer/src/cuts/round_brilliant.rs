//! The standard round brilliant.

use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

use super::{Half, StandardProportions, facet};
use crate::error::RendererError;
use crate::solid::HalfSpace;

/// Half the angle between neighbouring mains: 22.5°.
const H: f64 = std::f64::consts::PI / 8.0;
/// Half the angle between neighbouring girdle facets: 11.25°.
const Q: f64 = std::f64::consts::PI / 16.0;

/// Proportions of a round brilliant of 57 facets (58 with a culet) and a girdle of 16 flats.
///
/// The girdle plane is z = 0 and the axis is z; bezels and mains stand at multiples of 45° from +y.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RoundBrilliant {
    /// Diameter at the girdle corners, in millimetres.
    pub diameter_mm: f32,
    /// Table width over diameter, corner to corner.
    pub table: f32,
    /// Angle of the bezel facets from the girdle plane, in degrees.
    pub crown_angle_degrees: f32,
    /// Angle of the pavilion mains from the girdle plane, in degrees.
    pub pavilion_angle_degrees: f32,
    /// Length of the stars over the distance from table edge to girdle.
    pub star_length: f32,
    /// Length of the lower halves over the distance from girdle to culet.
    pub lower_half_length: f32,
    /// Thickness of the girdle at its valleys over diameter.
    pub girdle_thickness: f32,
    /// Width of the culet over diameter, corner to corner; 0 is a point.
    pub culet: f32,
}

/// What follows from the proportions. Lengths are fractions of the diameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundBrilliantMeasures {
    /// Angle of the stars from the girdle plane, in degrees.
    pub star_angle_degrees: f64,
    /// Angle of the upper halves from the girdle plane, in degrees.
    pub upper_half_angle_degrees: f64,
    /// Angle of the lower halves from the girdle plane, in degrees.
    pub lower_half_angle_degrees: f64,
    /// From the girdle's upper edge to the table.
    pub crown_height: f64,
    /// From the girdle's lower edge to the culet.
    pub pavilion_depth: f64,
    /// From table to culet.
    pub total_depth: f64,
}

impl Default for RoundBrilliant {
    /// The Practical Fine Cut at 6.5 mm, about one carat in diamond.
    fn default() -> Self {
        StandardProportions::default().of_diameter(6.5)
    }
}

/// The distances of the construction, in millimetres and radians.
struct Construction {
    /// Radius of the girdle corners.
    girdle_radius: f64,
    /// Half the girdle's thickness: its edges lie at ± this height.
    girdle_half: f64,
    /// Distance of the table's edges from the axis.
    table_apothem: f64,
    table_z: f64,
    bezel_angle: f64,
    star_angle: f64,
    upper_angle: f64,
    lower_angle: f64,
    main_angle: f64,
    /// Height of the culet, plane or point.
    culet_z: f64,
}

impl RoundBrilliant {
    /// Allowed [`diameter_mm`](Self::diameter_mm).
    pub const DIAMETER_MM: RangeInclusive<f32> = 0.5..=100.0;
    /// Allowed [`table`](Self::table).
    pub const TABLE: RangeInclusive<f32> = 0.2..=0.9;
    /// Allowed [`crown_angle_degrees`](Self::crown_angle_degrees).
    pub const CROWN_ANGLE_DEGREES: RangeInclusive<f32> = 5.0..=60.0;
    /// Allowed [`pavilion_angle_degrees`](Self::pavilion_angle_degrees).
    pub const PAVILION_ANGLE_DEGREES: RangeInclusive<f32> = 10.0..=65.0;
    /// Allowed [`star_length`](Self::star_length).
    pub const STAR_LENGTH: RangeInclusive<f32> = 0.05..=0.95;
    /// Allowed [`lower_half_length`](Self::lower_half_length).
    pub const LOWER_HALF_LENGTH: RangeInclusive<f32> = 0.05..=0.95;
    /// Allowed [`girdle_thickness`](Self::girdle_thickness).
    pub const GIRDLE_THICKNESS: RangeInclusive<f32> = 0.001..=0.2;
    /// Allowed [`culet`](Self::culet).
    pub const CULET: RangeInclusive<f32> = 0.0..=0.4;

    /// The planes of all facets: table, 8 stars, 8 bezels, 16 upper halves, 16 girdle flats, 16
    /// lower halves, 8 mains and the culet, if it has a width.
    ///
    /// # Errors
    /// A value outside its range, or stars too short for the table; names the value and the remedy.
    pub fn half_spaces(&self) -> Result<Vec<HalfSpace>, RendererError> {
        let at = self.construct()?;
        let (crown, pavilion) = (Half::Crown, Half::Pavilion);
        let radius = at.girdle_radius;
        let flat = radius * Q.cos();
        let mut facets = vec![facet("table".to_owned(), crown, 0.0, 0.0, (0.0, at.table_z))];
        let mut ring = |name: &str, count: u32, first: f64, half, angle, through| {
            facets.extend((0..count).map(|k| {
                let azimuth = first + std::f64::consts::TAU * f64::from(k) / f64::from(count);
                facet(format!("{name} {}", k + 1), half, angle, azimuth, through)
            }));
        };
        let (upper_edge, lower_edge) = (at.girdle_half, -at.girdle_half);
        ring("star", 8, H, crown, at.star_angle, (at.table_apothem, at.table_z));
        ring("bezel", 8, 0.0, crown, at.bezel_angle, (radius, upper_edge));
        ring("upper half", 16, Q, crown, at.upper_angle, (flat, upper_edge));
        ring("girdle", 16, Q, crown, std::f64::consts::FRAC_PI_2, (flat, 0.0));
        ring("lower half", 16, Q, pavilion, at.lower_angle, (flat, lower_edge));
        ring("main", 8, 0.0, pavilion, at.main_angle, (radius, lower_edge));
        if self.culet > 0.0 {
            facets.push(facet("culet".to_owned(), pavilion, 0.0, 0.0, (0.0, at.culet_z)));
        }
        Ok(facets)
    }

    /// Angles and heights that follow from the proportions.
    ///
    /// # Errors
    /// As [`half_spaces`](Self::half_spaces).
    pub fn measures(&self) -> Result<RoundBrilliantMeasures, RendererError> {
        let at = self.construct()?;
        let diameter = 2.0 * at.girdle_radius;
        Ok(RoundBrilliantMeasures {
            star_angle_degrees: at.star_angle.to_degrees(),
            upper_half_angle_degrees: at.upper_angle.to_degrees(),
            lower_half_angle_degrees: at.lower_angle.to_degrees(),
            crown_height: (at.table_z - at.girdle_half) / diameter,
            pavilion_depth: (-at.girdle_half - at.culet_z) / diameter,
            total_depth: (at.table_z - at.culet_z) / diameter,
        })
    }

    /// Solves for the facets that are not stated: each passes through the meet points that the
    /// stated ones leave.
    fn construct(&self) -> Result<Construction, RendererError> {
        self.check_ranges()?;
        let radius = 0.5 * decimal(self.diameter_mm);
        let girdle_half = radius * decimal(self.girdle_thickness);
        let bezel_angle = decimal(self.crown_angle_degrees).to_radians();
        let main_angle = decimal(self.pavilion_angle_degrees).to_radians();

        let table_radius = radius * decimal(self.table);
        let table_apothem = table_radius * H.cos();
        let star_tip_radius = table_apothem + decimal(self.star_length) * (radius - table_apothem);
        self.check_stars(table_radius / radius)?;
        // Bezels rise from the girdle corners to the table's corners and to the tips of the stars.
        let table_z = girdle_half + (radius - table_radius) * bezel_angle.tan();
        let star_tip_z = girdle_half + (radius - star_tip_radius * H.cos()) * bezel_angle.tan();
        let star_angle = ((table_z - star_tip_z) / (star_tip_radius - table_apothem)).atan();
        let upper_run = (radius - star_tip_radius) * Q.cos();
        let upper_angle = ((star_tip_z - girdle_half) / upper_run).atan();

        let lower_end_radius = (1.0 - decimal(self.lower_half_length)) * radius;
        let lower_drop = (radius - lower_end_radius * H.cos()) * main_angle.tan();
        let lower_angle = (lower_drop / ((radius - lower_end_radius) * Q.cos())).atan();
        let culet_apothem = radius * decimal(self.culet) * H.cos();
        let culet_z = -girdle_half - (radius - culet_apothem) * main_angle.tan();

        Ok(Construction {
            girdle_radius: radius,
            girdle_half,
            table_apothem,
            table_z,
            bezel_angle,
            star_angle,
            upper_angle,
            lower_angle,
            main_angle,
            culet_z,
        })
    }

    fn check_ranges(&self) -> Result<(), RendererError> {
        let values = [
            ("diameter", self.diameter_mm, Self::DIAMETER_MM, " mm"),
            ("table", self.table, Self::TABLE, " of the diameter"),
            ("crown angle", self.crown_angle_degrees, Self::CROWN_ANGLE_DEGREES, "°"),
            ("pavilion angle", self.pavilion_angle_degrees, Self::PAVILION_ANGLE_DEGREES, "°"),
            ("star length", self.star_length, Self::STAR_LENGTH, ""),
            ("lower half length", self.lower_half_length, Self::LOWER_HALF_LENGTH, ""),
            ("girdle thickness", self.girdle_thickness, Self::GIRDLE_THICKNESS, " of the diameter"),
            ("culet", self.culet, Self::CULET, " of the diameter"),
        ];
        for (name, value, range, unit) in values {
            if !range.contains(&value) {
                let (low, high) = range.into_inner();
                return Err(RendererError::Invalid(format!(
                    "round brilliant: the {name} is {value}{unit}; choose {low} to {high}{unit}"
                )));
            }
        }
        Ok(())
    }

    /// The tips of the stars must lie below the table, or the crown has no stars.
    fn check_stars(&self, table: f64) -> Result<(), RendererError> {
        let cos = H.cos();
        let shortest = table * (1.0 - cos * cos) / (cos - table * cos * cos);
        if decimal(self.star_length) > shortest + 1e-3 {
            return Ok(());
        }
        Err(RendererError::Invalid(format!(
            "round brilliant: stars of length {} end above a table of {}; \
             choose a star length of {:.2} or more, or a smaller table",
            self.star_length,
            self.table,
            // Rounded up, so that the advice itself is accepted.
            ((shortest + 2e-3) * 100.0).ceil() / 100.0,
        )))
    }
}

/// The decimal number that `value` stands for: 0.56, not the 0.5600000024 of the nearest `f32`.
///
/// Published proportions are short decimals; this keeps the meet points exact to `f64`.
fn decimal(value: f32) -> f64 {
    value.to_string().parse().unwrap_or(f64::from(value))
}
