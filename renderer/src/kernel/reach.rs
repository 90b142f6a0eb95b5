//! How far about its middle a fan meets one and the same surface.

use glam::Vec3A;

use crate::kernel::facet::clip_to_facet;
use crate::kernel::fan::{Fan, gathered, is_dispersed, ray_in_fan};
use crate::kernel::fan_walk::{is_worth_dividing, least_of};
use crate::kernel::intersect::find_intersection;
use crate::kernel::nodes::{Nodes, advance_each, dot_each, scale_each};
use crate::kernel::ray::{Hit, Ray};
use crate::kernel::trace::runs_in_absorber;
use crate::kernel::walk::Walk;
use crate::packed::{CONVEX, NONE, PackedScene};

/// Halvings in search of the wavelength at which a fan leaves a surface that is no facet of a convex
/// body, or that something may stand in front of.
pub const REACH_BISECTIONS: u32 = 10;

/// Cosine to a surface's normal below which a ray is not followed to it.
pub const GRAZING: f32 = 1e-4;

/// How far behind its start, in mm, rounding may put the point where a ray meets a surface.
pub const DRIFT_MM: f32 = 1e-3;

/// The part of the fan about its middle, between two positions in it, whose rays meet the surface
/// that the middle one meets at `hit`, or as it nothing.
#[inline]
pub fn reach(walk: &mut Walk<'_, Fan>, fan: &Fan, middle: &Ray, hit: &Hit) -> [f32; 2] {
    let scene = walk.scene;
    let mut reached = [-1.0, 1.0];
    if !is_dispersed(fan) || !is_worth_dividing(walk.rules, fan) {
        return reached;
    }
    let is_convex = is_convex_body(scene, hit.instance);
    if is_convex {
        reached = clip_fan(scene, fan, middle, hit);
    }
    if !is_convex || !is_unobstructed(scene, middle) {
        for end in &mut reached {
            *end = reach_towards(walk, fan, hit, *end);
        }
    }
    reached
}

/// Whether the instance is a convex body.
#[inline]
pub fn is_convex_body(scene: &PackedScene, instance: u32) -> bool {
    (instance as usize) < scene.instances.len() && scene.instances[instance as usize].kind == CONVEX
}

/// Whether only the body that the ray runs in, or the only one, can be met: no other surface can
/// stand in front of its facets.
#[inline]
pub fn is_unobstructed(scene: &PackedScene, ray: &Ray) -> bool {
    if ray.medium != NONE {
        return scene.instances[ray.medium as usize].interior_is_clear == 1;
    }
    is_single(scene)
}

/// Whether the scene has one body and no ground.
#[inline]
pub fn is_single(scene: &PackedScene) -> bool {
    scene.instances.len() == 1 && scene.ground.reflectance[0] == NONE
}

/// The part of the fan whose rays cross the plane of the facet at `hit` within the facet.
#[inline]
pub fn clip_fan(scene: &PackedScene, fan: &Fan, middle: &Ray, hit: &Hit) -> [f32; 2] {
    // A point in homogeneous coordinates, which is smooth also where a ray turns away from the plane:
    // the point itself is `points` over `scale`.
    let plane_distance = (middle.origin + middle.direction * hit.distance).dot(hit.normal);
    let side = if middle.medium == hit.instance { 1.0 } else { -1.0 };
    let scale = dot_each(&fan.direction, hit.normal) * side;
    let gap = (Vec3A::splat(plane_distance) - dot_each(&fan.origin, hit.normal)) * side;
    let points: Nodes = advance_each(&scale_each(&fan.origin, scale), &fan.direction, gap);
    let instance = &scene.instances[hit.instance as usize];
    clip_to_facet(scene, instance, &points, scale)
}

/// The position nearest to `end`, coming from the middle, whose ray meets the same surface as the
/// middle one.
#[inline]
pub fn reach_towards(walk: &mut Walk<'_, Fan>, fan: &Fan, hit: &Hit, end: f32) -> f32 {
    let mut same = 0.0;
    let mut other = end;
    let mut tried = end;
    for _ in 0..=REACH_BISECTIONS {
        if meets_same(walk, fan, hit, tried) {
            same = tried;
        } else {
            other = tried;
        }
        if same == end {
            break;
        }
        tried = 0.5 * (same + other);
    }
    same
}

/// Whether the ray at a position in the fan meets the facet at `hit`.
#[inline]
pub fn meets_same(walk: &mut Walk<'_, Fan>, fan: &Fan, hit: &Hit, position: f32) -> bool {
    walk.tally.segments += 1;
    let found = find_intersection(walk.scene, &ray_in_fan(fan, position));
    found.instance == hit.instance && found.facet == hit.facet
}

/// Moves the fan to the plane of the surface at `hit`, `height` from the origin along its normal. Where
/// a ray of its ends does not come to the plane, which is so only in a fan that was not worth
/// dividing, all take the middle one's place.
#[inline]
pub fn arrive(scene: &PackedScene, fan: &mut Fan, hit: &Hit, height: f32) {
    let along = dot_each(&fan.direction, hit.normal);
    let sense = if along.y < 0.0 { -1.0 } else { 1.0 };
    let towards = along * sense;
    let gap = (Vec3A::splat(height) - dot_each(&fan.origin, hit.normal)) * sense;
    let mut distance = gap / towards.max(Vec3A::splat(1e-12));
    if least_of(towards) < GRAZING || least_of(distance) < -DRIFT_MM {
        *fan = gathered(fan);
        distance = Vec3A::splat(distance.y);
    }
    fan.origin = advance_each(&fan.origin, &fan.direction, distance);
    if runs_in_absorber(scene, fan.absorber, fan.medium) {
        fan.path_mm += distance;
    }
}
