//! The nearest surface along a ray, over all bodies and the ground.

use crate::accel::MAX_DEPTH;
use crate::kernel::convex;
use crate::kernel::mesh::{self, BoxRay, Sides};
use crate::kernel::ray::{GROUND, Hit, Ray};
use crate::packed::{CONVEX, Instance, NONE, PackedScene};

/// Top-level nodes that can wait at once: one per level, and the one to look at.
const TOP_STACK: usize = MAX_DEPTH + 1;

/// How far, as a part of the way to the middle of the body, a lost ray is moved inwards.
const NUDGE: f32 = 1e-5;

/// A surface this close to another, in mm, touches it: rounding must not decide which is met.
pub const TOUCHING_MM: f32 = 1e-4;

/// The nearest surface along `ray`; [`Hit::MISS`] where there is none.
///
/// A ray inside a body meets that body's own surface before any that touches it.
#[inline]
pub fn find_intersection(scene: &PackedScene, ray: &Ray) -> Hit {
    let mut own = Hit::MISS;
    if ray.medium != NONE {
        own = meet_instance(scene, ray, ray.medium, f32::INFINITY);
        if scene.instances[ray.medium as usize].interior_is_clear == 1 {
            return own;
        }
    }
    let ground = meet_ground(scene, ray);
    let nearest = if ground.distance < own.distance - TOUCHING_MM { ground } else { own };
    let limit =
        if nearest.instance == GROUND { ground.distance } else { own.distance - TOUCHING_MM };
    let other = meet_bodies(scene, ray, limit, false);
    if other.instance == NONE { nearest } else { other }
}

/// Whether anything stands in the way of `ray`.
#[inline]
pub fn is_occluded(scene: &PackedScene, ray: &Ray) -> bool {
    meet_ground(scene, ray).instance != NONE
        || meet_bodies(scene, ray, f32::INFINITY, true).instance != NONE
}

/// A ray that a mesh seems not to let out, tried again from slightly further inside.
#[inline]
pub fn find_lost_exit(scene: &PackedScene, ray: &Ray) -> Hit {
    let center = scene.instances[ray.medium as usize].center;
    let nudged = Ray { origin: ray.origin + (center - ray.origin) * NUDGE, facet: NONE, ..*ray };
    meet_instance(scene, &nudged, ray.medium, f32::INFINITY)
}

/// The nearest body, or with `any` the first that is found.
#[inline]
fn meet_bodies(scene: &PackedScene, ray: &Ray, limit: f32, any: bool) -> Hit {
    let mut nearest = Hit { distance: limit, ..Hit::MISS };
    if scene.top_nodes.is_empty() {
        return Hit::MISS;
    }
    let box_ray = BoxRay::new(ray.origin, ray.direction);
    let mut stack = [0_u32; TOP_STACK];
    let mut count = 1;
    while count > 0 {
        count -= 1;
        let node = &scene.top_nodes[stack[count] as usize];
        if box_ray.entry(node, nearest.distance) == f32::INFINITY {
            continue;
        }
        if node.primitive_count == 0 {
            stack[count] = node.first + 1;
            stack[count + 1] = node.first;
            count += 2;
            continue;
        }
        for slot in node.first..node.first + node.primitive_count {
            let hit = meet_instance(scene, ray, scene.top_order[slot as usize], nearest.distance);
            if hit.distance < nearest.distance {
                nearest = hit;
                if any {
                    return nearest;
                }
            }
        }
    }
    nearest
}

/// Where the ray meets one body, from the side that the ray is on.
#[inline]
fn meet_instance(scene: &PackedScene, ray: &Ray, index: u32, limit: f32) -> Hit {
    let instance = &scene.instances[index as usize];
    let has_left_it = ray.instance == index;
    let is_inside = ray.medium == index;
    if ray.enclosing == index && !is_inside {
        // The ray is in a body inside this one, and must leave that first.
        return Hit::MISS;
    }
    let left_facet = if has_left_it { ray.facet } else { NONE };
    let mut hit = if instance.kind == CONVEX {
        if is_inside {
            convex::exit(scene, instance, ray, left_facet)
        } else if has_left_it {
            // What leaves a convex solid does not come back.
            Hit::MISS
        } else {
            convex::entry(scene, instance, ray)
        }
    } else {
        mesh::nearest(scene, instance, ray, left_facet, sides(scene, instance, is_inside), limit)
    };
    if hit.facet != NONE {
        hit.instance = index;
    }
    hit
}

#[inline]
fn sides(scene: &PackedScene, instance: &Instance, is_inside: bool) -> Sides {
    if scene.materials[instance.material as usize].is_opaque() {
        Sides::Both
    } else if is_inside {
        Sides::Back
    } else {
        Sides::Front
    }
}

#[inline]
fn meet_ground(scene: &PackedScene, ray: &Ray) -> Hit {
    if scene.ground.reflectance[0] == NONE || ray.instance == GROUND {
        return Hit::MISS;
    }
    let height = scene.ground.height - ray.origin.z;
    let distance = height / ray.direction.z;
    // What leaves a body that rests on the ground starts on it, or a rounding error below.
    let is_touching = ray.direction.z < 0.0 && height.abs() < TOUCHING_MM;
    if is_touching || (distance > 0.0 && distance.is_finite()) {
        Hit { distance: distance.max(0.0), instance: GROUND, facet: 0, normal: glam::Vec3::Z }
    } else {
        Hit::MISS
    }
}
