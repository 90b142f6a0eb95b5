//! What the threads of a session share. Every lock but one is held for moments only: never while
//! shaders are compiled, rays traced or pixels developed.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::bell::Bell;
use super::graphics::GraphicsSlot;
use super::reading::Watch;
use super::{Picture, Progress, RenderRequest};
use crate::develop::{LatentImage, Pixels, Shown};
use crate::settings::DisplaySettings;
use crate::tracer::Device;

/// What the threads share. A poisoned lock still holds a whole value, so poison is ignored.
///
/// The graphics are locked before image and picture where both are needed.
pub(super) struct Shared<D: Device> {
    pub(super) request: Mutex<Option<RenderRequest>>,
    /// Says that the request or the graphics are new.
    pub(super) to_trace: Bell,
    pub(super) graphics: Mutex<GraphicsSlot<D>>,
    pub(super) image: Mutex<Option<Arc<Exposed>>>,
    pub(super) display: Mutex<DisplaySettings>,
    /// What pictures show of the film.
    pub(super) shown: Mutex<Shown>,
    /// Says that there is something new to develop.
    pub(super) to_develop: Bell,
    pub(super) picture: Mutex<Option<Arc<Picture>>>,
    /// Serial of the picture developed last; locked before all others, and while one is developed.
    pub(super) last_serial: Mutex<u64>,
    pub(super) progress: Mutex<Progress>,
    pub(super) watch: Mutex<Watch>,
    /// Says that another region is watched than the render thread knows of.
    pub(super) to_read: Bell,
    on_update: Box<dyn Fn() + Send + Sync>,
}

/// An image, and the number of the device it is on; none for the processor.
pub(super) struct Exposed {
    pub(super) image: LatentImage,
    pub(super) device: Option<u64>,
}

impl<D: Device> Shared<D> {
    pub(super) fn new(on_update: impl Fn() + Send + Sync + 'static) -> Self {
        Self {
            request: Mutex::new(None),
            to_trace: Bell::new(),
            graphics: Mutex::new(GraphicsSlot::new()),
            image: Mutex::new(None),
            display: Mutex::new(DisplaySettings::default()),
            shown: Mutex::new(Shown::default()),
            to_develop: Bell::new(),
            picture: Mutex::new(None),
            last_serial: Mutex::new(0),
            progress: Mutex::new(Progress::default()),
            watch: Mutex::new(Watch::default()),
            to_read: Bell::new(),
            on_update: Box::new(on_update),
        }
    }

    /// Tells the window that there is news.
    pub(super) fn announce(&self) {
        (self.on_update)();
    }

    pub(super) fn publish(&self, progress: Progress) {
        *lock(&self.progress) = progress;
        self.announce();
    }

    /// Makes an image the one to be developed, unless its device has been given up.
    pub(super) fn expose(&self, exposed: Exposed) {
        let graphics = lock(&self.graphics);
        if exposed.device.is_some_and(|number| !graphics.is_current(number)) {
            return;
        }
        let old = lock(&self.image).replace(Arc::new(exposed));
        drop(graphics);
        drop(old);
    }

    /// Shows a picture, unless its device has been given up.
    pub(super) fn show(&self, picture: Picture, device: Option<u64>) {
        let graphics = lock(&self.graphics);
        if device.is_some_and(|number| !graphics.is_current(number)) {
            return;
        }
        let old = lock(&self.picture).replace(Arc::new(picture));
        drop(graphics);
        drop(old);
        self.announce();
    }

    /// Takes over another device; false where it is the one that is there already.
    pub(super) fn offer(&self, device: D) -> bool {
        let mut graphics = lock(&self.graphics);
        if !graphics.offer(device) {
            return false;
        }
        self.forget_image();
        // A texture can't be shown by any device but its own.
        let mut picture = lock(&self.picture);
        if picture.as_ref().is_some_and(|old| matches!(old.pixels, Pixels::Texture(_))) {
            *picture = None;
        }
        true
    }

    /// Gives up the device of this number, and with it what is developed there; false where that
    /// was done already.
    pub(super) fn give_up(&self, number: u64, reason: String) -> bool {
        let mut graphics = lock(&self.graphics);
        let is_news = graphics.fail(number, reason);
        if is_news {
            self.forget_image();
        }
        drop(graphics);
        if is_news {
            self.announce();
        }
        is_news
    }

    /// Forgets an image that is on a device.
    fn forget_image(&self) {
        let mut image = lock(&self.image);
        if image.as_ref().is_some_and(|exposed| exposed.device.is_some()) {
            *image = None;
        }
    }
}

pub(super) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
