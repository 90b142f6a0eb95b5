//! Looking things up in the scene.

use crate::probe::{Case, EXACT, Probe, Table, World, throw};

#[test]
fn packed() {
    table().check();
}

pub(super) fn table() -> Table {
    Table {
        worlds: vec![World::full()],
        probes: vec![
            Probe {
                name: "normal",
                wgsl: "put_vec3(normal(triangles[take_u32()]));",
                rust: |world, take, put| {
                    put.vec3(world.scene.triangles[take.u32() as usize].normal());
                },
                cases: |world| numbers(world.scene.triangles.len()),
                tolerance: EXACT,
            },
            Probe {
                name: "is_opaque",
                wgsl: "put_bool(is_opaque(materials[take_u32()]));",
                rust: |world, take, put| {
                    put.bool(world.scene.materials[take.u32() as usize].is_opaque());
                },
                cases: |world| numbers(world.scene.materials.len()),
                tolerance: EXACT,
            },
            Probe {
                name: "material_of",
                wgsl: "put_material(material_of(take_u32()));",
                rust: |world, take, put| put.material(world.scene.material_of(take.u32())),
                cases: |world| numbers(world.scene.instances.len()),
                tolerance: EXACT,
            },
            Probe {
                name: "projection_row",
                wgsl: "put_vec4(projection_row(take_u32()));",
                rust: |world, take, put| put.vec4(world.scene.projection_row(take.u32())),
                cases: |world| {
                    let print = |instance: u32| world.scene.material_of(instance).print;
                    let rows = |instance| [0, 4].map(|row| print(instance).projection + row);
                    let rows = world.printed().into_iter().flat_map(rows);
                    rows.map(|row| Case::new().u32(row)).collect()
                },
                tolerance: EXACT,
            },
            Probe {
                name: "spectrum_value",
                wgsl: "put_f32(spectrum_value(take_u32(), take_u32()));",
                rust: |world, take, put| {
                    put.f32(world.scene.spectrum_value(take.u32(), take.u32()));
                },
                cases: |world| {
                    let bins = world.scene.bins.count();
                    let rows = world.rows();
                    throw(100, |dice| {
                        Case::new().u32(dice.below(rows) as u32).u32(dice.below(bins) as u32)
                    })
                },
                tolerance: EXACT,
            },
        ],
    }
}

fn numbers(count: usize) -> Vec<Case> {
    (0..count as u32).map(|i| Case::new().u32(i)).collect()
}
