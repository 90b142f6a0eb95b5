//! What becomes of fans at interfaces.

use brilliance_renderer::kernel::crossing::crossing_of;
use brilliance_renderer::kernel::divide::{
    can_only_meet_lights, direction_tolerance, divide_fan, end_of_bin, is_bent, pays_on_entering,
    reflect_fan, refract_fan, refracted_fan, send_refracted,
};
use brilliance_renderer::kernel::fan::Fan;
use brilliance_renderer::kernel::fork::interface_at;
use brilliance_renderer::kernel::nodes::{Nodes, middle_node, nodes_of};
use brilliance_renderer::kernel::trace::meets_opaque;
use brilliance_renderer::packed::NONE;
use glam::{Vec3, Vec3A};

use crate::probe::{Case, Dice, EXACT, Meeting, Probe, Table, Tolerance, World, see_lights, throw};

#[test]
fn divide() {
    table().check();
}

/// Near the critical angle refracted directions and reflectances are roots of a small difference:
/// an error of 1e-6 in the square of a cosine is one of 1e-3 in itself.
pub(super) const CRITICAL: Tolerance = Tolerance::relative(1e-4).or(1e-3);

/// So it is with what comes of a fan; some come to where rounding decides whether it is divided once
/// more. On the processor alone 6 % of those that cross an interface change where one component of their
/// directions is one rounding off.
const DIVISION: Tolerance = Tolerance::relative(1e-3).or(1e-3).but(0.07);

pub(super) fn table() -> Table {
    let probes = [directions(), parts(), ends_of_media(), whole()];
    Table {
        worlds: vec![World::full(), World::curt(), World::single()],
        probes: probes.into_iter().flatten().collect(),
    }
}

fn directions() -> Vec<Probe> {
    vec![
        Probe {
            name: "direction_tolerance",
            wgsl: "put_f32(direction_tolerance(take_u32()));",
            rust: |world, take, put| put.f32(direction_tolerance(&world.rules, take.u32())),
            cases: |_| vec![Case::new().u32(0), Case::new().u32(NONE)],
            tolerance: EXACT,
        },
        Probe {
            name: "is_bent",
            wgsl: "put_bool(is_bent(take_nodes(), 4e-5));",
            rust: |_, take, put| put.bool(is_bent(&take.nodes(), 4e-5)),
            cases: |_| throw(600, |dice| Case::new().nodes(&bent_directions(dice))),
            tolerance: EXACT.but(0.005),
        },
    ]
}

fn parts() -> Vec<Probe> {
    vec![
        Probe {
            name: "reflect_fan",
            wgsl: "begin_walk();
    let fan = take_fan();
    let ray = take_ray();
    let hit = take_hit();
    reflect_fan(fan, hit, interface_at(ray, hit), vec3f(0.9, 0.8, 0.7));
    put_fan_walk();",
            rust: |world, take, put| {
                world.fan_walk(take, put, |walk, take, _| {
                    let (fan, ray, hit) = (take.fan(), take.ray(), take.hit());
                    let at = interface_at(walk.scene, &ray, &hit);
                    reflect_fan(walk, &fan, &hit, &at, Vec3A::new(0.9, 0.8, 0.7));
                });
            },
            cases: |world| arrivals(world, &walk()),
            tolerance: DIVISION,
        },
        Probe {
            name: "refracted_fan",
            wgsl: "let fan = take_fan();
    let ray = take_ray();
    let hit = take_hit();
    let at = interface_at(ray, hit);
    put_fan(refracted_fan(fan, ray, hit, at, crossing_of(at, fan), vec3f(0.1, 0.2, 0.3)));",
            rust: |world, take, put| {
                let (fan, ray, hit) = (take.fan(), take.ray(), take.hit());
                let at = interface_at(&world.scene, &ray, &hit);
                let crossing = crossing_of(&world.scene, &at, &fan);
                let reflectance = Vec3A::new(0.1, 0.2, 0.3);
                put.fan(&refracted_fan(
                    &world.scene,
                    &fan,
                    &ray,
                    &hit,
                    &at,
                    &crossing,
                    reflectance,
                ));
            },
            cases: |world| arrivals(world, &Case::new()),
            tolerance: CRITICAL,
        },
        Probe {
            name: "send_refracted",
            wgsl: "begin_walk();
    send_refracted(take_fan());
    see_lights();
    put_fan_walk();",
            rust: |world, take, put| {
                world.fan_walk(take, put, |walk, take, _| {
                    send_refracted(walk, take.fan());
                    see_lights(walk);
                });
            },
            cases: |world| {
                let mut cases: Vec<_> =
                    fans_in_colour(world).iter().map(|fan| walk().fan(fan)).collect();
                // Out of the body that they have met.
                cases.extend(world.arrivals(400).iter().map(|Meeting { fan, hit, .. }| {
                    let (instance, facet, medium) = (hit.instance, hit.facet, NONE);
                    walk().fan(&Fan { instance, facet, medium, depth: 2, ..*fan })
                }));
                cases
            },
            // Edges of lights.
            tolerance: Tolerance::relative(2e-3).or(2e-3).but(0.02),
        },
    ]
}

fn ends_of_media() -> Vec<Probe> {
    vec![
        Probe {
            name: "can_only_meet_lights",
            wgsl: "put_bool(can_only_meet_lights(take_fan()));",
            rust: |world, take, put| put.bool(can_only_meet_lights(&world.scene, &take.fan())),
            cases: |world| {
                let mut cases: Vec<_> =
                    fans_in_colour(world).iter().map(|fan| Case::new().fan(fan)).collect();
                cases.extend(world.fans(200).iter().map(|fan| Case::new().fan(fan)));
                cases
            },
            tolerance: EXACT,
        },
        Probe {
            name: "pays_on_entering",
            wgsl: "let fan = take_fan();
    put_bool(pays_on_entering(fan, fan.medium));",
            rust: |world, take, put| {
                let fan = take.fan();
                put.bool(pays_on_entering(&world.scene, &fan, fan.medium));
            },
            cases: |world| fans_in_colour(world).iter().map(|fan| Case::new().fan(fan)).collect(),
            tolerance: EXACT,
        },
        Probe {
            name: "end_of_bin",
            wgsl: "put_f32(end_of_bin(take_fan(), take_f32()));",
            rust: |world, take, put| put.f32(end_of_bin(&world.scene, &take.fan(), take.f32())),
            cases: |_| {
                throw(600, |dice| {
                    let fan = wide_fan(dice);
                    Case::new().fan(&fan).f32(dice.position())
                })
            },
            // Where rounding decides which bin it is.
            tolerance: Tolerance::relative(1e-4).or(1e-4).but(0.01),
        },
    ]
}

fn whole() -> Vec<Probe> {
    vec![
        Probe {
            name: "refract_fan",
            wgsl: "begin_walk();
    let fan = take_fan();
    let ray = take_ray();
    let hit = take_hit();
    let at = interface_at(ray, hit);
    refract_fan(fan, ray, hit, at);
    see_lights();
    put_fan_walk();",
            rust: |world, take, put| {
                world.fan_walk(take, put, |walk, take, _| {
                    let (fan, ray, hit) = (take.fan(), take.ray(), take.hit());
                    let at = interface_at(walk.scene, &ray, &hit);
                    let crossing = crossing_of(walk.scene, &at, &fan);
                    refract_fan(walk, &fan, &crossing, &ray, &hit, &at);
                    see_lights(walk);
                });
            },
            cases: |world| {
                let mut cases = Vec::new();
                for Meeting { fan, ray, hit } in interfaces(world) {
                    let at = interface_at(&world.scene, &ray, &hit);
                    let crossing = crossing_of(&world.scene, &at, &fan);
                    if crossing.cos_t_squared.max_element() > 0.0 {
                        cases.push(walk().fan(&fan).ray(&ray).hit(&hit));
                    }
                }
                cases
            },
            tolerance: DIVISION,
        },
        Probe {
            name: "divide_fan",
            wgsl: "begin_walk();
    divide_fan(take_fan(), take_ray(), take_hit());
    see_lights();
    put_fan_walk();",
            rust: |world, take, put| {
                world.fan_walk(take, put, |walk, take, _| {
                    divide_fan(walk, &take.fan(), &take.ray(), &take.hit());
                    see_lights(walk);
                });
            },
            cases: |world| arrivals(world, &walk()),
            tolerance: DIVISION,
        },
    ]
}

fn walk() -> Case {
    Case::new().u32(0).u32(0)
}

/// Fans at interfaces, some from directions at which a part of them is totally reflected.
fn interfaces(world: &World) -> Vec<Meeting> {
    let mut dice = Dice::new(29);
    let is_clear = |meeting: &Meeting| !meets_opaque(&world.scene, &meeting.hit);
    let turned = |mut meeting: Meeting| {
        let at = interface_at(&world.scene, &meeting.ray, &meeting.hit);
        let eta = crossing_of(&world.scene, &at, &meeting.fan).eta.y;
        if eta > 1.0 && dice.below(3) == 0 {
            let critical = (1.0 - 1.0 / (eta * eta)).sqrt();
            let middle = dice.direction_at(-at.normal, critical);
            let spread = middle.cross(dice.direction()) * dice.magnitude(1e-4, 0.02);
            let [low, high] = [middle - spread, middle + spread].map(Vec3::normalize_or_zero);
            meeting.fan.direction = nodes_of(low, middle, high);
            meeting.ray.direction = middle_node(&meeting.fan.direction);
        }
        meeting
    };
    world.arrivals(800).into_iter().filter(is_clear).map(turned).collect()
}

pub(super) fn arrivals(world: &World, start: &Case) -> Vec<Case> {
    let case = |Meeting { fan, ray, hit }: Meeting| start.clone().fan(&fan).ray(&ray).hit(&hit);
    interfaces(world).into_iter().map(case).collect()
}

/// Fans that have run through one coloured material, or none, and are in any body.
fn fans_in_colour(world: &World) -> Vec<Fan> {
    let mut dice = Dice::new(31);
    let absorbers = [&world.absorbers()[..], &[NONE]].concat();
    let bodies = world.scene.instances.len();
    let mut fan = || {
        let medium = dice.below(bodies) as u32;
        let absorber = dice.pick(&absorbers);
        Fan { medium: dice.pick(&[medium, medium, NONE]), absorber, ..dice.fan() }
    };
    (0..400).map(|_| fan()).collect()
}

/// At least a hundredth of the axis wide.
fn wide_fan(dice: &mut Dice) -> Fan {
    let (low, width) = (dice.between(0.0, 0.1), dice.magnitude(1e-2, 0.9));
    let drawn = dice.pick(&[0.5, 0.3, 0.7]);
    Fan { axis: Vec3A::new(low, low + drawn * width, low + width), ..dice.fan() }
}

/// Straight and bent about as much as is allowed.
fn bent_directions(dice: &mut Dice) -> Nodes {
    let middle = dice.direction();
    let spread = middle.cross(dice.direction()) * dice.magnitude(1e-4, 0.1);
    let bend = dice.point(1.0) * (1e-4 * spread.length()).sqrt() * dice.between(0.0, 2.0);
    let [low, high] = [bend - spread, bend + spread].map(|it| (middle + it).normalize_or_zero());
    nodes_of(low, middle, high)
}
