//! Bounding volume hierarchies, built by obvhs and kept in the form that tracers read.

use std::time::Duration;

use glam::Vec3;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::bvh2::node::Bvh2Node;
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

/// Levels below the root that the tracers' stacks of nodes have room for. A million triangles need
/// about 30; only a mesh made for the purpose needs more.
pub const MAX_DEPTH: usize = 96;

/// A hierarchy over primitives of any kind.
#[derive(Clone, Debug, Default)]
pub struct Hierarchy {
    /// Node 0 is the root; empty where there are no primitives.
    pub nodes: Vec<BvhNode>,
    /// Primitive per leaf slot.
    pub order: Vec<u32>,
    /// Levels below the root.
    pub depth: usize,
}

impl Hierarchy {
    /// Builds the hierarchy over primitives with these bounds.
    pub fn new(bounds: &[Bounds]) -> Self {
        if bounds.is_empty() {
            return Self::default();
        }
        let mut bvh = build_bvh2(bounds, BvhBuildParams::medium_build(), &mut Duration::default());
        let order = lay_out(&mut bvh);
        let node = |node: &Bvh2Node| BvhNode {
            min: node.aabb().min.into(),
            primitive_count: node.prim_count,
            max: node.aabb().max.into(),
            first: node.first_index,
        };
        let nodes = bvh.nodes.iter().map(node).collect();
        let depth = bvh.depth(0);
        Self { nodes, order, depth }
    }
}

/// Brings nodes and primitives into the order in which a ray comes to them, so that what is near in
/// space is near in memory: with a million triangles a ray waits for memory most of the time. Returns
/// the primitive per leaf slot.
fn lay_out(bvh: &mut Bvh2) -> Vec<u32> {
    bvh.reorder_in_stack_traversal_order();
    let mut order = Vec::with_capacity(bvh.primitive_indices.len());
    for leaf in bvh.nodes.iter_mut().filter(|node| node.is_leaf()) {
        let slots = leaf.first_index as usize..(leaf.first_index + leaf.prim_count) as usize;
        leaf.first_index = order.len() as u32;
        order.extend_from_slice(&bvh.primitive_indices[slots]);
    }
    order
}

/// The hierarchy of a mesh: nodes, and the triangles in leaf order.
#[derive(Clone, Debug, Default)]
pub struct MeshHierarchy {
    /// Node 0 is the root; empty for an empty mesh.
    pub nodes: Vec<BvhNode>,
    /// Triangles in the order of the leaves.
    pub triangles: Vec<PackedTriangle>,
    /// The number that each of these triangles has in the mesh.
    pub order: Vec<u32>,
    /// Levels below the root.
    pub depth: usize,
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
        let Hierarchy { nodes, order, depth } = Hierarchy::new(&bounds);
        let triangles = order.iter().map(|&i| triangles[i as usize]).collect();
        Self { nodes, triangles, order, depth }
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
