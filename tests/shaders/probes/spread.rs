//! The angular spread of a ray.

use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::kernel::spread::{
    direction_at, fan_at, interval_position, perturb, spread_angle, spread_between, subray_count,
};
use glam::Vec3;

use crate::probe::{Case, Probe, ROUNDING, Table, Tolerance, World, throw};

#[test]
fn spread() {
    table().check();
}

pub(super) fn table() -> Table {
    Table {
        worlds: vec![World::empty()],
        probes: vec![
            Probe {
                name: "fan_at",
                wgsl: "put_vec3(fan_at(take_ray(), take_f32()));",
                rust: |_, take, put| put.vec3(fan_at(&take.ray(), take.f32())),
                cases: |_| rays_at_wavelengths(1),
                tolerance: ROUNDING,
            },
            Probe {
                name: "direction_at",
                wgsl: "put_vec3(direction_at(take_ray(), take_f32()));",
                rust: |_, take, put| put.vec3(direction_at(&take.ray(), take.f32())),
                cases: |_| rays_at_wavelengths(1),
                tolerance: ROUNDING,
            },
            Probe {
                name: "perturb",
                wgsl: "put_ray(perturb(take_ray(), take_f32(), take_f32()));",
                rust: |_, take, put| put.ray(&perturb(&take.ray(), take.f32(), take.f32())),
                cases: |_| rays_at_wavelengths(2),
                tolerance: ROUNDING,
            },
            Probe {
                name: "interval_position",
                wgsl: "put_f32(interval_position(take_ray(), take_f32()));",
                rust: |_, take, put| put.f32(interval_position(&take.ray(), take.f32())),
                cases: |_| rays_at_wavelengths(1),
                tolerance: ROUNDING,
            },
            Probe {
                name: "spread_between",
                wgsl: "put_vec3(spread_between(take_vec3(), take_vec3()));",
                rust: |_, take, put| put.vec3(spread_between(take.vec3(), take.vec3())),
                cases: |_| pairs_of_directions(),
                tolerance: ROUNDING.or(0.0),
            },
            Probe {
                name: "spread_angle",
                wgsl: "put_f32(spread_angle(take_vec3()));",
                rust: |_, take, put| put.f32(spread_angle(take.vec3())),
                cases: |_| spreads(),
                // WGSL allows `atan` 4096 ulp.
                tolerance: Tolerance::relative(5e-4),
            },
            Probe {
                name: "subray_count",
                wgsl: "put_u32(subray_count(take_f32(), take_f32(), take_f32(), take_f32()));",
                rust: |_, take, put| {
                    put.u32(subray_count(take.f32(), take.f32(), take.f32(), take.f32()));
                },
                cases: |_| angles(),
                // Where rounding decides between two whole numbers.
                tolerance: ROUNDING.but(0.002),
            },
        ],
    }
}

/// Rays with wavelengths within their intervals, both ends included, in rising order.
fn rays_at_wavelengths(count: usize) -> Vec<Case> {
    throw(600, |dice| {
        let ray = dice.ray();
        let [low, high] = [ray.lambda_low_nm, ray.lambda_high_nm];
        let mut wavelengths: Vec<f32> = (0..count)
            .map(|_| match dice.below(4) {
                0 => low,
                1 => high,
                _ => dice.between(low, high),
            })
            .collect();
        wavelengths.sort_by(f32::total_cmp);
        wavelengths.into_iter().fold(Case::new().ray(&ray), Case::f32)
    })
}

/// Directions at all angles, equal ones and nearly opposite ones.
fn pairs_of_directions() -> Vec<Case> {
    let mut cases = throw(500, |dice| {
        let low = dice.direction();
        let high = (low + dice.direction() * dice.magnitude(1e-5, 1.9)).normalize_or_zero();
        Case::new().vec3(low).vec3(high)
    });
    let ends = [Vec3::X, Vec3::NEG_X, Vec3::ZERO];
    cases.extend(ends.map(|high| Case::new().vec3(Vec3::X).vec3(high)));
    cases
}

fn spreads() -> Vec<Case> {
    let mut cases = throw(300, |dice| {
        let length = dice.magnitude(1e-9, 1e3);
        Case::new().vec3(dice.direction() * length)
    });
    cases.push(Case::new().vec3(Ray::white(Vec3::ZERO, Vec3::X).spread));
    cases
}

/// Numbers of sub-rays from 1 to more than are allowed.
fn angles() -> Vec<Case> {
    let mut cases = throw(1000, |dice| {
        Case::new()
            .f32(dice.between(0.0, 4.0))
            .f32(dice.between(0.0, 0.3))
            .f32(dice.between(0.0, 0.3))
            .f32(dice.magnitude(1e-3, 3.2))
    });
    for [split_count, spread] in [[0.0, 0.2], [1.0, 0.0], [1.0, 1e-30], [8.0, 3.0]] {
        cases.push(Case::new().f32(split_count).f32(spread).f32(spread).f32(1e-3));
    }
    cases
}
