//! What a ray costs in a mesh over the number of its triangles, on one thread: a bumpy ball of a
//! thousand to a million.
#![expect(clippy::print_stdout, reason = "a benchmark prints what it measured")]

use std::collections::HashMap;
use std::f32::consts::TAU;
use std::hint::black_box;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use brilliance_renderer::error::RendererError;
use brilliance_renderer::kernel::interface::reflect;
use brilliance_renderer::kernel::mesh::{Sides, meet_mesh};
use brilliance_renderer::kernel::ray::{FAR, Ray};
use brilliance_renderer::kernel::rng::{hash, unit_float};
use brilliance_renderer::material::{self, Dielectric, Material};
use brilliance_renderer::mesh::Mesh;
use brilliance_renderer::packed::{NONE, PackedScene};
use brilliance_renderer::scene::{MeshSource, Object, Scene, Shape, Transform};
use brilliance_renderer::spectrum::Bins;
use glam::{Vec3, Vec3Swizzles};

/// Subdivisions of an icosahedron: each has four times the triangles of the one before.
const SUBDIVISIONS: std::ops::RangeInclusive<u32> = 3..=8;
const RADIUS_MM: f32 = 3.0;
/// Height of the bumps over the radius.
const BUMP: f32 = 0.08;
/// Rays of one kind; other ones each time, so that nodes are not in the cache by habit.
const RAYS: usize = 1_600;
/// Facets that a path is mirrored by.
const BOUNCES: usize = 8;
/// Each measurement is repeated and the shortest one counts: others disturb it only one way.
const REPEATS: u32 = 100;

fn main() -> Result<(), RendererError> {
    println!(
        "{:>10} {:>7} {:>9} {:>11} {:>10} {:>22} {:>10}",
        "triangles",
        "levels",
        "build ms",
        "outside ns",
        "inside ns",
        "outside ns per log₂ n",
        "inside"
    );
    for subdivisions in SUBDIVISIONS {
        let row = measure(bumpy_ball(subdivisions)?)?;
        let doublings = (row.triangles as f64).log2();
        println!(
            "{:>10} {:>7} {:>9.1} {:>11.0} {:>10.0} {:>22.1} {:>10.1}",
            row.triangles,
            row.depth,
            row.build_ms,
            row.outside_ns,
            row.inside_ns,
            row.outside_ns / doublings,
            row.inside_ns / doublings
        );
    }
    Ok(())
}

/// What was measured on one mesh.
struct Row {
    triangles: usize,
    depth: usize,
    build_ms: f64,
    /// Per camera ray that meets the mesh from outside.
    outside_ns: f64,
    /// Per ray that is mirrored from facet to facet inside.
    inside_ns: f64,
}

fn measure(mesh: Mesh) -> Result<Row, RendererError> {
    let start = Instant::now();
    let depth = mesh.hierarchy().depth;
    let build_ms = 1e3 * start.elapsed().as_secs_f64();
    let triangles = mesh.triangles.len();
    let scene = packed(mesh)?;
    let (mut outside_ns, mut inside_ns) = (f64::MAX, f64::MAX);
    for repeat in 0..REPEATS {
        let rays = rays_outside(repeat);
        outside_ns = outside_ns.min(nanoseconds_per_ray(|| follow_outside(&scene, &rays)));
        let rays = rays_inside(repeat);
        inside_ns = inside_ns.min(nanoseconds_per_ray(|| follow_inside(&scene, &rays)));
    }
    Ok(Row { triangles, depth, build_ms, outside_ns, inside_ns })
}

/// The time of one ray of `work`, which tells how many it followed.
fn nanoseconds_per_ray(work: impl FnOnce() -> usize) -> f64 {
    let start = Instant::now();
    let rays = work();
    start.elapsed().as_secs_f64() * 1e9 / rays as f64
}

fn follow_outside(scene: &PackedScene, rays: &[Ray]) -> usize {
    let hits = rays.iter().filter(|ray| {
        let hit = meet_mesh(scene, &scene.instances[0], ray, NONE, Sides::Front, FAR);
        hit.facet != NONE
    });
    black_box(hits.count());
    rays.len()
}

fn follow_inside(scene: &PackedScene, rays: &[Ray]) -> usize {
    let mut count = 0;
    for start in rays {
        let (mut ray, mut left_facet) = (*start, NONE);
        for _ in 0..BOUNCES {
            let hit = meet_mesh(scene, &scene.instances[0], &ray, left_facet, Sides::Back, FAR);
            count += 1;
            if hit.facet == NONE {
                break;
            }
            ray.origin += ray.direction * hit.distance;
            ray.direction = reflect(ray.direction, hit.normal);
            left_facet = hit.facet;
        }
        black_box(ray);
    }
    count
}

/// An icosahedron whose triangles are divided into four again and again, and then bent outwards to
/// a ball with bumps.
fn bumpy_ball(subdivisions: u32) -> Result<Mesh, RendererError> {
    let golden = f32::midpoint(1.0, 5.0_f32.sqrt());
    let mut positions: Vec<Vec3> = Vec::new();
    for (small, large) in [(1.0, golden), (-1.0, golden), (1.0, -golden), (-1.0, -golden)] {
        let corner = Vec3::new(0.0, small, large).normalize_or_zero();
        positions.extend([corner, corner.zxy(), corner.yzx()]);
    }
    let mut triangles = hull(&positions);
    for _ in 0..subdivisions {
        let mut middles = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                let between = positions[a as usize] + positions[b as usize];
                positions.push(between.normalize_or_zero());
                positions.len() as u32 - 1
            })
        };
        triangles = triangles
            .iter()
            .flat_map(|&[a, b, c]| {
                let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    let bump = |p: Vec3| (9.0 * p.x).sin() * (8.0 * p.y).sin() * (7.0 * p.z).sin();
    let bent = positions.iter().map(|&p| p * (RADIUS_MM * (1.0 + BUMP * bump(p))));
    Mesh::new(bent.collect(), triangles)
}

/// The triangles of three neighbours each among the corners of an icosahedron.
fn hull(corners: &[Vec3]) -> Vec<[u32; 3]> {
    let corner = |i: u32| corners[i as usize];
    let is_edge = |a: u32, b: u32| corner(a).dot(corner(b)) > 0.4;
    let mut triangles = Vec::new();
    for c in 0..corners.len() as u32 {
        for b in 0..c {
            for a in (0..b).filter(|&a| is_edge(a, b) && is_edge(b, c) && is_edge(c, a)) {
                let faces_outwards = corner(a).dot(corner(b).cross(corner(c))) > 0.0;
                triangles.push(if faces_outwards { [a, b, c] } else { [a, c, b] });
            }
        }
    }
    triangles
}

fn packed(mesh: Mesh) -> Result<PackedScene, RendererError> {
    let glass = material::find("N-BK7")
        .ok_or_else(|| RendererError::Invalid("N-BK7: does not ship".into()))?;
    let source = MeshSource { path: PathBuf::new(), index: 0, mesh: Arc::new(mesh) };
    let object = Object {
        name: "Ball".into(),
        shape: Shape::Mesh(source),
        transform: Transform::default(),
        material: Material::Dielectric(Dielectric {
            name: glass.name.clone(),
            dispersion: glass.dispersion.clone(),
            absorption_per_mm: None,
        }),
        throws_light: false,
    };
    let scene = Scene { objects: vec![object], ..Scene::default() };
    PackedScene::new(&scene, Bins::new(16))
}

/// From one eye towards all of the ball.
fn rays_outside(seed: u32) -> Vec<Ray> {
    let mut dice = Dice(hash(seed));
    let eye = Vec3::new(4.0, -20.0, 24.0);
    let rays = (0..RAYS).map(|_| {
        let target = dice.direction() * (0.9 * RADIUS_MM * dice.unit());
        Ray::white(eye, (target - eye).normalize_or_zero())
    });
    rays.collect()
}

/// From about the middle of the ball in all directions.
fn rays_inside(seed: u32) -> Vec<Ray> {
    let mut dice = Dice(hash(seed ^ 0x5eed));
    let rays = (0..RAYS / BOUNCES).map(|_| {
        let origin = dice.direction() * (0.5 * RADIUS_MM * dice.unit());
        Ray::white(origin, dice.direction())
    });
    rays.collect()
}

struct Dice(u32);

impl Dice {
    fn unit(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9);
        unit_float(hash(self.0))
    }

    fn direction(&mut self) -> Vec3 {
        let (height, azimuth) = (2.0 * self.unit() - 1.0, TAU * self.unit());
        let radius = (1.0 - height * height).sqrt();
        Vec3::new(radius * azimuth.cos(), radius * azimuth.sin(), height)
    }
}
