//! The develop thread: from the newest film to the newest picture.

use std::sync::Arc;

use super::{Picture, Shared, lock};

/// Develops every negative that is posted until the session closes.
pub(super) fn run(shared: &Shared) {
    let mut serial = 0;
    while let Some(negative) = shared.negatives.wait() {
        serial += 1;
        let rgba8 = negative.image.develop_rgba8(&negative.display);
        let picture = Picture { size: negative.image.size, rgba8, serial };
        *lock(&shared.picture) = Some(Arc::new(picture));
        (shared.on_update)();
    }
}
