//! The plane loop of convex stones alone, on one thread: nanoseconds per ray inside and outside of a
//! brilliant.
#![expect(clippy::print_stdout, reason = "a benchmark prints what it measured")]

use std::f32::consts::TAU;
use std::hint::black_box;
use std::path::Path;
use std::time::{Duration, Instant};

use brilliance_renderer::error::RendererError;
use brilliance_renderer::kernel::convex::{enter_convex, leave_convex};
use brilliance_renderer::kernel::interface::reflect;
use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::kernel::rng::{hash, unit_float};
use brilliance_renderer::packed::{Instance, NONE, PackedScene};
use brilliance_renderer::scene_file::{self, Document};
use brilliance_renderer::spectrum::Bins;
use glam::Vec3;

const SCENE: &str = "Diamond";
/// Rays of one kind; as many as stay in the cache next to the core.
const RAYS: usize = 256;
/// Facets that a path is mirrored by.
const BOUNCES: usize = 64;
/// Each measurement is short, is repeated and the shortest one counts: others disturb it only one way.
const REPEATS: u32 = 1000;
const TIME: Duration = Duration::from_millis(1);

fn main() -> Result<(), RendererError> {
    let scene = scene_file::scenes().iter().find(|scene| scene.name == SCENE);
    let scene = scene.ok_or_else(|| RendererError::Invalid(format!("{SCENE}: does not ship")))?;
    let document = Document::from_toml(scene.text, Path::new(""))?;
    let scene = PackedScene::new(&document.scene, Bins::new(16))?;
    let stone = &scene.instances[0];
    let (inside, outside) = (rays_inside(stone), rays_outside(stone));
    let facets = facet_count(&scene, stone);
    println!("one thread, a brilliant of {facets} facets in {} planes", stone.count);
    row("a path mirrored from facet to facet", || follow_paths(&scene, stone, &inside));
    row("rays inside, one by one", || {
        let exits = inside.iter().map(|ray| leave_convex(&scene, stone, black_box(ray), NONE));
        black_box(exits.map(|hit| hit.distance).sum::<f32>());
        RAYS
    });
    row("rays outside, half of them missing", || {
        let entries = outside.iter().map(|ray| enter_convex(&scene, stone, black_box(ray)));
        black_box(entries.filter(|hit| hit.facet != NONE).count());
        RAYS
    });
    Ok(())
}

/// Measures `work`, which tells how many rays it followed, and prints the time of one.
fn row(what: &str, mut work: impl FnMut() -> usize) {
    let mut shortest = f64::MAX;
    for _ in 0..REPEATS {
        let (start, mut rays) = (Instant::now(), 0);
        while start.elapsed() < TIME {
            rays += work();
        }
        shortest = shortest.min(start.elapsed().as_secs_f64() / rays as f64);
    }
    println!("{what:<40} {:>7.1} ns per ray", shortest * 1e9);
}

/// Follows the rays through total reflections, each after the last: what a tracer waits for.
fn follow_paths(scene: &PackedScene, stone: &Instance, rays: &[Ray]) -> usize {
    for start in rays.iter().take(RAYS / BOUNCES) {
        let (mut ray, mut left_facet) = (*start, NONE);
        for _ in 0..BOUNCES {
            let hit = leave_convex(scene, stone, &ray, left_facet);
            ray.origin += ray.direction * hit.distance;
            ray.direction = reflect(ray.direction, hit.normal);
            left_facet = hit.facet;
        }
        black_box(ray);
    }
    RAYS
}

fn facet_count(scene: &PackedScene, stone: &Instance) -> usize {
    let [first, count] = [stone.first, stone.count].map(|number| number as usize);
    let distances = &scene.planes[first + 3 * count..first + 4 * count];
    distances.iter().filter(|&&distance| distance != 0.0).count()
}

/// From anywhere about the middle of the stone in all directions.
fn rays_inside(stone: &Instance) -> Vec<Ray> {
    let mut dice = Dice(1);
    (0..RAYS).map(|_| Ray::white(stone.center + dice.direction(), dice.direction())).collect()
}

/// From all around towards the stone and its neighbourhood.
fn rays_outside(stone: &Instance) -> Vec<Ray> {
    let mut dice = Dice(2);
    let rays = (0..RAYS).map(|_| {
        let origin = stone.center + dice.direction() * 30.0;
        let target = stone.center + dice.direction() * (dice.unit() * 6.0);
        Ray::white(origin, (target - origin).normalize_or_zero())
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
