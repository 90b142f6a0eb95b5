//! The ray itself.

use brilliance_renderer::kernel::ray::Ray;

use crate::probe::{Case, EXACT, Probe, ROUNDING, Table, World, throw};

#[test]
fn ray() {
    table().check();
}

pub(super) fn table() -> Table {
    Table {
        worlds: vec![World::empty()],
        probes: vec![
            Probe {
                name: "white",
                wgsl: "put_ray(white(take_vec3(), take_vec3()));",
                rust: |_, take, put| put.ray(&Ray::white(take.vec3(), take.vec3())),
                cases: |_| {
                    throw(20, |dice| Case::new().vec3(dice.point(9.0)).vec3(dice.direction()))
                },
                tolerance: EXACT,
            },
            Probe {
                name: "bandwidth",
                wgsl: "put_f32(bandwidth(take_ray()));",
                rust: |_, take, put| put.f32(take.ray().bandwidth()),
                cases: |_| throw(200, |dice| Case::new().ray(&dice.ray())),
                tolerance: ROUNDING,
            },
        ],
    }
}
