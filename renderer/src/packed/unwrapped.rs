//! Meshes with texture coordinates: which triangles an image lies on alike.

use std::collections::HashMap;

use glam::{DVec2, DVec3, Vec2, Vec3, Vec4};

use super::PackedTriangle;
use crate::mesh::Mesh;

/// How far, in texture coordinates, a corner may be off where a projection is shared.
const TOLERANCE: f32 = 1e-5;

/// Projections of one flat facet that are compared with the next triangle's. Most facets have one;
/// where all triangles differ the search must end.
const COMPARED: usize = 4;

/// The two rows that give the texture coordinates of a point of a triangle.
type Projection = [Vec4; 2];

/// A mesh divided anew into facets: flat, and with one projection each.
pub(super) struct UnwrappedMesh {
    /// Facet per triangle, in leaf order.
    pub(super) facets: Vec<u32>,
    /// One per facet.
    pub(super) projections: Vec<Projection>,
}

impl UnwrappedMesh {
    /// For a mesh that has texture coordinates.
    pub(super) fn new(mesh: &Mesh) -> Self {
        let hierarchy = mesh.hierarchy();
        let mut projections = Vec::new();
        let mut of_flat_facet: HashMap<u32, Vec<u32>> = HashMap::new();
        let facet = |(triangle, &number): (&PackedTriangle, &u32)| {
            let coordinates = mesh.coordinates[number as usize];
            let known = of_flat_facet.entry(triangle.facet).or_default();
            let fits = |facet: &&u32| fits(&projections[**facet as usize], triangle, coordinates);
            if let Some(&facet) = known.iter().rev().take(COMPARED).find(fits) {
                return facet;
            }
            let facet = projections.len() as u32;
            projections.push(projection(triangle, coordinates));
            known.push(facet);
            facet
        };
        let facets = hierarchy.triangles.iter().zip(&hierarchy.order).map(facet).collect();
        Self { facets, projections }
    }
}

fn fits(projection: &Projection, triangle: &PackedTriangle, coordinates: [Vec2; 3]) -> bool {
    let corners = [triangle.a, triangle.b, triangle.c];
    corners.into_iter().zip(coordinates).all(|(corner, at)| {
        let found = Vec2::from_array(projection.map(|row| row.dot(corner.extend(1.0))));
        (found - at).abs().max_element() < TOLERANCE
    })
}

fn projection(triangle: &PackedTriangle, coordinates: [Vec2; 3]) -> Projection {
    let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(Vec3::as_dvec3);
    let [at_a, at_b, at_c] = coordinates.map(Vec2::as_dvec2);
    let (edge_b, edge_c) = (b - a, c - a);
    let normal = edge_b.cross(edge_c);
    // Along the triangle: what grows along one edge does not grow along the other.
    let area_squared = normal.length_squared();
    let (along_b, along_c) =
        (edge_c.cross(normal) / area_squared, normal.cross(edge_b) / area_squared);
    let row = |of: fn(DVec2) -> f64| {
        let gradient = along_b * (of(at_b) - of(at_a)) + along_c * (of(at_c) - of(at_a));
        let row = gradient.extend(of(at_a) - gradient.dot(a)).as_vec4();
        if row.is_finite() { row } else { DVec3::ZERO.extend(of(at_a)).as_vec4() }
    };
    [row(|at| at.x), row(|at| at.y)]
}

#[cfg(test)]
mod tests {
    use bytemuck::Zeroable;

    use super::*;

    fn triangle(a: Vec3, b: Vec3, c: Vec3) -> PackedTriangle {
        PackedTriangle { a, b, c, ..PackedTriangle::zeroed() }
    }

    #[test]
    fn a_projection_gives_each_corner_its_coordinates() {
        let corners =
            [Vec3::new(1.0, 2.0, 3.0), Vec3::new(-2.0, 0.5, 3.5), Vec3::new(4.0, 1.0, -1.0)];
        let coordinates = [Vec2::new(0.1, 0.9), Vec2::new(1.5, 0.2), Vec2::new(-0.3, 0.4)];
        let [a, b, c] = corners;
        let [u, v] = projection(&triangle(a, b, c), coordinates);
        for (corner, wanted) in corners.into_iter().zip(coordinates) {
            let point = corner.extend(1.0);
            let found = Vec2::new(u.dot(point), v.dot(point));
            assert!(found.distance(wanted) < 1e-5, "{found} is not {wanted}");
        }
    }

    #[test]
    fn a_triangle_without_area_has_one_coordinate() {
        let corner = Vec3::new(1.0, 2.0, 3.0);
        let at = Vec2::new(0.25, 0.75);
        let [u, v] = projection(&triangle(corner, corner, corner), [at, Vec2::ONE, Vec2::ZERO]);
        assert_eq!([u, v], [Vec3::ZERO.extend(0.25), Vec3::ZERO.extend(0.75)]);
    }
}
