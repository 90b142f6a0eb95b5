//! Convex solids: the processor's vectors against one plane after the other.

use brilliance_renderer::kernel::convex::{enter_convex, leave_convex};
use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::packed::{CONVEX, NONE};
use glam::Vec3;

use crate::probe::{Case, Dice, Probe, Table, Tolerance, World, throw};

#[test]
fn convex() {
    table().check();
}

/// The processor fuses multiplications and additions. Distances divide by the cosine to the facet,
/// which makes a long way of a small error where rays graze.
const DISTANCE: Tolerance = Tolerance::relative(1e-4).or(1e-5);

pub(super) fn table() -> Table {
    Table {
        worlds: vec![World::full(), World::single()],
        probes: vec![
            Probe {
                name: "leave_convex",
                wgsl: "let instance = instances[take_u32()];
    put_hit(leave_convex(instance, take_ray(), take_u32()));",
                rust: |world, take, put| {
                    let instance = &world.scene.instances[take.u32() as usize];
                    put.hit(&leave_convex(&world.scene, instance, &take.ray(), take.u32()));
                },
                cases: rays_inside,
                // Within rounding of an edge the two may choose different facets.
                tolerance: DISTANCE.but(0.002),
            },
            Probe {
                name: "leave_convex through edges",
                wgsl: "let instance = instances[take_u32()];
    put_f32(leave_convex(instance, take_ray(), NONE).distance);",
                rust: |world, take, put| {
                    let instance = &world.scene.instances[take.u32() as usize];
                    put.f32(leave_convex(&world.scene, instance, &take.ray(), NONE).distance);
                },
                cases: |world| rays_through_edges(world, false),
                tolerance: DISTANCE,
            },
            Probe {
                name: "enter_convex",
                wgsl: "let instance = instances[take_u32()];
    put_hit(enter_convex(instance, take_ray()));",
                rust: |world, take, put| {
                    let instance = &world.scene.instances[take.u32() as usize];
                    put.hit(&enter_convex(&world.scene, instance, &take.ray()));
                },
                cases: rays_outside,
                // Within rounding of an edge the two may choose different facets.
                tolerance: DISTANCE.but(0.002),
            },
            Probe {
                name: "enter_convex through edges",
                wgsl: "let instance = instances[take_u32()];
    put_f32(enter_convex(instance, take_ray()).distance);",
                rust: |world, take, put| {
                    let instance = &world.scene.instances[take.u32() as usize];
                    put.f32(enter_convex(&world.scene, instance, &take.ray()).distance);
                },
                cases: |world| rays_through_edges(world, true),
                tolerance: DISTANCE,
            },
        ],
    }
}

fn any_convex(world: &World, dice: &mut Dice) -> usize {
    loop {
        let number = dice.below(world.scene.instances.len());
        if world.scene.instances[number].kind == CONVEX {
            return number;
        }
    }
}

fn any_direction(dice: &mut Dice) -> Vec3 {
    let (any, along) = (dice.direction(), dice.pick(&Vec3::AXES));
    let flat = (any * (Vec3::ONE - along)).normalize_or_zero();
    dice.pick(&[any, any, flat, along, -along])
}

/// From the middle, from anywhere inside and from the surface, which they may have left.
fn rays_inside(world: &World) -> Vec<Case> {
    throw(1500, |dice| {
        let number = any_convex(world, dice);
        let instance = &world.scene.instances[number];
        let start = Ray::white(instance.center, dice.direction());
        let wall = leave_convex(&world.scene, instance, &start, NONE);
        let part = dice.between(0.0, 1.0);
        let part = dice.pick(&[0.0, part, 1.0]);
        let origin = start.origin + start.direction * (wall.distance * part);
        let towards = any_direction(dice);
        let is_inward = part < 1.0 || towards.dot(wall.normal) < -0.05;
        let inward = if is_inward { towards } else { -wall.normal };
        let left_facet = if part == 1.0 { wall.facet } else { NONE };
        Case::new().u32(number as u32).ray(&Ray::white(origin, inward)).u32(left_facet)
    })
}

/// At the solid, past it, away from it, along its sides, and from upon its surface.
fn rays_outside(world: &World) -> Vec<Case> {
    throw(2000, |dice| {
        let number = any_convex(world, dice);
        let instance = &world.scene.instances[number];
        let direction = any_direction(dice);
        let distance = dice.between(5.0, 30.0);
        let away = instance.center + dice.point(4.0) - direction * distance;
        let out = Ray::white(instance.center, dice.direction());
        let wall = leave_convex(&world.scene, instance, &out, NONE);
        let upon = out.origin + out.direction * wall.distance;
        // Straight away from the surface or into it: not along it, where rounding decides.
        if dice.below(4) == 0 && wall.normal.dot(direction).abs() > 0.05 {
            Case::new().u32(number as u32).ray(&Ray::white(upon, direction))
        } else {
            Case::new().u32(number as u32).ray(&Ray::white(away, direction))
        }
    })
}

/// Through the points where the facets of the solid meet, found by walking from wall to wall.
fn rays_through_edges(world: &World, from_outside: bool) -> Vec<Case> {
    let mut dice = Dice::new(11);
    let mut cases = Vec::new();
    while cases.len() < 400 {
        let number = any_convex(world, &mut dice);
        let instance = &world.scene.instances[number];
        let out = Ray::white(instance.center, dice.direction());
        let wall = leave_convex(&world.scene, instance, &out, NONE);
        let upon = out.origin + out.direction * wall.distance;
        // Along the wall to its edge, and along the edge to its corner.
        let along = wall.normal.cross(dice.direction()).normalize_or_zero();
        let edge = leave_convex(&world.scene, instance, &Ray::white(upon, along), wall.facet);
        let at_edge = upon + along * edge.distance;
        let target = if dice.below(2) == 0 {
            at_edge
        } else {
            let along = wall.normal.cross(edge.normal).normalize_or_zero();
            let corner =
                leave_convex(&world.scene, instance, &Ray::white(at_edge, along), edge.facet);
            at_edge + along * corner.distance
        };
        let outward = (target - instance.center).normalize_or_zero();
        let (direction, origin) = if from_outside {
            (-outward, target + outward * dice.between(1.0, 20.0))
        } else {
            (outward, instance.center)
        };
        cases.push(Case::new().u32(number as u32).ray(&Ray::white(origin, direction)));
    }
    cases
}
