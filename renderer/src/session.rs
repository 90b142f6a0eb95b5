//! From sliders to pixels: the newest request wins, the UI never waits.
//!
//! Two threads work behind a [`Session`]. The *render* thread takes the newest request, traces
//! pass after pass and hands on the film as an [`XyzImage`]; a newer request stops it within a
//! pixel. The *develop* thread turns the newest image into a [`Picture`] by the newest
//! [`DisplaySettings`], so that exposure acts while a long pass is being traced.

mod develop_thread;
mod mailbox;
mod render_thread;

use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;

use crate::camera::Camera;
use crate::develop::{LatentImage, Pixels};
use crate::error::RendererError;
use crate::gpu::Graphics;
use crate::scene::Scene;
use crate::settings::{DisplaySettings, TraceSettings};
use crate::statistics::Statistics;
use crate::tracer::{Backend, CpuTracer, TracerName};
use mailbox::Mailbox;

/// Everything that decides the film. Equal requests need no work; a different one restarts, unless
/// only the number of passes differs.
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
    /// What traces it.
    pub backend: Backend,
}

impl RenderRequest {
    /// Whether the two differ at most in how many passes they want: the film carries on.
    pub fn makes_same_film(&self, other: &Self) -> bool {
        let Self { scene: _, camera, size, trace, pass_limit: _, backend } = self;
        *camera == other.camera
            && *size == other.size
            && *trace == other.trace
            && *backend == other.backend
            && self.has_same_scene(other)
    }

    /// Whether the two show one scene, which need not be compared where it is shared.
    fn has_same_scene(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.scene, &other.scene) || self.scene == other.scene
    }
}

/// A developed image, ready for the screen.
#[derive(Debug)]
pub struct Picture {
    /// Width and height in pixels; smaller than requested while previewing.
    pub size: [u32; 2],
    /// What is shown.
    pub pixels: Pixels,
    /// Counts up with every picture published.
    pub serial: u64,
}

/// What the session is doing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Activity {
    /// No request yet.
    #[default]
    Idle,
    /// Reduced resolution while things change.
    Preview,
    /// Passes accumulate at full resolution.
    Accumulating,
    /// The pass limit is reached.
    Done,
    /// The request could not be traced; see [`Progress::error`].
    Failed,
}

/// Where the current request stands.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Progress {
    /// What the session is doing.
    pub activity: Activity,
    /// Passes in the film that is shown.
    pub passes: u32,
    /// Passes asked for.
    pub pass_limit: u32,
    /// Size of the film that is shown.
    pub size: [u32; 2],
    /// Counts of the film that is shown.
    pub statistics: Statistics,
    /// Seconds of tracing in the film that is shown.
    pub tracing_seconds: f64,
    /// Why the request failed.
    pub error: Option<String>,
    /// What traced the film that is shown; none before the first.
    pub tracer: Option<TracerName>,
}

/// How the session and the graphics device get on.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum GraphicsState {
    /// No device was offered.
    #[default]
    Absent,
    /// The shaders are being compiled.
    Preparing,
    /// The device traces whatever is asked of it.
    Ready,
    /// The device failed, and is asked no more; the text says why.
    Failed(String),
}

/// What the threads share. A poisoned lock still holds a whole value, so poison is ignored.
struct Shared {
    requests: Mailbox<RenderRequest>,
    image: Mutex<Option<Arc<LatentImage>>>,
    display: Mutex<DisplaySettings>,
    /// Says that there is something new to develop.
    to_develop: Mailbox<()>,
    picture: Mutex<Option<Arc<Picture>>>,
    progress: Mutex<Progress>,
    on_update: Box<dyn Fn() + Send + Sync>,
}

impl Shared {
    fn publish(&self, progress: Progress) {
        *lock(&self.progress) = progress;
        (self.on_update)();
    }
}

fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A render thread that serves the newest request, and a develop thread that shows it.
pub struct Session {
    shared: Arc<Shared>,
    last_request: Option<RenderRequest>,
    requests_made: u64,
    threads: usize,
    workers: Vec<JoinHandle<()>>,
}

impl Session {
    /// Starts the threads. `on_update` is called from them whenever a new picture or new progress
    /// can be read.
    ///
    /// # Errors
    /// The system refuses the threads.
    pub fn new(on_update: impl Fn() + Send + Sync + 'static) -> Result<Self, RendererError> {
        let tracer = CpuTracer::new(0)?;
        let threads = tracer.threads();
        let shared = Arc::new(Shared {
            requests: Mailbox::new(),
            image: Mutex::new(None),
            display: Mutex::new(DisplaySettings::default()),
            to_develop: Mailbox::new(),
            picture: Mutex::new(None),
            progress: Mutex::new(Progress::default()),
            on_update: Box::new(on_update),
        });
        let (render, develop) = (Arc::clone(&shared), Arc::clone(&shared));
        let workers = vec![
            spawn("render", move || render_thread::run(&render, &tracer))?,
            spawn("develop", move || develop_thread::run(&develop))?,
        ];
        Ok(Self { shared, last_request: None, requests_made: 0, threads, workers })
    }

    /// Asks for a picture. Equal to the last request: nothing happens. Returns at once.
    pub fn request(&mut self, request: RenderRequest) {
        let last = self.last_request.as_ref();
        let carries_on = last.is_some_and(|last| last.makes_same_film(&request));
        if carries_on && last.is_some_and(|last| last.pass_limit == request.pass_limit) {
            return;
        }
        self.last_request = Some(request.clone());
        self.requests_made += 1;
        if carries_on {
            self.shared.requests.post(request);
        } else {
            self.shared.requests.post_urgent(request);
        }
    }

    /// Develops the film with these settings from now on, without retracing. Returns at once.
    pub fn display(&mut self, settings: DisplaySettings) {
        let mut display = lock(&self.shared.display);
        if *display != settings {
            *display = settings;
            drop(display);
            self.shared.to_develop.post(());
        }
    }

    /// What was last asked for.
    pub fn last_request(&self) -> Option<&RenderRequest> {
        self.last_request.as_ref()
    }

    /// Number of different requests made so far.
    pub fn requests_made(&self) -> u64 {
        self.requests_made
    }

    /// Threads that trace.
    pub fn threads(&self) -> usize {
        self.threads
    }

    /// Lets the session trace on `graphics`, which it prepares while it goes on tracing on the
    /// processor.
    pub fn offer_graphics(&mut self, graphics: Graphics) {
        let _ = graphics;
    }

    /// Gives a graphics device that has failed another chance.
    pub fn retry_graphics(&mut self) {}

    /// How the session and the graphics device get on.
    pub fn graphics_state(&self) -> GraphicsState {
        GraphicsState::Absent
    }

    /// The graphics device that was offered.
    pub fn graphics(&self) -> Option<&Graphics> {
        None
    }

    /// The newest picture.
    pub fn picture(&self) -> Option<Arc<Picture>> {
        lock(&self.shared.picture).clone()
    }

    /// Where the newest request stands.
    pub fn progress(&self) -> Progress {
        lock(&self.shared.progress).clone()
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        self.shared.requests.close();
        self.shared.to_develop.close();
        for worker in self.workers.drain(..) {
            if worker.join().is_err() {
                log::error!("a thread of the session had panicked");
            }
        }
    }
}

fn spawn(name: &str, run: impl FnOnce() + Send + 'static) -> Result<JoinHandle<()>, RendererError> {
    std::thread::Builder::new()
        .name(name.to_owned())
        .spawn(run)
        .map_err(|error| RendererError::Invalid(format!("no thread to {name} with: {error}")))
}
