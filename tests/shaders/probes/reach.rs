//! How far fans meet one surface.

use brilliance_renderer::kernel::ray::GROUND;
use brilliance_renderer::kernel::reach::{
    arrive, clip_fan, is_convex_body, is_single, is_unobstructed, meets_same, reach, reach_towards,
};
use brilliance_renderer::packed::NONE;

use crate::probe::{Case, Dice, EXACT, Meeting, Probe, Table, Tolerance, World};

#[test]
fn reaches() {
    table().check();
}

/// Edges of facets, where rounding decides; a halving the other way is one of a thousandth.
const POSITION: Tolerance = Tolerance::relative(2e-3).or(2e-3).but(0.02);

pub(super) fn table() -> Table {
    let probes = [bodies(), positions(), vec![arrival()]];
    Table {
        worlds: vec![World::full(), World::single(), World::sliver(), World::empty()],
        probes: probes.into_iter().flatten().collect(),
    }
}

fn bodies() -> Vec<Probe> {
    vec![
        Probe {
            name: "is_convex_body",
            wgsl: "put_bool(is_convex_body(take_u32()));",
            rust: |world, take, put| put.bool(is_convex_body(&world.scene, take.u32())),
            cases: |world| {
                let bodies = 0..world.scene.instances.len() as u32;
                bodies.chain([GROUND, NONE]).map(|body| Case::new().u32(body)).collect()
            },
            tolerance: EXACT,
        },
        Probe {
            name: "is_unobstructed",
            wgsl: "put_bool(is_unobstructed(take_ray()));",
            rust: |world, take, put| put.bool(is_unobstructed(&world.scene, &take.ray())),
            cases: |world| {
                let meetings = world.meetings(200).into_iter();
                meetings.map(|meeting| Case::new().ray(&meeting.ray)).collect()
            },
            tolerance: EXACT,
        },
        Probe {
            name: "is_single",
            wgsl: "put_bool(is_single() && take_u32() == 7u);",
            rust: |world, take, put| put.bool(is_single(&world.scene) & (take.u32() == 7)),
            cases: |_| vec![Case::new().u32(7)],
            tolerance: EXACT,
        },
    ]
}

fn positions() -> Vec<Probe> {
    vec![
        Probe {
            name: "reach",
            wgsl: "begin_walk();
    put_vec2(reach(take_fan(), take_ray(), take_hit()));
    put_fan_walk();",
            rust: |world, take, put| {
                world.fan_walk(take, put, |walk, take, put| {
                    put.vec2(reach(walk, &take.fan(), &take.ray(), &take.hit()));
                });
            },
            cases: |world| {
                let case =
                    |Meeting { fan, ray, hit }: Meeting| walk().fan(&fan).ray(&ray).hit(&hit);
                world.meetings(600).into_iter().map(case).collect()
            },
            tolerance: POSITION,
        },
        Probe {
            name: "clip_fan",
            wgsl: "put_vec2(clip_fan(take_fan(), take_ray(), take_hit()));",
            rust: |world, take, put| {
                let (fan, ray) = (take.fan(), take.ray());
                put.vec2(clip_fan(&world.scene, &fan, &ray, &take.hit()));
            },
            cases: |world| {
                let is_convex =
                    |meeting: &Meeting| is_convex_body(&world.scene, meeting.hit.instance);
                let meetings = world.meetings(600).into_iter().filter(is_convex);
                let case = |Meeting { fan, ray, hit }| Case::new().fan(&fan).ray(&ray).hit(&hit);
                meetings.map(case).collect()
            },
            tolerance: POSITION,
        },
        Probe {
            name: "reach_towards",
            wgsl: "begin_walk();
    put_f32(reach_towards(take_fan(), take_hit(), take_f32()));
    put_fan_walk();",
            rust: |world, take, put| {
                world.fan_walk(take, put, |walk, take, put| {
                    put.f32(reach_towards(walk, &take.fan(), &take.hit(), take.f32()));
                });
            },
            cases: |world| {
                let mut dice = Dice::new(17);
                let case = |Meeting { fan, hit, .. }: Meeting| {
                    walk().fan(&fan).hit(&hit).f32(dice.position())
                };
                world.meetings(400).into_iter().map(case).collect()
            },
            tolerance: POSITION,
        },
        Probe {
            name: "meets_same",
            wgsl: "begin_walk();
    put_bool(meets_same(take_fan(), take_hit(), take_f32()));
    put_fan_walk();",
            rust: |world, take, put| {
                world.fan_walk(take, put, |walk, take, put| {
                    put.bool(meets_same(walk, &take.fan(), &take.hit(), take.f32()));
                });
            },
            cases: |world| {
                let mut dice = Dice::new(19);
                let case = |Meeting { fan, hit, .. }: Meeting| {
                    walk().fan(&fan).hit(&hit).f32(dice.position())
                };
                world.meetings(400).into_iter().map(case).collect()
            },
            tolerance: EXACT.but(0.01),
        },
    ]
}

fn arrival() -> Probe {
    Probe {
        name: "arrive",
        wgsl: "var fan = take_fan();
    arrive(&fan, take_hit(), take_f32());
    put_fan(fan);",
        rust: |world, take, put| {
            let (mut fan, hit) = (take.fan(), take.hit());
            arrive(&world.scene, &mut fan, &hit, take.f32());
            put.fan(&fan);
        },
        cases: |world| {
            let meets = |meeting: &Meeting| meeting.hit.instance != NONE;
            let meetings = world.meetings(600).into_iter().filter(meets);
            let case = |Meeting { fan, ray, hit }| {
                let height = (ray.origin + ray.direction * hit.distance).dot(hit.normal);
                Case::new().fan(&fan).hit(&hit).f32(height)
            };
            meetings.map(case).collect()
        },
        // Where rays graze, a long way comes of a small error.
        tolerance: Tolerance::relative(1e-3).or(1e-3).but(0.02),
    }
}

fn walk() -> Case {
    Case::new().u32(0).u32(0)
}
