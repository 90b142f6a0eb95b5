//! Bounding volume hierarchies, built by obvhs and kept in the form that both tracers read.

use std::time::Duration;

use glam::Vec3;
use obvhs::aabb::Aabb;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::{Boundable, BvhBuildParams};

use crate::mesh::Mesh;
use crate::packed::{BvhNode, PackedTriangle};

/// An axis-aligned box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Lower corner.
    pub min: Vec3,
    /// Upper corner.
    pub max: Vec3,
}

impl Bounds {
    /// The smallest box around `points`; inverted where there are none.
    pub fn of(points: impl IntoIterator<Item = Vec3>) -> Self {
        let empty = Self { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY };
        points.into_iter().fold(empty, |bounds, point| Self {
            min: bounds.min.min(point),
            max: bounds.max.max(point),
        })
    }

    /// The middle of the box.
    pub fn center(&self) -> Vec3 {
        0.5 * (self.min + self.max)
    }

    /// Whether the boxes have a point in common.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.min.cmple(other.max).all() && other.min.cmple(self.max).all()
    }
}

impl Boundable for Bounds {
    fn aabb(&self) -> Aabb {
        Aabb::new(self.min.into(), self.max.into())
    }
}

/// The hierarchy of a mesh: nodes, and the triangles in leaf order.
#[derive(Clone, Debug, Default)]
pub struct MeshHierarchy {
    /// Node 0 is the root; empty for an empty mesh.
    pub nodes: Vec<BvhNode>,
    /// Triangles in the order of the leaves.
    pub triangles: Vec<PackedTriangle>,
}

impl MeshHierarchy {
    /// Builds the hierarchy of `mesh`.
    pub fn new(mesh: &Mesh) -> Self {
        let triangles: Vec<_> = mesh
            .triangles
            .iter()
            .zip(&mesh.facet)
            .map(|(corners, &facet)| {
                packed_triangle(corners.map(|i| mesh.positions[i as usize]), facet)
            })
            .collect();
        let bounds: Vec<_> = triangles.iter().map(|t| Bounds::of([t.a, t.b, t.c])).collect();
        let (nodes, order) = build_hierarchy(&bounds);
        let triangles = order.iter().map(|&i| triangles[i as usize]).collect();
        Self { nodes, triangles }
    }
}

/// A triangle without area gets the normal 0, from which no ray ever meets it.
fn packed_triangle([a, b, c]: [Vec3; 3], facet: u32) -> PackedTriangle {
    let (edge_b, edge_c) = ((b - a).as_dvec3(), (c - a).as_dvec3());
    let normal = edge_b.cross(edge_c).normalize_or_zero().as_vec3();
    PackedTriangle {
        a,
        facet,
        b,
        normal_x: normal.x,
        c,
        normal_y: normal.y,
        normal_z: normal.z,
        padding: [0; 3],
    }
}

/// Builds a hierarchy over `bounds`: nodes, and the primitive index per leaf slot.
pub fn build_hierarchy(bounds: &[Bounds]) -> (Vec<BvhNode>, Vec<u32>) {
    if bounds.is_empty() {
        return (Vec::new(), Vec::new());
    }
    let bvh = build_bvh2(bounds, BvhBuildParams::medium_build(), &mut Duration::default());
    let nodes = bvh
        .nodes
        .iter()
        .map(|node| BvhNode {
            min: node.aabb().min.into(),
            primitive_count: node.prim_count,
            max: node.aabb().max.into(),
            first: node.first_index,
        })
        .collect();
    (nodes, bvh.primitive_indices)
}
