//! The render thread: has the newest request traced on the device or on the processor.

use std::sync::Arc;

use super::bell::Generation;
use super::graphics::ReadyTracer;
use super::shared::{Shared, lock};
use super::workplace::{Fault, Workplace};
use super::{Activity, Progress, RenderRequest};
use crate::tracer::{CpuTracer, Device};

/// Serves requests until the session closes.
pub(super) fn run<D: Device>(shared: &Shared<D>, cpu: CpuTracer) {
    let mut cpu = Workplace::new(Arc::new(cpu), None);
    let mut gpu = None;
    while let Some(generation) = shared.to_trace.wait() {
        let Some(request) = lock(&shared.request).clone() else { continue };
        let ready = lock(&shared.graphics).tracer_for(&request);
        if let Some(ready) = ready {
            cpu.clear();
            if serve_on_device(shared, &mut gpu, ready, &request, generation) {
                continue;
            }
        }
        // Before the processor fills the memory that scene and film take there.
        gpu = None;
        if let Err(fault) = cpu.serve(shared, request, generation) {
            publish_failure(shared, fault.text());
        }
    }
}

/// Serves a request on the device; false where the processor has to take over.
fn serve_on_device<D: Device>(
    shared: &Shared<D>,
    workplace: &mut Option<Workplace<D::Tracer>>,
    ready: ReadyTracer<D::Tracer>,
    request: &RenderRequest,
    generation: Generation,
) -> bool {
    let ReadyTracer { tracer, number } = ready;
    let mut current = workplace
        .take()
        .filter(|workplace| workplace.is_of(number))
        .unwrap_or_else(|| Workplace::new(tracer, Some(number)));
    match current.serve(shared, request.clone(), generation) {
        Ok(()) => *workplace = Some(current),
        Err(Fault::Request(error)) => {
            *workplace = Some(current);
            publish_failure(shared, error.to_string());
        }
        Err(Fault::Refused(refusal, reason)) => {
            lock(&shared.graphics).refuse(number, refusal, &reason);
            shared.announce();
            return false;
        }
        Err(Fault::Device(reason)) => {
            shared.give_up(number, reason);
            return false;
        }
    }
    true
}

fn publish_failure<D: Device>(shared: &Shared<D>, error: String) {
    // There is no film to be read any more.
    let unread = lock(&shared.watch).keep(None);
    drop(unread);
    shared.publish(Progress {
        activity: Activity::Failed,
        error: Some(error),
        ..Progress::default()
    });
}
