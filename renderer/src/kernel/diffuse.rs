//! Opaque diffuse surfaces under discs and sky, with shadow rays.

use std::f32::consts::{FRAC_1_PI, TAU};

use glam::Vec3;

use crate::kernel::deposit::{Reflectance, deposit};
use crate::kernel::intersect::is_occluded;
use crate::kernel::passage::shine_through;
use crate::kernel::print::print_reflectance;
use crate::kernel::ray::{GROUND, Hit, Ray};
use crate::kernel::rng;
use crate::kernel::walk::Walk;
use crate::packed::{NONE, PackedDisc};

/// Deposits the light that the surface at `hit` sends back along `ray`, which ends there.
///
/// Each disc counts with its solid angle (Thomas 1986: 2π(1 − √(1 − s²))) and is asked for by one
/// shadow ray to a point on it that changes from pass to pass; so, last, is the sky.
#[inline]
pub fn shade_diffuse<R: Copy>(walk: &mut Walk<'_, R>, ray: &Ray, hit: &Hit) {
    let scene = walk.scene;
    let sky = &scene.sky;
    let reflectance = &reflectance_at(walk, ray, hit);
    let normal = if ray.direction.dot(hit.normal) > 0.0 { -hit.normal } else { hit.normal };
    let disc_count = scene.discs.len() as u32;
    let has_sky = sky.hemisphere != NONE || sky.environment != NONE;
    for light in 0..disc_count + u32::from(has_sky) {
        let is_sky = light == disc_count;
        let sample = rng::light_sample(walk.next_seed(), walk.pass_index);
        let direction;
        let mut scale = 1.0;
        if is_sky {
            direction = direction_by_cosine(normal, sample);
        } else {
            let disc = &scene.discs[light as usize];
            direction = direction_on_disc(disc, sample);
            scale = FRAC_1_PI * disc.solid_angle * direction.dot(normal);
            shine_through(walk, ray, hit, normal, light, direction, reflectance);
        }
        if scale <= 0.0 || is_shadowed(walk, ray, hit, direction) {
            continue;
        }
        if !is_sky {
            deposit(walk, ray, scene.discs[light as usize].spectrum, reflectance, scale);
            continue;
        }
        if sky.environment != NONE {
            deposit(walk, ray, sky.environment, reflectance, scale);
        }
        if sky.hemisphere != NONE && direction.z > 0.0 {
            deposit(walk, ray, sky.hemisphere, reflectance, scale);
        }
    }
}

/// The reflectance of the surface where the ray ends.
#[inline]
pub fn reflectance_at<R: Copy>(walk: &Walk<'_, R>, ray: &Ray, hit: &Hit) -> Reflectance {
    let scene = walk.scene;
    if hit.instance != GROUND {
        let material = scene.material_of(hit.instance);
        if material.print.texels == NONE {
            return Reflectance::bare(material.reflectance);
        }
        return print_reflectance(scene, material, hit, ray.origin);
    }
    let square_x = (ray.origin.x / scene.ground.square).floor();
    let square_y = (ray.origin.y / scene.ground.square).floor();
    let half = (square_x + square_y) * 0.5;
    let is_odd = half != half.floor();
    Reflectance::bare(scene.ground.reflectance[usize::from(is_odd)])
}

/// Whether something stands between the surface and the light in `direction`.
#[inline]
pub fn is_shadowed<R: Copy>(walk: &mut Walk<'_, R>, ray: &Ray, hit: &Hit, direction: Vec3) -> bool {
    walk.tally.segments += 1;
    let mut shadow_ray = Ray::white(ray.origin, direction);
    shadow_ray.instance = hit.instance;
    shadow_ray.facet = hit.facet;
    is_occluded(walk.scene, &shadow_ray)
}

/// Two unit vectors at right angles to the unit vector `normal` and to each other (Duff et al.
/// 2017).
#[inline]
pub fn orthonormal_pair(normal: Vec3) -> (Vec3, Vec3) {
    let sign = if normal.z < 0.0 { -1.0 } else { 1.0 };
    let a = -1.0 / (sign + normal.z);
    let b = normal.x * normal.y * a;
    (
        Vec3::new(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x),
        Vec3::new(b, sign + normal.y * normal.y * a, -normal.y),
    )
}

/// A direction evenly distributed over the disc's solid angle.
#[inline]
pub fn direction_on_disc(disc: &PackedDisc, [u, v]: [f32; 2]) -> Vec3 {
    // 1 − cos of the radius, without the cancellation of the plain difference.
    let height = disc.sin_squared_radius / (1.0 + disc.cos_radius);
    let fall = u * height;
    let sin = (fall * (2.0 - fall)).max(0.0).sqrt();
    let (sin_azimuth, cos_azimuth) = (TAU * (v - 0.5)).sin_cos();
    let (tangent, bitangent) = orthonormal_pair(disc.direction);
    (tangent * (sin * cos_azimuth)
        + bitangent * (sin * sin_azimuth)
        + disc.direction * (1.0 - fall))
        .normalize_or_zero()
}

/// A direction about `normal` with a density proportional to its cosine.
#[inline]
pub fn direction_by_cosine(normal: Vec3, [u, v]: [f32; 2]) -> Vec3 {
    let (sin_azimuth, cos_azimuth) = (TAU * (v - 0.5)).sin_cos();
    let radius = u.sqrt();
    let (tangent, bitangent) = orthonormal_pair(normal);
    (tangent * (radius * cos_azimuth)
        + bitangent * (radius * sin_azimuth)
        + normal * (1.0 - u).max(0.0).sqrt())
    .normalize_or_zero()
}
