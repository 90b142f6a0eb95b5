//! The tree that is shown: recorded in the background, again whenever what it is of changes.

use std::sync::Arc;

use brilliance_renderer::error::RendererError;
use brilliance_renderer::inspect::{RayTree, RayTreeRequest};
use brilliance_renderer::scene::Scene;
use brilliance_renderer::settings::TraceSettings;

use super::traced::Traced;
use crate::inspector::Pick;
use crate::task::{Task, TaskState};
use crate::waker::Waker;

type Outcome = Result<Traced, RendererError>;

/// A tree being recorded.
#[derive(Debug)]
struct Running {
    request: RayTreeRequest,
    task: Task<Outcome>,
}

/// The newest tree there is, and the one that is on its way.
#[derive(Debug, Default)]
pub(super) struct Recording {
    running: Option<Running>,
    /// What `tree` or `fault` came of.
    request: Option<RayTreeRequest>,
    tree: Option<Traced>,
    fault: Option<String>,
}

impl Recording {
    /// The newest tree.
    pub(super) fn tree(&self) -> Option<&Traced> {
        self.tree.as_ref()
    }

    /// Why there is none.
    pub(super) fn fault(&self) -> Option<&str> {
        self.fault.as_deref()
    }

    /// Whether another is on its way.
    pub(super) fn is_running(&self) -> bool {
        self.running.is_some()
    }

    /// Forgets the tree; one that is on its way will not be shown.
    pub(super) fn clear(&mut self) {
        *self = Self::default();
    }

    /// Takes over a tree that has been recorded, and has another recorded where what is asked for is
    /// no longer what is shown. True if there is another tree now.
    pub(super) fn update(
        &mut self,
        pick: &Pick,
        scene: &Arc<Scene>,
        trace: &TraceSettings,
        waker: &Waker,
    ) -> bool {
        let is_new = self.poll(pick);
        let is_shown = |request: &RayTreeRequest| {
            is_of(request, pick) && request.trace == *trace && shows(request, scene)
        };
        if self.running.is_none() && !self.request.as_ref().is_some_and(is_shown) {
            self.start(request(pick, scene, trace), waker);
        }
        is_new
    }

    fn poll(&mut self, pick: &Pick) -> bool {
        let Some(running) = self.running.take() else { return false };
        let outcome = match running.task.poll() {
            TaskState::Running => {
                self.running = Some(running);
                return false;
            }
            TaskState::Finished(outcome) => outcome.map_err(|error| error.to_string()),
            TaskState::Broken => Err("the thread that follows the rays has failed".to_owned()),
        };
        if !is_of(&running.request, pick) {
            // Another pixel was picked meanwhile.
            return false;
        }
        self.request = Some(running.request);
        (self.tree, self.fault) = match outcome {
            Ok(tree) => (Some(tree), None),
            Err(fault) => (None, Some(fault)),
        };
        true
    }

    fn start(&mut self, request: RayTreeRequest, waker: &Waker) {
        let job = request.clone();
        let task = Task::spawn("trace rays", waker, move || {
            RayTree::trace(&job, RayTree::MAX_RAYS).map(|tree| Traced::new(tree, &job.scene))
        });
        match task {
            Ok(task) => self.running = Some(Running { request, task }),
            Err(error) => {
                self.request = Some(request);
                self.fault = Some(format!("the system gives no thread to follow rays on: {error}"));
            }
        }
    }
}

fn request(pick: &Pick, scene: &Arc<Scene>, trace: &TraceSettings) -> RayTreeRequest {
    RayTreeRequest {
        scene: Arc::clone(scene),
        camera: pick.camera,
        size: pick.size,
        pixel: pick.pixels.middle(),
        pass_index: 0,
        trace: trace.clone(),
    }
}

/// Whether the tree is that of the pixel that is picked.
fn is_of(request: &RayTreeRequest, pick: &Pick) -> bool {
    request.camera == pick.camera
        && request.size == pick.size
        && request.pixel == pick.pixels.middle()
}

/// Whether the tree is one of this scene, which need not be compared where it is shared.
fn shows(request: &RayTreeRequest, scene: &Arc<Scene>) -> bool {
    Arc::ptr_eq(&request.scene, scene) || request.scene == *scene
}
