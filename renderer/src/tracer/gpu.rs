//! The GPU tracer: many walkers, each at one camera ray's tree, in dispatches of bounded time.

mod film;
mod pace;
mod pipeline;
mod progress;
mod rounds;
mod scene;
mod walkers;

use std::sync::{Mutex, MutexGuard, PoisonError};

pub use film::GpuFilm;
pub use scene::GpuScene;

use self::pipeline::WalkPipeline;
use self::rounds::{Dispatcher, Order};
use self::walkers::Walkers;
use super::{Tracer, TracerName, View, rules};
use crate::develop::{GpuDeveloper, LatentImage};
use crate::error::RendererError;
use crate::film::{Film, PixelRect};
use crate::gpu::Graphics;
use crate::packed::PackedScene;
use crate::settings::{NoiseGoal, Splitting, TraceSettings};
use crate::spectrum::Bins;
use crate::statistics::Statistics;

/// Traces on a graphics device.
pub struct GpuTracer {
    graphics: Graphics,
    pipeline: WalkPipeline,
    developer: GpuDeveloper,
    dispatcher: Mutex<Dispatcher>,
}

impl GpuTracer {
    /// Compiles the shaders for a device, which takes up to some seconds: those of the default
    /// splitting. Those of another one are compiled when it is first asked for.
    ///
    /// # Errors
    /// The device lacks something that tracing needs, or fails.
    pub fn new(graphics: &Graphics) -> Result<Self, RendererError> {
        let pipeline = WalkPipeline::new(graphics)?;
        pipeline.of(graphics, Splitting::default())?;
        let developer = GpuDeveloper::new(graphics)?;
        Self::with(graphics, pipeline, developer)
    }

    /// A second tracer on the same device, which can trace at the same time. It has walkers of its
    /// own and shares the compiled shaders.
    ///
    /// # Errors
    /// The device's memory is full, or it fails.
    pub fn sibling(&self) -> Result<Self, RendererError> {
        Self::with(&self.graphics, self.pipeline.clone(), self.developer.clone())
    }

    /// For tests: several rounds in one call, of at most `items` camera rays where these are more
    /// than one pass.
    #[doc(hidden)]
    pub fn limit_rounds(&self, items: u32) {
        self.dispatcher().limit_rounds(items);
    }

    /// The device that it traces on.
    pub fn graphics(&self) -> &Graphics {
        &self.graphics
    }

    fn with(
        graphics: &Graphics,
        pipeline: WalkPipeline,
        developer: GpuDeveloper,
    ) -> Result<Self, RendererError> {
        let walkers = Walkers::new(graphics, &pipeline)?;
        let dispatcher = Mutex::new(Dispatcher::new(walkers, graphics.is_software()));
        Ok(Self { graphics: graphics.clone(), pipeline, developer, dispatcher })
    }

    /// What the walkers were at when a trace failed is forgotten by the next one.
    fn dispatcher(&self) -> MutexGuard<'_, Dispatcher> {
        self.dispatcher.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Tracer for GpuTracer {
    type Scene = GpuScene;
    type Film = GpuFilm;

    fn name(&self) -> TracerName {
        TracerName::Gpu {
            device: self.graphics.name().to_owned(),
            is_software: self.graphics.is_software(),
        }
    }

    fn load(&self, scene: PackedScene) -> Result<GpuScene, RendererError> {
        GpuScene::new(&self.graphics, &self.pipeline, &scene)
    }

    fn film(
        &self,
        size: [u32; 2],
        bins: Bins,
        used: Option<GpuFilm>,
    ) -> Result<GpuFilm, RendererError> {
        GpuFilm::new(&self.graphics, size, bins, used)
    }

    fn trace(
        &self,
        scene: &GpuScene,
        view: &View,
        settings: &TraceSettings,
        film: &mut GpuFilm,
        passes: u32,
        is_cancelled: &(dyn Fn() -> bool + Sync),
    ) -> Result<Statistics, RendererError> {
        if scene.bins != film.bins() {
            return Err(RendererError::Invalid(format!(
                "a scene packed for {} bins can't be traced on a film of {}",
                scene.bins.count(),
                film.bins().count()
            )));
        }
        let frame = scene.frame.seen(&view.frame, film.size(), rules(view, settings));
        let (graphics, pipeline, splitting) = (&self.graphics, &self.pipeline, settings.splitting);
        let kernel = pipeline.of(graphics, splitting)?;
        let order = Order { graphics, pipeline, kernel, splitting, scene, is_cancelled };
        let statistics = self.dispatcher().trace(order, film, frame, passes)?;
        film.complete_passes(passes);
        Ok(statistics)
    }

    fn expose(&self, film: &GpuFilm) -> Result<LatentImage, RendererError> {
        let (size, bins) = (film.size(), film.bins());
        let (light, counts) = self.developer.expose(size, bins, film.bands())?;
        Ok(LatentImage::Graphics { light, counts })
    }

    fn mean_spectrum(&self, film: &GpuFilm, rect: PixelRect) -> Result<Vec<f32>, RendererError> {
        self.developer.mean_spectrum(film.size(), film.bins(), film.bands(), rect)
    }

    fn measure_noise(&self, film: &mut GpuFilm, goal: NoiseGoal) -> Result<f32, RendererError> {
        self.developer.measure_noise(film.size(), film.bins(), film.bands(), goal)
    }

    fn copy_means(&self, _film: &GpuFilm) -> Option<Vec<f32>> {
        None
    }

    fn read(&self, film: GpuFilm) -> Result<Film, RendererError> {
        film.read(&self.graphics)
    }
}
