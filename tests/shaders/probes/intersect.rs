//! The nearest surface among all bodies and the ground.

use brilliance_renderer::kernel::intersect::{
    find_intersection, is_occluded, meet_bodies, meet_ground, meet_instance, nudge_inwards, sides,
};
use brilliance_renderer::kernel::ray::{FAR, GROUND, Ray};
use brilliance_renderer::packed::{MESH, NONE};
use glam::Vec3;

use crate::probe::{Case, Dice, EXACT, Probe, ROUNDING, Table, Tolerance, World, throw};

#[test]
fn intersect() {
    table().check();
}

/// Distances divide by the cosine to the surface, which makes a long way of a small error where
/// rays graze. Within rounding of an edge the two sides may choose different facets.
const HIT: Tolerance = Tolerance::relative(1e-4).or(1e-5).but(0.004);

pub(super) fn table() -> Table {
    let probes = [whole_scene(), parts()];
    Table {
        worlds: vec![World::full(), World::single(), World::sliver(), World::empty()],
        probes: probes.into_iter().flatten().collect(),
    }
}

fn whole_scene() -> Vec<Probe> {
    vec![
        Probe {
            name: "find_intersection",
            wgsl: "put_hit(find_intersection(take_ray()));",
            rust: |world, take, put| put.hit(&find_intersection(&world.scene, &take.ray())),
            cases: |world| all_rays(world).into_iter().map(|ray| Case::new().ray(&ray)).collect(),
            tolerance: HIT,
        },
        Probe {
            name: "is_occluded",
            wgsl: "put_bool(is_occluded(take_ray()));",
            rust: |world, take, put| put.bool(is_occluded(&world.scene, &take.ray())),
            cases: |world| all_rays(world).into_iter().map(|ray| Case::new().ray(&ray)).collect(),
            tolerance: HIT,
        },
        Probe {
            name: "meet_bodies",
            wgsl: "put_hit(meet_bodies(take_ray(), take_f32(), false));",
            rust: |world, take, put| {
                put.hit(&meet_bodies(&world.scene, &take.ray(), take.f32(), false));
            },
            cases: limited_rays,
            tolerance: HIT,
        },
        Probe {
            name: "meet_ground",
            wgsl: "put_hit(meet_ground(take_ray()));",
            rust: |world, take, put| put.hit(&meet_ground(&world.scene, &take.ray())),
            cases: rays_at_ground,
            tolerance: HIT.but(0.0),
        },
    ]
}

fn parts() -> Vec<Probe> {
    vec![
        Probe {
            name: "nudge_inwards",
            wgsl: "put_ray(nudge_inwards(take_ray()));",
            rust: |world, take, put| put.ray(&nudge_inwards(&world.scene, &take.ray())),
            cases: rays_in_bodies,
            tolerance: ROUNDING,
        },
        Probe {
            name: "meet_instance",
            wgsl: "put_hit(meet_instance(take_ray(), take_u32(), take_f32()));",
            rust: |world, take, put| {
                put.hit(&meet_instance(&world.scene, &take.ray(), take.u32(), take.f32()));
            },
            cases: rays_at_one_body,
            tolerance: HIT,
        },
        Probe {
            name: "sides",
            wgsl: "put_u32(sides(instances[take_u32()], take_u32() == 1u));",
            rust: |world, take, put| {
                let instance = &world.scene.instances[take.u32() as usize];
                put.u32(sides(&world.scene, instance, take.u32() == 1) as u32);
            },
            cases: |world| {
                let numbers = 0..world.scene.instances.len() as u32;
                numbers.flat_map(|i| [0, 1].map(|inside| Case::new().u32(i).u32(inside))).collect()
            },
            tolerance: EXACT,
        },
    ]
}

/// A ray in air that points about where the bodies are.
fn ray_from_afar(dice: &mut Dice) -> Ray {
    let target = dice.point(8.0) * Vec3::new(1.0, 1.0, 0.3);
    let direction = dice.direction();
    Ray::white(target - direction * dice.between(0.0, 30.0), direction)
}

/// Rays as they come about, and others from everywhere.
fn all_rays(world: &World) -> Vec<Ray> {
    let mut dice = Dice::new(13);
    let mut rays = world.rays(1200);
    rays.extend((0..800).map(|_| ray_from_afar(&mut dice)));
    rays
}

fn limited_rays(world: &World) -> Vec<Case> {
    let mut dice = Dice::new(17);
    let limit = |ray: Ray| {
        let near = dice.between(0.0, 20.0);
        Case::new().ray(&ray).f32(dice.pick(&[FAR, near]))
    };
    all_rays(world).into_iter().map(limit).collect()
}

/// Rays inside of bodies.
fn rays_in_bodies(world: &World) -> Vec<Case> {
    let is_inside = |ray: &Ray| ray.medium != NONE;
    let rays = world.rays(1200).into_iter().filter(is_inside);
    rays.map(|ray| Case::new().ray(&ray)).collect()
}

/// From inside, outside, within a body inside, having left it or not.
fn rays_at_one_body(world: &World) -> Vec<Case> {
    let count = world.scene.instances.len();
    if count == 0 {
        return Vec::new();
    }
    let mut dice = Dice::new(19);
    let case = |ray: Ray| {
        let number = dice.below(count) as u32;
        let is_mesh = world.scene.instances[number as usize].kind == MESH;
        let (facet, near) = (dice.below(6) as u32, dice.between(0.0, 20.0));
        let ray = match dice.below(5) {
            0 => Ray { enclosing: number, ..ray },
            1 if is_mesh => Ray { instance: number, facet, ..ray },
            _ => ray,
        };
        let own = if ray.medium == NONE { number } else { ray.medium };
        Case::new().ray(&ray).u32(dice.pick(&[number, own])).f32(dice.pick(&[FAR, near]))
    };
    all_rays(world).into_iter().map(case).collect()
}

/// From above, below, upon and just beside the ground, along it, and having left it.
fn rays_at_ground(world: &World) -> Vec<Case> {
    let ground = world.scene.ground.height;
    throw(600, |dice| {
        let height = dice.between(-9.0, 9.0);
        let height = dice.pick(&[height, 0.0, 5e-5, -5e-5, 2e-4, -2e-4]);
        let origin = dice.point(9.0).with_z(ground + height);
        let direction = dice.direction();
        let along = direction.with_z(0.0).normalize_or_zero();
        let along_below = along.with_z(-0.0);
        let instance = dice.pick(&[NONE, NONE, NONE, GROUND, 0]);
        let direction = dice.pick(&[direction, direction, along, along_below, Vec3::NEG_Z]);
        Case::new().ray(&Ray { instance, ..Ray::white(origin, direction) })
    })
}
