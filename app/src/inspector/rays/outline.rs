//! The edges of the stones.

use std::collections::HashMap;

use brilliance_renderer::mesh::Mesh;
use brilliance_renderer::scene::{Object, Scene, Shape};
use brilliance_renderer::solid::{HalfSpace, Solid};
use glam::Vec3;

/// Larger meshes are drawn without edges: these would be a grey mass.
const MOST_TRIANGLES: usize = 50_000;

/// Where two facets meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    /// Its ends in the world, in mm.
    pub(super) ends: [Vec3; 2],
    /// Outward normals of the two facets.
    normals: [Vec3; 2],
}

impl Edge {
    /// Whether one of the facets is turned towards `eye`.
    pub(super) fn faces(&self, eye: Vec3) -> bool {
        self.normals.iter().any(|normal| normal.dot(eye - self.ends[0]) > 0.0)
    }
}

/// The edges of all objects.
pub(super) fn edges(scene: &Scene) -> Vec<Edge> {
    scene.objects.iter().flat_map(edges_of).collect()
}

fn edges_of(object: &Object) -> Vec<Edge> {
    let own = match &object.shape {
        Shape::RoundBrilliant(cut) => {
            cut.half_spaces().map_or_else(|_| Vec::new(), |own| of_half_spaces(&own))
        }
        Shape::Polyhedron(half_spaces) => of_half_spaces(half_spaces),
        Shape::Mesh(source) => of_mesh(&source.mesh),
    };
    let transform = &object.transform;
    own.into_iter()
        .map(|edge| Edge {
            ends: edge.ends.map(|end| transform.point(end)),
            normals: edge.normals.map(|normal| transform.direction(normal)),
        })
        .collect()
}

/// The edges of a convex solid; none where the half-spaces do not close, as the tracer will say.
fn of_half_spaces(half_spaces: &[HalfSpace]) -> Vec<Edge> {
    let Ok(solid) = Solid::from_half_spaces(half_spaces) else { return Vec::new() };
    let mut joined = JoinedFacets::default();
    for facet in &solid.facets {
        let next = facet.vertices.iter().cycle().skip(1);
        for (&a, &b) in facet.vertices.iter().zip(next) {
            joined.add([a, b], facet.half_space.normal.as_vec3());
        }
    }
    joined.edges(|vertex| solid.vertices[vertex as usize].as_vec3())
}

/// The edges between the flat facets of a mesh.
fn of_mesh(mesh: &Mesh) -> Vec<Edge> {
    if mesh.triangles.len() > MOST_TRIANGLES {
        return Vec::new();
    }
    let mut joined = JoinedFacets::default();
    for &[a, b, c] in &mesh.triangles {
        let [at_a, at_b, at_c] = [a, b, c].map(|vertex| mesh.positions[vertex as usize]);
        let normal = (at_b - at_a).cross(at_c - at_a).normalize_or_zero();
        for side in [[a, b], [b, c], [c, a]] {
            joined.add(side, normal);
        }
    }
    joined.edges(|vertex| mesh.positions[vertex as usize])
}

/// The normals on both sides of each edge.
#[derive(Default)]
struct JoinedFacets {
    normals: HashMap<[u32; 2], Vec<Vec3>>,
}

impl JoinedFacets {
    fn add(&mut self, [a, b]: [u32; 2], normal: Vec3) {
        self.normals.entry([a.min(b), a.max(b)]).or_default().push(normal);
    }

    /// The edges, but for those within a plane.
    fn edges(self, position: impl Fn(u32) -> Vec3) -> Vec<Edge> {
        let is_edge = |normals: &[Vec3]| match normals {
            [one, other] => one.dot(*other) < 0.999_99,
            _ => true,
        };
        let mut edges: Vec<_> =
            self.normals.into_iter().filter(|(_, normals)| is_edge(normals)).collect();
        edges.sort_unstable_by_key(|(vertices, _)| *vertices);
        edges
            .into_iter()
            .map(|(vertices, normals)| {
                let first = normals[0];
                let second = normals.get(1).copied().unwrap_or(-first);
                Edge { ends: vertices.map(&position), normals: [first, second] }
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_brilliant_has_its_edges_and_half_of_them_face_the_eye() {
        let scene = brilliance_renderer::scene_file::Document::default().scene;
        let edges = edges(&scene);
        let Shape::RoundBrilliant(cut) = &scene.objects[0].shape else { panic!("a brilliant") };
        let solid = Solid::from_half_spaces(&cut.half_spaces().expect("it is")).expect("it is");
        assert_eq!(edges.len(), solid.edges().count());
        let table = Vec3::Z * 100.0;
        let facing = edges.iter().filter(|edge| edge.faces(table)).count();
        assert!(facing > edges.len() / 3 && facing < edges.len(), "{facing}");
    }
}
