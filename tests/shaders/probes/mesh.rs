//! Boxes, triangles and meshes.

use brilliance_renderer::kernel::mesh::{
    BoxRay, Shear, Sides, difference_of_products, faces, meet_mesh, triangle_distance,
};
use brilliance_renderer::kernel::ray::{FAR, Ray};
use brilliance_renderer::packed::{Instance, MESH, NONE, PackedTriangle};
use glam::{Mat3, Vec3, Vec4Swizzles};

use crate::probe::{Case, Dice, EXACT, Probe, ROUNDING, Table, Tolerance, World, throw};

#[test]
fn mesh() {
    table().check();
}

/// Distances of up to some tens of millimetres, in an object's own frame.
const DISTANCE: Tolerance = Tolerance::relative(1e-5).or(1e-5);

pub(super) fn table() -> Table {
    let probes = [boxes(), triangles(), meshes()];
    Table {
        worlds: vec![World::full(), World::sliver()],
        probes: probes.into_iter().flatten().collect(),
    }
}

fn boxes() -> Vec<Probe> {
    vec![Probe {
        name: "box_entry",
        wgsl: "let box_ray = new_box_ray(take_vec3(), take_vec3());
    put_f32(box_entry(box_ray, nodes[take_u32()], take_f32()));",
        rust: |world, take, put| {
            let box_ray = BoxRay::new(take.vec3(), take.vec3());
            let node = &world.scene.nodes[take.u32() as usize];
            put.f32(box_ray.box_entry(node, take.f32()));
        },
        cases: boxed_rays,
        // Where a ray along a side is in or out by rounding.
        tolerance: DISTANCE.but(0.01),
    }]
}

fn triangles() -> Vec<Probe> {
    vec![
        Probe {
            name: "shear_point",
            wgsl: "put_vec3(shear_point(new_shear(take_vec3()), take_vec3()));",
            rust: |_, take, put| {
                put.vec3(Shear::new(take.vec3()).shear_point(take.vec3()));
            },
            cases: |_| {
                throw(500, |dice| Case::new().vec3(any_direction(dice)).vec3(dice.point(20.0)))
            },
            tolerance: ROUNDING.or(1e-5),
        },
        Probe {
            name: "triangle_distance",
            wgsl: "let origin = take_vec3();
    put_f32(triangle_distance(origin, new_shear(take_vec3()), triangles[take_u32()]));",
            rust: |world, take, put| {
                let (origin, shear) = (take.vec3(), Shear::new(take.vec3()));
                let triangle = &world.scene.triangles[take.u32() as usize];
                put.f32(triangle_distance(origin, &shear, triangle));
            },
            cases: rays_at_triangles,
            tolerance: DISTANCE,
        },
        Probe {
            name: "difference_of_products",
            wgsl: "let p = take_vec3();
    let q = take_vec3();
    put_f32(difference_of_products(p.x, q.y, p.y, q.x));
    put_f32(sign(difference_of_products(p.x, q.y, p.y, q.x))
        + sign(difference_of_products(q.x, p.y, q.y, p.x)));",
            rust: |_, take, put| {
                let (p, q) = (take.vec3(), take.vec3());
                put.f32(difference_of_products(p.x, q.y, p.y, q.x));
                // The two sides of an edge.
                put.f32(0.0);
            },
            cases: |_| {
                throw(500, |dice| {
                    let p = dice.point(20.0);
                    Case::new().vec3(p).vec3(p * dice.magnitude(0.1, 10.0))
                })
            },
            // Of products of up to 4000, of which nearly nothing is left.
            tolerance: Tolerance::relative(0.0).or(1e-3),
        },
        Probe {
            name: "triangle_distance on the edge",
            wgsl: "let origin = take_vec3();
    let shear = new_shear(take_vec3());
    let first = take_u32();
    let one = triangle_distance(origin, shear, triangles[first]);
    put_f32(min(one, triangle_distance(origin, shear, triangles[take_u32()])));",
            rust: |world, take, put| {
                let (origin, shear) = (take.vec3(), Shear::new(take.vec3()));
                let mut distance = || {
                    let triangle = &world.scene.triangles[take.u32() as usize];
                    triangle_distance(origin, &shear, triangle)
                };
                put.f32(distance().min(distance()));
            },
            cases: rays_at_edges,
            // One of the two is met, whichever: there is no gap.
            tolerance: DISTANCE,
        },
        Probe {
            name: "faces",
            wgsl: "put_bool(faces(triangles[take_u32()], take_vec3(), take_u32()));",
            rust: |world, take, put| {
                let triangle = &world.scene.triangles[take.u32() as usize];
                put.bool(faces(triangle, take.vec3(), take.sides()));
            },
            cases: |world| {
                throw(300, |dice| {
                    let triangle = dice.below(world.scene.triangles.len()) as u32;
                    Case::new().u32(triangle).vec3(dice.direction()).u32(any_sides(dice))
                })
            },
            tolerance: EXACT,
        },
    ]
}

fn meshes() -> Vec<Probe> {
    vec![Probe {
        name: "meet_mesh",
        wgsl: "let instance = instances[take_u32()];
    put_hit(meet_mesh(instance, take_ray(), take_u32(), take_u32(), take_f32()));",
        rust: |world, take, put| {
            let instance = &world.scene.instances[take.u32() as usize];
            let (ray, left_facet) = (take.ray(), take.u32());
            put.hit(&meet_mesh(&world.scene, instance, &ray, left_facet, take.sides(), take.f32()));
        },
        cases: rays_at_meshes,
        // Distances divide by the cosine to the facet. Within rounding of an edge the two may
        // choose different facets.
        tolerance: Tolerance::relative(1e-4).or(1e-4).but(0.0005),
    }]
}

fn any_sides(dice: &mut Dice) -> u32 {
    dice.pick(&[Sides::Front, Sides::Back, Sides::Both]) as u32
}

/// Directions, some along an axis or in a plane of two, with zeros of both signs and denormals.
fn any_direction(dice: &mut Dice) -> Vec3 {
    let direction = dice.direction();
    let flat = match dice.below(6) {
        0 => dice.pick(&Vec3::AXES) * dice.pick(&[1.0, -1.0]),
        1 => direction * (Vec3::ONE - dice.pick(&Vec3::AXES)),
        2 => direction * (Vec3::ONE - dice.pick(&Vec3::AXES)) + dice.pick(&Vec3::AXES) * 1e-30,
        _ => direction,
    };
    flat.normalize_or_zero()
}

/// At boxes from outside and inside, past them, from upon their sides, with and without a limit.
fn boxed_rays(world: &World) -> Vec<Case> {
    throw(1000, |dice| {
        let number = dice.below(world.scene.nodes.len());
        let node = world.scene.nodes[number];
        let within = |dice: &mut Dice| {
            let place = dice.point(0.5) + Vec3::splat(0.5);
            node.min + (node.max - node.min) * place
        };
        let target = within(dice);
        let direction = any_direction(dice);
        let origin = match dice.below(4) {
            0 => target - direction * dice.between(0.0, 20.0),
            1 => dice.point(20.0),
            2 => Vec3::new(node.min.x, target.y, target.z),
            _ => target,
        };
        let limit = dice.between(0.0, 10.0);
        let limit = dice.pick(&[FAR, limit]);
        Case::new().vec3(origin).vec3(direction).u32(number as u32).f32(limit)
    })
}

/// Where the barycentric coordinates are `u`, `v` and what is left to 1.
fn point_of(triangle: &PackedTriangle, u: f32, v: f32) -> Vec3 {
    triangle.a * u + triangle.b * v + triangle.c * (1.0 - u - v)
}

/// Through triangles, past them, along them, and away from them; not through the edges.
fn rays_at_triangles(world: &World) -> Vec<Case> {
    throw(1000, |dice| {
        let number = dice.below(world.scene.triangles.len());
        let triangle = &world.scene.triangles[number];
        let (u, v) = (dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
        let is_near_edge = [u, v, 1.0 - u - v].iter().any(|w| w.abs() < 1e-3);
        let (u, v) = if is_near_edge { (0.2, 0.3) } else { (u, v) };
        let direction = any_direction(dice);
        let is_along = triangle.normal().dot(direction).abs() < 0.01;
        let direction = if is_along { triangle.normal() } else { direction };
        let origin = point_of(triangle, u, v) - direction * dice.between(-10.0, 30.0);
        Case::new().vec3(origin).vec3(direction).u32(number as u32)
    })
}

/// Through the common edge of two triangles, or a common corner.
fn rays_at_edges(world: &World) -> Vec<Case> {
    let triangles = &world.scene.triangles;
    let corners = |i: usize| [triangles[i].a, triangles[i].b, triangles[i].c];
    let mut dice = Dice::new(5);
    let mut cases = Vec::new();
    while cases.len() < 400 {
        let [first, second] = [0; 2].map(|_| dice.below(triangles.len()));
        let common: Vec<Vec3> =
            corners(first).into_iter().filter(|corner| corners(second).contains(corner)).collect();
        let has_area = |i: usize| {
            let [a, b, c] = corners(i);
            (b - a).cross(c - a).length() > 1e-6
        };
        if first == second || common.len() != 2 || !has_area(first) || !has_area(second) {
            continue;
        }
        let target = common[0].lerp(common[1], dice.between(0.05, 0.95));
        let middle = triangles[first].normal() + triangles[second].normal();
        let direction = (dice.direction() * 0.3 - middle).normalize_or_zero();
        let origin = target - direction * dice.between(1.0, 20.0);
        cases.push(Case::new().vec3(origin).vec3(direction).u32(first as u32).u32(second as u32));
    }
    cases
}

/// The world's point for one in the frame of a mesh, of which the matrix is a turn and a scale.
fn into_world(instance: &Instance, point: Vec3) -> Vec3 {
    let rows = instance.object_from_world;
    let offset = Vec3::new(rows[0].w, rows[1].w, rows[2].w);
    let turned = Mat3::from_cols(rows[0].xyz(), rows[1].xyz(), rows[2].xyz()) * (point - offset);
    turned / rows[0].xyz().length_squared()
}

/// At each triangle and past them, from outside and from inside, having left any facet or none,
/// with near and far limits.
fn rays_at_meshes(world: &World) -> Vec<Case> {
    let scene = &world.scene;
    let meshes: Vec<usize> =
        (0..scene.instances.len()).filter(|&i| scene.instances[i].kind == MESH).collect();
    throw(3000, |dice| {
        let number = dice.pick(&meshes);
        let instance = &scene.instances[number];
        let triangle = &scene.triangles[dice.below(scene.triangles.len())];
        let upon = into_world(instance, point_of(triangle, 0.3, 0.4));
        let beside = instance.center + dice.point(3.0);
        let (target, closest) = dice.pick(&[(upon, 0.5), (upon, 0.5), (beside, 0.0)]);
        let direction = any_direction(dice);
        let distance = dice.between(closest, 20.0);
        let ray = Ray::white(target - direction * dice.pick(&[closest, distance]), direction);
        let facet = dice.below(8) as u32;
        let left_facet = dice.pick(&[facet, NONE, NONE]);
        let limit = dice.between(0.0, 20.0);
        let limit = dice.pick(&[FAR, FAR, limit]);
        Case::new().u32(number as u32).ray(&ray).u32(left_facet).u32(any_sides(dice)).f32(limit)
    })
}
