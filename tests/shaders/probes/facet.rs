//! Fans and facets: the processor's vectors against one plane after the other.

use brilliance_renderer::kernel::convex::leave_convex;
use brilliance_renderer::kernel::facet::{clip_to_facet, facing_part};
use brilliance_renderer::kernel::nodes::{nodes_of, scale_each};
use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::packed::{CONVEX, NONE};
use glam::Vec3A;

use crate::probe::{Case, Dice, Probe, Table, Tolerance, World, throw};

#[test]
fn facet() {
    table().check();
}

pub(super) fn table() -> Table {
    Table {
        worlds: vec![World::full(), World::single()],
        probes: vec![
            Probe {
                name: "clip_to_facet",
                wgsl: "let instance = instances[take_u32()];
    put_vec2(clip_to_facet(instance, take_nodes(), take_vec3()));",
                rust: |world, take, put| {
                    let instance = &world.scene.instances[take.u32() as usize];
                    put.vec2(clip_to_facet(&world.scene, instance, &take.nodes(), take.each()));
                },
                cases: points_about_facets,
                // The processor fuses multiplications and additions, and the edge that a fan runs
                // along is a root of a small difference. Within rounding of the tolerance of a facet
                // one side sees an end outside and the other doesn't.
                tolerance: Tolerance::relative(1e-3).or(1e-3).but(0.01),
            },
            Probe {
                name: "facing_part",
                wgsl: "put_vec2(facing_part(take_vec3()));",
                rust: |_, take, put| put.vec2(facing_part(take.each())),
                cases: |_| {
                    throw(600, |dice| {
                        let scale = dice.each(-1.0, 1.0);
                        let middle = dice.pick(&[scale.y.abs(), 1e-4, 1.0]);
                        Case::new().each(Vec3A::new(scale.x, middle, scale.z))
                    })
                },
                tolerance: Tolerance::relative(1e-5).or(1e-5).but(0.005),
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

/// Three points on the plane of a facet, of which the middle one is within it: some all within, some
/// beyond an edge, some behind what sees them.
fn points_about_facets(world: &World) -> Vec<Case> {
    throw(1500, |dice| {
        let number = any_convex(world, dice);
        let instance = &world.scene.instances[number];
        let out = Ray::white(instance.center, dice.direction());
        let wall = leave_convex(&world.scene, instance, &out, NONE);
        let middle = out.origin + out.direction * wall.distance;
        let along = wall.normal.cross(dice.direction());
        let across = wall.normal.cross(dice.direction()) * 0.1;
        let reach = dice.magnitude(1e-3, 3.0);
        let other = dice.between(-0.5, 1.5);
        let (low, high) =
            (middle - (along + across) * reach, middle + (along - across) * reach * other);
        let scale = dice.each(0.05, 1.0);
        let behind = Vec3A::new(-scale.x, scale.y, scale.z);
        let scale = dice.pick(&[scale, scale, scale, behind]);
        let points = scale_each(&nodes_of(low, middle, high), scale);
        Case::new().u32(number as u32).nodes(&points).each(scale)
    })
}
