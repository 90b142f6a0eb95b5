//! What becomes of a ray at an interface (the paper's `fork_rays`, `refract`, `total_reflect`).

use glam::Vec3;

use crate::kernel::deposit::mean_transmittance;
use crate::kernel::interface::{
    Interface, cos_refracted_squared, find_total_refl_wave, fresnel, is_totally_reflected, reflect,
    refract, relative_index,
};
use crate::kernel::ray::{Hit, Ray};
use crate::kernel::spread::{
    direction_at, fan_at, perturb, spread_angle, spread_between, subray_count,
};
use crate::kernel::trace::Walk;
use crate::packed::{NONE, PackedScene};

/// Sends on what the interface at `hit` makes of `ray`, which has been moved to it.
#[inline]
pub fn fork_rays(walk: &mut Walk<'_>, ray: &Ray, hit: &Hit) {
    let scene = walk.scene;
    let interface = interface_at(scene, ray, hit);
    // Without `perturb` every wavelength arrives from one direction: the mistake of Fig. 3.
    let incident = if walk.pass.perturb { *ray } else { Ray { spread: Vec3::ZERO, ..*ray } };
    let (low_nm, high_nm) = (ray.lambda_low_nm, ray.lambda_high_nm);
    let is_reflected = |lambda_nm: f32| {
        is_totally_reflected(scene, &interface, fan_at(&incident, lambda_nm), lambda_nm)
    };
    match (is_reflected(low_nm), is_reflected(high_nm)) {
        (true, true) => total_reflect(walk, ray, hit, &interface),
        (false, false) => split_and_refract(walk, &incident, ray.spread, hit, &interface),
        (low_is_reflected, _) => {
            let dividing_nm = find_total_refl_wave(scene, &interface, &incident, low_is_reflected);
            let below = perturb(&incident, low_nm, dividing_nm);
            let above = perturb(&incident, dividing_nm, high_nm);
            let (reflected, refracted) =
                if low_is_reflected { (below, above) } else { (above, below) };
            total_reflect(walk, &reflected, hit, &interface);
            split_and_refract(walk, &refracted, refracted.spread, hit, &interface);
        }
    }
}

/// The body that the ray would be in beyond the surface at `hit`, or [`NONE`].
#[inline]
fn medium_beyond(ray: &Ray, hit: &Hit) -> u32 {
    if ray.medium == hit.instance { ray.enclosing } else { hit.instance }
}

/// The interface with its normal on the ray's side and the media in the ray's order.
#[inline]
fn interface_at(scene: &PackedScene, ray: &Ray, hit: &Hit) -> Interface {
    let index_table = |instance: u32| {
        if instance == NONE { NONE } else { scene.material_of(instance).index_table }
    };
    Interface {
        normal: if ray.medium == hit.instance { -hit.normal } else { hit.normal },
        medium_from: index_table(ray.medium),
        medium_to: index_table(medium_beyond(ray, hit)),
    }
}

/// Divides a ray of which nothing is totally reflected into sub-rays that are fine enough for
/// the smallest light, and refracts each. `spread` is the one that counts for their number.
#[inline]
fn split_and_refract(
    walk: &mut Walk<'_>,
    ray: &Ray,
    spread: Vec3,
    hit: &Hit,
    interface: &Interface,
) {
    let scene = walk.scene;
    let refracted_at = |lambda_nm: f32| {
        let eta = relative_index(scene, interface, lambda_nm);
        refract(direction_at(ray, lambda_nm), interface.normal, eta)
    };
    let (low_nm, high_nm) = (ray.lambda_low_nm, ray.lambda_high_nm);
    let mut low_end = refracted_at(low_nm);
    let last_end = refracted_at(high_nm);
    let dispersed = spread_angle(spread_between(low_end, last_end));
    let light_spread = scene.sky.light_spread;
    let mut count =
        subray_count(walk.pass.split_count, spread_angle(spread), dispersed, light_spread);
    if meets_second_absorber(scene, ray, hit) {
        count = count.max(((high_nm - low_nm) / scene.bins.width_nm()).ceil() as u32);
    }
    if count == 1 {
        refract_and_reflect(walk, ray, hit, interface, spread_between(low_end, last_end));
        return;
    }
    let edge_nm = |i: u32| low_nm + (high_nm - low_nm) * (i as f32 / count as f32);
    for i in 0..count {
        let sub_ray = perturb(ray, edge_nm(i), edge_nm(i + 1));
        let high_end = if i + 1 == count { last_end } else { refracted_at(edge_nm(i + 1)) };
        refract_and_reflect(walk, &sub_ray, hit, interface, spread_between(low_end, high_end));
        low_end = high_end;
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
    let cos_i = -ray.direction.dot(interface.normal);
    let cos_t_squared = cos_refracted_squared(cos_i, eta);
    if cos_i <= 0.0 || cos_t_squared <= 0.0 {
        total_reflect(walk, ray, hit, interface);
        return;
    }
    let reflectance = fresnel(cos_i, cos_t_squared.sqrt(), eta);
    let mut reflected = reflected_ray(ray, hit, interface);
    reflected.significance *= reflectance;
    walk.send(&reflected);
    let medium = medium_beyond(ray, hit);
    let mut refracted = Ray {
        direction: refract(ray.direction, interface.normal, eta),
        spread,
        significance: ray.significance * (1.0 - reflectance),
        instance: hit.instance,
        facet: hit.facet,
        medium,
        enclosing: if medium == hit.instance { ray.medium } else { NONE },
        depth: ray.depth + 1,
        ..*ray
    };
    enter_absorber(walk, &mut refracted);
    walk.send(&refracted);
}

/// Sends on the whole ray, mirrored.
#[inline]
fn total_reflect(walk: &mut Walk<'_>, ray: &Ray, hit: &Hit, interface: &Interface) {
    let reflected = reflected_ray(ray, hit, interface);
    walk.send(&reflected);
}

#[inline]
fn reflected_ray(ray: &Ray, hit: &Hit, interface: &Interface) -> Ray {
    let mut reflected =
        Ray { instance: hit.instance, facet: hit.facet, depth: ray.depth + 1, ..*ray };
    // At grazing incidence `perturb` may turn a sub-ray away from the surface: it goes on as it is.
    if ray.direction.dot(interface.normal) < 0.0 {
        reflected.direction = reflect(ray.direction, interface.normal);
        reflected.spread = reflect(ray.spread, interface.normal);
    }
    reflected
}

/// The material that absorbs inside the body `instance`, or [`NONE`].
#[inline]
fn absorber_of(scene: &PackedScene, instance: u32) -> u32 {
    if instance == NONE || scene.material_of(instance).absorption == NONE {
        return NONE;
    }
    scene.instances[instance as usize].material
}

/// Whether the ray, having run through one coloured material, would enter another.
#[inline]
fn meets_second_absorber(scene: &PackedScene, ray: &Ray, hit: &Hit) -> bool {
    let next = absorber_of(scene, medium_beyond(ray, hit));
    ray.absorber != NONE && next != NONE && next != ray.absorber
}

/// Starts the path through the ray's medium if that is coloured. A path through another one is
/// paid for first, by its mean over the interval, which for that is at most one bin wide.
#[inline]
fn enter_absorber(walk: &mut Walk<'_>, ray: &mut Ray) {
    let next = absorber_of(walk.scene, ray.medium);
    if next == NONE || next == ray.absorber {
        return;
    }
    let kept = mean_transmittance(walk.scene, ray);
    walk.tally.absorbed += ray.significance * ray.bandwidth() * (1.0 - kept);
    ray.significance *= kept;
    ray.absorber = next;
    ray.path_mm = 0.0;
}
