//! Fans that wait, and those that go into the books.

use brilliance_renderer::kernel::fan::Fan;
use brilliance_renderer::kernel::fan_walk::{
    FAN_STACK_LEN, energy_bound, fate_of_fan, is_worth_dividing, largest, least_of, send_fan,
    significance_bound,
};
use brilliance_renderer::packed::NONE;
use glam::Vec3A;

use crate::probe::{Case, Dice, EXACT, Probe, Table, Tolerance, World, throw};

#[test]
fn fan_walk() {
    table().check();
}

/// Whether a fan is too weak is decided by rounding where it is as weak as that.
const ENERGY: Tolerance = Tolerance::relative(1e-4).or(1e-5).but(0.005);

pub(super) fn table() -> Table {
    let probes = [stack(), fates(), values()];
    Table {
        worlds: vec![World::full(), World::curt()],
        probes: probes.into_iter().flatten().collect(),
    }
}

fn stack() -> Vec<Probe> {
    vec![
        Probe {
            name: "send_fan",
            wgsl: "begin_walk();
    send_fan(take_fan());
    send_fan(take_fan());
    if has_rays() {
        put_fan(pop_fan());
    }
    send_fan(take_fan());
    put_fan_walk();",
            rust: |world, take, put| {
                world.fan_walk(take, put, |walk, take, put| {
                    send_fan(walk, take.fan());
                    send_fan(walk, take.fan());
                    if walk.has_rays() {
                        put.fan(&walk.pop());
                    }
                    send_fan(walk, take.fan());
                });
            },
            cases: |world| {
                throw(400, |dice| {
                    let [a, b, c] = [0; 3].map(|_| any_fan(world, dice));
                    walk(dice).fan(&a).fan(&b).fan(&c)
                })
            },
            tolerance: ENERGY,
        },
        Probe {
            name: "send_fan to a full stack",
            wgsl: "begin_walk();
    let fan = take_fan();
    for (var i = 0u; i < FAN_STACK_LEN; i++) {
        send_fan(fan);
    }
    put_u32(waiting());
    send_fan(fan);
    put_u32(waiting());
    walk.stack_count = 1u;
    put_fan_walk();",
            rust: |world, take, put| {
                world.fan_walk(take, put, |walk, take, put| {
                    let fan = take.fan();
                    for _ in 0..FAN_STACK_LEN {
                        send_fan(walk, fan);
                    }
                    put.u32(walk.waiting());
                    send_fan(walk, fan);
                    put.u32(walk.waiting());
                    while walk.waiting() > 1 {
                        walk.pop();
                    }
                });
            },
            cases: |_| {
                throw(40, |dice| {
                    let axis = Vec3A::new(0.0, 0.5, 1.0);
                    let weight = dice.each(0.1, 1.0);
                    let fan = Fan { weight, axis, depth: 1, ..dice.fan() };
                    walk(dice).fan(&fan)
                })
            },
            tolerance: ENERGY,
        },
    ]
}

fn fates() -> Vec<Probe> {
    vec![
        Probe {
            name: "fate_of_fan",
            wgsl: "begin_walk();
    var fan = take_fan();
    walk.stack_count = take_u32();
    put_u32(fate_of_fan(&fan, take_f32()));
    put_fan(fan);
    walk.stack_count = 0u;
    put_fan_walk();",
            rust: |world, take, put| {
                world.fan_walk(take, put, |walk, take, put| {
                    let mut fan = take.fan();
                    for _ in 0..take.u32() {
                        walk.push(&fan);
                    }
                    put.u32(fate_of_fan(walk, &mut fan, take.f32()) as u32);
                    put.fan(&fan);
                    while walk.has_rays() {
                        walk.pop();
                    }
                });
            },
            cases: |world| {
                throw(800, |dice| {
                    let depth = dice.pick(&[0, 3, 4, 40, 41]);
                    let fan = Fan { depth, ..any_fan(world, dice) };
                    let full = FAN_STACK_LEN as u32;
                    let waiting = dice.pick(&[0, 0, full - 1, full]);
                    let threshold = dice.magnitude(1e-3, 0.5);
                    walk(dice).fan(&fan).u32(waiting).f32(threshold)
                })
            },
            // What lives carries more by one over a chance, which may be small.
            tolerance: Tolerance::relative(1e-4).or(1e-4).but(0.02),
        },
        Probe {
            name: "energy_bound",
            wgsl: "put_f32(energy_bound(take_fan()));",
            rust: |world, take, put| put.f32(energy_bound(&world.scene, &take.fan())),
            cases: |world| throw(400, |dice| Case::new().fan(&any_fan(world, dice))),
            tolerance: Tolerance::relative(1e-5).or(1e-7),
        },
        Probe {
            name: "significance_bound",
            wgsl: "put_f32(significance_bound(take_fan()));",
            rust: |world, take, put| put.f32(significance_bound(&world.scene, &take.fan())),
            cases: |world| throw(400, |dice| Case::new().fan(&any_fan(world, dice))),
            tolerance: Tolerance::relative(1e-5),
        },
        Probe {
            name: "is_worth_dividing",
            wgsl: "put_bool(is_worth_dividing(take_fan()));",
            rust: |world, take, put| put.bool(is_worth_dividing(&world.rules, &take.fan())),
            cases: |world| throw(400, |dice| Case::new().fan(&any_fan(world, dice))),
            tolerance: EXACT.but(0.005),
        },
    ]
}

fn values() -> Vec<Probe> {
    vec![
        Probe {
            name: "largest",
            wgsl: "put_f32(largest(take_vec3()));",
            rust: |_, take, put| put.f32(largest(take.each())),
            cases: |_| throw(100, |dice| Case::new().each(dice.each(-1.0, 1.0))),
            tolerance: EXACT,
        },
        Probe {
            name: "least_of",
            wgsl: "put_f32(least_of(take_vec3()));",
            rust: |_, take, put| put.f32(least_of(take.each())),
            cases: |_| throw(100, |dice| Case::new().each(dice.each(-1.0, 1.0))),
            tolerance: EXACT,
        },
    ]
}

/// Of any seed and pass.
fn walk(dice: &mut Dice) -> Case {
    Case::new().u32(dice.word()).u32(dice.below(100) as u32)
}

/// Strong and weak, with a path through one of the coloured materials or through none.
fn any_fan(world: &World, dice: &mut Dice) -> Fan {
    let absorber = dice.pick(&[&world.absorbers()[..], &[NONE]].concat());
    let fan = dice.fan();
    Fan { absorber, weight: fan.weight * dice.magnitude(1e-4, 1.0), ..fan }
}
