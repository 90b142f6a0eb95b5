//! A recorded tree with all that drawing it needs, made once.

use brilliance_renderer::inspect::{LightKind, RayCounts, RayEnd, RayTree, RecordedRay};
use brilliance_renderer::scene::Scene;
use eframe::egui::Color32;

use super::outline::{self, Edge};
use super::palette;
use crate::bounds::Bounds;

/// Length of a ray that meets nothing more, in radii of the scene.
const REACH: f32 = 1.1;
/// Length of a ray that was not followed, in radii of the scene.
const STUB: f32 = 0.06;

/// A tree and how it looks.
#[derive(Debug)]
pub(super) struct Traced {
    pub(super) tree: RayTree,
    pub(super) counts: RayCounts,
    /// Edges of the stones.
    pub(super) outline: Vec<Edge>,
    /// Ids of the rays, the most significant first.
    pub(super) strongest: Vec<u32>,
    /// Most interfaces before any ray.
    pub(super) deepest: u32,
    colors: Vec<Color32>,
    reaches_lamp: Vec<bool>,
    reach_mm: f32,
}

impl Traced {
    pub(super) fn new(tree: RayTree, scene: &Scene) -> Self {
        let mut strongest: Vec<u32> = (0..tree.rays.len() as u32).collect();
        let significance = |id: &u32| tree.rays[*id as usize].significance;
        strongest.sort_by(|a, b| significance(b).total_cmp(&significance(a)));
        let color = |ray: &RecordedRay| palette::color([ray.lambda_low_nm, ray.lambda_high_nm]);
        Self {
            outline: outline::edges(scene),
            strongest,
            deepest: tree.rays.iter().map(|ray| ray.depth).max().unwrap_or(0),
            colors: tree.rays.iter().map(color).collect(),
            reaches_lamp: reaching_lamps(&tree.rays),
            counts: RayCounts::of(&tree),
            reach_mm: Bounds::of(scene).radius,
            tree,
        }
    }

    /// A ray by its id.
    pub(super) fn ray(&self, id: u32) -> &RecordedRay {
        &self.tree.rays[id as usize]
    }

    /// The colour of the light in a ray's interval.
    pub(super) fn color(&self, id: u32) -> Color32 {
        self.colors[id as usize]
    }

    /// Whether the ray, or one that came of it, sees a lamp.
    pub(super) fn reaches_lamp(&self, id: u32) -> bool {
        self.reaches_lamp[id as usize]
    }

    /// How far a ray is drawn, in mm.
    pub(super) fn length_mm(&self, ray: &RecordedRay) -> f32 {
        match ray.end {
            RayEnd::Pruned | RayEnd::CutOff { .. } | RayEnd::Lost => STUB * self.reach_mm,
            _ => ray.path_mm.unwrap_or(REACH * self.reach_mm),
        }
    }
}

/// Whether a ray's own end is a lamp.
pub(super) fn sees_lamp(ray: &RecordedRay) -> bool {
    matches!(&ray.end, RayEnd::Lights { lights, .. }
        if lights.iter().any(|seen| seen.light == LightKind::Lamp))
}

fn reaching_lamps(rays: &[RecordedRay]) -> Vec<bool> {
    let mut reaching: Vec<_> = rays.iter().map(sees_lamp).collect();
    // What came of a ray stands behind it.
    for ray in rays.iter().rev() {
        if let Some(parent) = ray.parent {
            reaching[parent as usize] |= reaching[ray.id as usize];
        }
    }
    reaching
}
