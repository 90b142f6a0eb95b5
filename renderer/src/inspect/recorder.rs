//! The picture's walk, written down.

use std::ops::Range;

use super::end::{Limit, RayEnd, read_end};
use super::names::Names;
use super::request::RayTreeRequest;
use super::tree::{RayKind, RayTree, RecordedRay};
use crate::error::RendererError;
use crate::kernel::camera::{camera_ray, pixel_seed};
use crate::kernel::ray::Ray;
use crate::kernel::spread::spread_angle;
use crate::kernel::trace::{follow, next_surface};
use crate::kernel::walk::{Fate, RayStack, Tally, TraceRules, Walk, fate_of};
use crate::packed::{NONE, PackedScene};
use crate::spectrum::LAMBDA_MIN_NM;
use crate::statistics::Ledger;
use crate::tracer::{View, rules};

/// Traces the tree that `request` asks for in its scene, as it is packed.
pub(super) fn trace(
    request: &RayTreeRequest,
    packed: &PackedScene,
    max_rays: usize,
    is_cancelled: &dyn Fn() -> bool,
) -> Result<RayTree, RendererError> {
    request.check()?;
    let RayTreeRequest { scene, camera, size, pixel: [x, y], pass_index, trace } = request;
    let bins = packed.bins;
    let view = View::new(camera, *size);
    let rules = rules(&view, trace);
    let mut stack = RayStack::new();
    let mut radiance = vec![0.0; bins.count()];
    let seed = pixel_seed(*x, *y);
    let mut walk = Walk::new(packed, &rules, *pass_index, seed, &mut stack, &mut radiance);
    let mut recorder = Recorder::new(packed, &rules, Names::new(scene)?, max_rays);
    let camera_ray = camera_ray(&view.frame, *size, *x, *y, *pass_index);
    recorder.record(&mut walk, &camera_ray, is_cancelled)?;
    let tally = walk.tally;
    let rays = depth_first(recorder.rays, &recorder.children);
    Ok(RayTree {
        pixel: request.pixel,
        size_px: *size,
        pass_index: *pass_index,
        bin_edges_nm: (0..=bins.count())
            .map(|i| LAMBDA_MIN_NM + i as f32 * bins.width_nm())
            .collect(),
        radiance_per_bin: radiance,
        ledger: Ledger::of_tally(&tally),
        segments: tally.segments,
        is_truncated: recorder.unrecorded_rays > 0,
        unrecorded_rays: recorder.unrecorded_rays,
        rays,
    })
}

/// A ray that waits, and its place in the record; [`NONE`] where it has none.
struct Waiting {
    ray: Ray,
    id: u32,
}

/// What the walk that keeps all rays shows of a ray that is followed.
struct Sight {
    children: Vec<Ray>,
    tally: Tally,
}

struct Recorder<'a> {
    scene: &'a PackedScene,
    rules: &'a TraceRules,
    /// Rules by which every ray is kept.
    open_rules: TraceRules,
    open_stack: RayStack,
    open_radiance: Vec<f32>,
    names: Names,
    max_rays: usize,
    /// The rays on the stack of the picture's walk, in the same order.
    waiting: Vec<Waiting>,
    rays: Vec<RecordedRay>,
    /// Where in `rays` those stand that came of each.
    children: Vec<Range<usize>>,
    unrecorded_rays: u64,
}

impl<'a> Recorder<'a> {
    fn new(scene: &'a PackedScene, rules: &'a TraceRules, names: Names, max_rays: usize) -> Self {
        Self {
            scene,
            rules,
            open_rules: TraceRules { significance_threshold: 0.0, max_depth: u32::MAX, ..*rules },
            open_stack: RayStack::new(),
            open_radiance: vec![0.0; scene.bins.count()],
            names,
            max_rays,
            waiting: Vec::new(),
            rays: Vec::new(),
            children: Vec::new(),
            unrecorded_rays: 0,
        }
    }

    /// Makes the walk of the camera ray, as [`trace`](crate::kernel::trace::trace) does.
    fn record(
        &mut self,
        walk: &mut Walk<'_>,
        camera_ray: &Ray,
        is_cancelled: &dyn Fn() -> bool,
    ) -> Result<(), RendererError> {
        self.receive(NONE, RayKind::Camera, camera_ray);
        walk.send(camera_ray);
        while let Some(Waiting { ray, id }) = self.waiting.pop() {
            if is_cancelled() {
                return Err(RendererError::Cancelled);
            }
            let sight = self.look(&ray);
            let before = walk.radiance.to_vec();
            follow(walk);
            if id != NONE {
                self.finish(id, &ray, &sight, differences(&before, walk.radiance));
            }
            let first = self.rays.len();
            for child in &sight.children {
                self.receive(id, kind_of(&ray, child), child);
            }
            if id != NONE {
                self.children[id as usize] = first..self.rays.len();
            }
        }
        Ok(())
    }

    /// Follows the ray by rules that keep all that comes of it.
    fn look(&mut self, ray: &Ray) -> Sight {
        self.open_radiance.fill(0.0);
        let mut walk = Walk::new(
            self.scene,
            &self.open_rules,
            0,
            0,
            &mut self.open_stack,
            &mut self.open_radiance,
        );
        walk.send(ray);
        follow(&mut walk);
        let tally = walk.tally;
        let mut children: Vec<_> =
            std::iter::from_fn(|| walk.has_rays().then(|| walk.pop())).collect();
        children.reverse();
        Sight { children, tally }
    }

    /// Takes a ray that is sent on into the record, and where the rules keep it among those that
    /// wait.
    fn receive(&mut self, parent: u32, kind: RayKind, ray: &Ray) {
        let fate = fate_of(self.scene, self.rules, ray, self.waiting.len() as u32);
        let has_place = self.rays.len() < self.max_rays && (parent != NONE || self.rays.is_empty());
        let id = if has_place { self.rays.len() as u32 } else { NONE };
        if has_place {
            let recorded = self.begin(id, parent, kind, ray, fate);
            self.rays.push(recorded);
            self.children.push(0..0);
        } else {
            self.unrecorded_rays += 1;
            if let Some(parent) = self.rays.get_mut(parent as usize) {
                parent.unrecorded_children += 1;
            }
        }
        if fate == Fate::Kept {
            self.waiting.push(Waiting { ray: *ray, id });
        }
    }

    /// What is known of a ray before it is followed.
    fn begin(&mut self, id: u32, parent: u32, kind: RayKind, ray: &Ray, fate: Fate) -> RecordedRay {
        let end = match fate {
            // Until it is followed.
            Fate::Kept => RayEnd::Lost,
            Fate::TooWeak => RayEnd::Pruned,
            Fate::TooDeep => RayEnd::CutOff { limit: Limit::Depth },
            Fate::TooMany => RayEnd::CutOff { limit: Limit::Stack },
        };
        let [energy_at_end, energy_absorbed] =
            if fate == Fate::Kept { [0.0; 2] } else { self.retire(ray) };
        RecordedRay {
            id,
            parent: (parent != NONE).then_some(parent),
            depth: ray.depth,
            kind,
            from: self.names.surface(ray.instance, ray.facet),
            medium: self.names.object(ray.medium),
            origin_mm: ray.origin,
            end_mm: None,
            path_mm: None,
            direction: ray.direction,
            spread: ray.spread,
            spread_degrees: spread_angle(ray.spread).to_degrees(),
            lambda_low_nm: ray.lambda_low_nm,
            lambda_high_nm: ray.lambda_high_nm,
            significance: ray.significance,
            energy: ray.significance * ray.bandwidth(),
            end,
            energy_at_end,
            energy_absorbed,
            radiance_per_bin: Vec::new(),
            unrecorded_children: 0,
        }
    }

    /// The energy that a ray ends with, and what its path has absorbed.
    fn retire(&mut self, ray: &Ray) -> [f32; 2] {
        let (stack, radiance) = (&mut self.open_stack, &mut self.open_radiance);
        let mut walk = Walk::new(self.scene, &self.open_rules, 0, 0, stack, radiance);
        let energy = walk.retire(ray);
        [energy, walk.tally.absorbed]
    }

    /// What is known of a ray after it was followed.
    fn finish(&mut self, id: u32, ray: &Ray, sight: &Sight, radiance_per_bin: Vec<f64>) {
        let mut arrived = *ray;
        let hit = next_surface(self.scene, &mut arrived);
        if hit.instance != NONE {
            arrived.origin += arrived.direction * hit.distance;
        }
        let end =
            read_end(self.scene, self.rules, &mut self.names, &arrived, &hit, &sight.children);
        let recorded = &mut self.rays[id as usize];
        recorded.end = end;
        if hit.instance != NONE {
            recorded.end_mm = Some(arrived.origin);
            recorded.path_mm = Some(hit.distance);
        }
        recorded.energy_at_end = sight.tally.returned + sight.tally.lost;
        recorded.energy_absorbed = sight.tally.absorbed;
        recorded.radiance_per_bin = radiance_per_bin;
    }
}

/// How the ray `child` came of `ray`.
fn kind_of(ray: &Ray, child: &Ray) -> RayKind {
    if child.medium != ray.medium {
        RayKind::Refracted
    } else if child.significance < ray.significance {
        RayKind::Reflected
    } else {
        RayKind::TotallyReflected
    }
}

/// What was added to each value; nothing where that is nothing in all.
fn differences(before: &[f32], after: &[f32]) -> Vec<f64> {
    if before == after {
        return Vec::new();
    }
    before.iter().zip(after).map(|(before, after)| f64::from(*after) - f64::from(*before)).collect()
}

/// The rays with each before those that came of it, and these right behind it.
fn depth_first(rays: Vec<RecordedRay>, children: &[Range<usize>]) -> Vec<RecordedRay> {
    let mut order = Vec::with_capacity(rays.len());
    let mut pending = vec![0];
    while let Some(ray) = pending.pop() {
        order.push(ray);
        pending.extend(children[ray].clone().rev());
    }
    let mut place_of = vec![0; rays.len()];
    for (place, &ray) in order.iter().enumerate() {
        place_of[ray] = place as u32;
    }
    let mut sorted: Vec<_> = rays
        .into_iter()
        .map(|ray| RecordedRay {
            id: place_of[ray.id as usize],
            parent: ray.parent.map(|parent| place_of[parent as usize]),
            ..ray
        })
        .collect();
    sorted.sort_unstable_by_key(|ray| ray.id);
    sorted
}
