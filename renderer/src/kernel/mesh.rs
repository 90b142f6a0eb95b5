//! Rays and triangle meshes: a binary hierarchy with watertight triangles.

use glam::Vec3;

use crate::accel::MAX_DEPTH;
use crate::kernel::ray::{FAR, Hit, Ray};
use crate::packed::{BvhNode, Instance, NONE, PackedScene, PackedTriangle};

/// Nodes that can wait at once: one per level.
pub const NODE_STACK: usize = MAX_DEPTH;

/// Enlarges the far end of a slab so that rounding can't skip a box (Ize 2013).
pub const SLAB_ROUNDING: f32 = 1.000_000_4;

/// Component of a direction below which it runs along the sides of a box.
pub const PARALLEL: f32 = 1e-20;

/// Which side of a surface may be met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// Against the outward normal: a ray outside enters.
    Front,
    /// Along the outward normal: a ray inside leaves.
    Back,
    /// Either: an opaque surface.
    Both,
}

/// A ray as node boxes see it.
#[derive(Clone, Copy, Debug)]
pub struct BoxRay {
    origin: Vec3,
    inverse_direction: Vec3,
}

impl BoxRay {
    /// For a ray from `origin` along `direction`, which may have zero components.
    #[inline]
    pub fn new(origin: Vec3, direction: Vec3) -> Self {
        // A component of 0 would make infinite what may then be multiplied by 0.
        let is_parallel = direction.abs().cmplt(Vec3::splat(PARALLEL));
        let direction = Vec3::select(is_parallel, Vec3::splat(PARALLEL), direction);
        Self { origin, inverse_direction: direction.recip() }
    }

    /// Distance at which the ray enters the node's box, [`FAR`] for a miss or an entry beyond
    /// `limit`.
    #[inline]
    pub fn box_entry(&self, node: &BvhNode, limit: f32) -> f32 {
        let t0 = (node.min - self.origin) * self.inverse_direction;
        let t1 = (node.max - self.origin) * self.inverse_direction;
        let near = t0.min(t1).max_element().max(0.0);
        let far = t0.max(t1).min_element() * SLAB_ROUNDING;
        if near <= far && near <= limit { near } else { FAR }
    }
}

/// Permutation and shear that lay a ray along +z (Woop, Benthin, Wald 2013).
#[derive(Clone, Copy, Debug)]
pub struct Shear {
    axes: [usize; 3],
    scale: Vec3,
}

impl Shear {
    /// For a ray along `direction`, which is not zero.
    #[inline]
    pub fn new(direction: Vec3) -> Self {
        let z = direction.abs().max_position();
        let (mut x, mut y) = ((z + 1) % 3, (z + 2) % 3);
        if direction[z] < 0.0 {
            (x, y) = (y, x);
        }
        let scale = Vec3::new(direction[x], direction[y], 1.0) / direction[z];
        Self { axes: [x, y, z], scale }
    }

    /// The point relative to the ray's origin, in the sheared frame.
    #[inline]
    pub fn shear_point(&self, point: Vec3) -> Vec3 {
        let [x, y, z] = self.axes;
        Vec3::new(
            point[x] - self.scale.x * point[z],
            point[y] - self.scale.y * point[z],
            self.scale.z * point[z],
        )
    }
}

/// Distance to the triangle, [`FAR`] for a miss. Neighbouring triangles leave no gap: their
/// common edge is judged by the same arithmetic.
#[inline]
pub fn triangle_distance(origin: Vec3, shear: &Shear, triangle: &PackedTriangle) -> f32 {
    let a = shear.shear_point(triangle.a - origin);
    let b = shear.shear_point(triangle.b - origin);
    let c = shear.shear_point(triangle.c - origin);
    let u = difference_of_products(c.x, b.y, c.y, b.x);
    let v = difference_of_products(a.x, c.y, a.y, c.x);
    let w = difference_of_products(b.x, a.y, b.y, a.x);
    let has_negative = u < 0.0 || v < 0.0 || w < 0.0;
    let has_positive = u > 0.0 || v > 0.0 || w > 0.0;
    let determinant = u + v + w;
    if (has_negative && has_positive) || determinant == 0.0 {
        return FAR;
    }
    let distance = (u * a.z + v * b.z + w * c.z) / determinant;
    if distance >= 0.0 { distance } else { FAR }
}

/// a·b − c·d, of the right sign: two triangles must see their common edge on opposite sides. Here
/// nothing is fused, so that rounding is the same on both.
#[inline]
pub fn difference_of_products(a: f32, b: f32, c: f32, d: f32) -> f32 {
    a * b - c * d
}

/// The nearest triangle of the mesh along the ray, closer than `limit`, met from one of `sides`.
///
/// `left_facet` is the facet the ray has just left, which it can't meet again, or [`NONE`].
#[inline]
pub fn meet_mesh(
    scene: &PackedScene,
    instance: &Instance,
    ray: &Ray,
    left_facet: u32,
    sides: Sides,
    limit: f32,
) -> Hit {
    let [row_x, row_y, row_z] = instance.object_from_world;
    let point = ray.origin.extend(1.0);
    let vector = ray.direction.extend(0.0);
    let origin = Vec3::new(row_x.dot(point), row_y.dot(point), row_z.dot(point));
    let direction = Vec3::new(row_x.dot(vector), row_y.dot(vector), row_z.dot(vector));
    let shear = Shear::new(direction);
    let box_ray = BoxRay::new(origin, direction);

    let mut hit = Hit { distance: limit, ..Hit::MISS };
    let mut stack = [0_u32; NODE_STACK];
    let mut count = 0;
    let mut current = instance.first;
    if box_ray.box_entry(&scene.nodes[current as usize], limit) == FAR {
        return Hit::MISS;
    }
    loop {
        let node = &scene.nodes[current as usize];
        if node.primitive_count > 0 {
            for i in node.first..node.first + node.primitive_count {
                let triangle = &scene.triangles[i as usize];
                if triangle.facet == left_facet || !faces(triangle, direction, sides) {
                    continue;
                }
                let distance = triangle_distance(origin, &shear, triangle);
                if distance < hit.distance {
                    hit.distance = distance;
                    hit.facet = triangle.facet;
                    hit.normal = triangle.normal();
                }
            }
        } else {
            let (mut near, mut far) = (node.first, node.first + 1);
            let mut near_entry = box_ray.box_entry(&scene.nodes[near as usize], hit.distance);
            let mut far_entry = box_ray.box_entry(&scene.nodes[far as usize], hit.distance);
            if far_entry < near_entry {
                (near, far) = (far, near);
                (near_entry, far_entry) = (far_entry, near_entry);
            }
            if near_entry < FAR {
                if far_entry < FAR {
                    stack[count] = far;
                    count += 1;
                }
                current = near;
                continue;
            }
        }
        if count == 0 {
            break;
        }
        count -= 1;
        current = stack[count];
    }
    if hit.facet == NONE {
        return Hit::MISS;
    }
    // The inverse transpose of the world matrix, up to a scale.
    let normal = row_x.truncate() * hit.normal.x
        + row_y.truncate() * hit.normal.y
        + row_z.truncate() * hit.normal.z;
    hit.normal = normal.normalize_or_zero();
    hit
}

/// Whether the triangle turns one of `sides` towards the ray.
#[inline]
pub fn faces(triangle: &PackedTriangle, direction: Vec3, sides: Sides) -> bool {
    let along = triangle.normal().dot(direction);
    match sides {
        Sides::Front => along < 0.0,
        Sides::Back => along > 0.0,
        Sides::Both => true,
    }
}
