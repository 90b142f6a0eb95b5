//! Tracers: they add one pass after the other to a film.

mod backend;
mod cpu;
mod device;
#[cfg(test)]
pub(crate) mod fake;
mod gpu;

pub use backend::{Backend, TracerName};
pub use cpu::CpuTracer;
pub use device::TracingDevice;
pub(crate) use device::{DEVICE_PANICKED, Device};
pub use gpu::{GpuFilm, GpuScene, GpuTracer};

use glam::Vec3;

use crate::camera::{Camera, CameraFrame};
use crate::develop::LatentImage;
use crate::error::RendererError;
use crate::film::{Film, PixelRect};
use crate::kernel::walk::TraceRules;
use crate::packed::PackedScene;
use crate::settings::{NoiseGoal, Splitting, TraceSettings};
use crate::spectrum::Bins;
use crate::statistics::Statistics;

/// What adds passes to films: one interface to the processor and to graphics devices.
pub trait Tracer {
    /// A scene where the tracer can read it.
    type Scene;
    /// A film where the tracer can write to it.
    type Film;

    /// What the tracer is called.
    fn name(&self) -> TracerName;

    /// Brings a scene to where the tracer reads it.
    ///
    /// # Errors
    /// The scene is too large for the device, or the device fails.
    fn load(&self, scene: PackedScene) -> Result<Self::Scene, RendererError>;

    /// An empty film; `used`, a film that is no longer needed, is made empty where it fits.
    ///
    /// # Errors
    /// The film is too large for the device, or the device fails.
    fn film(
        &self,
        size: [u32; 2],
        bins: Bins,
        used: Option<Self::Film>,
    ) -> Result<Self::Film, RendererError>;

    /// Adds `passes` passes to `film`, each of one camera ray per pixel that is not settled.
    ///
    /// # Errors
    /// [`RendererError::Cancelled`] where `is_cancelled` came true, or the device fails; the film
    /// is then of no more use.
    fn trace(
        &self,
        scene: &Self::Scene,
        view: &View,
        settings: &TraceSettings,
        film: &mut Self::Film,
        passes: u32,
        is_cancelled: &(dyn Fn() -> bool + Sync),
    ) -> Result<Statistics, RendererError>;

    /// What the observer sees of the film, ready to be developed; it stays where the film is.
    ///
    /// # Errors
    /// The device fails.
    fn expose(&self, film: &Self::Film) -> Result<LatentImage, RendererError>;

    /// Mean spectral radiance of the pixels of `rect` that lie in the film, one value per bin; 0
    /// where none does. Nothing else is fetched from where the film is.
    ///
    /// # Errors
    /// The device fails.
    fn mean_spectrum(&self, film: &Self::Film, rect: PixelRect) -> Result<Vec<f32>, RendererError>;

    /// The film's noise, as [`Film::measure_noise`] finds it; marks the pixels that later passes
    /// leave out by `goal`.
    ///
    /// # Errors
    /// The device fails.
    fn measure_noise(&self, film: &mut Self::Film, goal: NoiseGoal) -> Result<f32, RendererError>;

    /// A copy of the film's means in the processor's memory, to be read while the film is traced on. None where the film is elsewhere; passes are short there.
    fn copy_means(&self, film: &Self::Film) -> Option<Vec<f32>>;

    /// The film in the processor's memory.
    ///
    /// # Errors
    /// The device fails.
    fn read(&self, film: Self::Film) -> Result<Film, RendererError>;
}

/// The camera as a tracer sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Axes of the image plane.
    pub frame: CameraFrame,
    /// Unit vector from the scene towards the observer.
    pub observer: Vec3,
}

impl View {
    /// The view for pictures of the proportions of `size`, whatever their resolution.
    pub fn new(camera: &Camera, size: [u32; 2]) -> Self {
        let frame = camera.frame(size[0], size[1]);
        Self { frame, observer: -frame.forward }
    }
}

/// The rules by which the settings want rays followed.
pub(crate) fn rules(view: &View, settings: &TraceSettings) -> TraceRules {
    TraceRules {
        observer: view.observer,
        split_count: settings.split_count,
        significance_threshold: match settings.splitting {
            Splitting::Paper => settings.significance_threshold,
            Splitting::Exact => settings.roulette_threshold,
        },
        max_depth: settings.max_depth,
        perturb: u32::from(settings.perturb),
        cut_threshold: settings.cut_share() * settings.roulette_threshold,
    }
}
