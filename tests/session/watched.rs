//! A session that a test can wait for, and what it is asked.

use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::{Duration, Instant};

use brilliance_renderer::scene_file::Document;
use brilliance_renderer::session::{Activity, Picture, Progress, RenderRequest, Session};
use brilliance_renderer::settings::NoiseGoal;
use brilliance_renderer::tracer::Backend;

/// Far beyond what any of this takes; only a hang reaches it.
const PATIENCE: Duration = Duration::from_mins(5);

/// A session and a bell that it rings at every update.
pub(crate) struct Watched {
    pub(crate) session: Session,
    bell: Arc<(Mutex<u64>, Condvar)>,
}

impl Watched {
    pub(crate) fn new() -> Self {
        let bell = Arc::new((Mutex::new(0), Condvar::new()));
        let ringer = Arc::clone(&bell);
        let session = Session::new(move || {
            // A test that fails while it looks must not take the threads along.
            *ringer.0.lock().unwrap_or_else(PoisonError::into_inner) += 1;
            ringer.1.notify_all();
        })
        .expect("threads can be started");
        Self { session, bell }
    }

    /// Waits until `is_there` holds.
    pub(crate) fn wait(&self, is_there: impl Fn(&Session) -> bool) {
        let deadline = Instant::now() + PATIENCE;
        let mut rings = self.bell.0.lock().expect("nobody panics with the bell");
        while !is_there(&self.session) {
            let left = deadline.saturating_duration_since(Instant::now());
            let session = &self.session;
            let failure = session.graphics_failure();
            assert!(!left.is_zero(), "it never came: {:?}, {failure:?}", session.progress());
            let (next, _) =
                self.bell.1.wait_timeout(rings, left).expect("nobody panics with the bell");
            rings = next;
        }
    }

    pub(crate) fn wait_for_done(&self, size: [u32; 2]) -> (Arc<Picture>, Progress) {
        let is_shown = |session: &Session| session.picture().is_some_and(|p| p.size == size);
        self.wait(|session| {
            let progress = session.progress();
            progress.activity == Activity::Done && progress.size == size && is_shown(session)
        });
        (self.session.picture().expect("it is there"), self.session.progress())
    }
}

pub(crate) fn request(size: [u32; 2], passes: u32) -> RenderRequest {
    let document = Document::default();
    RenderRequest {
        camera: document.scene.camera,
        scene: Arc::new(document.scene),
        size,
        trace: document.trace,
        pass_limit: passes,
        noise: NoiseGoal::NONE,
        backend: Backend::Cpu,
    }
}
