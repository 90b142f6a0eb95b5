//! The tables of the dispersion axis.

use brilliance_renderer::kernel::axis::{
    axis_moments, axis_position_of, indices_at, table_at, wavelength_at, wavelength_slope_at,
};
use brilliance_renderer::packed::{AXIS_LEN, INDEX_TABLE_LEN};

use crate::probe::{Case, Dice, EXACT, Probe, ROUNDING, Table, World, throw};

#[test]
fn axis() {
    table().check();
}

pub(super) fn table() -> Table {
    Table {
        worlds: vec![World::full(), World::empty()],
        probes: vec![
            Probe {
                name: "table_at",
                wgsl: "put_f32(table_at(take_u32(), take_u32(), take_f32()));",
                rust: |world, take, put| {
                    let (first, len) = (take.u32(), take.u32());
                    put.f32(table_at(&world.scene, first, len as usize, take.f32()));
                },
                cases: |world| {
                    throw(400, |dice| {
                        let len = dice.pick(&[2, 5, INDEX_TABLE_LEN, AXIS_LEN]) as u32;
                        Case::new().u32(world.scene.axis).u32(len).f32(place(dice))
                    })
                },
                tolerance: ROUNDING,
            },
            Probe {
                name: "wavelength_at",
                wgsl: "put_f32(wavelength_at(take_f32()));",
                rust: |world, take, put| put.f32(wavelength_at(&world.scene, take.f32())),
                cases: |_| throw(400, |dice| Case::new().f32(place(dice))),
                tolerance: ROUNDING,
            },
            Probe {
                name: "wavelength_slope_at",
                wgsl: "put_f32(wavelength_slope_at(take_f32()));",
                rust: |world, take, put| put.f32(wavelength_slope_at(&world.scene, take.f32())),
                cases: |_| throw(400, |dice| Case::new().f32(place(dice))),
                // Between two numbers of the table rounding decides which it is.
                tolerance: ROUNDING.or(1e-4).but(0.01),
            },
            Probe {
                name: "axis_position_of",
                wgsl: "put_f32(axis_position_of(take_f32()));",
                rust: |world, take, put| put.f32(axis_position_of(&world.scene, take.f32())),
                cases: |_| {
                    throw(400, |dice| {
                        let any = dice.between(375.0, 735.0);
                        Case::new().f32(dice.pick(&[any, any, any.round(), 380.0, 730.0]))
                    })
                },
                tolerance: ROUNDING,
            },
            Probe {
                name: "axis_moments",
                wgsl: "put_vec2(axis_moments(take_u32()));",
                rust: |world, take, put| put.vec2(axis_moments(&world.scene, take.u32())),
                cases: |world| {
                    (0..world.scene.bins.count() as u32).map(|bin| Case::new().u32(bin)).collect()
                },
                tolerance: EXACT,
            },
            Probe {
                name: "indices_at",
                wgsl: "put_vec3(indices_at(take_u32(), take_vec3()));",
                rust: |world, take, put| {
                    put.each(indices_at(&world.scene, take.u32(), take.each()));
                },
                cases: |world| {
                    let media = world.media();
                    throw(400, |dice| Case::new().u32(dice.pick(&media)).each(dice.each(0.0, 1.0)))
                },
                tolerance: ROUNDING,
            },
        ],
    }
}

/// Anywhere in a table, at its ends and beyond.
fn place(dice: &mut Dice) -> f32 {
    let any = dice.between(-0.1, 1.1);
    dice.pick(&[any, any, any, 0.0, 1.0])
}
