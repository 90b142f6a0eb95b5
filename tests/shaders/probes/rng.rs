//! Reproducible numbers: the films of both tracers sample the same points.

use brilliance_renderer::kernel::rng::{
    chance_sample, hash, light_sample, pixel_sample, scramble, sobol_second, unit_float,
    wavelength_sample,
};

use crate::probe::{Case, EXACT, Probe, Table, World, throw};

#[test]
fn rng() {
    table().check();
}

pub(super) fn table() -> Table {
    Table {
        worlds: vec![World::empty()],
        probes: vec![
            Probe {
                name: "hash",
                wgsl: "put_u32(hash(take_u32()));",
                rust: |_, take, put| put.u32(hash(take.u32())),
                cases: |_| words(1),
                tolerance: EXACT,
            },
            Probe {
                name: "unit_float",
                wgsl: "put_f32(unit_float(take_u32()));",
                rust: |_, take, put| put.f32(unit_float(take.u32())),
                cases: |_| words(1),
                tolerance: EXACT,
            },
            Probe {
                name: "scramble",
                wgsl: "put_u32(scramble(take_u32(), take_u32()));",
                rust: |_, take, put| put.u32(scramble(take.u32(), take.u32())),
                cases: |_| words(2),
                tolerance: EXACT,
            },
            Probe {
                name: "sobol_second",
                wgsl: "put_u32(sobol_second(take_u32()));",
                rust: |_, take, put| put.u32(sobol_second(take.u32())),
                cases: |_| words(1),
                tolerance: EXACT,
            },
            Probe {
                name: "pixel_sample",
                wgsl: "put_vec2(pixel_sample(take_u32(), take_u32()));",
                rust: |_, take, put| put.vec2(pixel_sample(take.u32(), take.u32())),
                cases: |_| words(2),
                tolerance: EXACT,
            },
            Probe {
                name: "chance_sample",
                wgsl: "put_f32(chance_sample(take_u32(), take_u32()));",
                rust: |_, take, put| put.f32(chance_sample(take.u32(), take.u32())),
                cases: |_| words(2),
                tolerance: EXACT,
            },
            Probe {
                name: "light_sample",
                wgsl: "put_vec2(light_sample(take_u32(), take_u32()));",
                rust: |_, take, put| put.vec2(light_sample(take.u32(), take.u32())),
                cases: |_| words(2),
                tolerance: EXACT,
            },
            Probe {
                name: "wavelength_sample",
                wgsl: "put_f32(wavelength_sample(take_u32()));",
                rust: |_, take, put| put.f32(wavelength_sample(take.u32())),
                cases: |_| words(1),
                tolerance: EXACT,
            },
        ],
    }
}

/// Cases of `count` words: random ones, and those at both ends.
fn words(count: usize) -> Vec<Case> {
    let mut cases =
        throw(500, |dice| (0..count).fold(Case::new(), |case, _| case.u32(dice.word())));
    let ends = [0, 1, 255, 256, u32::MAX >> 8, 1 << 31, u32::MAX - 1, u32::MAX];
    cases.extend(ends.map(|word| (0..count).fold(Case::new(), |case, _| case.u32(word))));
    cases
}
