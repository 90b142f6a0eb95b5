//! The graphics device of a session: from the offer over the shaders to its failure.

use std::sync::Arc;

use super::RenderRequest;
use crate::error::RendererError;
use crate::scene::Scene;
use crate::tracer::{Backend, Device};

/// How the session and the graphics device get on.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum GraphicsState {
    /// No device was offered.
    #[default]
    Absent,
    /// A device was offered that no request has called for yet.
    Offered,
    /// The shaders are being compiled.
    Preparing,
    /// The device traces whatever is asked of it.
    Ready,
    /// The device failed, and is asked no more; the text says why.
    Failed(String),
}

/// Why the processor took over, in words for the user.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GraphicsFailure {
    /// Counts up with every failure that was not told before.
    pub serial: u64,
    /// What failed.
    pub reason: String,
}

/// What a device that works could not take on.
pub(super) enum Refusal {
    /// This scene, with films of so many bins.
    Scene(Arc<Scene>, u32),
    /// A film of this width and height, with so many bins.
    Film([u32; 2], u32),
}

impl Refusal {
    pub(super) fn covers(&self, request: &RenderRequest) -> bool {
        let [width, height] = request.size;
        match self {
            Self::Scene(scene, bins) => request.trace.bins == *bins && request.shows(scene),
            Self::Film(size, bins) => {
                width >= size[0] && height >= size[1] && request.trace.bins >= *bins
            }
        }
    }
}

/// A tracer that is ready, and the number that its films and failures are known by.
pub(super) struct ReadyTracer<T> {
    pub(super) tracer: Arc<T>,
    pub(super) number: u64,
}

/// The device that was offered, and what has become of it.
pub(super) struct GraphicsSlot<D: Device> {
    device: Option<D>,
    stage: Stage<D::Tracer>,
    /// Changes when a device comes or fails, so that what is late from an earlier one is known as
    /// such.
    number: u64,
    refusal: Option<Refusal>,
    failure: Option<GraphicsFailure>,
    /// Whether a failure for the same reason as the last is to be told again.
    forgets_failure: bool,
}

enum Stage<T> {
    Offered,
    Preparing,
    Ready(Arc<T>),
    Failed(String),
}

impl<D: Device> GraphicsSlot<D> {
    pub(super) fn new() -> Self {
        Self {
            device: None,
            stage: Stage::Offered,
            number: 0,
            refusal: None,
            failure: None,
            forgets_failure: false,
        }
    }

    /// Takes over `device`; false where it is the one that is there already.
    pub(super) fn offer(&mut self, device: D) -> bool {
        if self.device.as_ref().is_some_and(|old| old.is_same(&device)) {
            return false;
        }
        self.device = Some(device);
        self.begin_anew();
        true
    }

    /// Forgets what went wrong; false where nothing did.
    pub(super) fn retry(&mut self) -> bool {
        match self.stage {
            Stage::Failed(_) => self.begin_anew(),
            _ if self.refusal.is_some() => {
                self.refusal = None;
                self.forgets_failure = true;
            }
            _ => return false,
        }
        true
    }

    fn begin_anew(&mut self) {
        self.stage = Stage::Offered;
        self.number += 1;
        self.refusal = None;
        self.forgets_failure = true;
    }

    /// Whether the device of this number has neither failed nor been replaced.
    pub(super) fn is_current(&self, number: u64) -> bool {
        self.number == number
    }

    /// The device whose shaders are to be compiled now, if `backend` calls for that; its number
    /// goes with the answer.
    pub(super) fn take_to_prepare(&mut self, backend: Backend) -> Option<(D, u64)> {
        let device = self.device.as_ref()?;
        if !matches!(self.stage, Stage::Offered) || !backend.uses_device(device.is_software()) {
            return None;
        }
        self.stage = Stage::Preparing;
        Some((device.clone(), self.number))
    }

    /// Takes note of the compiled shaders, unless they are those of an earlier device.
    pub(super) fn finish_preparing(
        &mut self,
        number: u64,
        prepared: Result<D::Tracer, RendererError>,
    ) {
        if !self.is_current(number) {
            return;
        }
        match prepared {
            Ok(tracer) => self.stage = Stage::Ready(Arc::new(tracer)),
            Err(error) => {
                self.fail(number, error.to_string());
            }
        }
    }

    /// What traces `request` on the device; none where the processor should.
    pub(super) fn tracer_for(&self, request: &RenderRequest) -> Option<ReadyTracer<D::Tracer>> {
        let device = self.device.as_ref()?;
        let Stage::Ready(tracer) = &self.stage else { return None };
        let is_refused = self.refusal.as_ref().is_some_and(|refusal| refusal.covers(request));
        (request.backend.uses_device(device.is_software()) && !is_refused)
            .then(|| ReadyTracer { tracer: Arc::clone(tracer), number: self.number })
    }

    /// The tracer, if it is ready.
    pub(super) fn ready_tracer(&self) -> Option<Arc<D::Tracer>> {
        match &self.stage {
            Stage::Ready(tracer) => Some(Arc::clone(tracer)),
            Stage::Offered | Stage::Preparing | Stage::Failed(_) => None,
        }
    }

    /// Takes note that the device failed and must not be asked again; false where that is known,
    /// or is about an earlier device.
    pub(super) fn fail(&mut self, number: u64, reason: String) -> bool {
        if !self.is_current(number) {
            return false;
        }
        self.tell(&reason);
        self.stage = Stage::Failed(reason);
        self.number += 1;
        true
    }

    /// Takes note that the device works, but can't take on this.
    pub(super) fn refuse(&mut self, number: u64, refusal: Refusal, reason: &str) {
        if self.is_current(number) {
            self.tell(reason);
            self.refusal = Some(refusal);
        }
    }

    fn tell(&mut self, reason: &str) {
        let last = self.failure.as_ref();
        if self.forgets_failure || last.is_none_or(|last| last.reason != reason) {
            let serial = last.map_or(0, |last| last.serial) + 1;
            self.failure = Some(GraphicsFailure { serial, reason: reason.to_owned() });
        }
        self.forgets_failure = false;
    }

    pub(super) fn state(&self) -> GraphicsState {
        match &self.stage {
            _ if self.device.is_none() => GraphicsState::Absent,
            Stage::Offered => GraphicsState::Offered,
            Stage::Preparing => GraphicsState::Preparing,
            Stage::Ready(_) => GraphicsState::Ready,
            Stage::Failed(reason) => GraphicsState::Failed(reason.clone()),
        }
    }

    pub(super) fn failure(&self) -> Option<&GraphicsFailure> {
        self.failure.as_ref()
    }
}
