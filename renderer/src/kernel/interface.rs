//! Snell, Fresnel and total reflection at one smooth interface.

use glam::Vec3;

use crate::kernel::ray::Ray;
use crate::kernel::spread::fan_at;
use crate::packed::{INDEX_TABLE_LEN, NONE, PackedScene};
use crate::spectrum::LAMBDA_MIN_NM;

/// Halvings of an interval in search of the critical wavelength: 350 nm / 2²⁰ is 0.0003 nm.
pub const BISECTIONS: u32 = 20;

/// An interface as a ray meets it.
#[derive(Clone, Copy, Debug)]
pub struct Interface {
    /// Unit normal on the side the ray comes from.
    pub normal: Vec3,
    /// Index table of the medium the ray comes from, or [`NONE`] for air.
    pub medium_from: u32,
    /// Index table of the medium beyond, or [`NONE`] for air.
    pub medium_to: u32,
}

/// Index of refraction of a medium at `lambda_nm`; 1 for air.
#[inline]
pub fn index_of_refraction(scene: &PackedScene, medium: u32, lambda_nm: f32) -> f32 {
    if medium == NONE {
        return 1.0;
    }
    let position = (lambda_nm - LAMBDA_MIN_NM).clamp(0.0, (INDEX_TABLE_LEN - 1) as f32);
    let i = (position as usize).min(INDEX_TABLE_LEN - 2);
    let start = medium as usize + i;
    let (n0, n1) = (scene.spectra[start], scene.spectra[start + 1]);
    n0 + (n1 - n0) * (position - i as f32)
}

/// Relative index n₁/n₂ of the interface at `lambda_nm`.
#[inline]
pub fn relative_index(scene: &PackedScene, at: &Interface, lambda_nm: f32) -> f32 {
    index_of_refraction(scene, at.medium_from, lambda_nm)
        / index_of_refraction(scene, at.medium_to, lambda_nm)
}

/// `direction` mirrored at a plane with unit `normal`.
#[inline]
pub fn reflect(direction: Vec3, normal: Vec3) -> Vec3 {
    direction - normal * (2.0 * direction.dot(normal))
}

/// Squared cosine of the angle of refraction by Snell's law; 0 or less beyond the critical angle.
///
/// `cos_i` is the cosine of the angle of incidence, `eta` is n₁/n₂.
#[inline]
pub fn cos_refracted_squared(cos_i: f32, eta: f32) -> f32 {
    1.0 - eta * eta * (1.0 - cos_i * cos_i)
}

/// Unit direction after refraction; grazing beyond the critical angle.
///
/// `normal` is the unit normal on the side of the incident unit `direction`, `eta` is n₁/n₂.
#[inline]
pub fn refract(direction: Vec3, normal: Vec3, eta: f32) -> Vec3 {
    let cos_i = -direction.dot(normal);
    let cos_t = cos_refracted_squared(cos_i, eta).max(0.0).sqrt();
    (direction * eta + normal * (eta * cos_i - cos_t)).normalize_or_zero()
}

/// Unpolarised Fresnel reflectance of a smooth dielectric interface.
///
/// `cos_i` and `cos_t` are the cosines of the angles of incidence and refraction, in 0..=1;
/// `eta` is n₁/n₂. Thomas 1986, "Dispersive refraction", after Born & Wolf, §1.5.2.
#[inline]
pub fn fresnel(cos_i: f32, cos_t: f32, eta: f32) -> f32 {
    // The paper's formulae with both indices divided by n₂.
    let parallel = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    let perpendicular = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    (0.5 * (parallel * parallel + perpendicular * perpendicular)).clamp(0.0, 1.0)
}

/// Whether light of `lambda_nm` that arrives along `direction`, of any length, is totally reflected
/// (the paper's `reflectp`): n₁·sin θ ≥ n₂, both sides squared and times the length squared.
#[inline]
pub fn is_totally_reflected(
    scene: &PackedScene,
    at: &Interface,
    direction: Vec3,
    lambda_nm: f32,
) -> bool {
    let n_from = index_of_refraction(scene, at.medium_from, lambda_nm);
    let n_to = index_of_refraction(scene, at.medium_to, lambda_nm);
    let along_normal = direction.dot(at.normal);
    let length_squared = direction.length_squared();
    let sideways_squared = length_squared - along_normal * along_normal;
    n_from * n_from * sideways_squared >= n_to * n_to * length_squared
}

/// The wavelength in the ray's interval that divides total reflection from refraction, found by
/// binary search; the returned wavelength itself is refracted.
///
/// `low_is_reflected` tells that the low end is the totally reflected one.
#[inline]
pub fn find_total_refl_wave(
    scene: &PackedScene,
    at: &Interface,
    ray: &Ray,
    low_is_reflected: bool,
) -> f32 {
    let (mut reflected_nm, mut refracted_nm) = if low_is_reflected {
        (ray.lambda_low_nm, ray.lambda_high_nm)
    } else {
        (ray.lambda_high_nm, ray.lambda_low_nm)
    };
    for _ in 0..BISECTIONS {
        let middle_nm = 0.5 * (reflected_nm + refracted_nm);
        if is_totally_reflected(scene, at, fan_at(ray, middle_nm), middle_nm) {
            reflected_nm = middle_nm;
        } else {
            refracted_nm = middle_nm;
        }
    }
    refracted_nm
}
