//! The tree that is shown: recorded in the background, again whenever what it is of changes.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

use brilliance_renderer::error::RendererError;
use brilliance_renderer::inspect::{RayTree, RayTreeRequest};
use brilliance_renderer::packed::PackedScene;
use brilliance_renderer::scene::Scene;
use brilliance_renderer::settings::TraceSettings;
use brilliance_renderer::spectrum::Bins;

use super::traced::Traced;
use crate::inspector::Pick;
use crate::task::{Task, TaskState};
use crate::waker::Waker;

type Outcome = Result<Traced, RendererError>;

/// A tree of the same pixel is waited for so long after the scene or the settings have changed, so
/// that some are seen while a hand drags.
const PATIENCE: Duration = Duration::from_millis(500);

/// A tree being recorded.
#[derive(Debug)]
struct Running {
    request: RayTreeRequest,
    task: Task<Outcome>,
    started: Instant,
    cancel: CancelOnDrop,
}

/// Tells the thread that nobody wants its tree any more.
#[derive(Debug)]
struct CancelOnDrop(Arc<AtomicBool>);

impl CancelOnDrop {
    fn cancel(&self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

impl Drop for CancelOnDrop {
    fn drop(&mut self) {
        self.cancel();
    }
}

/// The scene as it is traced, which its first tree packs.
#[derive(Debug)]
struct Packing {
    scene: Arc<Scene>,
    bins: Bins,
    packed: Arc<OnceLock<PackedScene>>,
}

/// The newest tree there is, and the one that is on its way.
#[derive(Debug, Default)]
pub(super) struct Recording {
    running: Option<Running>,
    /// What `tree` or `fault` came of.
    request: Option<RayTreeRequest>,
    tree: Option<Traced>,
    fault: Option<String>,
    packing: Option<Packing>,
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

    /// Forgets the tree, and has the one that is on its way left undone.
    pub(super) fn clear(&mut self) {
        *self = Self::default();
    }

    /// Has the tree that is on its way left undone.
    pub(super) fn cancel(&self) {
        if let Some(running) = &self.running {
            running.cancel.cancel();
        }
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
        let is_wanted = |request: &RayTreeRequest| {
            is_of(request, pick) && request.trace == *trace && shows(request, scene)
        };
        if let Some(running) = &self.running {
            let is_late = running.started.elapsed() > PATIENCE;
            if !is_of(&running.request, pick) || is_late && !is_wanted(&running.request) {
                running.cancel.cancel();
            }
        } else if !self.request.as_ref().is_some_and(is_wanted) {
            self.start(request(pick, scene, trace), waker);
        }
        is_new
    }

    /// Where the packed scene of `request` is, or will be.
    fn packed(&mut self, request: &RayTreeRequest) -> Arc<OnceLock<PackedScene>> {
        let bins = Bins::new(request.trace.bins);
        let known = self
            .packing
            .as_ref()
            .filter(|packing| packing.bins == bins && shows(request, &packing.scene));
        let packed = known.map(|packing| Arc::clone(&packing.packed)).unwrap_or_default();
        let scene = Arc::clone(&request.scene);
        self.packing = Some(Packing { scene, bins, packed: Arc::clone(&packed) });
        packed
    }

    fn poll(&mut self, pick: &Pick) -> bool {
        let Some(running) = self.running.take() else { return false };
        let outcome = match running.task.poll() {
            TaskState::Running => {
                self.running = Some(running);
                return false;
            }
            TaskState::Finished(Err(RendererError::Cancelled)) => return false,
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
        let (job, packed) = (request.clone(), self.packed(&request));
        let cancel = CancelOnDrop(Arc::default());
        let is_cancelled = Arc::clone(&cancel.0);
        let task = Task::spawn("trace rays", waker, move || {
            record(&job, &packed, &|| is_cancelled.load(Ordering::Relaxed))
        });
        match task {
            Ok(task) => {
                self.running = Some(Running { request, task, started: Instant::now(), cancel });
            }
            Err(error) => {
                self.request = Some(request);
                self.fault = Some(format!("the system gives no thread to follow rays on: {error}"));
            }
        }
    }
}

/// Records a tree, in the packed scene if there is one already.
fn record(
    request: &RayTreeRequest,
    packed: &OnceLock<PackedScene>,
    is_cancelled: &dyn Fn() -> bool,
) -> Outcome {
    let packed = if let Some(packed) = packed.get() {
        packed
    } else {
        let new = PackedScene::new(&request.scene, Bins::new(request.trace.bins))?;
        packed.get_or_init(|| new)
    };
    let tree = RayTree::trace_packed(request, packed, RayTree::MAX_RAYS, is_cancelled)?;
    Ok(Traced::new(tree, &request.scene))
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
