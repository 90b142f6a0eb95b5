//! What a ray sees that meets nothing.

use std::f32::consts::PI;

use brilliance_renderer::kernel::lights::{
    Cone, disc_cone, is_far_off, overlap_amount, overlap_hemisphere, ray_light,
};
use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::packed::NONE;
use glam::Vec3;

use crate::probe::{Case, Dice, EXACT, Probe, ROUNDING, Table, Tolerance, World, throw};

#[test]
fn lights() {
    table().check();
}

/// The cuts are roots of a quadratic: where the fan touches the cone they are roots of a small
/// difference.
const OVERLAP: Tolerance = Tolerance::relative(0.0).or(2e-3);

pub(super) fn table() -> Table {
    let probes = [overlaps(), vec![sky()]];
    Table {
        worlds: vec![World::full(), World::single(), World::sliver()],
        probes: probes.into_iter().flatten().collect(),
    }
}

fn overlaps() -> Vec<Probe> {
    vec![
        Probe {
            name: "is_far_off",
            wgsl: "put_bool(is_far_off(take_ray(), take_f32(), take_cone()));",
            rust: |_, take, put| {
                let (ray, spread_length) = (take.ray(), take.f32());
                put.bool(is_far_off(&ray, spread_length, &take.cone()));
            },
            cases: |_| {
                throw(1000, |dice| {
                    let (ray, cone) = fan_and_cone(dice);
                    Case::new().ray(&ray).f32(ray.spread.length()).cone(&cone)
                })
            },
            // Where rounding decides.
            tolerance: ROUNDING.but(0.001),
        },
        Probe {
            name: "overlap_amount",
            wgsl: "put_f32(overlap_amount(take_ray(), take_cone()));",
            rust: |_, take, put| put.f32(overlap_amount(&take.ray(), &take.cone())),
            cases: |_| {
                throw(2000, |dice| {
                    let (ray, cone) = fan_and_cone(dice);
                    Case::new().ray(&ray).cone(&cone)
                })
            },
            // Where the fan is so narrow that rounding puts all of it on one side of the edge.
            tolerance: OVERLAP.but(0.002),
        },
        Probe {
            name: "overlap_hemisphere",
            wgsl: "put_f32(overlap_hemisphere(take_ray()));",
            rust: |_, take, put| put.f32(overlap_hemisphere(&take.ray())),
            cases: |_| fans_at_horizon(),
            tolerance: ROUNDING,
        },
        Probe {
            name: "disc_cone",
            wgsl: "put_cone(disc_cone(discs[take_u32()]));",
            rust: |world, take, put| {
                put.cone(&disc_cone(&world.scene.discs[take.u32() as usize]));
            },
            cases: |world| {
                (0..world.scene.discs.len() as u32).map(|i| Case::new().u32(i)).collect()
            },
            tolerance: EXACT,
        },
    ]
}

fn sky() -> Probe {
    Probe {
        name: "ray_light",
        wgsl: "begin_walk();
    ray_light(take_ray());
    put_walk();",
        rust: |world, take, put| {
            world.walk(take, put, |walk, take, _| ray_light(walk, &take.ray()));
        },
        cases: rays_to_lights,
        tolerance: OVERLAP.but(0.002),
    }
}

fn cone(center: Vec3, radius: f32) -> Cone {
    Cone { center, cos_radius: radius.cos(), sin_squared_radius: radius.sin().powi(2) }
}

/// Fans of all widths on, across and beside the edges of cones from 0.1° to 90°.
fn fan_and_cone(dice: &mut Dice) -> (Ray, Cone) {
    let radius = dice.magnitude(0.1, 90.0);
    let radius = dice.pick(&[radius, radius, 90.0_f32]).to_radians();
    let cone = cone(dice.direction(), radius);
    (fan_at_cone(dice, &cone), cone)
}

/// A fan anywhere about the cone; every other one across or along its edge.
fn fan_at_cone(dice: &mut Dice, cone: &Cone) -> Ray {
    let ray = dice.ray();
    let width = ray.spread.length();
    let radius = cone.cos_radius.acos();
    let at_edge = radius + width * dice.between(-1.2, 1.2);
    let (beside, any) = (dice.between(0.0, 2.0) * radius, dice.between(0.0, PI));
    let angle = dice.pick(&[at_edge, at_edge, beside, any]);
    let direction = dice.direction_at(cone.center, angle.cos());
    let outwards = (direction - cone.center).normalize_or_zero() * width;
    let spread = if width > 0.0 { dice.spread(direction, 0.5 * width, width) } else { Vec3::ZERO };
    Ray { direction, spread: dice.pick(&[spread, outwards, -outwards]), ..ray }
}

/// Fans above, below, across and along the horizon.
fn fans_at_horizon() -> Vec<Case> {
    throw(800, |dice| {
        let ray = dice.ray();
        let level = ray.direction.with_z(0.0).normalize_or_zero();
        let rise = dice.between(-0.3, 0.3);
        let near = level.with_z(rise).normalize_or_zero();
        let flat = ray.spread.with_z(0.0);
        let direction = dice.pick(&[ray.direction, near, near, level]);
        let spread = dice.pick(&[ray.spread, ray.spread, flat]);
        // A spread below rounding is not divided by.
        let spread = if spread.z.abs() < 1e-7 { flat } else { spread };
        Case::new().ray(&Ray { direction, spread, ..ray })
    })
}

/// Camera rays and others, at discs, at the observer and anywhere.
fn rays_to_lights(world: &World) -> Vec<Case> {
    let discs = &world.scene.discs;
    throw(800, |dice| {
        let ray = match dice.below(4) {
            0 if !discs.is_empty() => {
                let disc = discs[dice.below(discs.len())];
                fan_at_cone(dice, &disc_cone(&disc))
            }
            1 => fan_at_cone(dice, &cone(world.rules.observer, 0.15)),
            // The sky ends at the horizon.
            2 => fan_at_cone(dice, &cone(Vec3::Z, 0.5 * PI)),
            _ => dice.ray(),
        };
        let absorber = dice.pick(&[&world.absorbers()[..], &[NONE]].concat());
        let path_mm = dice.between(0.0, 5.0);
        let ray = Ray { absorber, path_mm, depth: dice.pick(&[0, 1, 5]), ..ray };
        Case::new().u32(0).u32(0).ray(&ray)
    })
}
