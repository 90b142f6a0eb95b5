//! Fans and their parts.

use brilliance_renderer::kernel::fan::{
    axis_position_in, axis_positions, gathered, is_dispersed, part_of_fan, ray_in_fan,
    segment_count, white_fan,
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
            wgsl: "put_fan(white_fan(take_vec3(), take_vec3()));",
            rust: |_, take, put| put.fan(&white_fan(take.vec3(), take.vec3())),
            cases: |_| throw(100, |dice| Case::new().vec3(dice.point(9.0)).vec3(dice.direction())),
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
            name: "axis_positions",
            wgsl: "put_vec3(axis_positions(take_fan()));",
            rust: |_, take, put| put.each(axis_positions(&take.fan())),
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
