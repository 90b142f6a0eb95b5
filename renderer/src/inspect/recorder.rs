//! The picture's walk, written down.

use super::branch::{Branch, Meeting, Start};
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
    recorder.record(&mut walk, &B::of_camera_ray(&camera_ray), is_cancelled)?;
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

/// What the walk that keeps all branches shows of one that is followed.
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
    /// Rules by which every branch is kept. Where fans are divided is left as it is.
    open_rules: TraceRules,
    open_stack: RayStack<B>,
    open_radiance: Vec<f32>,
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
            open_rules: TraceRules { significance_threshold: 0.0, max_depth: u32::MAX, ..*rules },
            open_stack: B::stack(),
            open_radiance: vec![0.0; scene.bins.count()],
            names,
            max_rays,
            waiting: Vec::new(),
            rays: Vec::new(),
            wholes: Vec::new(),
            unrecorded_rays: 0,
        }
    }

    /// Makes the walk of the camera ray, as the picture's tracer does.
    fn record(
        &mut self,
        walk: &mut Walk<'_, B>,
        camera_ray: &B,
        is_cancelled: &dyn Fn() -> bool,
    ) -> Result<(), RendererError> {
        self.receive(NONE, RayKind::Camera, camera_ray);
        camera_ray.send(walk);
        while let Some(Waiting { branch, id }) = self.waiting.pop() {
            if is_cancelled() {
                return Err(RendererError::Cancelled);
            }
            let sight = self.look(&branch);
            let mut radiance = walk.radiance.to_vec();
            B::follow(walk);
            for rest in &sight.rest {
                self.receive_rest(id, rest);
            }
            let kinds = sight.meeting.part.kinds(&sight.children);
            for (child, kind) in sight.children.iter().zip(&kinds) {
                let has_ended = *kind == RayKind::Refracted
                    && self.receive_ended(id, *kind, child, &mut radiance);
                if !has_ended {
                    self.receive(id, *kind, child);
                }
            }
            if id != NONE {
                self.finish(id, &sight, &kinds, differences(&radiance, walk.radiance));
            }
        }
        Ok(())
    }

    /// Follows the branch by rules that keep all that comes of it.
    fn look(&mut self, branch: &B) -> Sight<B> {
        self.open_radiance.fill(0.0);
        let Self { scene, open_rules, open_stack, open_radiance, .. } = self;
        let meeting =
            branch.meet(&mut Walk::new(scene, open_rules, 0, 0, open_stack, open_radiance));
        let mut walk = Walk::new(scene, open_rules, 0, 0, open_stack, open_radiance);
        walk.holds_exits = true;
        branch.send(&mut walk);
        B::follow(&mut walk);
        let tally = walk.tally;
        let mut sent: Vec<_> = std::iter::from_fn(|| walk.has_rays().then(|| walk.pop())).collect();
        sent.reverse();
        let depth = branch.start(scene).depth;
        let (rest, children) = sent.into_iter().partition(|sent| sent.start(scene).depth == depth);
        Sight { meeting, rest, children, tally }
    }

    /// Takes a branch that is sent on into the record, and where the rules keep it among those that
    /// wait. Its place in the record, or [`NONE`].
    fn receive(&mut self, parent: u32, kind: RayKind, branch: &B) -> u32 {
        let fate = branch.fate(self.scene, self.rules, self.waiting.len() as u32);
        let id = self.enter(parent, kind, branch, fate);
        if fate == Fate::Kept {
            self.waiting.push(Waiting { branch: *branch, id });
        }
        id
    }

    /// Takes a part of the branch at `id` that waits again into the record, as one of its own.
    fn receive_rest(&mut self, id: u32, rest: &B) {
        let (mut parent, mut kind) = (NONE, RayKind::Camera);
        if let Some(recorded) = self.rays.get(id as usize) {
            (parent, kind) = (recorded.parent.unwrap_or(NONE), recorded.kind);
        }
        let part = self.receive(parent, kind, rest);
        if part != NONE {
            self.wholes[part as usize] = self.wholes[id as usize];
        }
    }

    /// Takes a branch into the record that ends as soon as it is sent on, and adds what it sees to
    /// `radiance`; false where it does not.
    fn receive_ended(
        &mut self,
        parent: u32,
        kind: RayKind,
        branch: &B,
        radiance: &mut [f32],
    ) -> bool {
        let before = radiance.to_vec();
        let mut walk = Walk::new(self.scene, self.rules, 0, 0, &mut self.open_stack, radiance);
        if !branch.end_if_sent(&mut walk) {
            return false;
        }
        let tally = walk.tally;
        let id = self.enter(parent, kind, branch, Fate::Kept);
        if let Some(recorded) = self.rays.get_mut(id as usize) {
            recorded.end = branch.sky_view(self.scene, self.rules, &self.names).into_end();
            write_account(recorded, &tally, differences(&before, radiance));
        }
        true
    }

    /// Takes a branch into the record. Its place there, or [`NONE`] where there is none left.
    fn enter(&mut self, parent: u32, kind: RayKind, branch: &B, fate: Fate) -> u32 {
        let id = self.rays.len() as u32;
        if self.rays.len() < self.max_rays && (parent != NONE || self.rays.is_empty()) {
            let recorded = self.begin(id, parent, kind, branch, fate);
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

    /// What is known of a branch before it is followed.
    fn begin(
        &mut self,
        id: u32,
        parent: u32,
        kind: RayKind,
        branch: &B,
        fate: Fate,
    ) -> RecordedRay {
        let end = match fate {
            // Until it is followed.
            Fate::Kept => RayEnd::Lost,
            Fate::TooWeak => RayEnd::Pruned,
            Fate::TooDeep => RayEnd::CutOff { limit: Limit::Depth },
            Fate::TooMany => RayEnd::CutOff { limit: Limit::Stack },
        };
        let [energy_at_end, energy_absorbed] =
            if fate == Fate::Kept { [0.0; 2] } else { self.retire(branch) };
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
            end,
            energy_at_end,
            energy_absorbed,
            radiance_per_bin: Vec::new(),
            unrecorded_children: 0,
        }
    }

    /// The energy that a branch ends with, and what its path has absorbed.
    fn retire(&mut self, branch: &B) -> [f32; 2] {
        let (stack, radiance) = (&mut self.open_stack, &mut self.open_radiance);
        let mut walk = Walk::new(self.scene, &self.open_rules, 0, 0, stack, radiance);
        let energy = branch.retire(&mut walk);
        [energy, walk.tally.absorbed]
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
        let whole = &self.rays[id as usize];
        let (parent, kind) = (whole.parent.unwrap_or(NONE), whole.kind);
        let unrecorded_children = whole.unrecorded_children;
        let mut recorded = self.begin(id, parent, kind, &meeting.part, Fate::Kept);
        recorded.unrecorded_children = unrecorded_children;
        recorded.end = end;
        if meeting.hit.instance != NONE {
            recorded.end_mm = Some(meeting.ray.origin);
            recorded.path_mm = Some(meeting.path_mm);
            for (edge, end_mm) in recorded.edges.iter_mut().zip(meeting.edge_ends_mm) {
                edge.end_mm = Some(end_mm);
            }
        }
        write_account(&mut recorded, tally, radiance_per_bin);
        self.rays[id as usize] = recorded;
    }
}

/// Writes down what a branch that was followed ended with.
fn write_account(recorded: &mut RecordedRay, tally: &Tally, radiance_per_bin: Vec<f64>) {
    recorded.energy_at_end = tally.returned + tally.lost;
    recorded.energy_absorbed = tally.absorbed;
    recorded.radiance_per_bin = radiance_per_bin;
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
