//! What one measures on a body with a gauge: widths, heights, depths.

use super::body::FacetedBody;
use super::facet_class::{FacetClass, Zone};

/// A facet is part of the table or the culet if it is flatter than this, in degrees.
const FLAT_DEGREES: f64 = 0.01;

/// Sizes of a body in mm; a part it does not have is `None`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyMeasures {
    /// Size along x.
    pub width: f64,
    /// Size along y.
    pub length: f64,
    /// From the highest point to the lowest.
    pub depth: f64,
    /// Ends of the table along x and along y.
    pub table: Option<[[f64; 2]; 2]>,
    /// Lowest and highest point.
    pub z: [f64; 2],
    /// Lower and upper end of the girdle: of the vertical facets, or both 0 where there are none and
    /// the girdle is a sharp edge.
    pub girdle: Option<[f64; 2]>,
}

impl BodyMeasures {
    /// Measures `body`, whose facets are of `classes`.
    pub fn of(body: &FacetedBody, classes: &[FacetClass]) -> Self {
        let (low, high) = body.bounds();
        let size = high - low;
        let coordinates = |facet: &usize, axis: usize| {
            let ends: Vec<f64> = body.facets[*facet]
                .rim
                .iter()
                .flatten()
                .map(|v| body.vertices[*v as usize][axis])
                .collect();
            ends
        };
        let table_along = |axis: usize| {
            let flat_top = classes
                .iter()
                .filter(|class| class.zone == Zone::Crown && class.angle_degrees < FLAT_DEGREES)
                .flat_map(|class| &class.facets);
            span(flat_top.flat_map(|facet| coordinates(facet, axis)))
        };
        let table = table_along(0).zip(table_along(1)).map(|(x, y)| [x, y]);
        let vertical = classes.iter().filter(|class| class.zone == Zone::Girdle);
        let vertical = vertical.flat_map(|class| &class.facets);
        let girdle = match span(vertical.flat_map(|facet| coordinates(facet, 2))) {
            // A side that goes all the way up and down is none.
            Some([lower, upper]) => (lower > low.z || upper < high.z).then_some([lower, upper]),
            None => (low.z < 0.0 && high.z > 0.0).then_some([0.0, 0.0]),
        };
        let (width, length, depth) = (size.x, size.y, size.z);
        Self { width, length, depth, table, z: [low.z, high.z], girdle }
    }

    /// The smaller of width and length, which percentages refer to.
    pub fn reference(&self) -> f64 {
        self.width.min(self.length)
    }

    /// The table's size along the reference.
    pub fn table_size(&self) -> Option<f64> {
        let axis = usize::from(self.length < self.width);
        self.table.map(|ends| ends[axis][1] - ends[axis][0])
    }

    /// From the girdle's upper end to the table.
    pub fn crown_height(&self) -> Option<f64> {
        self.girdle.map(|[_, upper]| self.z[1] - upper)
    }

    /// From the girdle's lower end to the culet.
    pub fn pavilion_depth(&self) -> Option<f64> {
        self.girdle.map(|[lower, _]| lower - self.z[0])
    }
}

/// The least and the greatest of `values`.
fn span(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    values.fold(None, |span: Option<[f64; 2]>, value| {
        let [low, high] = span.unwrap_or([value, value]);
        Some([low.min(value), high.max(value)])
    })
}
