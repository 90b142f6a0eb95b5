//! What becomes of a ray at an interface (the paper's `fork_rays`, `refract`, `total_reflect`).

use glam::Vec3;

use crate::kernel::deposit::mean_transmittance;
use crate::kernel::interface::{
    Interface, cos_refracted_squared, find_total_refl_wave, fresnel, is_totally_reflected, reflect,
    refract, relative_index,
};
use crate::kernel::ray::{Hit, Ray};
use crate::kernel::spread::{direction_at, perturb, spread_angle, spread_between, subray_count};
use crate::kernel::trace::Walk;
use crate::packed::{NONE, PackedScene};

/// Sends on what the interface at `hit` makes of `ray`, which has been moved to it.
#[inline]
pub fn fork_rays(walk: &mut Walk<'_>, ray: &Ray, hit: &Hit) {
    let interface = interface_at(walk.scene, ray, hit);
    let scene = walk.scene;
    let (low_nm, high_nm) = (ray.lambda_low_nm, ray.lambda_high_nm);
    let low_is_reflected =
        is_totally_reflected(scene, &interface, incident_at(walk, ray, low_nm), low_nm);
    let high_is_reflected =
        is_totally_reflected(scene, &interface, incident_at(walk, ray, high_nm), high_nm);
    if low_is_reflected && high_is_reflected {
        total_reflect(walk, ray, hit);
    } else if low_is_reflected || high_is_reflected {
        let dividing_nm = find_total_refl_wave(scene, &interface, ray, low_is_reflected);
        let below = sub_interval(walk, ray, low_nm, dividing_nm);
        let above = sub_interval(walk, ray, dividing_nm, high_nm);
        let (reflected, refracted) = if low_is_reflected { (below, above) } else { (above, below) };
        total_reflect(walk, &reflected, hit);
        split_and_refract(walk, &refracted, hit, &interface);
    } else {
        split_and_refract(walk, ray, hit, &interface);
    }
}

/// The interface with its normal on the ray's side and the media in the ray's order.
#[inline]
fn interface_at(scene: &PackedScene, ray: &Ray, hit: &Hit) -> Interface {
    let medium_of = |instance: u32| {
        let material = scene.instances[instance as usize].material;
        scene.materials[material as usize].index_table
    };
    let medium_from = if ray.inside == 1 { medium_of(ray.instance) } else { NONE };
    if is_leaving(ray, hit) {
        Interface { normal: -hit.normal, medium_from, medium_to: NONE }
    } else {
        Interface { normal: hit.normal, medium_from, medium_to: medium_of(hit.instance) }
    }
}

/// Whether the ray would pass out of the body that it meets.
#[inline]
fn is_leaving(ray: &Ray, hit: &Hit) -> bool {
    ray.inside == 1 && ray.instance == hit.instance
}

/// Direction at which light of `lambda_nm` arrives.
#[inline]
fn incident_at(walk: &Walk<'_>, ray: &Ray, lambda_nm: f32) -> Vec3 {
    if walk.pass.perturb { direction_at(ray, lambda_nm) } else { ray.direction }
}

/// The part of the ray between two wavelengths. Without `perturb` it keeps the direction of the
/// whole: the mistake of the paper's Fig. 3.
#[inline]
fn sub_interval(walk: &Walk<'_>, ray: &Ray, low_nm: f32, high_nm: f32) -> Ray {
    if walk.pass.perturb {
        perturb(ray, low_nm, high_nm)
    } else {
        Ray { lambda_low_nm: low_nm, lambda_high_nm: high_nm, ..*ray }
    }
}

/// Divides a ray of which nothing is totally reflected into sub-rays that are fine enough for
/// the smallest light, and refracts each.
#[inline]
fn split_and_refract(walk: &mut Walk<'_>, ray: &Ray, hit: &Hit, interface: &Interface) {
    let scene = walk.scene;
    let refracted_at = |walk: &Walk<'_>, lambda_nm: f32| {
        let eta = relative_index(scene, interface, lambda_nm);
        refract(incident_at(walk, ray, lambda_nm), interface.normal, eta)
    };
    let mut low_end = refracted_at(walk, ray.lambda_low_nm);
    let high_end = refracted_at(walk, ray.lambda_high_nm);
    let mut count = subray_count(
        walk.pass.split_count,
        spread_angle(ray.spread),
        spread_angle(spread_between(low_end, high_end)),
        scene.sky.light_spread,
    );
    if meets_second_absorber(scene, ray, hit) {
        let width_nm = ray.lambda_high_nm - ray.lambda_low_nm;
        count = count.max((width_nm / scene.bins.width_nm()).ceil() as u32);
    }
    let step_nm = (ray.lambda_high_nm - ray.lambda_low_nm) / count as f32;
    for i in 1..=count {
        let is_last = i == count;
        let low_nm = ray.lambda_low_nm + step_nm * (i - 1) as f32;
        let high_nm =
            if is_last { ray.lambda_high_nm } else { ray.lambda_low_nm + step_nm * i as f32 };
        let next_end = if is_last { high_end } else { refracted_at(walk, high_nm) };
        let sub_ray = if count == 1 { *ray } else { sub_interval(walk, ray, low_nm, high_nm) };
        refract_and_reflect(walk, &sub_ray, hit, interface, spread_between(low_end, next_end));
        low_end = next_end;
    }
}

/// Sends on the refracted and the reflected part of one sub-ray, weighted by Fresnel's
/// coefficients at its central wavelength. `spread` is that of the refracted ray, from its ends.
#[inline]
fn refract_and_reflect(
    walk: &mut Walk<'_>,
    ray: &Ray,
    hit: &Hit,
    interface: &Interface,
    spread: Vec3,
) {
    let central_nm = 0.5 * (ray.lambda_low_nm + ray.lambda_high_nm);
    let eta = relative_index(walk.scene, interface, central_nm);
    let cos_i = (-ray.direction.dot(interface.normal)).max(0.0);
    let cos_t = cos_refracted_squared(cos_i, eta).max(0.0).sqrt();
    let reflectance = if cos_t > 0.0 { fresnel(cos_i, cos_t, eta) } else { 1.0 };
    let mut reflected = reflected_ray(ray, hit);
    reflected.significance *= reflectance;
    walk.send(&reflected);
    let mut refracted = Ray {
        direction: refract(ray.direction, interface.normal, eta),
        spread,
        significance: ray.significance * (1.0 - reflectance),
        instance: hit.instance,
        facet: hit.facet,
        inside: u32::from(!is_leaving(ray, hit)),
        depth: ray.depth + 1,
        ..*ray
    };
    if refracted.inside == 1 {
        enter_absorber(walk, &mut refracted, hit);
    }
    walk.send(&refracted);
}

/// Sends on the whole ray, mirrored.
#[inline]
fn total_reflect(walk: &mut Walk<'_>, ray: &Ray, hit: &Hit) {
    let reflected = reflected_ray(ray, hit);
    walk.send(&reflected);
}

#[inline]
fn reflected_ray(ray: &Ray, hit: &Hit) -> Ray {
    Ray {
        direction: reflect(ray.direction, hit.normal),
        spread: reflect(ray.spread, hit.normal),
        instance: hit.instance,
        facet: hit.facet,
        inside: u32::from(is_leaving(ray, hit)),
        depth: ray.depth + 1,
        ..*ray
    }
}

/// The material that absorbs inside the body of `hit`, or [`NONE`].
#[inline]
fn absorber_of(scene: &PackedScene, hit: &Hit) -> u32 {
    let material = scene.instances[hit.instance as usize].material;
    if scene.materials[material as usize].absorption == NONE { NONE } else { material }
}

/// Whether the ray, having run through one coloured material, would enter another.
#[inline]
fn meets_second_absorber(scene: &PackedScene, ray: &Ray, hit: &Hit) -> bool {
    let next = absorber_of(scene, hit);
    ray.absorber != NONE && next != NONE && next != ray.absorber && !is_leaving(ray, hit)
}

/// Starts the path through a coloured body. A path through another one is paid for first; the
/// interval has been cut to one bin for that.
#[inline]
fn enter_absorber(walk: &mut Walk<'_>, ray: &mut Ray, hit: &Hit) {
    let next = absorber_of(walk.scene, hit);
    if next == NONE || next == ray.absorber {
        return;
    }
    let kept = mean_transmittance(walk.scene, ray);
    walk.tally.absorbed += ray.significance * ray.bandwidth() * (1.0 - kept);
    ray.significance *= kept;
    ray.absorber = next;
    ray.path_mm = 0.0;
}
