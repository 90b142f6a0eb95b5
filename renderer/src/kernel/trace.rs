//! The walk of one camera ray through the tree of its sub-rays (the paper's `ray_solid`).

use glam::Vec3;

use crate::kernel::deposit::{mean_transmittance, transmittance_bound};
use crate::kernel::diffuse::shade_diffuse;
use crate::kernel::fork::fork_rays;
use crate::kernel::intersect::{find_intersection, find_lost_exit};
use crate::kernel::lights::ray_light;
use crate::kernel::ray::{GROUND, Hit, Ray};
use crate::kernel::rng;
use crate::packed::{NONE, PackedScene};

/// Rays that can wait at once. What leaves a convex stone ends at once, so that only the splits of
/// the path being followed wait; what would not fit is counted as cut off.
pub const STACK_LEN: usize = 256;

/// What stays the same over one pass.
#[derive(Clone, Copy, Debug)]
pub struct Pass {
    /// Number of the pass, which moves the samples.
    pub index: u32,
    /// K of the paper.
    pub split_count: f32,
    /// Significance below which a ray is pruned.
    pub significance_threshold: f32,
    /// Interfaces after which a ray is cut off.
    pub max_depth: u32,
    /// Whether sub-rays take their own directions.
    pub perturb: bool,
    /// Unit vector from the scene towards the observer.
    pub observer: Vec3,
}

/// Counts of one camera ray; energies in units of the camera ray's.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tally {
    /// Rays traced, shadow rays included.
    pub segments: u32,
    /// Energy that reached a light, the sky, the dark or an opaque surface.
    pub returned: f32,
    /// Energy absorbed in coloured bodies.
    pub absorbed: f32,
    /// Energy below the significance threshold.
    pub pruned: f32,
    /// Energy beyond the maximum depth or the stack.
    pub cut_off: f32,
    /// Energy that slipped through a mesh.
    pub lost: f32,
}

/// The rays that wait to be traced.
pub struct RayStack {
    rays: [Ray; STACK_LEN],
    count: usize,
}

impl RayStack {
    /// An empty stack.
    #[expect(clippy::large_stack_arrays, reason = "20 kB, once per worker")]
    pub fn new() -> Self {
        Self { rays: [Ray::white(Vec3::ZERO, Vec3::Z); STACK_LEN], count: 0 }
    }
}

impl Default for RayStack {
    fn default() -> Self {
        Self::new()
    }
}

/// One camera ray's walk: what it reads, and what it writes to.
pub struct Walk<'a> {
    /// The scene.
    pub scene: &'a PackedScene,
    /// The pass.
    pub pass: &'a Pass,
    /// Radiance per bin of the pixel.
    pub pixel: &'a mut [f32],
    /// Counts.
    pub tally: Tally,
    stack: &'a mut RayStack,
    seed: u32,
}

impl Walk<'_> {
    /// A random word that is the same in every pass at the same place of the walk.
    #[inline]
    pub fn next_seed(&mut self) -> u32 {
        self.seed = self.seed.wrapping_add(1);
        rng::hash(self.seed)
    }

    /// Puts a ray on the stack, or into the books where it is too weak, too deep or too much.
    #[inline]
    pub fn send(&mut self, ray: &Ray) {
        let significance = ray.significance * transmittance_bound(self.scene, ray);
        if significance < self.pass.significance_threshold {
            self.tally.pruned += self.retire(ray);
        } else if ray.depth > self.pass.max_depth || self.stack.count == STACK_LEN {
            self.tally.cut_off += self.retire(ray);
        } else {
            self.stack.rays[self.stack.count] = *ray;
            self.stack.count += 1;
        }
    }

    /// The energy that a ray still carries at its end, after its path's absorption is booked.
    #[inline]
    fn retire(&mut self, ray: &Ray) -> f32 {
        let energy = ray.significance * ray.bandwidth();
        let kept = mean_transmittance(self.scene, ray);
        self.tally.absorbed += energy * (1.0 - kept);
        energy * kept
    }
}

/// Traces `camera_ray` and all that comes of it; adds radiance to `pixel`, one value per bin.
/// `seed` is the pixel's own random word.
#[inline]
pub fn trace(
    scene: &PackedScene,
    pass: &Pass,
    camera_ray: &Ray,
    seed: u32,
    stack: &mut RayStack,
    pixel: &mut [f32],
) -> Tally {
    stack.count = 0;
    let mut walk = Walk { scene, pass, pixel, tally: Tally::default(), stack, seed };
    walk.send(camera_ray);
    while walk.stack.count > 0 {
        walk.stack.count -= 1;
        let ray = walk.stack.rays[walk.stack.count];
        walk.tally.segments += 1;
        follow(&mut walk, ray);
    }
    walk.tally
}

/// Takes one ray to the next surface, or to the lights.
#[inline]
fn follow(walk: &mut Walk<'_>, mut ray: Ray) {
    let mut hit = find_intersection(walk.scene, &ray);
    if hit.instance == NONE && ray.medium != NONE {
        hit = find_lost_exit(walk.scene, &ray);
        if hit.instance == NONE {
            walk.tally.lost += walk.retire(&ray);
            return;
        }
    }
    if hit.instance == NONE {
        ray_light(walk, &ray);
        walk.tally.returned += walk.retire(&ray);
        return;
    }
    ray.origin += ray.direction * hit.distance;
    if runs_in_absorber(walk.scene, &ray) {
        ray.path_mm += hit.distance;
    }
    if is_opaque(walk.scene, &hit) {
        shade_diffuse(walk, &ray, &hit);
        walk.tally.returned += walk.retire(&ray);
    } else {
        fork_rays(walk, &ray, &hit);
    }
}

/// Whether the ray's medium is the material whose path it counts.
#[inline]
fn runs_in_absorber(scene: &PackedScene, ray: &Ray) -> bool {
    ray.absorber != NONE
        && ray.medium != NONE
        && scene.instances[ray.medium as usize].material == ray.absorber
}

#[inline]
fn is_opaque(scene: &PackedScene, hit: &Hit) -> bool {
    hit.instance == GROUND || scene.material_of(hit.instance).is_opaque()
}
