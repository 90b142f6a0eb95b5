//! The threads of a session, from their start to their end.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use super::bell::Urgency;
use super::shared::{Shared, lock};
use super::{GraphicsState, RenderRequest, develop_thread, read_thread, render_thread};
use crate::error::RendererError;
use crate::film::Region;
use crate::tracer::{CpuTracer, DEVICE_PANICKED, Device};

/// Longest wait for shaders that are still being compiled when the session ends. A process that
/// ends while a driver compiles may crash in it, but nobody wants to wait for long.
const COMPILER_PATIENCE: Duration = Duration::from_secs(3);
const COMPILER_POLL: Duration = Duration::from_millis(5);

/// The threads behind a session; they end when this is dropped.
pub(super) struct Threads<D: Device> {
    pub(super) shared: Arc<Shared<D>>,
    workers: Vec<JoinHandle<()>>,
    compilers: Vec<JoinHandle<()>>,
}

impl<D: Device> Threads<D> {
    /// Starts the render, the develop and the read thread.
    ///
    /// # Errors
    /// The system refuses the threads.
    pub(super) fn start(
        cpu: CpuTracer,
        on_update: impl Fn() + Send + Sync + 'static,
    ) -> Result<Self, RendererError> {
        let shared = Arc::new(Shared::new(on_update));
        let mut threads = Self { shared, workers: Vec::new(), compilers: Vec::new() };
        let [render, develop, read] = [(); 3].map(|()| Arc::clone(&threads.shared));
        threads.workers.push(spawn("render", move || render_thread::run(&render, cpu))?);
        threads.workers.push(spawn("develop", move || develop_thread::run(&develop))?);
        threads.workers.push(spawn("read", move || read_thread::run(&read))?);
        Ok(threads)
    }

    /// Asks for `request`; work in progress is dropped for it where `is_urgent`.
    pub(super) fn ask(&mut self, request: RenderRequest, is_urgent: bool) {
        *lock(&self.shared.request) = Some(request);
        self.prepare();
        self.shared.to_trace.ring(if is_urgent { Urgency::Wish } else { Urgency::None });
    }

    /// Reads the spectrum of `region` from now on. No work is dropped for that.
    pub(super) fn watch(&mut self, region: Option<Region>) {
        let mut watch = lock(&self.shared.watch);
        let is_other = watch.set(region);
        let unread = if region.is_none() { watch.keep(None) } else { None };
        drop(watch);
        drop(unread);
        if is_other && region.is_some() {
            self.shared.to_trace.ring(Urgency::None);
            self.shared.to_read.ring(Urgency::None);
        }
    }

    /// Lets requests be traced on `device`.
    pub(super) fn offer(&mut self, device: D) {
        let replaces = lock(&self.shared.graphics).state() != GraphicsState::Absent;
        if self.shared.offer(device) {
            self.prepare();
            if replaces {
                self.shared.to_trace.ring(Urgency::Command);
            }
        }
    }

    /// Gives a device that failed, or could not take on a request, another chance.
    pub(super) fn retry(&mut self) {
        if lock(&self.shared.graphics).retry() {
            self.prepare();
            self.shared.to_trace.ring(Urgency::Command);
        }
    }

    /// Begins to compile the shaders if the newest request calls for a device that waits for them.
    fn prepare(&mut self) {
        let Some(backend) = lock(&self.shared.request).as_ref().map(|request| request.backend)
        else {
            return;
        };
        let Some((device, number)) = lock(&self.shared.graphics).take_to_prepare(backend) else {
            return;
        };
        let shared = Arc::clone(&self.shared);
        match spawn("compile shaders", move || compile(&shared, &device, number)) {
            Ok(compiler) => {
                self.compilers.retain(|compiler| !compiler.is_finished());
                self.compilers.push(compiler);
            }
            Err(error) => {
                self.shared.give_up(number, error.to_string());
            }
        }
    }
}

/// Compiles the shaders for `device`, and has the newest request traced there if it calls for it.
fn compile<D: Device>(shared: &Shared<D>, device: &D, number: u64) {
    let prepared = catch_unwind(AssertUnwindSafe(|| device.prepare()))
        .unwrap_or_else(|_| Err(RendererError::Graphics(DEVICE_PANICKED.to_owned())));
    lock(&shared.graphics).finish_preparing(number, prepared);
    if shared.to_trace.is_closed() {
        return;
    }
    let request = lock(&shared.request).clone();
    if request.is_some_and(|request| lock(&shared.graphics).tracer_for(&request).is_some()) {
        shared.to_trace.ring(Urgency::Command);
    }
    shared.announce();
}

impl<D: Device> Drop for Threads<D> {
    fn drop(&mut self) {
        self.shared.to_trace.close();
        self.shared.to_develop.close();
        self.shared.to_read.close();
        let deadline = Instant::now() + COMPILER_PATIENCE;
        while self.compilers.iter().any(|compiler| !compiler.is_finished())
            && Instant::now() < deadline
        {
            std::thread::sleep(COMPILER_POLL);
        }
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
