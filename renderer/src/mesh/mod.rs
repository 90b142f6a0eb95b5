//! Triangle meshes.

mod edges;
mod facets;
mod weld;

pub use edges::MeshFault;

use std::sync::OnceLock;

use glam::{Vec2, Vec3};

use crate::accel::MeshHierarchy;
use crate::error::RendererError;
use crate::solid::Solid;
use edges::Edges;

/// An indexed triangle mesh, counter-clockwise seen from outside.
#[derive(Debug)]
pub struct Mesh {
    /// Vertex positions in millimetres; no two are equal and each is used.
    pub positions: Vec<Vec3>,
    /// Three different vertex indices per triangle.
    pub triangles: Vec<[u32; 3]>,
    /// Per triangle the flat facet it is part of: triangles that lie in one plane and hang together
    /// by edges share a number, so that a ray that leaves one need not be tested against the others.
    pub facet: Vec<u32>,
    /// Per triangle the texture coordinates of its corners: from (0, 0) at the upper left of an
    /// image to (1, 1) at its lower right. Empty where the mesh has none.
    pub coordinates: Vec<[Vec2; 3]>,
    fault: Option<MeshFault>,
    hierarchy: OnceLock<MeshHierarchy>,
}

impl Mesh {
    /// Most triangles one mesh may have; their half-edges are counted in `u32`.
    pub const MAX_TRIANGLES: usize = 1 << 24;

    /// Welds equal positions, drops triangles of which two corners coincide, turns a closed mesh
    /// that is inside out, and finds the flat facets.
    ///
    /// Triangles without area whose corners differ stay: they close the gap between neighbours.
    ///
    /// # Errors
    /// No triangle left, too many, an index beyond the positions, or a position that is not finite;
    /// names the triangle or vertex.
    pub fn new(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Result<Self, RendererError> {
        Self::with_coordinates(positions, triangles, Vec::new())
    }

    /// The same with texture coordinates: those of the corners of each triangle, or none at all.
    ///
    /// # Errors
    /// As [`new`](Self::new), and coordinates that are not finite.
    pub fn with_coordinates(
        positions: Vec<Vec3>,
        triangles: Vec<[u32; 3]>,
        coordinates: Vec<[Vec2; 3]>,
    ) -> Result<Self, RendererError> {
        check(&positions, &triangles)?;
        check_coordinates(&triangles, &coordinates)?;
        let kept = triangles.iter().zip(coordinates);
        let kept = kept.filter(|(corners, _)| has_three_corners(corners, &positions));
        let coordinates = kept.map(|(_, coordinates)| coordinates).collect();
        let mut mesh = Self::welded(positions, triangles, &[])?;
        mesh.coordinates = coordinates;
        let edges = mesh.orient();
        mesh.facet = facets::flat_facets(&mesh.positions, &mesh.triangles, &edges);
        Ok(mesh)
    }

    /// The mesh of a solid, with the solid's facets as its facets.
    ///
    /// # Errors
    /// A solid too large or too small for single precision.
    pub fn from_solid(solid: &Solid) -> Result<Self, RendererError> {
        let positions: Vec<Vec3> = solid.vertices.iter().map(|v| v.as_vec3()).collect();
        let (triangles, facet): (Vec<_>, Vec<_>) = solid.triangles().unzip();
        check(&positions, &triangles)?;
        let mut mesh = Self::welded(positions, triangles, &facet)?;
        mesh.orient();
        Ok(mesh)
    }

    /// Whether the mesh encloses a volume without gap or doubt, as a stone must.
    ///
    /// # Errors
    /// What is wrong, and where it was first seen.
    pub fn closed(&self) -> Result<(), MeshFault> {
        self.fault.clone().map_or(Ok(()), Err)
    }

    /// The bounding volume hierarchy of the triangles, built when first asked for.
    pub fn hierarchy(&self) -> &MeshHierarchy {
        self.hierarchy.get_or_init(|| MeshHierarchy::new(self))
    }

    /// Lowest and highest coordinates.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        self.positions.iter().fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), p| {
            (low.min(*p), high.max(*p))
        })
    }

    /// Enclosed volume in mm³, positive when the triangles face outwards; only a closed mesh has one.
    pub fn volume(&self) -> f64 {
        let apex = self.positions.first().copied().unwrap_or_default().as_dvec3();
        let six_fold: f64 = self
            .triangles
            .iter()
            .map(|corners| {
                let [a, b, c] = corners.map(|v| self.positions[v as usize].as_dvec3() - apex);
                a.dot(b.cross(c))
            })
            .sum();
        six_fold / 6.0
    }

    /// Welds, and drops triangles with equal corners; `facet` holds their facets, or nothing yet.
    fn welded(
        mut positions: Vec<Vec3>,
        mut triangles: Vec<[u32; 3]>,
        facet: &[u32],
    ) -> Result<Self, RendererError> {
        let kept = triangles.iter().zip(facet);
        let kept = kept.filter(|(corners, _)| has_three_corners(corners, &positions));
        let facet = kept.map(|(_, facet)| *facet).collect();
        triangles.retain(|corners| has_three_corners(corners, &positions));
        let index_of = weld::weld(&mut positions, &triangles);
        for corners in &mut triangles {
            *corners = corners.map(|v| index_of[v as usize]);
        }
        if triangles.is_empty() {
            return Err(RendererError::Invalid(
                "the mesh has no triangle with three different corners; export it with its faces"
                    .to_owned(),
            ));
        }
        let (coordinates, fault) = (Vec::new(), None);
        Ok(Self { positions, triangles, facet, coordinates, fault, hierarchy: OnceLock::new() })
    }

    /// Records whether the mesh is closed and, if it is, turns it outside out.
    fn orient(&mut self) -> Edges {
        let mut edges = Edges::new(&self.triangles, self.positions.len());
        self.fault = edges.fault(&self.positions);
        if self.fault.is_some() {
            return edges;
        }
        let (low, high) = self.bounds();
        let volume = self.volume();
        // Far below any real stone, far above the rounding of the sum.
        if volume.abs() < 1e-10 * high.as_dvec3().distance(low.as_dvec3()).powi(3) {
            self.fault = Some(MeshFault::Flat);
        } else if volume < 0.0 {
            for corners in &mut self.triangles {
                corners.swap(1, 2);
            }
            for corners in &mut self.coordinates {
                corners.swap(1, 2);
            }
            edges = Edges::new(&self.triangles, self.positions.len());
        }
        edges
    }
}

/// Whether no two corners of a triangle are at one place.
fn has_three_corners(corners: &[u32; 3], positions: &[Vec3]) -> bool {
    let [a, b, c] = corners.map(|v| positions[v as usize]);
    a != b && b != c && c != a
}

fn check_coordinates(
    triangles: &[[u32; 3]],
    coordinates: &[[Vec2; 3]],
) -> Result<(), RendererError> {
    if !coordinates.is_empty() && coordinates.len() != triangles.len() {
        return Err(RendererError::Invalid(format!(
            "{} triangles but {} sets of texture coordinates; give one per triangle, or none",
            triangles.len(),
            coordinates.len()
        )));
    }
    let is_finite = |corners: &[Vec2; 3]| corners.iter().all(|corner| corner.is_finite());
    match coordinates.iter().position(|corners| !is_finite(corners)) {
        Some(t) => Err(RendererError::Invalid(format!(
            "the texture coordinates of triangle {t} are not finite; unwrap the mesh again"
        ))),
        None => Ok(()),
    }
}

fn check(positions: &[Vec3], triangles: &[[u32; 3]]) -> Result<(), RendererError> {
    let invalid = |text: String| Err(RendererError::Invalid(text));
    if triangles.len() > Mesh::MAX_TRIANGLES {
        return invalid(format!(
            "the mesh has {} triangles; at most {} are allowed, so decimate it",
            triangles.len(),
            Mesh::MAX_TRIANGLES
        ));
    }
    if let Some(v) = positions.iter().position(|position| !position.is_finite()) {
        return invalid(format!(
            "vertex {v} has the position {}, which is not finite; export the mesh again",
            positions[v]
        ));
    }
    let beyond = |v: &u32| *v as usize >= positions.len();
    if let Some(t) = triangles.iter().position(|corners| corners.iter().any(beyond)) {
        return invalid(format!(
            "triangle {t} names the vertices {:?}, but there are only {}; export the mesh again",
            triangles[t],
            positions.len()
        ));
    }
    Ok(())
}
