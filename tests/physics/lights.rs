//! How much of a fan a light covers, against brute force.

use brilliance_renderer::kernel::lights::{Cone, overlap_amount, overlap_hemisphere};
use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::kernel::rng::{hash, unit_float};
use brilliance_renderer::light::{DiscLight, Lights};
use brilliance_renderer::settings::TraceSettings;
use glam::{DVec3, Vec3};

use crate::scenes::{flat_disc, flat_sky, scene, trace_ray};

fn cone(center: Vec3, radius: f32) -> Cone {
    Cone { center, cos_radius: radius.cos(), sin_squared_radius: radius.sin().powi(2) }
}

/// The part of 20,001 directions of the fan for which `is_inside` holds, in f64.
fn brute_force(ray: &Ray, is_inside: impl Fn(DVec3) -> bool) -> f32 {
    let steps = 20_000;
    let count = (0..=steps)
        .map(|i| 2.0 * f64::from(i) / f64::from(steps) - 1.0)
        .filter(|u| is_inside((ray.direction.as_dvec3() + ray.spread.as_dvec3() * *u).normalize()))
        .count();
    count as f32 / (steps + 1) as f32
}

fn random(seed: u32) -> impl FnMut() -> f32 {
    let mut state = seed;
    move || {
        state = state.wrapping_add(1);
        2.0 * unit_float(hash(state)) - 1.0
    }
}

#[test]
fn the_overlap_with_a_disc_matches_brute_force() {
    let mut random = random(7);
    let mut partial = 0;
    for _ in 0..1500 {
        let center = Vec3::new(random(), random(), random()).normalize_or_zero();
        let radius = (random().powi(2) * 89.9 + 0.05).to_radians();
        let offset = Vec3::new(random(), random(), random()) * radius.tan().min(3.0) * 1.5;
        let direction = (center + offset).normalize_or_zero();
        let sideways = direction.cross(Vec3::new(random(), random(), random()));
        let mut ray = Ray::white(Vec3::ZERO, direction);
        ray.spread = sideways * radius.min(0.4) * (1.5 * random());
        let cos_radius = f64::from(radius).cos();
        let expected = brute_force(&ray, |d| d.dot(center.as_dvec3().normalize()) >= cos_radius);
        let found = overlap_amount(&ray, &cone(center, radius));
        assert!((found - expected).abs() < 3e-3, "{found} {expected} {ray:?} {center} {radius}");
        partial += usize::from(found > 0.01 && found < 0.99);
    }
    assert!(partial > 100, "the sweep meets edges: {partial}");
}

#[test]
fn the_overlap_with_the_hemisphere_matches_brute_force() {
    let mut random = random(3);
    for _ in 0..200 {
        let mut ray = Ray::white(
            Vec3::ZERO,
            Vec3::new(random(), random(), 0.1 * random()).normalize_or_zero(),
        );
        ray.spread = ray.direction.cross(Vec3::new(random(), random(), random())) * 0.2;
        let expected = brute_force(&ray, |direction| direction.z > 0.0);
        assert!((overlap_hemisphere(&ray) - expected).abs() < 1e-3);
    }
}

#[test]
fn a_ray_without_spread_is_in_the_disc_or_out_of_it() {
    let sun = cone(Vec3::Z, 0.265_f32.to_radians());
    let at = |degrees: f32| {
        let angle = degrees.to_radians();
        overlap_amount(&Ray::white(Vec3::ZERO, Vec3::new(angle.sin(), 0.0, angle.cos())), &sun)
    };
    assert_eq!(at(0.0), 1.0);
    assert_eq!(at(0.264), 1.0);
    assert_eq!(at(0.266), 0.0);
    assert_eq!(at(179.9), 0.0);
}

#[test]
fn the_solid_angle_is_that_of_the_paper() {
    // 2π(1 − √(1 − s²)) with s the sine of the radius; the sun's disc is 6.8e-5 sr.
    let sun: DiscLight = flat_disc(Vec3::Z, 0.2666, 1.0);
    assert!((sun.solid_angle_steradians() / 6.8e-5 - 1.0).abs() < 0.01);
    assert!(
        (flat_disc(Vec3::Z, 90.0, 1.0).solid_angle_steradians() / std::f32::consts::TAU - 1.0)
            .abs()
            < 1e-6
    );
}

#[test]
fn the_observers_head_is_dark_in_the_sky_and_the_backdrop_only_behind() {
    let mut lights = Lights {
        environment: Some(flat_sky(1.0)),
        observer_shadow_radians: 10.0_f32.to_radians(),
        backdrop: Some(flat_sky(0.25)),
        ..Lights::default()
    };
    let settings = TraceSettings::default();
    let mut ray = Ray::white(Vec3::ZERO, Vec3::Z);
    let see = |lights: &Lights, ray: &Ray| {
        trace_ray(&scene(Vec::new(), lights.clone()), &settings, ray).0[0]
    };
    assert_eq!(see(&lights, &ray), 0.25, "a camera ray sees the backdrop");
    lights.backdrop = None;
    assert_eq!(see(&lights, &ray), 0.0, "towards the observer");
    ray.direction = Vec3::X;
    assert_eq!(see(&lights, &ray), 1.0);
}
