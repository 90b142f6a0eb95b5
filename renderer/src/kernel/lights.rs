//! What a ray sees that meets nothing: discs, hemisphere, environment, the observer's shadow.

use glam::Vec3;

use crate::kernel::deposit::{Reflectance, deposit};
use crate::kernel::parabola::{Parabola, crossings};
use crate::kernel::ray::Ray;
use crate::kernel::walk::Walk;
use crate::packed::{NONE, PackedDisc};

/// A cone of directions: a light's disc or the observer's shadow.
#[derive(Clone, Copy, Debug)]
pub struct Cone {
    /// Unit vector along the middle.
    pub center: Vec3,
    /// Cosine of the half-angle, which is at most 90°.
    pub cos_radius: f32,
    /// Squared sine of the half-angle: keeps the digits that the cosine of a small angle loses.
    pub sin_squared_radius: f32,
}

/// Whether the ray's fan, of half-width `spread_length`, is sure to miss the cone: the cosine
/// changes at most as fast as the direction itself.
#[inline]
pub fn is_far_off(ray: &Ray, spread_length: f32, cone: &Cone) -> bool {
    ray.direction.dot(cone.center) + spread_length < cone.cos_radius
}

/// The part of the ray's fan, in 0..=1, that lies within the cone (the paper's `overlap_amount`).
///
/// The fan is the directions `direction + u·spread`, u in −1..=1. It is inside where
/// |(direction + u·spread) × center|² ≤ sin²·|direction + u·spread|², a quadratic in u, and on the
/// side of the center.
#[inline]
pub fn overlap_amount(ray: &Ray, cone: &Cone) -> f32 {
    let along = ray.direction.dot(cone.center);
    let spread_squared = ray.spread.length_squared();
    let off_center = ray.direction.cross(cone.center);
    let c = off_center.length_squared() - cone.sin_squared_radius;
    if spread_squared < 1e-14 {
        return f32::from(u8::from(c <= 0.0 && along >= 0.0));
    }
    let sideways = ray.spread.cross(cone.center);
    let a = sideways.length_squared() - cone.sin_squared_radius * spread_squared;
    let b = off_center.dot(sideways) - cone.sin_squared_radius * ray.direction.dot(ray.spread);
    let drift = ray.spread.dot(cone.center);
    // The fan is cut where it crosses the edge; each part is inside or outside as its middle is.
    let [first, second] = crossings(&Parabola { a, b, c });
    let cuts = [-1.0, first, second, 1.0];
    let mut inside = 0.0;
    for i in 0..3 {
        let u = 0.5 * (cuts[i] + cuts[i + 1]);
        if a * u * u + 2.0 * b * u + c <= 0.0 && along + u * drift >= 0.0 {
            inside += cuts[i + 1] - cuts[i];
        }
    }
    0.5 * inside
}

/// The part of the ray's fan, in 0..=1, that points into the upper half space.
#[inline]
pub fn overlap_hemisphere(ray: &Ray) -> f32 {
    let slope = ray.spread.z;
    if slope.abs() < 1e-12 {
        return f32::from(u8::from(ray.direction.z > 0.0));
    }
    let above_low_end = 0.5 * (1.0 + ray.direction.z / slope.abs());
    above_low_end.clamp(0.0, 1.0)
}

/// The directions of a disc light.
#[inline]
pub fn disc_cone(disc: &PackedDisc) -> Cone {
    Cone {
        center: disc.direction,
        cos_radius: disc.cos_radius,
        sin_squared_radius: disc.sin_squared_radius,
    }
}

/// Deposits what the ray sees where it meets no surface (the paper's `ray_light`).
#[inline]
pub fn ray_light(walk: &mut Walk<'_>, ray: &Ray) {
    let scene = walk.scene;
    let sky = &scene.sky;
    if ray.depth == 0 && sky.backdrop != NONE {
        deposit(walk, ray, sky.backdrop, &Reflectance::WHOLE, 1.0);
        return;
    }
    let spread_length = ray.spread.length();
    for disc in &scene.discs {
        let cone = disc_cone(disc);
        if is_far_off(ray, spread_length, &cone) {
            continue;
        }
        let amount = overlap_amount(ray, &cone);
        if amount > 0.0 {
            deposit(walk, ray, disc.spectrum, &Reflectance::WHOLE, amount);
        }
    }
    let mut visible = 1.0;
    if sky.sin_squared_observer_shadow > 0.0 {
        let head = Cone {
            center: walk.rules.observer,
            cos_radius: sky.cos_observer_shadow,
            sin_squared_radius: sky.sin_squared_observer_shadow,
        };
        if !is_far_off(ray, spread_length, &head) {
            visible -= overlap_amount(ray, &head);
        }
    }
    if sky.environment != NONE && visible > 0.0 {
        deposit(walk, ray, sky.environment, &Reflectance::WHOLE, visible);
    }
    if sky.hemisphere != NONE && visible > 0.0 {
        let amount = overlap_hemisphere(ray);
        if amount > 0.0 {
            deposit(walk, ray, sky.hemisphere, &Reflectance::WHOLE, visible * amount);
        }
    }
}
