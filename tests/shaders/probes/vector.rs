//! glam's functions and what stands for them in WGSL.

use glam::Vec3;

use crate::probe::{Case, EXACT, Probe, ROUNDING, Table, World, throw};

#[test]
fn vectors() {
    table().check();
}

pub(super) fn table() -> Table {
    Table {
        worlds: vec![World::empty()],
        probes: vec![
            Probe {
                name: "normalize_or_zero",
                wgsl: "put_vec3(normalize_or_zero(take_vec3()));",
                rust: |_, take, put| put.vec3(take.vec3().normalize_or_zero()),
                cases: vectors_of_any_length,
                tolerance: ROUNDING,
            },
            Probe {
                name: "length_squared",
                wgsl: "put_f32(length_squared(take_vec3()));",
                rust: |_, take, put| put.f32(take.vec3().length_squared()),
                cases: vectors_of_any_length,
                tolerance: ROUNDING.or(0.0),
            },
            Probe {
                name: "max_element",
                wgsl: "put_f32(max_element(take_vec3()));",
                rust: |_, take, put| put.f32(take.vec3().max_element()),
                cases: vectors_of_any_length,
                tolerance: EXACT,
            },
            Probe {
                name: "min_element",
                wgsl: "put_f32(min_element(take_vec3()));",
                rust: |_, take, put| put.f32(take.vec3().min_element()),
                cases: vectors_of_any_length,
                tolerance: EXACT,
            },
            Probe {
                name: "max_position",
                wgsl: "put_u32(max_position(take_vec3()));",
                rust: |_, take, put| put.u32(take.vec3().max_position() as u32),
                cases: vectors_of_any_length,
                tolerance: EXACT,
            },
        ],
    }
}

/// From 0 up to where the square of the length is still a number, and with equal components. What
/// is so short that its square is 0 to a device has a direction only for glam; no ray is so.
fn vectors_of_any_length(_: &World) -> Vec<Case> {
    let mut cases = throw(500, |dice| {
        let length = dice.magnitude(1e-18, 1e18);
        Case::new().vec3(dice.direction() * length)
    });
    let ends = [Vec3::ZERO, -Vec3::ZERO, Vec3::ONE, Vec3::NEG_ONE];
    let pairs = [Vec3::new(1.0, 1.0, 0.5), Vec3::new(0.5, 1.0, 1.0), Vec3::new(1.0, 0.5, 1.0)];
    cases
        .extend([&ends[..], &pairs, &Vec3::AXES].concat().into_iter().map(|v| Case::new().vec3(v)));
    cases
}
