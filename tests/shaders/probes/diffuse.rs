//! Matte surfaces.

use brilliance_renderer::kernel::diffuse::{
    direction_by_cosine, direction_on_disc, is_shadowed, orthonormal_pair, reflectance_at,
    shade_diffuse,
};
use brilliance_renderer::kernel::intersect::find_intersection;
use brilliance_renderer::kernel::ray::{GROUND, Hit, Ray};
use brilliance_renderer::kernel::trace::meets_opaque;
use brilliance_renderer::packed::NONE;
use glam::Vec3;

use crate::probe::{Case, Dice, EXACT, Probe, ROUNDING, Table, Tolerance, World};

#[test]
fn diffuse() {
    table().check();
}

/// WGSL lets sines and cosines be off by 2⁻¹¹; the devices that there are do better by far, as a
/// light's shadow needs.
const ON_CIRCLE: Tolerance = Tolerance::relative(0.0).or(1e-5);

pub(super) fn table() -> Table {
    let probes = [surfaces(), directions()];
    Table {
        worlds: vec![
            World::full(),
            World::under_sky("no hemisphere", |sky| sky.hemisphere = NONE),
            World::under_sky("no environment", |sky| sky.environment = NONE),
            World::under_sky("no sky", |sky| (sky.hemisphere, sky.environment) = (NONE, NONE)),
            World::throwing(),
        ],
        probes: probes.into_iter().flatten().collect(),
    }
}

fn surfaces() -> Vec<Probe> {
    vec![
        Probe {
            name: "shade_diffuse",
            wgsl: "begin_walk();
    shade_diffuse(take_ray(), take_hit());
    put_walk();",
            rust: |world, take, put| {
                world.walk(take, put, |walk, take, _| {
                    shade_diffuse(walk, &take.ray(), &take.hit());
                });
            },
            cases: |world| {
                let mut dice = Dice::new(29);
                let case = |(ray, hit): &(Ray, Hit)| {
                    Case::new().u32(dice.word()).u32(dice.word() >> 22).ray(ray).hit(hit)
                };
                matte_points(world).iter().map(case).collect()
            },
            // Where rounding decides about a shadow or an edge of the light.
            tolerance: Tolerance::relative(1e-4).or(1e-5).but(0.005),
        },
        Probe {
            name: "reflectance_at",
            wgsl: "put_reflectance(reflectance_at(take_ray(), take_hit()));",
            rust: |world, take, put| {
                let (ray, hit) = (take.ray(), take.hit());
                put.reflectance(&world.begin_walk(0, 0, |walk| reflectance_at(walk, &ray, &hit)));
            },
            cases: |world| {
                let case = |(ray, hit): &(Ray, Hit)| Case::new().ray(ray).hit(hit);
                matte_points(world).iter().map(case).collect()
            },
            // On the line between two squares, and along the edge of an image.
            tolerance: Tolerance::relative(1e-4).or(1e-4).but(0.004),
        },
        Probe {
            name: "is_shadowed",
            wgsl: "begin_walk();
    let ray = take_ray();
    let hit = take_hit();
    put_bool(is_shadowed(ray, hit, take_vec3()));
    put_walk();",
            rust: |world, take, put| {
                world.walk(take, put, |walk, take, put| {
                    let (ray, hit) = (take.ray(), take.hit());
                    put.bool(is_shadowed(walk, &ray, &hit, take.vec3()));
                });
            },
            cases: |world| {
                let mut dice = Dice::new(31);
                let case = |(ray, hit): &(Ray, Hit)| {
                    Case::new().u32(0).u32(0).ray(ray).hit(hit).vec3(dice.direction())
                };
                matte_points(world).iter().map(case).collect()
            },
            // Where rounding decides.
            tolerance: EXACT.but(0.005),
        },
    ]
}

fn directions() -> Vec<Probe> {
    vec![
        Probe {
            name: "orthonormal_pair",
            wgsl: "let pair = orthonormal_pair(take_vec3());
    put_vec3(pair[0]);
    put_vec3(pair[1]);",
            rust: |_, take, put| {
                let (tangent, bitangent) = orthonormal_pair(take.vec3());
                put.vec3(tangent);
                put.vec3(bitangent);
            },
            cases: |_| normals().into_iter().map(|normal| Case::new().vec3(normal)).collect(),
            // The divisor is between 1 and 2.
            tolerance: ROUNDING,
        },
        Probe {
            name: "direction_on_disc",
            wgsl: "put_vec3(direction_on_disc(discs[take_u32()], take_vec2()));",
            rust: |world, take, put| {
                let disc = &world.scene.discs[take.u32() as usize];
                put.vec3(direction_on_disc(disc, take.vec2()));
            },
            cases: |world| {
                let discs = world.scene.discs.len();
                let case = |[u, v]: [f32; 2], i| Case::new().u32(i as u32).f32(u).f32(v);
                let samples = samples().into_iter();
                samples.flat_map(|sample| (0..discs).map(move |i| case(sample, i))).collect()
            },
            tolerance: ON_CIRCLE,
        },
        Probe {
            name: "direction_by_cosine",
            wgsl: "put_vec3(direction_by_cosine(take_vec3(), take_vec2()));",
            rust: |_, take, put| put.vec3(direction_by_cosine(take.vec3(), take.vec2())),
            cases: |_| {
                let case =
                    |(normal, [u, v]): (Vec3, [f32; 2])| Case::new().vec3(normal).f32(u).f32(v);
                normals().into_iter().zip(samples().into_iter().cycle()).map(case).collect()
            },
            tolerance: ON_CIRCLE,
        },
    ]
}

/// Rays that have been moved to where they met the ground or a matte body, and far-off ground.
pub(super) fn matte_points(world: &World) -> Vec<(Ray, Hit)> {
    let mut points = Vec::new();
    for ray in world.rays(3000) {
        let hit = find_intersection(&world.scene, &ray);
        if hit.instance != NONE && meets_opaque(&world.scene, &hit) {
            points.push((Ray { origin: ray.origin + ray.direction * hit.distance, ..ray }, hit));
        }
    }
    assert!(points.iter().any(|(_, hit)| hit.instance != GROUND));
    let mut dice = Dice::new(23);
    let ground = Hit { distance: 1.0, instance: GROUND, facet: 0, normal: Vec3::Z };
    points.extend((0..200).map(|_| {
        let origin = dice.point(300.0).with_z(world.scene.ground.height);
        (Ray { origin, ..dice.ray() }, ground)
    }));
    points
}

fn normals() -> Vec<Vec3> {
    let mut dice = Dice::new(37);
    let mut normals: Vec<_> = (0..400).map(|_| dice.direction()).collect();
    normals.extend(Vec3::AXES);
    normals.extend(Vec3::AXES.map(|axis| -axis));
    // On both sides of where the construction changes.
    normals.extend([1e-7, -1e-7, -0.0].map(|z| Vec3::new(0.6, 0.8, z)));
    normals
}

/// Of the unit square, its sides included.
fn samples() -> Vec<[f32; 2]> {
    let mut dice = Dice::new(41);
    let mut samples: Vec<_> =
        (0..200).map(|_| [dice.between(0.0, 1.0), dice.between(0.0, 1.0)]).collect();
    let end = 1.0 - 1.0 / 16_777_216.0;
    samples.extend([[0.0, 0.0], [0.0, end], [end, 0.0], [end, end], [0.5, 0.5]]);
    samples
}
