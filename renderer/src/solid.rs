//! Convex solids: half-spaces in, closed facets out.

use glam::DVec3;

/// The points x with `normal · x ≤ distance`: one facet plane of a convex solid.
#[derive(Clone, Debug, PartialEq)]
pub struct HalfSpace {
    /// Outward unit normal.
    pub normal: DVec3,
    /// Distance of the plane from the origin along the normal, in millimetres.
    pub distance: f64,
    /// Name of the facet, for the user: "table", "main 3".
    pub name: String,
}
