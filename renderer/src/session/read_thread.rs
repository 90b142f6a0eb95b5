//! The read thread: reads another region of a film that is just being worked on, from its copy.

use super::shared::{Shared, lock};
use crate::tracer::Device;

/// Reads what is watched from the copy whenever that is rung for, until the session closes.
pub(super) fn run<D: Device>(shared: &Shared<D>) {
    while shared.to_read.wait().is_some() {
        let watch = lock(&shared.watch);
        let (watched, copy) = (watch.watched(), watch.copy().cloned());
        drop(watch);
        if let (Some((region, number)), Some(copy)) = (watched, copy) {
            let reading = copy.read(region);
            lock(&shared.watch).take_first(number, reading);
            shared.announce();
        }
    }
}
