//! The GPU tracer: many walkers, each at one camera ray's tree, in dispatches of bounded time.

mod film;
mod frame;
mod pace;
mod pipeline;
mod progress;
mod rounds;
mod scene;
mod walkers;

use std::sync::{Mutex, PoisonError};

use bytemuck::Zeroable;

pub use film::GpuFilm;
pub use scene::GpuScene;

use self::frame::Frame;
use self::pace::Pace;
use self::pipeline::WalkPipeline;
use self::rounds::Work;
use self::walkers::Walkers;
use super::{Tracer, TracerName, View, rules};
use crate::develop::{GpuDeveloper, LatentImage};
use crate::error::RendererError;
use crate::film::Film;
use crate::gpu::Graphics;
use crate::packed::PackedScene;
use crate::settings::TraceSettings;
use crate::spectrum::Bins;
use crate::statistics::Statistics;

/// Traces on a graphics device.
pub struct GpuTracer {
    graphics: Graphics,
    pipeline: WalkPipeline,
    developer: GpuDeveloper,
    crew: Mutex<Crew>,
}

/// The walkers, and how fast they are.
struct Crew {
    walkers: Walkers,
    pace: Pace,
}

impl GpuTracer {
    /// Compiles the shaders for a device, which takes up to some seconds.
    ///
    /// # Errors
    /// The device lacks something that tracing needs, or fails.
    pub fn new(graphics: &Graphics) -> Result<Self, RendererError> {
        let pipeline = WalkPipeline::new(graphics)?;
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
        let pace = Pace::new(graphics.is_software());
        let crew = Mutex::new(Crew { walkers, pace });
        Ok(Self { graphics: graphics.clone(), pipeline, developer, crew })
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
        // What the walkers were at when a trace failed is forgotten by the next one.
        let mut crew = self.crew.lock().unwrap_or_else(PoisonError::into_inner);
        let Crew { walkers, pace } = &mut *crew;
        let [width, height] = film.size();
        let frame = Frame {
            position: view.frame.position,
            width,
            forward: view.frame.forward,
            height,
            right: view.frame.right,
            up: view.frame.up,
            rules: rules(view, settings),
            sky: scene.sky,
            ground: scene.ground,
            bin_count: scene.bins.count() as u32,
            bin_width_nm: scene.bins.width_nm(),
            disc_count: scene.disc_count,
            top_node_count: scene.top_node_count,
            walker_count: walkers.count(),
            ..Frame::zeroed()
        };
        let work = Work {
            graphics: &self.graphics,
            pipeline: &self.pipeline,
            walkers,
            scene,
            is_cancelled,
        };
        let statistics = work.trace(film, frame, passes, pace)?;
        film.complete_passes(passes);
        Ok(statistics)
    }

    fn expose(&self, film: &GpuFilm) -> Result<LatentImage, RendererError> {
        let image = self.developer.expose(film.size(), film.bins(), film.passes(), film.bands())?;
        Ok(LatentImage::Graphics(image))
    }

    fn read(&self, film: GpuFilm) -> Result<Film, RendererError> {
        film.read(&self.graphics)
    }
}
