//! The spread vector: `perturb`, the number of sub-rays, and its agreement with exact refraction.

use brilliance_renderer::kernel::interface::refract;
use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::kernel::spread::{
    MAX_SUBRAYS, direction_at, perturb, spread_angle, spread_between, subray_count,
};
use glam::Vec3;

use crate::scenes::DIAMOND;

fn fan() -> Ray {
    let mut ray = Ray::white(Vec3::ZERO, Vec3::NEG_Z);
    ray.spread = Vec3::new(0.02, 0.01, 0.0);
    ray
}

#[test]
fn the_length_of_the_spread_vector_is_the_tangent_of_half_the_angle() {
    for degrees in [0.001_f32, 0.1, 1.0, 10.0, 60.0] {
        let half = 0.5 * degrees.to_radians();
        let low = Vec3::new(-half.sin(), 0.0, half.cos());
        let high = Vec3::new(half.sin(), 0.0, half.cos());
        let spread = spread_between(low, high);
        assert!((spread.length() / half.tan() - 1.0).abs() < 1e-4);
        assert!((spread_angle(spread).to_degrees() / degrees - 1.0).abs() < 1e-4);
    }
}

#[test]
fn the_whole_interval_perturbed_is_the_ray_itself() {
    let ray = fan();
    let whole = perturb(&ray, ray.lambda_low_nm, ray.lambda_high_nm);
    assert!((whole.direction - ray.direction).length() < 1e-7);
    assert!((whole.spread - ray.spread).length() < 1e-7);
}

#[test]
fn parts_tile_the_fan_without_gap_or_overlap() {
    let ray = fan();
    let parts: Vec<_> =
        (0..7).map(|i| perturb(&ray, 380.0 + 50.0 * i as f32, 430.0 + 50.0 * i as f32)).collect();
    for pair in parts.windows(2) {
        let end = direction_at(&pair[0], pair[0].lambda_high_nm);
        let start = direction_at(&pair[1], pair[1].lambda_low_nm);
        // The parts' spread vectors belong to directions not normalised: second order in the spread.
        assert!((end - start).length() < 2e-5, "{}", (end - start).length());
    }
    let ends = [direction_at(&parts[0], 380.0), direction_at(&parts[6], 730.0)];
    assert!((ends[0] - direction_at(&ray, 380.0)).length() < 2e-5);
    assert!((ends[1] - direction_at(&ray, 730.0)).length() < 2e-5);
}

#[test]
fn an_interval_of_no_width_keeps_its_direction() {
    let mut ray = fan();
    ray.lambda_high_nm = ray.lambda_low_nm;
    let part = perturb(&ray, ray.lambda_low_nm, ray.lambda_low_nm);
    assert!((part.direction - ray.direction).length() < 1e-7);
    assert_eq!(part.spread, Vec3::ZERO);
}

/// Greatest error in radians of `direction_at` within a fan of `width_nm` refracted into diamond.
fn interpolation_error(width_nm: f32) -> f32 {
    let incident = Vec3::new(0.7, 0.0, -(1.0_f32 - 0.49).sqrt());
    let exact =
        |lambda_nm: f32| refract(incident, Vec3::Z, 1.0 / DIAMOND.n(f64::from(lambda_nm)) as f32);
    let (low, high) = (555.0 - 0.5 * width_nm, 555.0 + 0.5 * width_nm);
    let mut ray = Ray::white(Vec3::ZERO, exact(555.0));
    (ray.lambda_low_nm, ray.lambda_high_nm) = (low, high);
    ray.spread = spread_between(exact(low), exact(high));
    (0..=20)
        .map(|i| low + width_nm * i as f32 / 20.0)
        .map(|lambda_nm| direction_at(&ray, lambda_nm).distance(exact(lambda_nm)))
        .fold(0.0, f32::max)
}

#[test]
fn halving_the_interval_quarters_the_error_of_the_fan() {
    let ratio = interpolation_error(350.0) / interpolation_error(175.0);
    assert!((3.0..5.0).contains(&ratio), "{ratio}");
}

#[test]
fn six_sub_rays_hit_a_light_that_the_fan_just_covers() {
    // nrays := 1 + 6·(spread + dispersed spread)/light spread (Thomas 1986, fork_rays).
    assert_eq!(subray_count(6.0, 0.0, 0.0, 0.02), 1);
    assert_eq!(subray_count(6.0, 0.0, 0.02, 0.02), 7);
    assert_eq!(subray_count(6.0, 0.01, 0.01, 0.02), 7);
    assert_eq!(subray_count(6.0, 0.0, 0.0033, 0.02), 1);
    assert_eq!(subray_count(1.0, 0.02, 0.02, 0.02), 3);
    assert_eq!(subray_count(24.0, 1.0, 1.0, 1e-6), MAX_SUBRAYS);
}
