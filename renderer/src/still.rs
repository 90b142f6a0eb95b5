//! Pictures to keep: traced to a pass or time limit, with progress and cancel.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use crate::develop::XyzImage;
use crate::error::RendererError;
use crate::film::Film;
use crate::image_file;
use crate::packed::PackedScene;
use crate::session::RenderRequest;
use crate::settings::DisplaySettings;
use crate::spectrum::Bins;
use crate::statistics::Statistics;
use crate::tracer::{CpuTracer, Tracer, View};

/// What a still says of its maker.
const SOFTWARE: &str = concat!("Brilliance ", env!("CARGO_PKG_VERSION"));

/// How a still is ended early, and with how many threads it is traced.
#[derive(Clone, Copy, Debug, Default)]
pub struct StillLimits {
    /// Stop after this much tracing, at the end of the pass in progress (at least one pass).
    pub time: Option<Duration>,
    /// Threads to trace with; 0 is all of them.
    pub threads: usize,
}

/// File formats of a still.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StillFormat {
    /// PNG, 8 bits per channel, sRGB, developed.
    Png8,
    /// PNG, 16 bits per channel, sRGB, developed.
    Png16,
    /// OpenEXR, 32-bit float, linear Rec. 709 RGB, undeveloped.
    Exr {
        /// Adds one channel per spectral bin.
        spectral: bool,
    },
}

/// A finished still.
#[derive(Debug)]
pub struct Still {
    /// Counts of all passes.
    pub statistics: Statistics,
    /// Passes traced.
    pub passes: u32,
    /// Seconds of tracing alone.
    pub tracing_seconds: f64,
    /// Threads that traced.
    pub threads: usize,
    /// The film.
    pub film: Film,
}

impl Still {
    /// Traces `request`. `progress` is told after each pass how many are done, of
    /// `request.pass_limit`; set `cancel` to end with [`RendererError::Cancelled`] within a
    /// pixel.
    ///
    /// # Errors
    /// An impossible scene, an empty picture, or a cancelled job.
    pub fn render(
        request: &RenderRequest,
        limits: StillLimits,
        cancel: &AtomicBool,
        mut progress: impl FnMut(u32, &Statistics),
    ) -> Result<Self, RendererError> {
        let [width, height] = request.size;
        if width == 0 || height == 0 || request.pass_limit == 0 {
            return Err(RendererError::Invalid(format!(
                "a still of {width}×{height} pixels and {} passes is empty; each must be 1 or more",
                request.pass_limit
            )));
        }
        let bins = Bins::new(request.trace.bins);
        let scene = PackedScene::new(&request.scene, bins)?;
        let tracer = CpuTracer::new(limits.threads)?;
        let view = View::new(&request.camera, request.size);
        let mut film = Film::new(width, height, bins);
        let mut statistics = Statistics::default();
        let started = Instant::now();
        while film.passes() < request.pass_limit {
            let is_cancelled = || cancel.load(Ordering::Relaxed);
            statistics +=
                tracer.trace(&scene, &view, &request.trace, &mut film, 1, &is_cancelled)?;
            progress(film.passes(), &statistics);
            if limits.time.is_some_and(|time| started.elapsed() >= time) {
                break;
            }
        }
        Ok(Self {
            statistics,
            passes: film.passes(),
            tracing_seconds: started.elapsed().as_secs_f64(),
            threads: tracer.threads(),
            film,
        })
    }

    /// Writes the picture to `path` by way of a temporary file, with the scene file `scene_toml`
    /// in its metadata.
    ///
    /// # Errors
    /// The file can't be written.
    pub fn write(
        &self,
        path: &Path,
        format: StillFormat,
        display: &DisplaySettings,
        scene_toml: &str,
    ) -> Result<(), RendererError> {
        let image = XyzImage::from_film(&self.film);
        let metadata = [(image_file::SCENE_KEYWORD, scene_toml), ("Software", SOFTWARE)];
        let size = self.film.size();
        match format {
            StillFormat::Png8 => {
                let pixels = image.develop(display).to_rgba8_srgb();
                image_file::write_png8(path, size, &pixels, &metadata)
            }
            StillFormat::Png16 => {
                let pixels = image.develop(display).to_rgb16_srgb();
                image_file::write_png16(path, size, &pixels, &metadata)
            }
            StillFormat::Exr { spectral } => {
                let means = spectral.then(|| self.film.means());
                let bins = means.as_ref().map(|means| (self.film.bins(), means.as_slice()));
                image_file::write_exr(path, size, &image.linear_rgb(), bins, &metadata)
            }
        }
    }
}
