//! Where a tracer works: what it keeps from one request to the next, and how it fails.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use super::RenderRequest;
use super::bell::Generation;
use super::graphics::Refusal;
use super::job::Job;
use super::shared::Shared;
use crate::error::RendererError;
use crate::scheduler::{Machine, Scheduler};
use crate::spectrum::Bins;
use crate::tracer::{DEVICE_PANICKED, Device, Tracer};

/// What the user reads where a tracer has panicked.
const PANICKED: &str = "the tracer failed on this scene, which is a fault of the program; \
    change a setting to try again, and please report it with the scene file";

/// Why a request was not served.
pub(super) enum Fault {
    /// It makes no sense to any tracer.
    Request(RendererError),
    /// The device works, but this is too much for it.
    Refused(Refusal, String),
    /// The device failed.
    Device(String),
}

impl Fault {
    /// What an error that did not come of the size of things means.
    pub(super) fn new(error: RendererError) -> Self {
        match error {
            RendererError::Graphics(reason) => Self::Device(reason),
            error => Self::Request(error),
        }
    }

    /// What an error means that came when `wanted` was brought to where `tracer` works, or exposed
    /// there. A device that can't do that with a film of one pixel either has failed.
    pub(super) fn of_size<T: Tracer>(
        error: RendererError,
        wanted: Refusal,
        tracer: &T,
        bins: Bins,
    ) -> Self {
        match Self::new(error) {
            Self::Device(reason) if has_room_for_a_pixel(tracer, bins) => {
                Self::Refused(wanted, reason)
            }
            fault => fault,
        }
    }

    /// What happened, in words for the user.
    pub(super) fn text(self) -> String {
        match self {
            Self::Request(error) => error.to_string(),
            Self::Refused(_, reason) | Self::Device(reason) => reason,
        }
    }
}

fn has_room_for_a_pixel<T: Tracer>(tracer: &T, bins: Bins) -> bool {
    tracer.film([1, 1], bins, None).and_then(|film| tracer.expose(&film)).is_ok()
}

/// A tracer with its measured costs, its scene and its films.
pub(super) struct Workplace<T: Tracer> {
    tracer: Arc<T>,
    /// Number of the device that it works on; none for the processor.
    device: Option<u64>,
    scheduler: Scheduler,
    job: Option<Job<T>>,
}

impl<T: Tracer> Workplace<T> {
    pub(super) fn new(tracer: Arc<T>, device: Option<u64>) -> Self {
        let scheduler = Scheduler::new(Machine::from(&tracer.name()));
        Self { tracer, device, scheduler, job: None }
    }

    /// Whether this is on the device of that number.
    pub(super) fn is_of(&self, number: u64) -> bool {
        self.device == Some(number)
    }

    /// Drops scene and films, and keeps what was learnt of costs.
    pub(super) fn clear(&mut self) {
        self.job = None;
    }

    /// Traces `request` until it is done or the bell rings.
    pub(super) fn serve<D: Device>(
        &mut self,
        shared: &Shared<D>,
        request: RenderRequest,
        generation: Generation,
    ) -> Result<(), Fault> {
        let previous = self.job.take();
        if previous.as_ref().is_some_and(|job| job.has_film_of(&request)) {
            self.scheduler.limit_passes(request.pass_limit);
        } else {
            self.scheduler.restart(request.size, request.pass_limit);
        }
        self.scheduler.aim_at(request.noise);
        // A bug in the tracer must not leave the window waiting for ever.
        let served = catch_unwind(AssertUnwindSafe(|| {
            let mut job = Job::new(&*self.tracer, request, previous)?;
            job.serve(shared, &*self.tracer, self.device, &mut self.scheduler, generation)?;
            Ok(job)
        }));
        match served {
            Ok(Ok(job)) => {
                self.job = Some(job);
                Ok(())
            }
            Ok(Err(fault)) => Err(fault),
            Err(_) if self.device.is_some() => Err(Fault::Device(DEVICE_PANICKED.to_owned())),
            Err(_) => Err(Fault::Request(RendererError::Invalid(PANICKED.to_owned()))),
        }
    }
}
