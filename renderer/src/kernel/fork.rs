//! What becomes of a ray at an interface (the paper's `fork_rays` and `refract`).

use glam::Vec3;

use crate::kernel::absorption::mean_transmittance;
use crate::kernel::interface::{
    Interface, cos_refracted_squared, find_total_refl_wave, fresnel, is_totally_reflected, reflect,
    refract, relative_index,
};
use crate::kernel::ray::{Hit, Ray};
use crate::kernel::spread::{
    direction_at, fan_at, perturb, spread_angle, spread_between, subray_count,
};
use crate::kernel::walk::Walk;
use crate::packed::{NONE, PackedScene};

/// Sends on what the interface at `hit` makes of `ray`, which has been moved to it.
#[inline]
pub fn fork_rays(walk: &mut Walk<'_>, ray: &Ray, hit: &Hit) {
    let scene = walk.scene;
    let at = interface_at(scene, ray, hit);
    let mut incident = *ray;
    if walk.rules.perturb == 0 {
        // Every wavelength arrives from one direction: the mistake of Fig. 3.
        incident.spread = Vec3::ZERO;
    }
    let (low_nm, high_nm) = (ray.lambda_low_nm, ray.lambda_high_nm);
    let low_is_reflected = is_totally_reflected(scene, &at, fan_at(&incident, low_nm), low_nm);
    let high_is_reflected = is_totally_reflected(scene, &at, fan_at(&incident, high_nm), high_nm);
    let mut reflected = *ray;
    let mut refracted = incident;
    let mut refracted_spread = ray.spread;
    if low_is_reflected != high_is_reflected {
        let dividing_nm = find_total_refl_wave(scene, &at, &incident, low_is_reflected);
        reflected = perturb(&incident, low_nm, dividing_nm);
        refracted = perturb(&incident, dividing_nm, high_nm);
        if high_is_reflected {
            (reflected, refracted) = (refracted, reflected);
        }
        refracted_spread = refracted.spread;
    }
    if low_is_reflected || high_is_reflected {
        walk.send(&reflected_ray(&reflected, hit, &at));
    }
    if !low_is_reflected || !high_is_reflected {
        split_and_refract(walk, &refracted, refracted_spread, hit, &at);
    }
}

/// The body that the ray would be in beyond the surface at `hit`, or [`NONE`].
#[inline]
pub fn medium_beyond(ray: &Ray, hit: &Hit) -> u32 {
    if ray.medium == hit.instance { ray.enclosing } else { hit.instance }
}

/// The interface with its normal on the ray's side and the media in the ray's order.
#[inline]
pub fn interface_at(scene: &PackedScene, ray: &Ray, hit: &Hit) -> Interface {
    Interface {
        normal: if ray.medium == hit.instance { -hit.normal } else { hit.normal },
        medium_from: index_table_of(scene, ray.medium),
        medium_to: index_table_of(scene, medium_beyond(ray, hit)),
    }
}

/// The index table of a body, or [`NONE`] for air.
#[inline]
pub fn index_table_of(scene: &PackedScene, instance: u32) -> u32 {
    if instance == NONE { NONE } else { scene.material_of(instance).index_table }
}

/// Divides a ray of which nothing is totally reflected into sub-rays that are fine enough for
/// the smallest light, and refracts each. `spread` is the one that counts for their number.
#[inline]
pub fn split_and_refract(walk: &mut Walk<'_>, ray: &Ray, spread: Vec3, hit: &Hit, at: &Interface) {
    let scene = walk.scene;
    let (low_nm, high_nm) = (ray.lambda_low_nm, ray.lambda_high_nm);
    let mut low_end = refracted_at(scene, ray, at, low_nm);
    let last_end = refracted_at(scene, ray, at, high_nm);
    let dispersed = spread_angle(spread_between(low_end, last_end));
    let light_spread = scene.sky.light_spread;
    let mut count =
        subray_count(walk.rules.split_count, spread_angle(spread), dispersed, light_spread);
    if meets_second_absorber(scene, ray, hit) {
        count = count.max(((high_nm - low_nm) / scene.bins.width_nm()).ceil() as u32);
    }
    let mut edge_nm = low_nm;
    for i in 1..=count {
        let mut sub_ray = *ray;
        let mut high_end = last_end;
        if count > 1 {
            let next_nm = low_nm + (high_nm - low_nm) * (i as f32 / count as f32);
            sub_ray = perturb(ray, edge_nm, next_nm);
            edge_nm = next_nm;
        }
        if i < count {
            high_end = refracted_at(scene, ray, at, edge_nm);
        }
        refract_and_reflect(walk, &sub_ray, hit, at, spread_between(low_end, high_end));
        low_end = high_end;
    }
}

/// Unit direction of the refracted light of `lambda_nm`.
#[inline]
pub fn refracted_at(scene: &PackedScene, ray: &Ray, at: &Interface, lambda_nm: f32) -> Vec3 {
    let eta = relative_index(scene, at, lambda_nm);
    refract(direction_at(ray, lambda_nm), at.normal, eta)
}

/// Sends on the refracted and the reflected part of one sub-ray, weighted by Fresnel's
/// coefficients at its central wavelength. `spread` is that of the refracted ray, from its ends.
#[inline]
pub fn refract_and_reflect(
    walk: &mut Walk<'_>,
    ray: &Ray,
    hit: &Hit,
    at: &Interface,
    spread: Vec3,
) {
    let central_nm = 0.5 * (ray.lambda_low_nm + ray.lambda_high_nm);
    let eta = relative_index(walk.scene, at, central_nm);
    let cos_i = -ray.direction.dot(at.normal);
    let cos_t_squared = cos_refracted_squared(cos_i, eta);
    let mut reflectance = 1.0;
    if cos_i > 0.0 && cos_t_squared > 0.0 {
        reflectance = fresnel(cos_i, cos_t_squared.sqrt(), eta);
    }
    let mut reflected = reflected_ray(ray, hit, at);
    reflected.significance *= reflectance;
    walk.send(&reflected);
    if reflectance == 1.0 {
        return;
    }
    let medium = medium_beyond(ray, hit);
    let mut refracted = *ray;
    refracted.direction = refract(ray.direction, at.normal, eta);
    refracted.spread = spread;
    refracted.significance *= 1.0 - reflectance;
    refracted.instance = hit.instance;
    refracted.facet = hit.facet;
    refracted.medium = medium;
    refracted.enclosing = if medium == hit.instance { ray.medium } else { NONE };
    refracted.depth += 1;
    let refracted = enter_absorber(walk, refracted);
    walk.send(&refracted);
}

/// The whole ray, mirrored.
#[inline]
pub fn reflected_ray(ray: &Ray, hit: &Hit, at: &Interface) -> Ray {
    let mut reflected = *ray;
    reflected.instance = hit.instance;
    reflected.facet = hit.facet;
    reflected.depth += 1;
    // At grazing incidence `perturb` may turn a sub-ray away from the surface: it goes on as it is.
    if ray.direction.dot(at.normal) < 0.0 {
        reflected.direction = reflect(ray.direction, at.normal);
        reflected.spread = reflect(ray.spread, at.normal);
    }
    reflected
}

/// The material that absorbs inside the body `instance`, or [`NONE`].
#[inline]
pub fn absorber_of(scene: &PackedScene, instance: u32) -> u32 {
    if instance == NONE || scene.material_of(instance).absorption == NONE {
        return NONE;
    }
    scene.instances[instance as usize].material
}

/// Whether the ray, having run through one coloured material, would enter another.
#[inline]
pub fn meets_second_absorber(scene: &PackedScene, ray: &Ray, hit: &Hit) -> bool {
    let next = absorber_of(scene, medium_beyond(ray, hit));
    ray.absorber != NONE && next != NONE && next != ray.absorber
}

/// The ray with the path through its medium begun if that is coloured. A path through another one is
/// paid for first, by its mean over the interval, which for that is at most one bin wide.
#[inline]
pub fn enter_absorber(walk: &mut Walk<'_>, mut ray: Ray) -> Ray {
    let next = absorber_of(walk.scene, ray.medium);
    if next == NONE || next == ray.absorber {
        return ray;
    }
    let kept = mean_transmittance(walk.scene, &ray);
    walk.tally.absorbed += ray.significance * ray.bandwidth() * (1.0 - kept);
    ray.significance *= kept;
    ray.absorber = next;
    ray.path_mm = 0.0;
    ray
}
