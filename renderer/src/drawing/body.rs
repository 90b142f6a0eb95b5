//! What is drawn: a closed body of flat facets, from any shape of a scene.

use std::collections::BTreeMap;

use glam::DVec3;

use crate::error::RendererError;
use crate::mesh::Mesh;
use crate::scene::{Object, Shape};
use crate::solid::Solid;

/// How far a vertex may stand above a facet of a convex body, over the body's size.
const CONVEX: f64 = 1e-5;

/// A closed body with flat facets, in its own frame: the girdle plane is z = 0 and +z goes through
/// the table.
#[derive(Clone, Debug)]
pub struct FacetedBody {
    /// What the user calls it.
    pub name: String,
    /// Corners, in millimetres.
    pub vertices: Vec<DVec3>,
    /// Flat facets.
    pub facets: Vec<BodyFacet>,
    /// Where two facets meet, each edge once.
    pub edges: Vec<BodyEdge>,
    /// The surface, wound counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// True if no facet can hide another.
    pub is_convex: bool,
}

/// A flat facet.
#[derive(Clone, Debug)]
pub struct BodyFacet {
    /// Name with number, as "main 3"; empty where the shape has no names.
    pub name: String,
    /// Outward unit normal.
    pub normal: DVec3,
    /// Surface in mm².
    pub area: f64,
    /// Its edges as pairs of vertices.
    pub rim: Vec<[u32; 2]>,
}

/// An edge of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BodyEdge {
    /// Its two vertices, the lower index first.
    pub ends: [u32; 2],
    /// The two facets that meet there.
    pub facets: [u32; 2],
}

impl FacetedBody {
    /// Most facets a line drawing may have: more make no drawing that one could read.
    pub const MAX_FACETS: usize = 512;
    /// Most triangles that a mesh to be drawn may have.
    pub const MAX_TRIANGLES: usize = 4096;

    /// The body of `object` at its true size, but unturned and unmoved.
    ///
    /// # Errors
    /// A shape that encloses no volume, or that has too many facets or triangles; names the object
    /// and the remedy.
    pub fn of(object: &Object) -> Result<Self, RendererError> {
        let invalid = |fault: String| RendererError::Invalid(format!("{}: {fault}", object.name));
        let body = match &object.shape {
            Shape::Mesh(source) => {
                source.mesh.closed().map_err(|fault| {
                    invalid(format!("the mesh can't be drawn, since {fault}; close it"))
                })?;
                Self::from_mesh(&source.mesh).map_err(invalid)?
            }
            Shape::RoundBrilliant(_) | Shape::Polyhedron(_) => Self::from_solid(&object.solid()?),
        };
        let facets = body.facets.iter().filter(|facet| !facet.rim.is_empty()).count();
        if facets > Self::MAX_FACETS {
            return Err(invalid(format!(
                "it has {facets} facets, and a line drawing may have {}, since more can't be read; \
                 draw a stone of fewer facets",
                Self::MAX_FACETS
            )));
        }
        Ok(body.named(object))
    }

    fn from_solid(solid: &Solid) -> Self {
        let (triangles, facet): (Vec<_>, Vec<_>) = solid.triangles().unzip();
        let names = solid.facets.iter().map(|facet| facet.half_space.name.clone()).collect();
        let mut body = Self::assembled(solid.vertices.clone(), triangles, &facet, names);
        for (facet, of_solid) in body.facets.iter_mut().zip(&solid.facets) {
            // Exact, where the sum of the triangles is rounded.
            facet.normal = of_solid.half_space.normal;
        }
        body.is_convex = true;
        body
    }

    fn from_mesh(mesh: &Mesh) -> Result<Self, String> {
        let facets = mesh.facet.iter().max().map_or(0, |last| *last as usize + 1);
        if facets > Self::MAX_FACETS {
            return Err(format!(
                "the mesh has {facets} flat facets, and a line drawing may have {}; it is for \
                 faceted stones, not for smooth surfaces",
                Self::MAX_FACETS
            ));
        }
        if mesh.triangles.len() > Self::MAX_TRIANGLES {
            return Err(format!(
                "the mesh has {} triangles, and a line drawing may have {}; dissolve the flat \
                 facets into fewer triangles",
                mesh.triangles.len(),
                Self::MAX_TRIANGLES
            ));
        }
        let vertices = mesh.positions.iter().map(|position| position.as_dvec3()).collect();
        let names = vec![String::new(); facets];
        let mut body = Self::assembled(vertices, mesh.triangles.clone(), &mesh.facet, names);
        body.is_convex = body.bulges_nowhere_in();
        Ok(body)
    }

    /// Collects the triangles into facets, of which `facet` has one for each triangle.
    fn assembled(
        vertices: Vec<DVec3>,
        triangles: Vec<[u32; 3]>,
        facet: &[u32],
        names: Vec<String>,
    ) -> Self {
        let mut doubled_areas = vec![DVec3::ZERO; names.len()];
        let mut sides: BTreeMap<[u32; 2], Vec<u32>> = BTreeMap::new();
        for (&[a, b, c], &facet) in triangles.iter().zip(facet) {
            let [p, q, r] = [a, b, c].map(|v| vertices[v as usize]);
            doubled_areas[facet as usize] += (q - p).cross(r - p);
            for [from, to] in [[a, b], [b, c], [c, a]] {
                sides.entry([from.min(to), from.max(to)]).or_default().push(facet);
            }
        }
        let mut facets: Vec<BodyFacet> = names
            .into_iter()
            .zip(doubled_areas)
            .map(|(name, doubled)| BodyFacet {
                name,
                normal: doubled.normalize_or_zero(),
                area: 0.5 * doubled.length(),
                rim: Vec::new(),
            })
            .collect();
        let mut edges = Vec::new();
        for (ends, sides) in sides {
            if let [a, b] = sides[..]
                && a != b
            {
                facets[a as usize].rim.push(ends);
                facets[b as usize].rim.push(ends);
                edges.push(BodyEdge { ends, facets: [a, b] });
            }
        }
        Self { name: String::new(), vertices, facets, edges, triangles, is_convex: false }
    }

    fn named(mut self, object: &Object) -> Self {
        self.name.clone_from(&object.name);
        let scale = f64::from(object.transform.scale);
        for vertex in &mut self.vertices {
            *vertex *= scale;
        }
        for facet in &mut self.facets {
            facet.area *= scale * scale;
        }
        self
    }

    fn bulges_nowhere_in(&self) -> bool {
        let (low, high) = self.bounds();
        let tolerance = CONVEX * low.distance(high);
        self.facets.iter().all(|facet| {
            let Some([on_it, _]) = facet.rim.first() else { return true };
            let distance = facet.normal.dot(self.vertices[*on_it as usize]);
            self.vertices.iter().all(|vertex| facet.normal.dot(*vertex) <= distance + tolerance)
        })
    }

    /// Lowest and highest coordinates, in mm.
    pub fn bounds(&self) -> (DVec3, DVec3) {
        self.vertices.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), vertex| {
            (low.min(*vertex), high.max(*vertex))
        })
    }
}
