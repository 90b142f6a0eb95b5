//! Stills end when they are told to.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use brilliance_renderer::error::RendererError;
use brilliance_renderer::still::{Still, StillLimits};

use crate::watched::request;

#[test]
fn a_cancelled_still_ends_at_once_with_its_error() {
    let cancel = AtomicBool::new(false);
    let request = request([64, 64], 1_000_000);
    let result = Still::render(&request, StillLimits::default(), None, &cancel, |passes, _| {
        if passes == 2 {
            cancel.store(true, Ordering::Relaxed);
        }
    });
    assert!(matches!(result, Err(RendererError::Cancelled)));
}

#[test]
fn a_still_stops_at_its_time_after_whole_passes() {
    let limits = StillLimits { time: Some(Duration::ZERO), threads: 1 };
    let cancel = AtomicBool::new(false);
    let still =
        Still::render(&request([16, 16], 9), limits, None, &cancel, |_, _| {}).expect("renders");
    assert_eq!(still.passes, 1);
    assert_eq!(still.film.passes(), 1);
}
