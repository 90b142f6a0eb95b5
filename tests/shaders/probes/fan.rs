//! Fans and their parts.

use brilliance_renderer::kernel::fan::{
    axis_position_in, axis_width, fan_through, gathered, is_dispersed, part_of_fan, position_of,
    ray_in_fan, seed_of_way, segment_count, white_fan,
};

use crate::probe::{Case, EXACT, Probe, ROUNDING, Table, Tolerance, World, throw};

#[test]
fn fan() {
    table().check();
}

/// Origins lie up to 10 mm away.
const PARTS: Tolerance = ROUNDING.or(1e-5);

pub(super) fn table() -> Table {
    let probes = [wholes(), positions(), parts()];
    Table { worlds: vec![World::full()], probes: probes.into_iter().flatten().collect() }
}

fn wholes() -> Vec<Probe> {
    vec![
        Probe {
            name: "white_fan",
            wgsl: "put_fan(white_fan(take_vec3(), take_vec3(), take_u32()));",
            rust: |_, take, put| put.fan(&white_fan(take.vec3(), take.vec3(), take.u32())),
            cases: |_| {
                throw(100, |dice| {
                    let (origin, direction) = (dice.point(9.0), dice.direction());
                    Case::new().vec3(origin).vec3(direction).u32(dice.word())
                })
            },
            tolerance: EXACT,
        },
        Probe {
            name: "seed_of_way",
            wgsl: "put_u32(seed_of_way(take_u32(), take_u32()));",
            rust: |_, take, put| put.u32(seed_of_way(take.u32(), take.u32())),
            cases: |_| throw(100, |dice| Case::new().u32(dice.word()).u32(dice.word())),
            tolerance: EXACT,
        },
        Probe {
            name: "is_dispersed",
            wgsl: "put_bool(is_dispersed(take_fan()));",
            rust: |_, take, put| put.bool(is_dispersed(&take.fan())),
            cases: |_| throw(200, |dice| Case::new().fan(&dice.fan())),
            tolerance: EXACT,
        },
        Probe {
            name: "segment_count",
            wgsl: "put_u32(segment_count(take_fan()));",
            rust: |_, take, put| put.u32(segment_count(&take.fan())),
            cases: |_| throw(200, |dice| Case::new().fan(&dice.fan())),
            tolerance: EXACT,
        },
    ]
}

fn positions() -> Vec<Probe> {
    vec![
        Probe {
            name: "axis_width",
            wgsl: "put_f32(axis_width(take_fan()));",
            rust: |_, take, put| put.f32(axis_width(&take.fan())),
            cases: |_| throw(200, |dice| Case::new().fan(&dice.fan())),
            tolerance: ROUNDING,
        },
        Probe {
            name: "axis_position_in",
            wgsl: "put_f32(axis_position_in(take_fan(), take_f32()));",
            rust: |_, take, put| put.f32(axis_position_in(&take.fan(), take.f32())),
            cases: |_| throw(200, |dice| Case::new().fan(&dice.fan()).f32(dice.position())),
            tolerance: ROUNDING,
        },
        Probe {
            name: "position_of",
            wgsl: "put_f32(position_of(take_fan(), take_f32()));",
            rust: |_, take, put| put.f32(position_of(&take.fan(), take.f32())),
            cases: |_| {
                throw(400, |dice| {
                    let fan = dice.fan();
                    let inside = axis_position_in(&fan, dice.position());
                    let any = dice.between(0.0, 1.0);
                    Case::new().fan(&fan).f32(dice.pick(&[inside, inside, any]))
                })
            },
            // In a narrow fan the quotient of small differences.
            tolerance: Tolerance::relative(1e-4).or(1e-4).but(0.01),
        },
    ]
}

fn parts() -> Vec<Probe> {
    vec![
        Probe {
            name: "part_of_fan",
            wgsl: "put_fan(part_of_fan(take_fan(), take_f32(), take_f32()));",
            rust: |_, take, put| put.fan(&part_of_fan(&take.fan(), take.f32(), take.f32())),
            cases: |_| throw(400, |dice| Case::new().fan(&dice.fan()).vec2(dice.part())),
            tolerance: PARTS,
        },
        Probe {
            name: "part_of_fan as they come about",
            wgsl: "put_fan(part_of_fan(take_fan(), take_f32(), take_f32()));",
            rust: |_, take, put| put.fan(&part_of_fan(&take.fan(), take.f32(), take.f32())),
            cases: |world| {
                let fans = world.fans(200).into_iter();
                fans.map(|fan| Case::new().fan(&fan).vec2([-0.25, 1.0])).collect()
            },
            tolerance: PARTS,
        },
        Probe {
            name: "fan_through",
            wgsl: "put_fan(fan_through(take_fan(), take_vec3()));",
            rust: |_, take, put| put.fan(&fan_through(&take.fan(), take.each())),
            cases: |_| throw(400, |dice| Case::new().fan(&dice.fan()).each(dice.each(-1.0, 1.0))),
            tolerance: PARTS,
        },
        Probe {
            name: "gathered",
            wgsl: "put_fan(gathered(take_fan()));",
            rust: |_, take, put| put.fan(&gathered(&take.fan())),
            cases: |_| throw(200, |dice| Case::new().fan(&dice.fan())),
            tolerance: EXACT,
        },
        Probe {
            name: "ray_in_fan",
            wgsl: "put_ray(ray_in_fan(take_fan(), take_f32()));",
            rust: |_, take, put| put.ray(&ray_in_fan(&take.fan(), take.f32())),
            cases: |_| throw(400, |dice| Case::new().fan(&dice.fan()).f32(dice.position())),
            tolerance: PARTS,
        },
    ]
}
