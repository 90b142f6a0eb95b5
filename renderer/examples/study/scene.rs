//! What the study looks at.

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use brilliance_renderer::camera::Camera;
use brilliance_renderer::error::RendererError;
use brilliance_renderer::scene_file::{self, Document};
use brilliance_renderer::session::RenderRequest;
use brilliance_renderer::settings::{NoiseGoal, TraceSettings};
use brilliance_renderer::still::{Still, StillLimits};
use brilliance_renderer::tracer::Backend;
use glam::Vec3;

/// Passes of each picture: the edges are smooth, and what is left of the error does not average out.
const PASSES: u32 = 4;

/// A part of a scene, near enough to see single pixels.
pub(crate) struct StudyScene {
    pub(crate) name: &'static str,
    pub(crate) file_name: &'static str,
    pub(crate) document: Document,
    size: [u32; 2],
}

/// The lamp that is drawn out by a prism, where every step of the splitting is seen, and a brilliant
/// under small lamps, where rays fork a hundred times.
pub(crate) fn all() -> Result<Vec<StudyScene>, RendererError> {
    Ok(vec![
        StudyScene::new("Prism", "prism", [40, 120], Vec3::new(0.0, 0.0, -5.9), 9.0)?,
        StudyScene::new("Brilliant", "brilliant", [100, 100], Vec3::new(0.0, -0.3, 0.0), 6.0)?,
    ])
}

impl StudyScene {
    /// A scene that ships, seen from where it wants to be seen, but towards `target` (in mm).
    fn new(
        name: &'static str,
        file_name: &'static str,
        size: [u32; 2],
        target: Vec3,
        fov_y_degrees: f32,
    ) -> Result<Self, RendererError> {
        let scene = scene_file::scenes().iter().find(|scene| scene.name == name);
        let scene = scene.ok_or_else(|| {
            RendererError::Invalid(format!("{name}: no scene of this name ships any more"))
        })?;
        let mut document = Document::from_toml(scene.text, Path::new(""))?;
        // Its sampled light would differ by more than the settings do.
        document.scene.ground = None;
        let camera = document.scene.camera;
        document.scene.camera =
            Camera { target, fov_y_radians: fov_y_degrees.to_radians(), ..camera };
        Ok(Self { name, file_name, document, size })
    }

    /// A picture by these settings, of the same camera rays for all of them.
    pub(crate) fn trace(&self, settings: &TraceSettings) -> Result<Still, RendererError> {
        let request = RenderRequest {
            scene: Arc::new(self.document.scene.clone()),
            camera: self.document.scene.camera,
            size: self.size,
            trace: settings.clone(),
            pass_limit: PASSES,
            noise: NoiseGoal::NONE,
            backend: Backend::Cpu,
        };
        Still::render(&request, StillLimits::default(), None, &AtomicBool::new(false), |_, _| {})
    }
}
