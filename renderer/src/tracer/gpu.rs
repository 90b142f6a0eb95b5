//! The GPU tracer.

use super::{Tracer, TracerName, View};
use crate::develop::LatentImage;
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
}

/// A scene in the memory of a graphics device.
pub struct GpuScene {}

/// A film in the memory of a graphics device.
pub struct GpuFilm {}

impl GpuTracer {
    /// Compiles the shaders for a device, which takes up to some seconds.
    ///
    /// # Errors
    /// The device lacks something that tracing needs, or fails.
    pub fn new(graphics: &Graphics) -> Result<Self, RendererError> {
        let _ = Self { graphics: graphics.clone() };
        Err(RendererError::Graphics("the GPU tracer is not built yet".to_owned()))
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

    fn load(&self, _scene: PackedScene) -> Result<GpuScene, RendererError> {
        Ok(GpuScene {})
    }

    fn film(
        &self,
        _size: [u32; 2],
        _bins: Bins,
        _used: Option<GpuFilm>,
    ) -> Result<GpuFilm, RendererError> {
        Ok(GpuFilm {})
    }

    fn trace(
        &self,
        _scene: &GpuScene,
        _view: &View,
        _settings: &TraceSettings,
        _film: &mut GpuFilm,
        _passes: u32,
        _is_cancelled: &(dyn Fn() -> bool + Sync),
    ) -> Result<Statistics, RendererError> {
        Err(RendererError::Cancelled)
    }

    fn expose(&self, _film: &GpuFilm) -> Result<LatentImage, RendererError> {
        Err(RendererError::Cancelled)
    }

    fn read(&self, _film: GpuFilm) -> Result<Film, RendererError> {
        Err(RendererError::Cancelled)
    }
}
