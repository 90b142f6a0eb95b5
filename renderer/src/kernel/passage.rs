//! Light that goes straight through a clear convex body onto matte surfaces: in through one facet,
//! out through another, without a reflection inside.
//!
//! Lamps are distant and facets flat, so that behind such a pair of facets light of one wavelength
//! has one direction, wherever it came through. A matte surface can therefore look for it.

use std::f32::consts::FRAC_1_PI;

use glam::Vec3;

use crate::kernel::absorption::{bin_range, transmittance};
use crate::kernel::deposit::{Reflectance, deposit};
use crate::kernel::interface::{cos_refracted_squared, index_of_refraction, refract};
use crate::kernel::intersect::{find_intersection, is_occluded};
use crate::kernel::ray::{Hit, Ray, TOUCHING_MM};
use crate::kernel::rng;
use crate::kernel::walk::Walk;
use crate::packed::{NONE, PackedPassage, PackedScene};
use crate::spectrum::LAMBDA_MIN_NM;

/// Light of one wavelength on its way through a passage.
#[derive(Clone, Copy, Debug)]
pub struct Beam {
    /// Unit direction inside the body.
    pub inside: Vec3,
    /// Unit direction behind the body.
    pub behind: Vec3,
    /// Irradiance across the beam behind the body by that before it, absorption left out; 0 where
    /// the light does not get through.
    pub gain: f32,
}

/// Deposits what reaches the surface at `hit` through clear bodies of the light that shines from
/// `towards_light`, a point on the disc number `light`.
///
/// `normal` is the surface's unit normal on the side that `ray` came from. Each bin of the ray's
/// interval is asked for at one wavelength, which changes from pass to pass.
#[inline]
pub fn shine_through<R: Copy>(
    walk: &mut Walk<'_, R>,
    ray: &Ray,
    hit: &Hit,
    normal: Vec3,
    light: u32,
    towards_light: Vec3,
    reflectance: &Reflectance,
) {
    let scene = walk.scene;
    let disc = &scene.discs[light as usize];
    let bins = bin_range(scene, ray.lambda_low_nm, ray.lambda_high_nm);
    let position = rng::wavelength_sample(walk.pass_index);
    for number in disc.first_passage..disc.first_passage + disc.passage_count {
        let passage = &scene.passages[number as usize];
        if is_out_of_reach(passage, ray.origin) {
            continue;
        }
        for bin in bins.first..=bins.last {
            let mut band = *ray;
            let bin_low_nm = LAMBDA_MIN_NM + bin as f32 * scene.bins.width_nm();
            band.lambda_low_nm = bin_low_nm.max(ray.lambda_low_nm);
            band.lambda_high_nm = (bin_low_nm + scene.bins.width_nm()).min(ray.lambda_high_nm);
            let width_nm = band.lambda_high_nm - band.lambda_low_nm;
            let beam =
                bend(scene, passage, towards_light, band.lambda_low_nm + width_nm * position);
            let cos = -beam.behind.dot(normal);
            if width_nm <= 0.0 || beam.gain <= 0.0 || cos <= 0.0 {
                continue;
            }
            let kept = follow_back(walk, &band, hit, passage, &beam, towards_light, bin);
            if kept > 0.0 {
                let scale = FRAC_1_PI * disc.solid_angle * cos * beam.gain * kept;
                deposit(walk, &band, disc.spectrum, reflectance, scale);
            }
        }
    }
}

/// Whether no light that comes through the passage can fall on `point`: the way back to the facet
/// that it leaves is in a cone about the passage's direction, and that cone misses the facet.
#[inline]
pub fn is_out_of_reach(passage: &PackedPassage, point: Vec3) -> bool {
    let way = passage.center_out - point;
    let along = way.dot(passage.direction);
    let across = way.cross(passage.direction).length();
    across * passage.cos_bound - along * passage.sin_bound > passage.radius_out
}

/// What the passage makes of light of `lambda_nm` that comes from the unit direction
/// `towards_light`.
#[inline]
pub fn bend(
    scene: &PackedScene,
    passage: &PackedPassage,
    towards_light: Vec3,
    lambda_nm: f32,
) -> Beam {
    let medium = scene.material_of(passage.instance).index_table;
    let n = index_of_refraction(scene, medium, lambda_nm);
    let inside = refract(-towards_light, passage.normal_in, 1.0 / n);
    let behind = refract(inside, -passage.normal_out, n);
    let cos_in = towards_light.dot(passage.normal_in);
    let cos_out = inside.dot(passage.normal_out);
    let mut gain = 0.0;
    if cos_in > 0.0 && cos_out > 0.0 && cos_refracted_squared(cos_out, n) > 0.0 {
        gain = facet_gain(cos_in, 1.0 / n) * facet_gain(cos_out, n);
    }
    Beam { inside, behind, gain }
}

/// By what an interface multiplies the irradiance across a beam: (1 − R)·cos θᵢ/cos θₜ, where R is
/// Fresnel's reflectance and the cosines say how the beam's cross-section changes.
///
/// `cos_i`, of the angle of incidence, is above 0; `eta` is n₁/n₂ and short of total reflection.
/// Written with the transmission coefficients (Born & Wolf, §1.5.2), nothing cancels and nothing is
/// divided by the cosine of a grazing angle.
#[inline]
pub fn facet_gain(cos_i: f32, eta: f32) -> f32 {
    let cos_t = cos_refracted_squared(cos_i, eta).max(0.0).sqrt();
    let parallel = cos_i / (cos_i + eta * cos_t);
    let perpendicular = cos_i / (eta * cos_i + cos_t);
    2.0 * eta * (parallel * parallel + perpendicular * perpendicular)
}

/// Whether the way back along the beam from `point` runs through the spheres about both facets: asked
/// before any ray is traced.
#[inline]
pub fn nears_both_facets(passage: &PackedPassage, beam: &Beam, point: Vec3) -> bool {
    let cos_out = beam.behind.dot(passage.normal_out);
    let cos_in = -beam.inside.dot(passage.normal_in);
    let off_out = point - passage.center_out;
    let height_out = off_out.dot(passage.normal_out);
    if cos_out <= 0.0 || cos_in <= 0.0 || height_out < -TOUCHING_MM {
        return false;
    }
    let leaves_at = off_out - beam.behind * (height_out / cos_out);
    let off_in = leaves_at + passage.center_out - passage.center_in;
    let enters_at = off_in + beam.inside * (off_in.dot(passage.normal_in) / cos_in);
    leaves_at.length_squared() <= passage.radius_out * passage.radius_out
        && enters_at.length_squared() <= passage.radius_in * passage.radius_in
}

/// Goes back along the beam from the surface at `hit` to the light: how much, in 0..=1, the body
/// lets through in `bin`; 0 where the beam does not come this way.
#[inline]
pub fn follow_back<R: Copy>(
    walk: &mut Walk<'_, R>,
    ray: &Ray,
    hit: &Hit,
    passage: &PackedPassage,
    beam: &Beam,
    towards_light: Vec3,
    bin: u32,
) -> f32 {
    let scene = walk.scene;
    if !nears_both_facets(passage, beam, ray.origin) {
        return 0.0;
    }
    let mut back = Ray::white(ray.origin, -beam.behind);
    back.instance = hit.instance;
    back.facet = hit.facet;
    walk.tally.segments += 1;
    let way_out = find_intersection(scene, &back);
    if way_out.instance != passage.instance || way_out.facet != passage.facet_out {
        return 0.0;
    }
    back.origin += back.direction * way_out.distance;
    back.direction = -beam.inside;
    back.instance = passage.instance;
    back.facet = passage.facet_out;
    back.medium = passage.instance;
    walk.tally.segments += 1;
    let way_in = find_intersection(scene, &back);
    if way_in.instance != passage.instance || way_in.facet != passage.facet_in {
        return 0.0;
    }
    let material = scene.instances[passage.instance as usize].material;
    let mut kept = 1.0;
    if scene.materials[material as usize].absorption != NONE {
        back.absorber = material;
        back.path_mm = way_in.distance;
        kept = transmittance(scene, &back, bin);
    }
    back.origin += back.direction * way_in.distance;
    back.direction = towards_light;
    back.facet = passage.facet_in;
    back.medium = NONE;
    walk.tally.segments += 1;
    if is_occluded(scene, &back) { 0.0 } else { kept }
}
