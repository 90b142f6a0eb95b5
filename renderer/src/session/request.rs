//! What a session is asked for.

use std::sync::Arc;

use crate::camera::Camera;
use crate::scene::Scene;
use crate::settings::{NoiseGoal, TraceSettings};
use crate::tracer::Backend;

/// Everything that decides the film. Equal requests need no work; a different one restarts, unless
/// only the number of passes or the noise that is aimed at differs.
#[derive(Clone, Debug, PartialEq)]
pub struct RenderRequest {
    /// What is seen.
    pub scene: Arc<Scene>,
    /// Where it is seen from (the scene's own camera is not used).
    pub camera: Camera,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// How it is traced.
    pub trace: TraceSettings,
    /// Passes after which the picture is done.
    pub pass_limit: u32,
    /// Noise at which it is done before that, and which pixels that leaves out.
    pub noise: NoiseGoal,
    /// What traces it.
    pub backend: Backend,
}

impl RenderRequest {
    /// Whether the two differ at most in how many passes or how little noise they want: the film
    /// carries on.
    pub fn makes_same_film(&self, other: &Self) -> bool {
        let Self { scene: _, camera, size, trace, pass_limit: _, noise: _, backend } = self;
        *camera == other.camera
            && *size == other.size
            && *trace == other.trace
            && *backend == other.backend
            && self.shows(&other.scene)
    }

    /// Whether this is the scene, which need not be compared where it is shared.
    pub(super) fn shows(&self, scene: &Arc<Scene>) -> bool {
        Arc::ptr_eq(&self.scene, scene) || self.scene == *scene
    }
}
