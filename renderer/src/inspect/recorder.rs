//! The picture's walk, written down.

use super::branch::{Branch, Meeting, Sent, Start};
use super::end::{Limit, Offspring, RayEnd, read_end};
use super::names::Names;
use super::request::RayTreeRequest;
use super::tree::{RayKind, RayTree, RecordedRay};
use crate::error::RendererError;
use crate::kernel::camera::{camera_ray, pixel_seed};
use crate::kernel::fan::Fan;
use crate::kernel::ray::Ray;
use crate::kernel::spread::spread_angle;
use crate::kernel::walk::{Fate, RayStack, Tally, TraceRules, Walk};
use crate::packed::{NONE, PackedScene};
use crate::settings::Splitting;
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
    match request.trace.splitting {
        Splitting::Paper => trace_branches::<Ray>(request, packed, max_rays, is_cancelled),
        Splitting::Exact => trace_branches::<Fan>(request, packed, max_rays, is_cancelled),
    }
}

fn trace_branches<B: Branch>(
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
    let mut stack = B::stack();
    let mut radiance = vec![0.0; bins.count()];
    let seed = pixel_seed(*x, *y);
    let mut walk = Walk::new(packed, &rules, *pass_index, seed, &mut stack, &mut radiance);
    let mut recorder = Recorder::new(packed, &rules, Names::new(scene)?, max_rays);
    let camera_ray = camera_ray(&view.frame, *size, *x, *y, *pass_index);
    recorder.record(&mut walk, &B::of_camera_ray(&camera_ray, seed), is_cancelled)?;
    let tally = walk.tally;
    let rays = depth_first(recorder.rays, &recorder.wholes);
    Ok(RayTree {
        pixel: request.pixel,
        size_px: *size,
        pass_index: *pass_index,
        splitting: trace.splitting,
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

/// A branch that waits, and its place in the record; [`NONE`] where it has none.
struct Waiting<B> {
    branch: B,
    id: u32,
}

/// What is seen of a branch that is followed by a walk that keeps all that comes of it.
struct Sight<B> {
    meeting: Meeting<B>,
    /// Parts that meet something else: they wait again.
    rest: Vec<B>,
    /// What came of the part that goes on, in the order in which it was sent.
    children: Vec<B>,
    tally: Tally,
}

struct Recorder<'a, B> {
    scene: &'a PackedScene,
    rules: &'a TraceRules,
    names: Names,
    max_rays: usize,
    /// The branches on the stack of the picture's walk, in the same order.
    waiting: Vec<Waiting<B>>,
    rays: Vec<RecordedRay>,
    /// For each of them the place of that which it was a part of when it was sent; mostly its own.
    wholes: Vec<u32>,
    unrecorded_rays: u64,
}

impl<'a, B: Branch> Recorder<'a, B> {
    fn new(scene: &'a PackedScene, rules: &'a TraceRules, names: Names, max_rays: usize) -> Self {
        Self {
            scene,
            rules,
            names,
            max_rays,
            waiting: Vec::new(),
            rays: Vec::new(),
            wholes: Vec::new(),
            unrecorded_rays: 0,
        }
    }

    /// Makes the walk of the camera ray, as the picture's tracer does. What its steps send on is sent
    /// once more, one by one, in a walk of the same state.
    fn record(
        &mut self,
        walk: &mut Walk<'_, B>,
        camera_ray: &B,
        is_cancelled: &dyn Fn() -> bool,
    ) -> Result<(), RendererError> {
        let (mut open_stack, mut stack) = (B::stack(), B::stack());
        let mut camera_ray = *camera_ray;
        camera_ray.send(RayKind::Camera, walk);
        let id = self.enter(NONE, RayKind::Camera, &camera_ray);
        self.waiting.push(Waiting { branch: camera_ray, id });
        while let Some(Waiting { branch, id }) = self.waiting.pop() {
            if is_cancelled() {
                return Err(RendererError::Cancelled);
            }
            let sight = self.look(&branch, &mut open_stack);
            let mut radiance = walk.radiance.to_vec();
            let Walk { scene, rules, pass_index, seed, .. } = *walk;
            B::follow(walk);
            let mut again = Walk::new(scene, rules, pass_index, seed, &mut stack, &mut radiance);
            for waiting in &self.waiting {
                again.push(&waiting.branch);
            }
            for rest in &sight.rest {
                self.send_rest(id, rest, &mut again);
            }
            let kinds = sight.meeting.part.kinds(&sight.children);
            for (child, kind) in sight.children.iter().zip(&kinds) {
                self.send(id, *kind, child, &mut again);
            }
            if id != NONE {
                self.finish(id, &sight, &kinds, differences(&radiance, walk.radiance));
            }
        }
        Ok(())
    }

    /// Follows the branch by a walk that keeps all that comes of it.
    fn look(&self, branch: &B, stack: &mut RayStack<B>) -> Sight<B> {
        let mut radiance = vec![0.0; self.scene.bins.count()];
        let mut walk = Walk::new(self.scene, self.rules, 0, 0, stack, &mut radiance);
        walk.keeps_all = true;
        let meeting = branch.meet(&mut walk);
        let mut walk = Walk::new(self.scene, self.rules, 0, 0, stack, &mut radiance);
        walk.keeps_all = true;
        walk.push(branch);
        B::follow(&mut walk);
        let tally = walk.tally;
        let mut sent: Vec<_> = std::iter::from_fn(|| walk.has_rays().then(|| walk.pop())).collect();
        sent.reverse();
        let depth = |branch: &B| branch.start(self.scene).depth;
        let (rest, children) = sent.into_iter().partition(|sent| depth(sent) == depth(branch));
        Sight { meeting, rest, children, tally }
    }

    /// What the recorded branch `id` came of, and how.
    fn origin_of(&self, id: u32) -> (u32, RayKind) {
        let recorded = self.rays.get(id as usize);
        recorded.map_or((NONE, RayKind::Camera), |ray| (ray.parent.unwrap_or(NONE), ray.kind))
    }

    /// Sends a branch on in `walk`, and takes it into the record. Its place there, or [`NONE`] where
    /// there is none left.
    fn send(&mut self, parent: u32, kind: RayKind, branch: &B, walk: &mut Walk<'_, B>) -> u32 {
        let before = walk.radiance.to_vec();
        walk.tally = Tally::default();
        let mut sent = *branch;
        let outcome = sent.send(kind, walk);
        let id = self.enter(parent, kind, &sent);
        if outcome == Sent::Waits {
            self.waiting.push(Waiting { branch: sent, id });
        }
        let Some(recorded) = self.rays.get_mut(id as usize) else { return id };
        recorded.energy_gained = recorded.energy - branch.start(self.scene).energy;
        recorded.energy_absorbed = walk.tally.absorbed;
        match outcome {
            Sent::Waits => {}
            Sent::HasSeenLights => {
                recorded.end = sent.sky_view(self.scene, self.rules, &self.names).into_end();
                recorded.energy_at_end = walk.tally.returned;
                recorded.radiance_per_bin = differences(&before, walk.radiance);
            }
            Sent::Ends(Fate::TooWeak) => {
                recorded.end = RayEnd::Pruned;
                recorded.energy_at_end = walk.tally.pruned;
            }
            Sent::Ends(fate) => {
                let limit = if fate == Fate::TooDeep { Limit::Depth } else { Limit::Stack };
                recorded.end = RayEnd::CutOff { limit };
                recorded.energy_at_end = walk.tally.cut_off;
            }
        }
        id
    }

    /// As `send`, with a part of the branch `id` that waits again: it came of the same.
    fn send_rest(&mut self, id: u32, rest: &B, walk: &mut Walk<'_, B>) {
        let (parent, kind) = self.origin_of(id);
        let gained = self.gained_share(id) * rest.start(self.scene).energy;
        let part = self.send(parent, kind, rest, walk);
        if part != NONE {
            self.wholes[part as usize] = self.wholes[id as usize];
            self.rays[part as usize].energy_gained += gained;
        }
    }

    /// How much of the energy of the recorded branch `id` was not its own.
    fn gained_share(&self, id: u32) -> f32 {
        let recorded = self.rays.get(id as usize);
        recorded.map_or(0.0, |ray| ray.energy_gained / ray.energy.max(f32::MIN_POSITIVE))
    }

    /// Takes a branch into the record. Its place there, or [`NONE`] where there is none left.
    fn enter(&mut self, parent: u32, kind: RayKind, branch: &B) -> u32 {
        let id = self.rays.len() as u32;
        if self.rays.len() < self.max_rays && (parent != NONE || self.rays.is_empty()) {
            let recorded = self.begin(id, parent, kind, branch);
            self.rays.push(recorded);
            self.wholes.push(id);
            return id;
        }
        self.unrecorded_rays += 1;
        if let Some(parent) = self.rays.get_mut(parent as usize) {
            parent.unrecorded_children += 1;
        }
        NONE
    }

    /// What is known of a branch before it ends.
    fn begin(&mut self, id: u32, parent: u32, kind: RayKind, branch: &B) -> RecordedRay {
        let start = branch.start(self.scene);
        RecordedRay {
            id,
            parent: (parent != NONE).then_some(parent),
            depth: start.depth,
            kind,
            from: self.names.surface(start.instance, start.facet),
            medium: self.names.object(start.medium),
            origin_mm: start.origin_mm,
            end_mm: None,
            path_mm: None,
            direction: start.direction,
            spread: start.spread,
            spread_degrees: spread_angle(start.spread).to_degrees(),
            edges: start.edges,
            lambda_low_nm: start.lambda_low_nm,
            lambda_high_nm: start.lambda_high_nm,
            central_nm: start.central_nm,
            significance: start.significance,
            energy: start.energy,
            energy_gained: 0.0,
            // Until it ends.
            end: RayEnd::Lost,
            energy_at_end: 0.0,
            energy_absorbed: 0.0,
            radiance_per_bin: Vec::new(),
            unrecorded_children: 0,
        }
    }

    /// What is known of a branch after it was followed: from now on it is the part that went on.
    fn finish(&mut self, id: u32, sight: &Sight<B>, kinds: &[RayKind], radiance_per_bin: Vec<f64>) {
        let Sight { meeting, children, tally, .. } = sight;
        let offspring: Vec<_> = children
            .iter()
            .zip(kinds)
            .map(|(child, &kind)| {
                let Start { lambda_low_nm, lambda_high_nm, .. } = child.start(self.scene);
                Offspring { kind, lambda_low_nm, lambda_high_nm }
            })
            .collect();
        let end = read_end(self.scene, self.rules, &mut self.names, meeting, &offspring);
        let (parent, kind) = self.origin_of(id);
        let part = self.begin(id, parent, kind, &meeting.part);
        let whole = &self.rays[id as usize];
        let mut recorded = RecordedRay {
            end,
            energy_gained: self.gained_share(id) * part.energy,
            energy_at_end: tally.returned + tally.lost,
            energy_absorbed: tally.absorbed,
            radiance_per_bin,
            unrecorded_children: whole.unrecorded_children,
            ..part
        };
        if meeting.hit.instance != NONE {
            recorded.end_mm = Some(meeting.ray.origin);
            recorded.path_mm = Some(meeting.path_mm);
            for (edge, end_mm) in recorded.edges.iter_mut().zip(meeting.edge_ends_mm) {
                edge.end_mm = Some(end_mm);
            }
        }
        self.rays[id as usize] = recorded;
    }
}

/// What was added to each value; nothing where that is nothing in all.
fn differences(before: &[f32], after: &[f32]) -> Vec<f64> {
    if before == after {
        return Vec::new();
    }
    before.iter().zip(after).map(|(before, after)| f64::from(*after) - f64::from(*before)).collect()
}

/// The rays with each before those that came of it, and these right behind it. Parts of one stand side
/// by side.
fn depth_first(rays: Vec<RecordedRay>, wholes: &[u32]) -> Vec<RecordedRay> {
    let mut in_turn: Vec<usize> = (0..rays.len()).collect();
    in_turn.sort_by(|&a, &b| {
        let low_nm = |id: usize| rays[id].lambda_low_nm;
        wholes[a].cmp(&wholes[b]).then(low_nm(a).total_cmp(&low_nm(b)))
    });
    let mut children = vec![Vec::new(); rays.len()];
    for id in in_turn {
        if let Some(parent) = rays[id].parent {
            children[parent as usize].push(id);
        }
    }
    let mut place_of = vec![0; rays.len()];
    let mut pending = vec![0];
    let mut place = 0;
    while let Some(ray) = pending.pop() {
        place_of[ray] = place;
        place += 1;
        pending.extend(children[ray].iter().rev());
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
