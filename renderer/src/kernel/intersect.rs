//! The nearest surface along a ray, over all bodies and the ground.

use glam::Vec3;

use crate::accel::MAX_DEPTH;
use crate::kernel::convex::{enter_convex, leave_convex};
use crate::kernel::mesh::{BoxRay, Sides, meet_mesh};
use crate::kernel::ray::{FAR, GROUND, Hit, Ray, TOUCHING_MM};
use crate::packed::{CONVEX, Instance, NONE, PackedScene};

/// Top-level nodes that can wait at once: one per level, and the one to look at.
pub const TOP_STACK: usize = MAX_DEPTH + 1;

/// How far, as a part of the way to the middle of the body, a lost ray is moved inwards.
pub const NUDGE: f32 = 1e-5;

/// The nearest surface along `ray`; [`Hit::MISS`] where there is none.
///
/// A ray inside a body meets that body's own surface before any that touches it.
#[expect(clippy::inline_always, reason = "most of what following a ray is, though others call it")]
#[inline(always)]
pub fn find_intersection(scene: &PackedScene, ray: &Ray) -> Hit {
    let mut own = Hit::MISS;
    if ray.medium != NONE {
        own = meet_instance(scene, ray, ray.medium, FAR);
        if scene.instances[ray.medium as usize].interior_is_clear == 1 {
            return own;
        }
    }
    let ground = meet_ground(scene, ray);
    let mut nearest = own;
    let mut limit = own.distance - TOUCHING_MM;
    if ground.distance < limit {
        nearest = ground;
        limit = ground.distance;
    }
    let other = meet_bodies(scene, ray, limit, false);
    if other.instance == NONE { nearest } else { other }
}

/// Whether anything stands in the way of `ray`.
#[inline]
pub fn is_occluded(scene: &PackedScene, ray: &Ray) -> bool {
    meet_ground(scene, ray).instance != NONE || meet_bodies(scene, ray, FAR, true).instance != NONE
}

/// The ray inside a body, from slightly further inside and met by every facet.
#[inline]
pub fn nudge_inwards(scene: &PackedScene, ray: &Ray) -> Ray {
    let center = scene.instances[ray.medium as usize].center;
    let mut nudged = *ray;
    nudged.origin += (center - ray.origin) * NUDGE;
    nudged.facet = NONE;
    nudged
}

/// The nearest body, or with `any` the first that is found.
#[inline]
pub fn meet_bodies(scene: &PackedScene, ray: &Ray, limit: f32, any: bool) -> Hit {
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
        if box_ray.box_entry(node, nearest.distance) == FAR {
            continue;
        }
        if node.primitive_count == 0 {
            stack[count] = node.first + 1;
            stack[count + 1] = node.first;
            count += 2;
            continue;
        }
        for slot in node.first..node.first + node.primitive_count {
            let hit = meet_instance(scene, ray, scene.words[slot as usize], nearest.distance);
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
pub fn meet_instance(scene: &PackedScene, ray: &Ray, index: u32, limit: f32) -> Hit {
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
            leave_convex(scene, instance, ray, left_facet)
        } else if has_left_it {
            // What leaves a convex solid does not come back.
            Hit::MISS
        } else {
            enter_convex(scene, instance, ray)
        }
    } else {
        meet_mesh(scene, instance, ray, left_facet, sides(scene, instance, is_inside), limit)
    };
    if hit.facet != NONE {
        hit.instance = index;
    }
    hit
}

/// The sides from which a body is met.
#[inline]
pub fn sides(scene: &PackedScene, instance: &Instance, is_inside: bool) -> Sides {
    if scene.materials[instance.material as usize].is_opaque() {
        Sides::Both
    } else if is_inside {
        Sides::Back
    } else {
        Sides::Front
    }
}

/// Where the ray meets the ground; a ray that has just left it never does.
#[inline]
pub fn meet_ground(scene: &PackedScene, ray: &Ray) -> Hit {
    if scene.ground.reflectance[0] == NONE || ray.instance == GROUND {
        return Hit::MISS;
    }
    let height = scene.ground.height - ray.origin.z;
    // What leaves a body that rests on the ground starts on it, or a rounding error below.
    let is_touching = ray.direction.z < 0.0 && height.abs() < TOUCHING_MM;
    // So does what goes up inside it.
    let is_resting = ray.medium != NONE && ray.direction.z > 0.0 && height < TOUCHING_MM;
    let is_ahead = height * ray.direction.z > 0.0 && !is_resting;
    if !is_touching && !is_ahead {
        return Hit::MISS;
    }
    let distance = (height / ray.direction.z).max(0.0);
    Hit { distance, instance: GROUND, facet: 0, normal: Vec3::Z }
}
