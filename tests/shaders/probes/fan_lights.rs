//! What fans see that meet nothing.

use brilliance_renderer::kernel::fan::Fan;
use brilliance_renderer::kernel::fan_lights::{
    deposit_beside, depth_in_cone, depth_slope_in_cone, edge_of_cone, end_at_lights, fan_light,
    is_fan_far_off, largest_spread, nearest_approach, part_in_cone,
};
use brilliance_renderer::kernel::lights::{Cone, disc_cone};
use brilliance_renderer::kernel::nodes::{middle_node, nodes_of};
use brilliance_renderer::packed::NONE;
use glam::Vec3;

use crate::probe::{Case, Dice, Probe, ROUNDING, Table, Tolerance, World, throw};

#[test]
fn fan_lights() {
    table().check();
}

/// Edges are found to hundredths of a thousandth of the fan, but where it runs along them rounding
/// decides.
const EDGE: Tolerance = Tolerance::relative(0.0).or(2e-3).but(0.02);

pub(super) fn table() -> Table {
    let probes = [cones(), parts(), skies()];
    Table {
        worlds: vec![World::full(), World::single(), World::sliver()],
        probes: probes.into_iter().flatten().collect(),
    }
}

fn cones() -> Vec<Probe> {
    vec![
        Probe {
            name: "largest_spread",
            wgsl: "put_f32(largest_spread(take_fan()));",
            rust: |_, take, put| put.f32(largest_spread(&take.fan())),
            cases: |_| throw(400, |dice| Case::new().fan(&dice.fan())),
            tolerance: ROUNDING,
        },
        Probe {
            name: "is_fan_far_off",
            wgsl: "put_bool(is_fan_far_off(take_fan(), take_cone()));",
            rust: |_, take, put| put.bool(is_fan_far_off(&take.fan(), &take.cone())),
            cases: |_| throw(1000, case_of_both),
            // Where rounding decides.
            tolerance: ROUNDING.but(0.002),
        },
        Probe {
            name: "depth_in_cone",
            wgsl: "put_f32(depth_in_cone(take_fan(), take_cone(), take_f32()));",
            rust: |_, take, put| {
                put.f32(depth_in_cone(&take.fan(), &take.cone(), take.f32()));
            },
            cases: |_| throw(1000, |dice| case_of_both(dice).f32(dice.position())),
            tolerance: ROUNDING,
        },
        Probe {
            name: "depth_slope_in_cone",
            wgsl: "put_f32(depth_slope_in_cone(take_fan(), take_cone(), take_f32()));",
            rust: |_, take, put| {
                put.f32(depth_slope_in_cone(&take.fan(), &take.cone(), take.f32()));
            },
            cases: |_| throw(1000, |dice| case_of_both(dice).f32(dice.position())),
            tolerance: ROUNDING,
        },
        Probe {
            name: "nearest_approach",
            wgsl: "put_f32(nearest_approach(take_fan(), take_cone()));",
            rust: |_, take, put| put.f32(nearest_approach(&take.fan(), &take.cone())),
            cases: |_| throw(1000, case_of_both),
            // In a narrow fan the nearest direction is a quotient of small differences.
            tolerance: EDGE.but(0.1),
        },
    ]
}

fn parts() -> Vec<Probe> {
    vec![
        Probe {
            name: "part_in_cone",
            wgsl: "put_vec2(part_in_cone(take_fan(), take_cone()));",
            rust: |_, take, put| put.vec2(part_in_cone(&take.fan(), &take.cone())),
            cases: |_| throw(1000, case_of_both),
            tolerance: EDGE,
        },
        Probe {
            name: "edge_of_cone",
            wgsl: "put_f32(edge_of_cone(take_fan(), take_cone(), take_f32(), take_f32()));",
            rust: |_, take, put| {
                let (fan, cone) = (take.fan(), take.cone());
                put.f32(edge_of_cone(&fan, &cone, take.f32(), take.f32()));
            },
            cases: |_| {
                let mut dice = Dice::new(23);
                let mut cases = Vec::new();
                while cases.len() < 600 {
                    let (fan, cone) = fan_and_cone(&mut dice);
                    let nearest = nearest_approach(&fan, &cone);
                    if depth_in_cone(&fan, &cone, nearest) > 0.0 {
                        let end = dice.pick(&[-1.0, 1.0]);
                        cases.push(Case::new().fan(&fan).cone(&cone).f32(nearest).f32(end));
                    }
                }
                cases
            },
            tolerance: EDGE,
        },
        Probe {
            name: "deposit_beside",
            wgsl: "begin_walk();
    let fan = take_fan();
    let part = vec2f(take_f32(), take_f32());
    deposit_beside(fan, part, vec2f(take_f32(), take_f32()), take_u32());
    put_fan_walk();",
            rust: |world, take, put| {
                world.fan_walk(take, put, |walk, take, _| {
                    let (fan, part, shadow) = (take.fan(), take.vec2(), take.vec2());
                    deposit_beside(walk, &fan, part, shadow, take.u32());
                });
            },
            cases: |world| {
                throw(400, |dice| {
                    let (part, shadow) = (dice.part(), dice.part());
                    let row = dice.below(world.rows()) as u32;
                    walk().fan(&dice.fan()).vec2(part).vec2(shadow).u32(row)
                })
            },
            tolerance: Tolerance::relative(1e-4).or(1e-5).but(0.005),
        },
    ]
}

fn skies() -> Vec<Probe> {
    vec![
        Probe {
            name: "fan_light",
            wgsl: "begin_walk();
    fan_light(take_fan());
    put_fan_walk();",
            rust: |world, take, put| {
                world.fan_walk(take, put, |walk, take, _| fan_light(walk, &take.fan()));
            },
            cases: fans_to_lights,
            tolerance: EDGE,
        },
        Probe {
            name: "end_at_lights",
            wgsl: "begin_walk();
    end_at_lights(take_fan());
    put_fan_walk();",
            rust: |world, take, put| {
                world.fan_walk(take, put, |walk, take, _| end_at_lights(walk, &take.fan()));
            },
            cases: fans_to_lights,
            tolerance: EDGE,
        },
    ]
}

fn walk() -> Case {
    Case::new().u32(0).u32(0)
}

fn cone(center: Vec3, radius: f32) -> Cone {
    Cone { center, cos_radius: radius.cos(), sin_squared_radius: radius.sin().powi(2) }
}

fn case_of_both(dice: &mut Dice) -> Case {
    let (fan, cone) = fan_and_cone(dice);
    Case::new().fan(&fan).cone(&cone)
}

/// Fans of all widths on, across and beside the edges of cones from 0.1° to 90°.
fn fan_and_cone(dice: &mut Dice) -> (Fan, Cone) {
    let radius = dice.magnitude(0.1, 90.0);
    let radius = dice.pick(&[radius, radius, 90.0_f32]).to_radians();
    let cone = cone(dice.direction(), radius);
    (fan_at_cone(dice, &cone), cone)
}

/// A fan anywhere about the cone; every other one across or along its edge.
fn fan_at_cone(dice: &mut Dice, cone: &Cone) -> Fan {
    let fan = dice.fan();
    let [x, y, z] = [fan.direction.x, fan.direction.y, fan.direction.z].map(|it| it.z - it.y);
    let width = Vec3::new(x, y, z).length();
    let radius = cone.cos_radius.acos();
    let at_edge = radius + width * dice.between(-1.2, 1.2);
    let beside = dice.between(0.0, 2.0) * radius;
    let angle = dice.pick(&[at_edge, at_edge, beside]);
    let middle = dice.direction_at(cone.center, angle.cos());
    let outwards = (middle - cone.center).normalize_or_zero() * width;
    let sideways = middle.cross(dice.direction()) * width;
    let spread = dice.pick(&[outwards, -outwards, sideways]);
    let bend = dice.point(0.2) * width;
    let [low, high] =
        [bend - spread, bend + spread].map(|apart| (middle + apart).normalize_or_zero());
    Fan { direction: nodes_of(low, middle, high), ..fan }
}

/// Camera rays and others, at discs, at the observer and anywhere.
fn fans_to_lights(world: &World) -> Vec<Case> {
    let discs = &world.scene.discs;
    throw(800, |dice| {
        let fan = match dice.below(4) {
            0 if !discs.is_empty() => {
                let disc = discs[dice.below(discs.len())];
                fan_at_cone(dice, &disc_cone(&disc))
            }
            1 => fan_at_cone(dice, &cone(world.rules.observer, 0.15)),
            // The sky ends at the horizon.
            2 => fan_at_cone(dice, &cone(Vec3::Z, 1.57)),
            _ => dice.fan(),
        };
        assert!(middle_node(&fan.direction).is_normalized());
        let absorber = dice.pick(&[&world.absorbers()[..], &[NONE]].concat());
        walk().fan(&Fan { absorber, ..fan })
    })
}
