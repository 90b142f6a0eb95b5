//! The light of fans, bin by bin.

use brilliance_renderer::kernel::band::{
    axis_position_of_bins, band_of, bin_part, bin_weight, deposit_band, fan_energy,
    fan_transmittance, retire_fan, wavelengths_per_position,
};
use brilliance_renderer::kernel::fan::Fan;
use brilliance_renderer::packed::NONE;

use crate::probe::{Case, Dice, Probe, ROUNDING, Table, Tolerance, World, throw};

#[test]
fn band() {
    table().check();
}

/// A bin's overlap is a difference of numbers up to the number of bins, its position in a fan a
/// quotient of small differences where the fan is narrow.
const PART: Tolerance = Tolerance::relative(1e-5).or(1e-5).but(0.03);
/// So is the light of a bin that is hardly met. The processor sums up whole bins along the axis.
const LIGHT: Tolerance = Tolerance::relative(1e-3).or(1e-4).but(0.005);

pub(super) fn table() -> Table {
    let probes = [bands(), light_in_a_bin(), light()];
    Table {
        worlds: vec![World::full(), World::empty()],
        probes: probes.into_iter().flatten().collect(),
    }
}

fn bands() -> Vec<Probe> {
    vec![
        Probe {
            name: "band_of",
            wgsl: "let band = band_of(take_fan(), take_f32(), take_f32());
    put_f32(band.range.low);
    put_f32(band.range.high);
    put_u32(band.range.first);
    put_u32(band.range.last);
    put_vec2(band.ends);
    put_parabola(band.axis);
    put_parabola(band.weight);
    put_parabola(band.path_mm);",
            rust: |world, take, put| {
                let band = band_of(&world.scene, &take.fan(), take.f32(), take.f32());
                put.f32(band.range.low);
                put.f32(band.range.high);
                put.u32(band.range.first);
                put.u32(band.range.last);
                put.vec2(band.ends);
                put.parabola(&band.axis);
                put.parabola(&band.weight);
                put.parabola(&band.path_mm);
            },
            cases: |world| fans_and_parts(world, &Case::new()),
            // At the edge of a bin rounding decides which is the first.
            tolerance: Tolerance::relative(1e-5).or(1e-5).but(0.02),
        },
        Probe {
            name: "bin_part",
            wgsl: "let band = band_of(take_fan(), take_f32(), take_f32());
    let part = bin_part(band, band.range.last);
    put_f32(part.overlap);
    put_f32(part.position);
    put_f32(part.position_squared);",
            rust: |world, take, put| {
                let band = band_of(&world.scene, &take.fan(), take.f32(), take.f32());
                let part = bin_part(&world.scene, &band, band.range.last);
                put.f32(part.overlap);
                put.f32(part.position);
                put.f32(part.position_squared);
            },
            cases: |world| fans_and_parts(world, &Case::new()),
            tolerance: PART,
        },
        Probe {
            name: "wavelengths_per_position",
            wgsl: "let band = band_of(take_fan(), take_f32(), take_f32());
    put_f32(wavelengths_per_position(band, band.ends.y));",
            rust: |world, take, put| {
                let band = band_of(&world.scene, &take.fan(), take.f32(), take.f32());
                put.f32(wavelengths_per_position(&world.scene, &band, band.ends[1]));
            },
            cases: |world| fans_and_parts(world, &Case::new()),
            tolerance: PART,
        },
        Probe {
            name: "axis_position_of_bins",
            wgsl: "put_f32(axis_position_of_bins(take_f32()));",
            rust: |world, take, put| put.f32(axis_position_of_bins(&world.scene, take.f32())),
            cases: |world| {
                let bins = world.scene.bins.count() as f32;
                throw(200, |dice| {
                    let any = dice.between(0.0, bins);
                    Case::new().f32(dice.pick(&[any, any.floor(), 0.0, bins]))
                })
            },
            tolerance: ROUNDING,
        },
    ]
}

fn light_in_a_bin() -> Vec<Probe> {
    vec![
        Probe {
            name: "bin_weight",
            wgsl: "let band = band_of(take_fan(), take_f32(), take_f32());
    put_f32(bin_weight(band, bin_part(band, band.range.first)));",
            rust: |world, take, put| {
                let band = band_of(&world.scene, &take.fan(), take.f32(), take.f32());
                put.f32(bin_weight(&band, &bin_part(&world.scene, &band, band.range.first)));
            },
            cases: |world| fans_and_parts(world, &Case::new()),
            tolerance: LIGHT,
        },
        Probe {
            name: "fan_transmittance",
            wgsl: "let fan = take_fan();
    let band = band_of(fan, take_f32(), take_f32());
    put_f32(fan_transmittance(fan, band, bin_part(band, band.range.first), band.range.first));",
            rust: |world, take, put| {
                let (scene, fan) = (&world.scene, take.fan());
                let band = band_of(scene, &fan, take.f32(), take.f32());
                let part = bin_part(scene, &band, band.range.first);
                put.f32(fan_transmittance(scene, &fan, &band, &part, band.range.first));
            },
            cases: |world| {
                let absorbers = world.absorbers();
                if absorbers.is_empty() {
                    return Vec::new();
                }
                throw(400, |dice| {
                    let fan = Fan { absorber: dice.pick(&absorbers), ..dice.fan() };
                    Case::new().fan(&fan).vec2(dice.part())
                })
            },
            tolerance: LIGHT.but(0.03),
        },
    ]
}

fn light() -> Vec<Probe> {
    vec![
        Probe {
            name: "deposit_band",
            wgsl: "begin_walk();
    deposit_band(take_fan(), take_f32(), take_f32(), take_u32());
    deposit_band(take_fan(), take_f32(), take_f32(), 0u);
    put_fan_walk();",
            rust: |world, take, put| {
                world.fan_walk(take, put, |walk, take, _| {
                    let (fan, low, high) = (take.fan(), take.f32(), take.f32());
                    deposit_band(walk, &fan, low, high, take.u32());
                    deposit_band(walk, &take.fan(), take.f32(), take.f32(), 0);
                });
            },
            cases: |world| {
                let rows = world.rows() as u32;
                if rows == 0 {
                    return Vec::new();
                }
                let mut dice = Dice::new(13);
                let first = fans_and_parts(world, &Case::new().u32(0).u32(0)).into_iter();
                let last = |case: Case| {
                    let fan = any_fan(world, &mut dice);
                    case.u32(dice.below(rows as usize) as u32).fan(&fan).vec2(dice.part())
                };
                first.map(last).collect()
            },
            tolerance: LIGHT,
        },
        Probe {
            name: "fan_energy",
            wgsl: "put_f32(fan_energy(take_fan()));",
            rust: |world, take, put| put.f32(fan_energy(&world.scene, &take.fan())),
            cases: |world| throw(400, |dice| Case::new().fan(&any_fan(world, dice))),
            tolerance: LIGHT,
        },
        Probe {
            name: "retire_fan",
            wgsl: "begin_walk();
    put_f32(retire_fan(take_fan()));
    put_fan_walk();",
            rust: |world, take, put| {
                world.fan_walk(take, put, |walk, take, put| {
                    put.f32(retire_fan(walk, &take.fan()));
                });
            },
            cases: |world| throw(400, |dice| Case::new().u32(0).u32(0).fan(&any_fan(world, dice))),
            tolerance: LIGHT,
        },
    ]
}

/// With a path through one of the coloured materials, or through none.
fn any_fan(world: &World, dice: &mut Dice) -> Fan {
    let absorber = dice.pick(&[&world.absorbers()[..], &[NONE]].concat());
    Fan { absorber, ..dice.fan() }
}

/// Behind `start` fans and parts of them.
fn fans_and_parts(world: &World, start: &Case) -> Vec<Case> {
    throw(600, |dice| start.clone().fan(&any_fan(world, dice)).vec2(dice.part()))
}
