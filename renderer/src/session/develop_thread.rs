//! The develop thread: from the newest film to the newest picture.

use std::sync::Arc;

use super::{Picture, Shared, lock};

/// Develops the newest image by the newest settings whenever either changes, until the session
/// closes.
pub(super) fn run(shared: &Shared) {
    let mut serial = 0;
    while shared.to_develop.wait().is_some() {
        // Read here and not by who posted: what is read last is newest.
        let image = lock(&shared.image).clone();
        let display = lock(&shared.display).clone();
        let Some(image) = image else { continue };
        serial += 1;
        let Ok(pixels) = image.develop(&display) else { continue };
        *lock(&shared.picture) = Some(Arc::new(Picture { size: image.size(), pixels, serial }));
        (shared.on_update)();
    }
}
