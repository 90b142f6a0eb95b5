//! Camera rays.

use brilliance_renderer::kernel::camera::{camera_ray, pixel_seed};

use crate::probe::{Case, EXACT, Probe, ROUNDING, Table, World, throw};

#[test]
fn camera() {
    table().check();
}

pub(super) fn table() -> Table {
    Table {
        worlds: vec![World::empty()],
        probes: vec![
            Probe {
                name: "camera_ray",
                wgsl: "put_ray(camera_ray(take_u32(), take_u32(), take_u32()));",
                rust: |world, take, put| {
                    let World { camera, size, .. } = world;
                    put.ray(&camera_ray(camera, *size, take.u32(), take.u32(), take.u32()));
                },
                cases: pixels,
                tolerance: ROUNDING,
            },
            Probe {
                name: "pixel_seed",
                wgsl: "put_u32(pixel_seed(take_u32(), take_u32()));",
                rust: |_, take, put| put.u32(pixel_seed(take.u32(), take.u32())),
                cases: |_| throw(300, |dice| Case::new().u32(dice.word()).u32(dice.word() >> 20)),
                tolerance: EXACT,
            },
        ],
    }
}

/// Pixels in some pass, and the corners of the picture in the first.
fn pixels(world: &World) -> Vec<Case> {
    let [width, height] = world.size;
    let mut cases = throw(300, |dice| {
        let [x, y] = world.size.map(|size| dice.below(size as usize) as u32);
        Case::new().u32(x).u32(y).u32(dice.word())
    });
    let corners = [[0, 0], [width - 1, 0], [0, height - 1], [width - 1, height - 1]];
    cases.extend(corners.map(|[x, y]| Case::new().u32(x).u32(y).u32(0)));
    cases
}
