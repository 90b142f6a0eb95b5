//! The develop thread: from the newest film to the newest picture.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use super::Picture;
use super::shared::{Shared, lock};
use crate::tracer::Device;

/// What the user reads where developing has panicked.
const PANICKED: &str = "the picture could not be developed, which is a fault of the program; \
    please report it with the scene file";

/// Develops the newest image by the newest settings whenever either changes, until the session
/// closes.
pub(super) fn run<D: Device>(shared: &Shared<D>) {
    let mut serial = 0;
    while shared.to_develop.wait().is_some() {
        // Read here and not by who rang: what is read last is newest.
        let exposed = lock(&shared.image).as_ref().map(Arc::clone);
        let display = lock(&shared.display).clone();
        let Some(exposed) = exposed else { continue };
        let developed = catch_unwind(AssertUnwindSafe(|| exposed.image.develop(&display)));
        let reason = match developed {
            Ok(Ok(pixels)) => {
                serial += 1;
                let picture = Picture { size: exposed.image.size(), pixels, serial };
                shared.show(picture, exposed.device);
                continue;
            }
            Ok(Err(error)) => error.to_string(),
            Err(_) => PANICKED.to_owned(),
        };
        match exposed.device {
            // The film is on a device that failed: the request has to be traced again.
            Some(number) if shared.give_up(number, reason.clone()) => {
                shared.to_trace.ring_urgently();
            }
            _ => log::error!("no picture: {reason}"),
        }
    }
}
