//! A still on its way to a file, independent of the viewport.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::time::Instant;

use brilliance_renderer::develop::Shown;
use brilliance_renderer::error::RendererError;
use brilliance_renderer::session::RenderRequest;
use brilliance_renderer::settings::DisplaySettings;
use brilliance_renderer::still::{Still, StillFormat, StillLimits};
use brilliance_renderer::tracer::{TracerName, TracingDevice};
use brilliance_renderer::whole_file;

use crate::task::{Task, TaskState};
use crate::waker::Waker;

/// Everything that makes a still.
#[derive(Clone, Debug)]
pub struct StillJob {
    /// What is traced.
    pub request: RenderRequest,
    /// The device to trace it on, where its backend calls for that.
    pub device: Option<TracingDevice>,
    /// How it is developed.
    pub display: DisplaySettings,
    /// How it is written.
    pub format: StillFormat,
    /// Where it is written.
    pub path: PathBuf,
    /// The scene file that makes it again, for the metadata.
    pub scene_toml: String,
}

/// What a finished still cost.
#[derive(Clone, Debug, PartialEq)]
pub struct StillReport {
    /// Passes traced.
    pub passes: u32,
    /// Seconds of tracing alone.
    pub tracing_seconds: f64,
    /// What traced it.
    pub tracer: TracerName,
    /// Why the processor traced it though a graphics device was to.
    pub warning: Option<String>,
}

/// Renders and writes a job; called on a thread of its own. The flag cancels it, and the closure
/// is told how many passes are done.
pub type RenderStill = Arc<
    dyn Fn(&StillJob, &AtomicBool, &mut dyn FnMut(u32)) -> Result<StillReport, RendererError>
        + Send
        + Sync,
>;

/// Renders `job` by [`Still`] and writes its file.
///
/// # Errors
/// The file can't be written, or as [`Still::render`] and [`Still::write`].
pub fn render_and_write(
    job: &StillJob,
    cancel: &AtomicBool,
    progress: &mut dyn FnMut(u32),
) -> Result<StillReport, RendererError> {
    // A mistyped folder should be told now, not after an hour of tracing.
    whole_file::check(&job.path)?;
    let limits = StillLimits::default();
    let device = job.device.as_ref();
    let still = Still::render(&job.request, limits, device, cancel, |passes, _| progress(passes))?;
    still.write(&job.path, job.format, &job.display, Shown::Color, &job.scene_toml)?;
    let Still { passes, tracing_seconds, tracer, warning, .. } = still;
    Ok(StillReport { passes, tracing_seconds, tracer, warning })
}

/// A job that runs.
pub(super) struct RunningJob {
    /// Where the still will be.
    pub(super) path: PathBuf,
    pass_limit: u32,
    passes: Arc<AtomicU32>,
    cancel: Arc<AtomicBool>,
    since: Instant,
    task: Task<Result<StillReport, RendererError>>,
}

impl RunningJob {
    /// Starts `job` on its own thread.
    pub(super) fn start(
        job: StillJob,
        render: &RenderStill,
        waker: &Waker,
    ) -> std::io::Result<Self> {
        let (passes, cancel) = (Arc::new(AtomicU32::new(0)), Arc::new(AtomicBool::new(false)));
        let (path, pass_limit) = (job.path.clone(), job.request.pass_limit);
        let (render, repaint) = (Arc::clone(render), waker.clone());
        let (done, cancelled) = (Arc::clone(&passes), Arc::clone(&cancel));
        let task = Task::spawn("export", waker, move || {
            render(&job, &cancelled, &mut |passes| {
                done.store(passes, Ordering::Relaxed);
                repaint.request_repaint();
            })
        })?;
        Ok(Self { path, pass_limit, passes, cancel, since: Instant::now(), task })
    }

    /// Asks it to end.
    pub(super) fn cancel(&self) {
        self.cancel.store(true, Ordering::Relaxed);
    }

    /// True once it was asked to end.
    pub(super) fn is_cancelled(&self) -> bool {
        self.cancel.load(Ordering::Relaxed)
    }

    /// Passes done and asked for.
    pub(super) fn passes(&self) -> (u32, u32) {
        (self.passes.load(Ordering::Relaxed), self.pass_limit)
    }

    /// Seconds that the rest will take at the pace so far; unknown before the first pass.
    pub(super) fn seconds_left(&self) -> Option<f64> {
        let (done, all) = self.passes();
        let remaining = f64::from(all.saturating_sub(done));
        (done > 0).then(|| self.since.elapsed().as_secs_f64() * remaining / f64::from(done))
    }

    pub(super) fn poll(&self) -> TaskState<Result<StillReport, RendererError>> {
        self.task.poll()
    }
}
