//! Values at the three wavelengths that a fan of rays is traced at, and between them.
//!
//! A position in the fan runs from −1 at its shortest wavelength over 0 at the middle node to 1 at the
//! longest. Between the nodes a value is the quadratic function through the three.

use glam::{Mat3A, Vec3, Vec3A};

/// Vectors at the three nodes, component by component.
#[derive(Clone, Copy, Debug)]
pub struct Nodes {
    /// The x of each.
    pub x: Vec3A,
    /// The y of each.
    pub y: Vec3A,
    /// The z of each.
    pub z: Vec3A,
}

/// The same vector at all nodes.
#[inline]
pub fn equal_nodes(vector: Vec3) -> Nodes {
    Nodes { x: Vec3A::splat(vector.x), y: Vec3A::splat(vector.y), z: Vec3A::splat(vector.z) }
}

/// The vectors at the low, the middle and the high node.
#[inline]
pub fn nodes_of(low: Vec3, middle: Vec3, high: Vec3) -> Nodes {
    Nodes {
        x: Vec3A::new(low.x, middle.x, high.x),
        y: Vec3A::new(low.y, middle.y, high.y),
        z: Vec3A::new(low.z, middle.z, high.z),
    }
}

/// The vector at the low node.
#[inline]
pub fn low_node(nodes: &Nodes) -> Vec3 {
    Vec3::new(nodes.x.x, nodes.y.x, nodes.z.x)
}

/// The vector at the middle node.
#[inline]
pub fn middle_node(nodes: &Nodes) -> Vec3 {
    Vec3::new(nodes.x.y, nodes.y.y, nodes.z.y)
}

/// The vector at the high node.
#[inline]
pub fn high_node(nodes: &Nodes) -> Vec3 {
    Vec3::new(nodes.x.z, nodes.y.z, nodes.z.z)
}

/// The scalar product of each vector with `vector`.
#[inline]
pub fn dot_each(nodes: &Nodes, vector: Vec3) -> Vec3A {
    nodes.x * vector.x + nodes.y * vector.y + nodes.z * vector.z
}

/// The squared length of each vector.
#[inline]
pub fn length_squared_each(nodes: &Nodes) -> Vec3A {
    nodes.x * nodes.x + nodes.y * nodes.y + nodes.z * nodes.z
}

/// Each vector times its own factor.
#[inline]
pub fn scale_each(nodes: &Nodes, factor: Vec3A) -> Nodes {
    Nodes { x: nodes.x * factor, y: nodes.y * factor, z: nodes.z * factor }
}

/// `start` and, times its own factor, `along` at each node.
#[inline]
pub fn advance_each(start: &Nodes, along: &Nodes, factor: Vec3A) -> Nodes {
    Nodes {
        x: start.x + along.x * factor,
        y: start.y + along.y * factor,
        z: start.z + along.z * factor,
    }
}

/// Each vector and, times its own factor, `vector`.
#[inline]
pub fn shift_each(nodes: &Nodes, vector: Vec3, factor: Vec3A) -> Nodes {
    Nodes {
        x: nodes.x + factor * vector.x,
        y: nodes.y + factor * vector.y,
        z: nodes.z + factor * vector.z,
    }
}

/// Each vector brought to length 1; none of them is 0.
#[inline]
pub fn normalize_each(nodes: &Nodes) -> Nodes {
    scale_each(nodes, length_squared_each(nodes).sqrt().recip())
}

/// How much each node counts at `position`.
#[inline]
pub fn basis_at(position: f32) -> Vec3A {
    let half = 0.5 * position;
    Vec3A::new(half * (position - 1.0), 1.0 - position * position, half * (position + 1.0))
}

/// How much each node counts in the change of a value with the position.
#[inline]
pub fn slope_basis_at(position: f32) -> Vec3A {
    Vec3A::new(position - 0.5, -2.0 * position, position + 0.5)
}

/// What makes the values at three positions of those at the nodes.
#[inline]
pub fn basis_of(positions: Vec3A) -> Mat3A {
    let half = positions * 0.5;
    Mat3A::from_cols(
        half * (positions - Vec3A::ONE),
        Vec3A::ONE - positions * positions,
        half * (positions + Vec3A::ONE),
    )
}

/// The vector that `basis` makes of the nodes.
#[inline]
pub fn blend(nodes: &Nodes, basis: Vec3A) -> Vec3 {
    Vec3::new(nodes.x.dot(basis), nodes.y.dot(basis), nodes.z.dot(basis))
}

/// The vectors that `basis` makes of the nodes.
#[inline]
pub fn blend_nodes(nodes: &Nodes, basis: Mat3A) -> Nodes {
    Nodes { x: basis * nodes.x, y: basis * nodes.y, z: basis * nodes.z }
}
