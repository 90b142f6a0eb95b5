//! The angular spread of a ray and its division among sub-rays.

use glam::Vec3;

use crate::kernel::ray::Ray;

/// Most sub-rays that one interface makes of one ray.
pub const MAX_SUBRAYS: u32 = 64;

/// Direction of `ray` at `lambda_nm` within its interval, of a length of about 1.
#[inline]
pub fn fan_at(ray: &Ray, lambda_nm: f32) -> Vec3 {
    ray.direction + ray.spread * interval_position(ray, lambda_nm)
}

/// Unit direction of `ray` at `lambda_nm` within its interval (the paper's `perturb(ray, λ, λ)`).
#[inline]
pub fn direction_at(ray: &Ray, lambda_nm: f32) -> Vec3 {
    fan_at(ray, lambda_nm).normalize_or_zero()
}

/// The part of `ray` between two wavelengths of its interval, with the direction and spread of
/// that part (Thomas 1986, `perturb`; Fig. 4).
#[inline]
pub fn perturb(ray: &Ray, low_nm: f32, high_nm: f32) -> Ray {
    let (low, high) = (fan_at(ray, low_nm), fan_at(ray, high_nm));
    Ray {
        lambda_low_nm: low_nm,
        lambda_high_nm: high_nm,
        direction: ((low + high) * 0.5).normalize_or_zero(),
        spread: (high - low) * 0.5,
        ..*ray
    }
}

/// Position of `lambda_nm` in the interval, from −1 at the low end to 1 at the high end.
#[inline]
pub fn interval_position(ray: &Ray, lambda_nm: f32) -> f32 {
    let width_nm = ray.lambda_high_nm - ray.lambda_low_nm;
    if width_nm > 0.0 { 2.0 * (lambda_nm - ray.lambda_low_nm) / width_nm - 1.0 } else { 0.0 }
}

/// The spread vector between two unit directions: half their difference, of length
/// tan(angle / 2).
#[inline]
pub fn spread_between(low: Vec3, high: Vec3) -> Vec3 {
    // |low + high| is 2·cos(angle/2); opposite directions do not come out of one interface.
    (high - low) / (high + low).length().max(1e-6)
}

/// Angle in radians that a spread vector stands for.
#[inline]
pub fn spread_angle(spread: Vec3) -> f32 {
    2.0 * spread.length().atan()
}

/// Number of sub-rays that makes `split_count` of them hit a light of angular extent
/// `light_spread`: 1 + K·(spread + dispersed spread)/light spread, all angles in radians.
#[inline]
pub fn subray_count(split_count: f32, ray_spread: f32, dispersed: f32, light_spread: f32) -> u32 {
    let extra = split_count * (ray_spread + dispersed) / light_spread;
    1 + extra.clamp(0.0, (MAX_SUBRAYS - 1) as f32) as u32
}
