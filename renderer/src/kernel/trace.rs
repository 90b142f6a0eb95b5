//! Following rays through the tree of a camera ray's descendants (the paper's `ray_solid`).

use crate::kernel::diffuse::shade_diffuse;
use crate::kernel::fork::fork_rays;
use crate::kernel::intersect::{find_intersection, nudge_inwards};
use crate::kernel::lights::ray_light;
use crate::kernel::ray::{GROUND, Hit, Ray};
use crate::kernel::walk::Walk;
use crate::packed::{NONE, PackedScene};

/// Follows `camera_ray` and all that comes of it to the end.
#[inline]
pub fn trace(walk: &mut Walk<'_>, camera_ray: &Ray) {
    walk.send(camera_ray);
    while walk.has_rays() {
        follow(walk);
    }
}

/// Takes the next ray that waits to the next surface, or to the lights.
#[expect(clippy::inline_always, reason = "a part of the loop above, though others call it too")]
#[inline(always)]
pub fn follow(walk: &mut Walk<'_>) {
    let scene = walk.scene;
    let mut ray = walk.pop();
    walk.tally.segments += 1;
    walk.tally.depth = walk.tally.depth.max(ray.depth);
    let hit = next_surface(scene, &mut ray);
    if hit.instance != NONE {
        ray.origin += ray.direction * hit.distance;
        if runs_in_absorber(scene, ray.absorber, ray.medium) {
            ray.path_mm += hit.distance;
        }
        if !meets_opaque(scene, &hit) {
            fork_rays(walk, &ray, &hit);
            return;
        }
        shade_diffuse(walk, &ray, &hit);
    } else if ray.medium == NONE {
        ray_light(walk, &ray);
    }
    let energy = walk.retire(&ray);
    if is_lost(&ray, &hit) {
        walk.tally.lost += energy;
    } else {
        walk.tally.returned += energy;
    }
}

/// The next surface along a ray. One that a mesh seems not to let out tries once more, and is left
/// slightly further inside.
#[expect(clippy::inline_always, reason = "a part of the loop above, though the record calls it")]
#[inline(always)]
pub fn next_surface(scene: &PackedScene, ray: &mut Ray) -> Hit {
    let mut hit = Hit::MISS;
    for attempt in 0..2 {
        if attempt > 0 {
            *ray = nudge_inwards(scene, ray);
        }
        hit = find_intersection(scene, ray);
        if !is_lost(ray, &hit) {
            break;
        }
    }
    hit
}

/// Whether the ray is inside of a body that it does not meet from there.
#[inline]
pub fn is_lost(ray: &Ray, hit: &Hit) -> bool {
    hit.instance == NONE && ray.medium != NONE
}

/// Whether the body `medium` that a ray runs in is of the material `absorber` whose path it counts.
#[inline]
pub fn runs_in_absorber(scene: &PackedScene, absorber: u32, medium: u32) -> bool {
    absorber != NONE && medium != NONE && scene.instances[medium as usize].material == absorber
}

/// Whether the ray ends at `hit`.
#[inline]
pub fn meets_opaque(scene: &PackedScene, hit: &Hit) -> bool {
    hit.instance == GROUND || scene.material_of(hit.instance).is_opaque()
}
