//! The way to a ray, to find it again in the tree of a changed stone.

use brilliance_renderer::inspect::{RayKind, RayTree, RecordedRay, Surface};

/// How a ray came to be, and where.
#[derive(Clone, Debug)]
struct Step {
    kind: RayKind,
    from: Option<Surface>,
    central_nm: f32,
}

/// The steps from the camera ray to a ray.
#[derive(Clone, Debug)]
pub(super) struct Trail(Vec<Step>);

impl Trail {
    /// The way to the ray `id`.
    pub(super) fn to(tree: &RayTree, id: u32) -> Self {
        let step = |ray: &RecordedRay| Step {
            kind: ray.kind,
            from: ray.from.clone(),
            central_nm: ray.central_nm,
        };
        let mut steps: Vec<_> = tree.path_to_camera(id).map(step).collect();
        steps.reverse();
        Self(steps)
    }

    /// The ray of another tree at the end of the same way, or as far along it as there is one. Among
    /// sub-rays that of the nearest colour is followed.
    pub(super) fn follow(&self, tree: &RayTree) -> u32 {
        let mut reached = 0;
        for step in self.0.iter().skip(1) {
            let distance_nm = |ray: &RecordedRay| (ray.central_nm - step.central_nm).abs();
            // What came of a ray stands behind it.
            let next = tree.rays[reached as usize..]
                .iter()
                .filter(|ray| ray.parent == Some(reached))
                .filter(|ray| ray.kind == step.kind && ray.from == step.from)
                .min_by(|a, b| distance_nm(a).total_cmp(&distance_nm(b)));
            let Some(next) = next else { break };
            reached = next.id;
        }
        reached
    }
}
