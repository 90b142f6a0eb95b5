//! The develop thread: shows the newest film by new settings; and how a film is shown.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use super::Picture;
use super::bell::Urgency;
use super::shared::{Shared, lock};
use crate::tracer::Device;

/// What the user reads where developing has panicked.
const PANICKED: &str = "the picture could not be developed, which is a fault of the program; \
    please report it with the scene file";

/// Develops the newest image whenever that is rung for, until the session closes.
pub(super) fn run<D: Device>(shared: &Shared<D>) {
    while shared.to_develop.wait().is_some() {
        develop(shared);
    }
}

/// Develops the newest image by the newest settings.
pub(super) fn develop<D: Device>(shared: &Shared<D>) {
    // One at a time: what is read below by the last to come is newest, and is shown last.
    let mut last_serial = lock(&shared.last_serial);
    let exposed = lock(&shared.image).as_ref().map(Arc::clone);
    let (display, shown) = (lock(&shared.display).clone(), *lock(&shared.shown));
    let Some(exposed) = exposed else { return };
    let developed = catch_unwind(AssertUnwindSafe(|| exposed.image.develop(&display, shown)));
    let reason = match developed {
        Ok(Ok(pixels)) => {
            *last_serial += 1;
            let (size, serial) = (exposed.image.size(), *last_serial);
            let picture = Picture { size, pixels, shown, serial };
            return shared.show(picture, exposed.device);
        }
        Ok(Err(error)) => error.to_string(),
        Err(_) => PANICKED.to_owned(),
    };
    match exposed.device {
        // The film is on a device that failed: the request has to be traced again.
        Some(number) if shared.give_up(number, reason.clone()) => {
            shared.to_trace.ring(Urgency::Command);
        }
        _ => log::error!("no picture: {reason}"),
    }
}
