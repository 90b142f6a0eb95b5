//! The live picture: what is asked of the renderer's session, from before there is a window.

use std::sync::{Arc, OnceLock};

use brilliance_renderer::camera::Camera;
use brilliance_renderer::error::RendererError;
use brilliance_renderer::scene::Scene;
use brilliance_renderer::scene_file::Document;
use brilliance_renderer::session::{RenderRequest, Session};
use brilliance_renderer::tracer::Backend;
use eframe::egui;

/// A session, and the window that it wakes.
pub struct Live {
    session: Session,
    /// The window to wake for news, once there is one.
    window: Arc<OnceLock<egui::Context>>,
}

impl Live {
    /// A session that was asked for nothing yet.
    ///
    /// # Errors
    /// The system gives the session no threads.
    pub fn new() -> Result<Self, RendererError> {
        let window = Arc::<OnceLock<egui::Context>>::default();
        let waker = Arc::clone(&window);
        let session = Session::new(move || {
            if let Some(ctx) = waker.get() {
                ctx.request_repaint();
            }
        })?;
        Ok(Self { session, window })
    }

    /// Repaints the window of `ctx` from now on when there is a new picture or new progress.
    pub fn wake(&self, ctx: &egui::Context) {
        // There is one window; a second call would change nothing.
        let _ = self.window.set(ctx.clone());
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
            backend: Backend::Auto,
        });
        self.session.display(document.display.clone());
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
