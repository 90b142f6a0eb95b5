//! What becomes of a ray at an interface.

use brilliance_renderer::kernel::fork::{
    absorber_of, enter_absorber, fork_rays, index_table_of, interface_at, medium_beyond,
    meets_second_absorber, reflected_ray, refract_and_reflect, refracted_at, split_and_refract,
};
use brilliance_renderer::kernel::interface::{Interface, is_totally_reflected, relative_index};
use brilliance_renderer::kernel::intersect::find_intersection;
use brilliance_renderer::kernel::ray::{Hit, Ray};
use brilliance_renderer::kernel::spread::fan_at;
use brilliance_renderer::kernel::trace::meets_opaque;
use brilliance_renderer::packed::NONE;
use glam::Vec3;

use crate::probe::{Case, Dice, EXACT, Probe, ROUNDING, Table, Tolerance, World};

#[test]
fn fork() {
    table().check();
}

/// Near the critical angle refracted directions and reflectances are roots of a small difference:
/// an error of 1e-6 in the square of a cosine is one of 1e-3 in itself.
const CRITICAL: Tolerance = Tolerance::relative(1e-4).or(1e-3);

/// Away from it all is a chain of roundings; the wavelength that divides a ray is found to
/// hundredths of a nanometre, which is 1e-4 of it. A few rays come close to the critical angle or
/// to where the number of sub-rays changes.
const FORK: Tolerance = Tolerance::relative(1e-4).or(1e-5).but(0.01);

pub(super) fn table() -> Table {
    let probes = [media(), single_rays(), whole_forks()];
    Table {
        worlds: vec![World::full(), World::curt()],
        probes: probes.into_iter().flatten().collect(),
    }
}

fn media() -> Vec<Probe> {
    vec![
        Probe {
            name: "medium_beyond",
            wgsl: "put_u32(medium_beyond(take_ray(), take_hit()));",
            rust: |_, take, put| put.u32(medium_beyond(&take.ray(), &take.hit())),
            cases: arrivals,
            tolerance: EXACT,
        },
        Probe {
            name: "interface_at",
            wgsl: "put_interface(interface_at(take_ray(), take_hit()));",
            rust: |world, take, put| {
                put.interface(&interface_at(&world.scene, &take.ray(), &take.hit()));
            },
            cases: arrivals,
            tolerance: EXACT,
        },
        Probe {
            name: "index_table_of",
            wgsl: "put_u32(index_table_of(take_u32()));",
            rust: |world, take, put| put.u32(index_table_of(&world.scene, take.u32())),
            cases: bodies,
            tolerance: EXACT,
        },
        Probe {
            name: "absorber_of",
            wgsl: "put_u32(absorber_of(take_u32()));",
            rust: |world, take, put| put.u32(absorber_of(&world.scene, take.u32())),
            cases: bodies,
            tolerance: EXACT,
        },
        Probe {
            name: "meets_second_absorber",
            wgsl: "put_bool(meets_second_absorber(take_ray(), take_hit()));",
            rust: |world, take, put| {
                put.bool(meets_second_absorber(&world.scene, &take.ray(), &take.hit()));
            },
            cases: arrivals,
            tolerance: EXACT,
        },
        Probe {
            name: "enter_absorber",
            wgsl: "begin_walk();
    put_ray(enter_absorber(take_ray()));
    put_walk();",
            rust: |world, take, put| {
                world.walk(take, put, |walk, take, put| {
                    put.ray(&enter_absorber(walk, take.ray()));
                });
            },
            cases: |world| {
                let arrivals = arriving_rays(world).into_iter();
                arrivals.map(|(ray, _)| walk_case().ray(&ray)).collect()
            },
            // The weights of very narrow intervals within a bin are small differences.
            tolerance: Tolerance::relative(1e-5).or(1e-5).but(0.01),
        },
    ]
}

fn single_rays() -> Vec<Probe> {
    vec![
        Probe {
            name: "reflected_ray",
            wgsl: "put_ray(reflected_ray(take_ray(), take_hit(), take_interface()));",
            rust: |_, take, put| {
                put.ray(&reflected_ray(&take.ray(), &take.hit(), &take.interface()));
            },
            cases: |world| arrivals_at_interfaces(world, &Case::new()),
            tolerance: ROUNDING,
        },
        Probe {
            name: "refracted_at",
            wgsl: "let ray = take_ray();
    let hit = take_hit();
    put_vec3(refracted_at(ray, take_interface(), 0.5 * (ray.lambda_low_nm + ray.lambda_high_nm)));",
            rust: |world, take, put| {
                let (ray, _) = (take.ray(), take.hit());
                let lambda_nm = 0.5 * (ray.lambda_low_nm + ray.lambda_high_nm);
                put.vec3(refracted_at(&world.scene, &ray, &take.interface(), lambda_nm));
            },
            cases: |world| arrivals_at_interfaces(world, &Case::new()),
            tolerance: CRITICAL,
        },
        Probe {
            name: "refract_and_reflect",
            wgsl: "begin_walk();
    refract_and_reflect(take_ray(), take_hit(), take_interface(), vec3f(0.01, 0.02, 0.03));
    put_walk();",
            rust: |world, take, put| {
                world.walk(take, put, |walk, take, _| {
                    let (ray, hit) = (take.ray(), take.hit());
                    let spread = Vec3::new(0.01, 0.02, 0.03);
                    refract_and_reflect(walk, &ray, &hit, &take.interface(), spread);
                });
            },
            cases: |world| arrivals_at_interfaces(world, &walk_case()),
            tolerance: FORK,
        },
    ]
}

fn whole_forks() -> Vec<Probe> {
    vec![
        Probe {
            name: "split_and_refract",
            wgsl: "begin_walk();
    let ray = take_ray();
    split_and_refract(ray, ray.spread, take_hit(), take_interface());
    put_walk();",
            rust: |world, take, put| {
                world.walk(take, put, |walk, take, _| {
                    let (ray, hit) = (take.ray(), take.hit());
                    split_and_refract(walk, &ray, ray.spread, &hit, &take.interface());
                });
            },
            cases: |world| refracted_arrivals(world),
            tolerance: FORK,
        },
        Probe {
            name: "fork_rays",
            wgsl: "begin_walk();
    fork_rays(take_ray(), take_hit());
    put_walk();",
            rust: |world, take, put| {
                world.walk(take, put, |walk, take, _| {
                    fork_rays(walk, &take.ray(), &take.hit());
                });
            },
            cases: |world| {
                let arrivals = arriving_rays(world).into_iter();
                arrivals.map(|(ray, hit)| walk_case().ray(&ray).hit(&hit)).collect()
            },
            tolerance: FORK,
        },
        Probe {
            name: "fork_rays at the critical angle",
            wgsl: "begin_walk();
    fork_rays(take_ray(), take_hit());
    put_walk();",
            rust: |world, take, put| {
                world.walk(take, put, |walk, take, _| {
                    fork_rays(walk, &take.ray(), &take.hit());
                });
            },
            cases: divided_arrivals,
            // The wavelength is found to hundredths of a nanometre.
            tolerance: Tolerance::relative(1e-3).or(2e-3).but(0.02),
        },
    ]
}

fn walk_case() -> Case {
    Case::new().u32(0).u32(0)
}

fn bodies(world: &World) -> Vec<Case> {
    let all = 0..world.scene.instances.len() as u32;
    all.chain([NONE]).map(|body| Case::new().u32(body)).collect()
}

/// Rays that have been moved to an interface, as they come about: into and out of stones, from one
/// into another, coloured ones among them; half with any interval and a path behind them in some
/// absorber.
fn arriving_rays(world: &World) -> Vec<(Ray, Hit)> {
    let mut dice = Dice::new(43);
    let mut arrivals = Vec::new();
    for mut ray in world.rays(1200) {
        let hit = find_intersection(&world.scene, &ray);
        if hit.instance == NONE || meets_opaque(&world.scene, &hit) {
            continue;
        }
        ray.origin += ray.direction * hit.distance;
        if dice.below(2) == 0 {
            ray.absorber = dice.pick(&world.absorbers());
            ray.path_mm = dice.magnitude(1e-3, 3.0);
            [ray.lambda_low_nm, ray.lambda_high_nm] = dice.interval_nm();
        }
        arrivals.push((ray, hit));
    }
    arrivals
}

fn arrivals(world: &World) -> Vec<Case> {
    let arrivals = arriving_rays(world).into_iter();
    arrivals.map(|(ray, hit)| Case::new().ray(&ray).hit(&hit)).collect()
}

fn arrivals_at_interfaces(world: &World, start: &Case) -> Vec<Case> {
    let case = |(ray, hit): (Ray, Hit)| {
        let at = interface_at(&world.scene, &ray, &hit);
        start.clone().ray(&ray).hit(&hit).interface(&at)
    };
    arriving_rays(world).into_iter().map(case).collect()
}

/// Of the arrivals those of which nothing is totally reflected.
fn refracted_arrivals(world: &World) -> Vec<Case> {
    let is_refracted = |ray: &Ray, at: &Interface| {
        [ray.lambda_low_nm, ray.lambda_high_nm]
            .iter()
            .all(|&nm| !is_totally_reflected(&world.scene, at, fan_at(ray, nm), nm))
    };
    let mut cases = Vec::new();
    for (ray, hit) in arriving_rays(world) {
        let at = interface_at(&world.scene, &ray, &hit);
        if is_refracted(&ray, &at) {
            cases.push(walk_case().ray(&ray).hit(&hit).interface(&at));
        }
    }
    cases
}

/// Rays inside that arrive exactly at the critical angle of a wavelength within their interval.
fn divided_arrivals(world: &World) -> Vec<Case> {
    let mut dice = Dice::new(47);
    let inside = |(ray, _): &(Ray, Hit)| ray.medium != NONE;
    let arrivals = arriving_rays(world).into_iter().filter(inside);
    let case = |(ray, hit): (Ray, Hit)| {
        let at = interface_at(&world.scene, &ray, &hit);
        let lambda_nm = dice.between(ray.lambda_low_nm, ray.lambda_high_nm);
        let eta = relative_index(&world.scene, &at, lambda_nm);
        let critical = (1.0 - 1.0 / (eta * eta)).max(0.0).sqrt().max(0.1);
        let direction = dice.direction_at(-at.normal, critical);
        let spread = direction.cross(dice.direction()) * dice.pick(&[0.0, 0.01]);
        walk_case().ray(&Ray { direction, spread, ..ray }).hit(&hit)
    };
    arrivals.map(case).collect()
}
