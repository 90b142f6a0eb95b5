//! From sliders to pixels: the newest request wins, the UI never waits.
//!
//! Two threads work behind a [`Session`]. The *render* thread takes the newest request, has pass
//! after pass traced and hands on the film as a [`LatentImage`](crate::develop::LatentImage); a
//! newer request stops it. The *develop* thread turns the newest image into a
//! [`Picture`] by the newest [`DisplaySettings`], so that exposure acts while a long pass is being
//! traced. What a graphics device has traced is developed there between two rounds, by the render
//! thread, which only has to say so; the develop thread then sees to new settings alone.
//!
//! While requests come faster than pictures, the first round after a restart is given a moment to
//! become one ([`Scheduler::PATIENCE_SECONDS`](crate::scheduler::Scheduler::PATIENCE_SECONDS)), so
//! that there is something to see while a hand drags.
//!
//! A graphics device that was [offered](Session::offer_graphics) traces what calls for it as soon
//! as a third thread has compiled its shaders, and until it fails; the processor traces the rest.

mod bell;
mod develop_thread;
mod graphics;
mod job;
mod progress;
mod read_thread;
mod reading;
mod render_thread;
mod request;
mod shared;
#[cfg(test)]
mod tests;
mod threads;
mod workplace;

use std::sync::Arc;

use crate::develop::Shown;
use crate::error::RendererError;
use crate::film::Region;
use crate::gpu::Graphics;
use crate::settings::DisplaySettings;
use crate::tracer::{CpuTracer, TracingDevice};
use bell::Urgency;
pub use graphics::{GraphicsFailure, GraphicsState};
pub use progress::{Activity, Picture, Progress};
pub use reading::Reading;
pub use request::RenderRequest;
use shared::lock;
use threads::Threads;

/// A render thread that serves the newest request, and a develop thread that shows it.
///
/// Nothing here waits for either, but for dropping: that waits for the pixels in progress, and for
/// up to three seconds where shaders are being compiled.
pub struct Session {
    running: Threads<Graphics>,
    graphics: Option<Graphics>,
    last_request: Option<RenderRequest>,
    requests_made: u64,
    threads: usize,
}

impl Session {
    /// Starts the threads. `on_update` is called from them whenever a new picture, new progress or
    /// a new state of the graphics can be read.
    ///
    /// # Errors
    /// The system refuses the threads.
    pub fn new(on_update: impl Fn() + Send + Sync + 'static) -> Result<Self, RendererError> {
        let cpu = CpuTracer::new(0)?;
        let threads = cpu.threads();
        let running = Threads::start(cpu, on_update)?;
        Ok(Self { running, graphics: None, last_request: None, requests_made: 0, threads })
    }

    /// Asks for a picture. Equal to the last request: nothing happens. Returns at once.
    pub fn request(&mut self, request: RenderRequest) {
        let last = self.last_request.as_ref();
        let carries_on = last.is_some_and(|last| last.makes_same_film(&request));
        let wants_as_much = |last: &RenderRequest| {
            last.pass_limit == request.pass_limit && last.noise == request.noise
        };
        if carries_on && last.is_some_and(wants_as_much) {
            return;
        }
        self.last_request = Some(request.clone());
        self.requests_made += 1;
        self.running.ask(request, !carries_on);
    }

    /// Develops the film with these settings from now on, without retracing. Returns at once.
    pub fn display(&mut self, settings: DisplaySettings) {
        let shared = &self.running.shared;
        let mut display = lock(&shared.display);
        if *display != settings {
            *display = settings;
            drop(display);
            shared.to_develop.ring(Urgency::None);
        }
    }

    /// Shows this of the film from now on, without retracing. Returns at once.
    pub fn show(&mut self, shown: Shown) {
        let shared = &self.running.shared;
        if std::mem::replace(&mut *lock(&shared.shown), shown) != shown {
            shared.to_develop.ring(Urgency::None);
        }
    }

    /// What is shown of the film, or will be with the next picture.
    pub fn shown(&self) -> Shown {
        *lock(&self.running.shared.shown)
    }

    /// Reads the spectrum of this region of the picture from now on: of the film as it was handed
    /// on last, and then with every state of it; None ends that. Nothing is traced for it. Returns
    /// at once.
    ///
    /// While a region is watched, and the processor's passes take long, a copy of the film is kept
    /// so that another region can be read during a pass.
    pub fn watch(&mut self, region: Option<Region>) {
        self.running.watch(region);
    }

    /// The newest reading while a region is watched: of that region, or of the one watched before
    /// where nothing was read since.
    pub fn reading(&self) -> Option<Arc<Reading>> {
        lock(&self.running.shared.watch).reading().cloned()
    }

    /// What was last asked for.
    pub fn last_request(&self) -> Option<&RenderRequest> {
        self.last_request.as_ref()
    }

    /// Number of different requests made so far.
    pub fn requests_made(&self) -> u64 {
        self.requests_made
    }

    /// Threads that trace on the processor.
    pub fn threads(&self) -> usize {
        self.threads
    }

    /// Lets the session trace on `graphics`, in place of any device offered before. Its shaders are
    /// compiled once a request calls for it, while the processor goes on tracing. Returns at once;
    /// nothing happens where the device is the one that was offered before.
    pub fn offer_graphics(&mut self, graphics: Graphics) {
        self.graphics = Some(graphics.clone());
        self.running.offer(graphics);
    }

    /// Gives a graphics device that has failed, or could not take on a scene, another chance.
    /// Returns at once.
    pub fn retry_graphics(&mut self) {
        self.running.retry();
    }

    /// How the session and the graphics device get on.
    pub fn graphics_state(&self) -> GraphicsState {
        lock(&self.running.shared.graphics).state()
    }

    /// Why the processor last took over from the graphics device, which may work by now. A serial
    /// that was not seen before is worth telling the user.
    pub fn graphics_failure(&self) -> Option<GraphicsFailure> {
        lock(&self.running.shared.graphics).failure().cloned()
    }

    /// The graphics device that was offered.
    pub fn graphics(&self) -> Option<&Graphics> {
        self.graphics.as_ref()
    }

    /// The graphics device that was offered, unless it has failed, with what was compiled for it.
    pub fn tracing_device(&self) -> Option<TracingDevice> {
        let slot = lock(&self.running.shared.graphics);
        if matches!(slot.state(), GraphicsState::Failed(_)) {
            return None;
        }
        let ready = slot.ready_tracer().map(TracingDevice::from);
        ready.or_else(|| self.graphics.clone().map(TracingDevice::from))
    }

    /// The newest picture.
    pub fn picture(&self) -> Option<Arc<Picture>> {
        lock(&self.running.shared.picture).clone()
    }

    /// Where the newest request stands.
    pub fn progress(&self) -> Progress {
        lock(&self.running.shared.progress).clone()
    }
}
