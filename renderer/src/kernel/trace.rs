//! Following rays through the tree of a camera ray's descendants (the paper's `ray_solid`).

use crate::kernel::diffuse::shade_diffuse;
use crate::kernel::fork::fork_rays;
use crate::kernel::intersect::{find_intersection, find_lost_exit};
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
#[inline]
pub fn follow(walk: &mut Walk<'_>) {
    let scene = walk.scene;
    let mut ray = walk.pop();
    walk.tally.segments += 1;
    let mut hit = find_intersection(scene, &ray);
    if hit.instance == NONE && ray.medium != NONE {
        hit = find_lost_exit(scene, &ray);
        if hit.instance == NONE {
            walk.tally.lost += walk.retire(&ray);
            return;
        }
    }
    if hit.instance == NONE {
        ray_light(walk, &ray);
        walk.tally.returned += walk.retire(&ray);
        return;
    }
    ray.origin += ray.direction * hit.distance;
    if runs_in_absorber(scene, &ray) {
        ray.path_mm += hit.distance;
    }
    if meets_opaque(scene, &hit) {
        shade_diffuse(walk, &ray, &hit);
        walk.tally.returned += walk.retire(&ray);
    } else {
        fork_rays(walk, &ray, &hit);
    }
}

/// Whether the ray's medium is the material whose path it counts.
#[inline]
pub fn runs_in_absorber(scene: &PackedScene, ray: &Ray) -> bool {
    ray.absorber != NONE
        && ray.medium != NONE
        && scene.instances[ray.medium as usize].material == ray.absorber
}

/// Whether the ray ends at `hit`.
#[inline]
pub fn meets_opaque(scene: &PackedScene, hit: &Hit) -> bool {
    hit.instance == GROUND || scene.material_of(hit.instance).is_opaque()
}
