//! What is printed on matte bodies.

use brilliance_renderer::kernel::print::{
    filtered_texel, folded, is_off, neighbour, print_reflectance, texel,
};
use brilliance_renderer::material::Outside;
use brilliance_renderer::packed::NONE;
use glam::Vec2;

use super::diffuse::matte_points;
use crate::probe::{Case, Dice, EXACT, Probe, ROUNDING, Table, Tolerance, World, throw};

#[test]
fn prints() {
    table().check();
}

const OUTSIDES: [Outside; 4] = [Outside::Bare, Outside::Edge, Outside::Repeat, Outside::Mirror];

pub(super) fn table() -> Table {
    let probes = [bodies(), coordinates(), texels()];
    Table { worlds: vec![World::full()], probes: probes.into_iter().flatten().collect() }
}

fn bodies() -> Vec<Probe> {
    vec![Probe {
        name: "print_reflectance",
        wgsl: "let hit = take_hit();
    put_reflectance(print_reflectance(material_of(hit.instance), hit, take_vec3()));",
        rust: |world, take, put| {
            let hit = take.hit();
            let material = world.scene.material_of(hit.instance);
            put.reflectance(&print_reflectance(&world.scene, material, &hit, take.vec3()));
        },
        cases: |world| {
            let points = matte_points(world)
                .into_iter()
                .filter(|(_, hit)| world.printed().contains(&hit.instance));
            points.map(|(ray, hit)| Case::new().hit(&hit).vec3(ray.origin)).collect()
        },
        // Along the edge of an image, and where a texture coordinate is large.
        tolerance: Tolerance::relative(1e-4).or(1e-4).but(0.01),
    }]
}

fn coordinates() -> Vec<Probe> {
    vec![
        Probe {
            name: "is_off",
            wgsl: "put_bool(is_off(take_f32(), take_u32()));",
            rust: |_, take, put| put.bool(is_off(take.f32(), take.u32())),
            cases: |_| far_coordinates(),
            tolerance: EXACT,
        },
        Probe {
            name: "folded",
            wgsl: "put_f32(folded(take_f32(), take_u32()));",
            rust: |_, take, put| put.f32(folded(take.f32(), take.u32())),
            cases: |_| far_coordinates(),
            tolerance: ROUNDING,
        },
        Probe {
            name: "neighbour",
            wgsl: "put_u32(neighbour(bitcast<i32>(take_u32()), take_u32(), take_u32()));",
            rust: |_, take, put| {
                put.u32(neighbour(take.u32().cast_signed(), take.u32(), take.u32()));
            },
            cases: |_| {
                let counts = [1, 2, 7, 8192_i32];
                let indices = |count: i32| [-1, 0, 1, count - 1, count].map(|i| (i, count));
                let pairs = counts.into_iter().flat_map(indices);
                let case = |((index, count), outside): ((i32, i32), Outside)| {
                    Case::new()
                        .u32(index.cast_unsigned())
                        .u32(count.cast_unsigned())
                        .u32(outside as u32)
                };
                pairs.flat_map(|pair| OUTSIDES.map(|outside| case((pair, outside)))).collect()
            },
            tolerance: EXACT,
        },
    ]
}

fn texels() -> Vec<Probe> {
    vec![
        Probe {
            name: "filtered_texel",
            wgsl: "let print = material_of(take_u32()).print;
    put_vec3(filtered_texel(print, take_vec2()));",
            rust: |world, take, put| {
                let print = &world.scene.material_of(take.u32()).print;
                let at = Vec2::from_array(take.vec2());
                put.vec3(filtered_texel(&world.scene, print, at));
            },
            cases: |world| {
                throw(600, |dice| {
                    let reach = dice.pick(&[0.0, 2.0]);
                    let mut at = || dice.between(-reach, 1.0 + reach);
                    let (u, v) = (at(), at());
                    Case::new().u32(dice.pick(&world.printed())).f32(u).f32(v)
                })
            },
            // Coordinates are off by their rounding, times the texels from one side to the other.
            tolerance: Tolerance::relative(1e-5).or(1e-5).but(0.005),
        },
        Probe {
            name: "texel",
            wgsl: "let print = material_of(take_u32()).print;
    put_vec3(texel(print, take_u32(), take_u32()));",
            rust: |world, take, put| {
                let print = &world.scene.material_of(take.u32()).print;
                put.vec3(texel(&world.scene, print, take.u32(), take.u32()));
            },
            cases: |world| {
                let all = |instance: u32| {
                    let [width, height] = world.scene.material_of(instance).print.size;
                    let rows = 0..height;
                    rows.flat_map(move |y| {
                        (0..width).map(move |x| Case::new().u32(instance).u32(x).u32(y))
                    })
                };
                world.printed().into_iter().flat_map(all).collect()
            },
            tolerance: EXACT,
        },
    ]
}

/// Inside of the image, outside of it, and on its edges.
fn far_coordinates() -> Vec<Case> {
    let mut dice = Dice::new(43);
    let mut coordinates: Vec<f32> = (0..100).map(|_| dice.between(-3.0, 4.0)).collect();
    coordinates.extend([-2.0, -1.0, -0.0, 0.0, 0.5, 1.0, 2.0, 3.0, -1e-9, 1.0 + 1e-6, 1e6]);
    let case =
        |coordinate: f32| OUTSIDES.map(|outside| Case::new().f32(coordinate).u32(outside as u32));
    coordinates.into_iter().flat_map(case).collect()
}

#[test]
fn the_world_has_prints_of_all_kinds() {
    let world = World::full();
    let printed = world.printed();
    let prints = printed.iter().map(|&instance| world.scene.material_of(instance).print);
    let outsides: Vec<u32> = prints.flat_map(|print| print.outside).collect();
    assert!(OUTSIDES.iter().all(|&outside| outsides.contains(&(outside as u32))));
    assert!(
        world.scene.materials.iter().any(|material| {
            material.print.texels != NONE && material.print.projection_stride > 0
        })
    );
}
