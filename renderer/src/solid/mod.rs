//! Convex solids: half-spaces in, closed facets out.

mod clip;
mod measure;

use glam::DVec3;

use crate::error::RendererError;
use clip::Polyhedron;

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

/// A closed convex polyhedron.
///
/// Every edge belongs to two facets, every vertex stands once in `vertices`.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// Corners, in millimetres.
    pub vertices: Vec<DVec3>,
    /// Polished faces, in the order of the half-spaces they came from.
    pub facets: Vec<Facet>,
    /// Names of the half-spaces that bound nothing, because others cut deeper.
    pub dropped: Vec<String>,
}

/// One face of a [`Solid`].
#[derive(Clone, Debug, PartialEq)]
pub struct Facet {
    /// The plane, with its normal brought to unit length.
    pub half_space: HalfSpace,
    /// Corners as indices into [`Solid::vertices`], at least three, counter-clockwise seen from
    /// outside.
    pub vertices: Vec<u32>,
}

impl Solid {
    /// Most half-spaces one solid may have. The busiest published cuts stay below 500 facets.
    pub const MAX_HALF_SPACES: usize = 4096;

    /// Intersects `half_spaces`.
    ///
    /// The origin need not lie inside. Planes that meet within 1e-9 of the largest distance count
    /// as meeting in one point, so that the meet points of a cut come out as single vertices.
    ///
    /// # Errors
    /// A normal that is zero or not finite, too many half-spaces, nothing left inside them all, or
    /// a side on which they do not close; each names the facet and the remedy.
    pub fn from_half_spaces(half_spaces: &[HalfSpace]) -> Result<Self, RendererError> {
        let planes = normalized(half_spaces)?;
        let scale = planes.iter().map(|plane| plane.distance.abs()).fold(0.0, f64::max);
        let mut polyhedron = Polyhedron::cube(if scale > 0.0 { scale } else { 1.0 });
        for (index, plane) in planes.iter().enumerate() {
            polyhedron.clip(index, plane)?;
        }
        if let Some(fault) = polyhedron.opening(&planes) {
            return Err(RendererError::Invalid(fault));
        }
        polyhedron.collapse_short_edges();
        polyhedron.sharpen(&planes);
        Self::assemble(&polyhedron, planes)
    }

    fn assemble(polyhedron: &Polyhedron, planes: Vec<HalfSpace>) -> Result<Self, RendererError> {
        let (vertices, loops) = polyhedron.compact(planes.len());
        let mut solid = Self { vertices, facets: Vec::new(), dropped: Vec::new() };
        for (half_space, vertices) in planes.into_iter().zip(loops) {
            if vertices.len() < 3 {
                solid.dropped.push(half_space.name);
            } else {
                solid.facets.push(Facet { half_space, vertices });
            }
        }
        if solid.euler_characteristic() == 2 {
            Ok(solid)
        } else {
            Err(RendererError::Invalid(format!(
                "the {} facets do not join into one closed surface: several planes nearly coincide; \
                 remove duplicate facets or state their angles and distances with more digits",
                solid.facets.len()
            )))
        }
    }

    /// Facets cut into triangles, each with the index of its facet.
    ///
    /// A facet becomes a fan about its first corner, wound as the facet is.
    pub fn triangles(&self) -> impl Iterator<Item = ([u32; 3], u32)> {
        self.facets.iter().enumerate().flat_map(|(index, facet)| {
            let corners = &facet.vertices;
            corners[1..].windows(2).map(move |pair| ([corners[0], pair[0], pair[1]], index as u32))
        })
    }

    /// Edges as pairs of vertex indices, each once, lower index first.
    pub fn edges(&self) -> impl Iterator<Item = [u32; 2]> {
        self.facets.iter().flat_map(|facet| {
            let corners = &facet.vertices;
            let next = corners.iter().cycle().skip(1);
            corners.iter().zip(next).filter(|(a, b)| a < b).map(|(&a, &b)| [a, b])
        })
    }
}

fn normalized(half_spaces: &[HalfSpace]) -> Result<Vec<HalfSpace>, RendererError> {
    if half_spaces.len() > Solid::MAX_HALF_SPACES {
        return Err(RendererError::Invalid(format!(
            "{} facets are too many for one solid; at most {} are allowed",
            half_spaces.len(),
            Solid::MAX_HALF_SPACES
        )));
    }
    half_spaces
        .iter()
        .map(|plane| {
            let length = plane.normal.length();
            let (normal, distance) = (plane.normal / length, plane.distance / length);
            // A zero, infinite or NaN normal makes the quotient NaN.
            if !(normal.is_finite() && distance.is_finite() && length > 0.0) {
                return Err(RendererError::Invalid(format!(
                    "facet '{}' has no usable plane (normal {}, distance {}); \
                     give it a finite distance and a normal that is not zero",
                    plane.name, plane.normal, plane.distance
                )));
            }
            Ok(HalfSpace { normal, distance, name: plane.name.clone() })
        })
        .collect()
}
