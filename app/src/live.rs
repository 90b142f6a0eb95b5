//! The live picture: what is asked of the renderer's session, from before there is a window.

use std::sync::Arc;

use brilliance_renderer::camera::Camera;
use brilliance_renderer::develop::Shown;
use brilliance_renderer::error::RendererError;
use brilliance_renderer::film::Region;
use brilliance_renderer::gpu::Graphics;
use brilliance_renderer::scene::Scene;
use brilliance_renderer::scene_file::Document;
use brilliance_renderer::session::{RenderRequest, Session};
use brilliance_renderer::tracer::Backend;

use crate::waker::Waker;

/// A session, the tracer that it should use, and the window that it wakes.
pub struct Live {
    session: Session,
    backend: Backend,
    waker: Waker,
}

impl Live {
    /// A session that was asked for nothing yet and should trace by `backend`.
    ///
    /// # Errors
    /// The system gives the session no threads.
    pub fn new(backend: Backend) -> Result<Self, RendererError> {
        let waker = Waker::default();
        let bell = waker.clone();
        let session = Session::new(move || bell.request_repaint())?;
        Ok(Self { session, backend, waker })
    }

    /// What wakes the window when there is a new picture or new progress.
    pub fn waker(&self) -> &Waker {
        &self.waker
    }

    /// Which tracer is asked for.
    pub fn backend(&self) -> Backend {
        self.backend
    }

    /// Asks for another tracer from the next request on.
    pub fn set_backend(&mut self, backend: Backend) {
        self.backend = backend;
    }

    /// Shows this of what was traced from now on.
    pub fn show(&mut self, shown: Shown) {
        self.session.show(shown);
    }

    /// Lets the session trace on the window's graphics device.
    pub fn offer_graphics(&mut self, graphics: Graphics) {
        self.session.offer_graphics(graphics);
    }

    /// Gives a graphics device that has failed another chance.
    pub fn retry_graphics(&mut self) {
        self.session.retry_graphics();
    }

    /// Asks for `scene`, which is the document's, seen by `camera` at `size` in pixels. Returns
    /// at once; nothing happens if that was asked before.
    pub fn ask(&mut self, document: &Document, scene: &Arc<Scene>, camera: Camera, size: [u32; 2]) {
        self.session.request(RenderRequest {
            scene: Arc::clone(scene),
            camera,
            size,
            trace: document.trace.clone(),
            pass_limit: document.still.passes,
            noise: document.still.noise,
            backend: self.backend,
        });
        self.session.display(document.display.clone());
    }

    /// Has the spectrum of this part of the picture read.
    pub fn watch(&mut self, region: Option<Region>) {
        self.session.watch(region);
    }

    /// The renderer's session.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// What the session was last asked for.
    pub fn request(&self) -> Option<&RenderRequest> {
        self.session.last_request()
    }
}
