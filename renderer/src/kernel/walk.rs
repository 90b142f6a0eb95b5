//! The state of one camera ray's walk: the rays that wait, and the books.

use bytemuck::{Pod, Zeroable};
use glam::Vec3;

use crate::kernel::absorption::{mean_transmittance, transmittance_bound};
use crate::kernel::ray::Ray;
use crate::kernel::rng;
use crate::packed::PackedScene;

/// Rays that can wait at once. What leaves a convex stone ends at once, so that only the splits of
/// the path being followed wait; what would not fit is counted as cut off.
pub const STACK_LEN: usize = 256;

/// By which rules rays are followed; the same for all of a film.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct TraceRules {
    /// Unit vector from the scene towards the observer.
    pub observer: Vec3,
    /// K of the paper.
    pub split_count: f32,
    /// Significance below which a ray is pruned; of fans the energy, in units of the camera ray's,
    /// below which they live by chance.
    pub significance_threshold: f32,
    /// Interfaces after which a ray is cut off.
    pub max_depth: u32,
    /// 1 where sub-rays take their own directions.
    pub perturb: u32,
    /// Energy of a fan below which it is not divided any more.
    pub cut_threshold: f32,
}

/// What becomes of a ray that is sent on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Fate {
    /// It waits to be followed.
    Kept,
    /// Its significance is below the threshold: it is pruned.
    TooWeak,
    /// It has met too many interfaces: it is cut off.
    TooDeep,
    /// Too many rays wait already: it is cut off.
    TooMany,
}

/// Counts of one camera ray; energies in units of the camera ray's.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tally {
    /// Rays traced, shadow rays included.
    pub segments: u32,
    /// Most interfaces that a traced ray had met.
    pub depth: u32,
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

/// The rays, or fans of rays, that wait to be followed.
pub struct RayStack<R = Ray> {
    rays: Vec<R>,
    count: usize,
}

impl RayStack {
    /// An empty stack.
    pub fn new() -> Self {
        Self::of(Ray::white(Vec3::ZERO, Vec3::Z), STACK_LEN)
    }
}

impl<R: Copy> RayStack<R> {
    /// An empty stack with room for `len` of the kind of `blank`.
    pub(crate) fn of(blank: R, len: usize) -> Self {
        Self { rays: vec![blank; len], count: 0 }
    }
}

impl Default for RayStack {
    fn default() -> Self {
        Self::new()
    }
}

/// One camera ray's walk: what it reads, and what it writes to.
pub struct Walk<'a, R = Ray> {
    /// The scene.
    pub scene: &'a PackedScene,
    /// The rules.
    pub rules: &'a TraceRules,
    /// Number of the pass, which moves the samples.
    pub pass_index: u32,
    /// Radiance found so far, per bin.
    pub radiance: &'a mut [f32],
    /// Counts.
    pub tally: Tally,
    stack: &'a mut RayStack<R>,
    /// The random word that was used last.
    pub seed: u32,
    /// Whether all that is sent on waits, whatever the rules say, for who wants to see it.
    pub keeps_all: bool,
}

impl<'a, R: Copy> Walk<'a, R> {
    /// A walk that has not begun; `seed` is the pixel's own random word.
    #[inline]
    pub fn new(
        scene: &'a PackedScene,
        rules: &'a TraceRules,
        pass_index: u32,
        seed: u32,
        stack: &'a mut RayStack<R>,
        radiance: &'a mut [f32],
    ) -> Self {
        stack.count = 0;
        let tally = Tally::default();
        Self { scene, rules, pass_index, radiance, tally, stack, seed, keeps_all: false }
    }

    /// A random word that is the same in every pass at the same place of the walk.
    #[inline]
    pub fn next_seed(&mut self) -> u32 {
        self.seed = self.seed.wrapping_add(1);
        rng::hash(self.seed)
    }

    /// Whether rays wait.
    #[inline]
    pub fn has_rays(&self) -> bool {
        self.stack.count > 0
    }

    /// Takes the ray that was put on the stack last.
    #[inline]
    pub fn pop(&mut self) -> R {
        self.stack.count -= 1;
        self.stack.rays[self.stack.count]
    }

    /// Number of rays that wait.
    #[inline]
    pub fn waiting(&self) -> u32 {
        self.stack.count as u32
    }

    /// Has a ray wait, for which there must be room.
    #[inline]
    pub fn push(&mut self, ray: &R) {
        self.stack.rays[self.stack.count] = *ray;
        self.stack.count += 1;
    }

    /// Has a ray wait on a walk that keeps all of them, for which room is made.
    #[cold]
    pub fn keep(&mut self, ray: &R) {
        if self.stack.count == self.stack.rays.len() {
            self.stack.rays.push(*ray);
        }
        self.push(ray);
    }

    /// The energy that a ray still carries at its end, after its path's absorption is booked.
    #[inline]
    pub fn retire(&mut self, ray: &Ray) -> f32 {
        let energy = ray.significance * ray.bandwidth();
        let kept = mean_transmittance(self.scene, ray);
        self.tally.absorbed += energy * (1.0 - kept);
        energy * kept
    }
}

impl Walk<'_> {
    /// Puts a ray on the stack, or into the books where it is too weak, too deep or too much.
    #[inline]
    pub fn send(&mut self, ray: &Ray) {
        let fate = fate_of(self.scene, self.rules, ray, self.waiting());
        if fate == Fate::Kept {
            self.push(ray);
            return;
        }
        if self.keeps_all {
            self.keep(ray);
            return;
        }
        let energy = self.retire(ray);
        if fate == Fate::TooWeak {
            self.tally.pruned += energy;
        } else {
            self.tally.cut_off += energy;
        }
    }
}

/// What becomes of a ray that is sent on while `waiting` others wait.
#[inline]
pub fn fate_of(scene: &PackedScene, rules: &TraceRules, ray: &Ray, waiting: u32) -> Fate {
    if ray.significance * transmittance_bound(scene, ray) < rules.significance_threshold {
        return Fate::TooWeak;
    }
    if ray.depth > rules.max_depth {
        return Fate::TooDeep;
    }
    if waiting == STACK_LEN as u32 {
        return Fate::TooMany;
    }
    Fate::Kept
}
