//! The standard round brilliant.

use serde::{Deserialize, Serialize};

/// Proportions of a round brilliant of 57 facets (58 with a culet).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RoundBrilliant {
    /// Diameter at the girdle corners, in millimetres.
    pub diameter_mm: f32,
    /// Table width over diameter.
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
    /// Width of the culet over diameter; 0 is a point.
    pub culet: f32,
}
