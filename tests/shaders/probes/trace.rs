//! The walk itself, for one ray and for some.

use brilliance_renderer::kernel::intersect::{find_intersection, meet_instance};
use brilliance_renderer::kernel::ray::{FAR, Hit, Ray};
use brilliance_renderer::kernel::trace::{
    follow, is_lost, meets_opaque, next_surface, runs_in_absorber,
};
use brilliance_renderer::packed::{MESH, NONE};

use crate::probe::{Case, Dice, EXACT, Probe, Table, Tolerance, World};

#[test]
fn trace() {
    table().check();
}

pub(super) fn table() -> Table {
    Table {
        worlds: vec![World::full(), World::curt(), World::sliver(), World::empty()],
        probes: vec![
            Probe {
                name: "follow",
                wgsl: "begin_walk();
    send(take_ray());
    if has_rays() {
        follow();
    }
    put_walk();",
                rust: |world, take, put| {
                    world.walk(take, put, |walk, take, _| {
                        walk.send(&take.ray());
                        if walk.has_rays() {
                            follow(walk);
                        }
                    });
                },
                cases: rays,
                // Critical angles, edges of lights, shadows and facets: where rounding decides.
                tolerance: Tolerance::relative(1e-4).or(1e-4).but(0.01),
            },
            Probe {
                name: "next_surface",
                wgsl: "var ray = take_ray();
    put_hit(next_surface(&ray));
    put_ray(ray);",
                rust: |world, take, put| {
                    let mut ray = take.ray();
                    put.hit(&next_surface(&world.scene, &mut ray));
                    put.ray(&ray);
                },
                cases: |world| {
                    let rays = world.rays(600).into_iter().chain(astray(world));
                    rays.map(|ray| Case::new().ray(&ray)).collect()
                },
                // Edges of facets, where rounding decides.
                tolerance: Tolerance::relative(1e-4).or(1e-4).but(0.01),
            },
            Probe {
                name: "is_lost",
                wgsl: "put_bool(is_lost(take_ray(), take_hit()));",
                rust: |_, take, put| put.bool(is_lost(&take.ray(), &take.hit())),
                cases: |world| {
                    let rays = world.rays(600).into_iter();
                    let hits = [Hit::MISS, Hit { instance: 0, ..Hit::MISS }];
                    let case = |ray: Ray| hits.map(|hit| Case::new().ray(&ray).hit(&hit));
                    rays.flat_map(case).collect()
                },
                tolerance: EXACT,
            },
            Probe {
                name: "runs_in_absorber",
                wgsl: "let ray = take_ray();
    put_bool(runs_in_absorber(ray.absorber, ray.medium));",
                rust: |world, take, put| {
                    let ray = take.ray();
                    put.bool(runs_in_absorber(&world.scene, ray.absorber, ray.medium));
                },
                cases: |world| {
                    world.rays(600).into_iter().map(|ray| Case::new().ray(&ray)).collect()
                },
                tolerance: EXACT,
            },
            Probe {
                name: "meets_opaque",
                wgsl: "put_bool(meets_opaque(take_hit()));",
                rust: |world, take, put| put.bool(meets_opaque(&world.scene, &take.hit())),
                cases: |world| {
                    let hit = |ray: &Ray| find_intersection(&world.scene, ray);
                    let rays = world.rays(600);
                    let hits = rays.iter().map(hit).filter(|hit| hit.instance != NONE);
                    hits.map(|hit| Case::new().hit(&hit)).collect()
                },
                tolerance: EXACT,
            },
        ],
    }
}

fn rays(world: &World) -> Vec<Case> {
    let case = |(i, ray): (usize, Ray)| Case::new().u32(i as u32).u32(i as u32 / 7).ray(&ray);
    let rays = world.rays(1000).into_iter().chain(astray(world));
    rays.enumerate().map(case).collect()
}

/// Rays that run in a mesh which they do not meet from inside: upon the facet that they have left,
/// which another try meets, and too far outside for that.
fn astray(world: &World) -> Vec<Ray> {
    let mut dice = Dice::new(53);
    let mut rays = Vec::new();
    for (number, instance) in (0..).zip(&world.scene.instances) {
        if instance.kind != MESH || world.scene.material_of(number).is_opaque() {
            continue;
        }
        for _ in 0..40 {
            let medium = Ray { medium: number, ..Ray::white(instance.center, dice.direction()) };
            let hit = meet_instance(&world.scene, &medium, number, FAR);
            let distance = hit.distance * dice.pick(&[1.0, 1.3]);
            let origin = medium.origin + medium.direction * distance;
            rays.push(Ray { origin, instance: number, facet: hit.facet, ..medium });
        }
    }
    rays
}
