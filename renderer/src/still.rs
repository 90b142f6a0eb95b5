//! Pictures to keep: traced to a pass or time limit or a noise target, with progress and cancel.

use std::cell::OnceCell;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use crate::develop::{CountImage, Shown, XyzImage};
use crate::error::RendererError;
use crate::film::{Film, next_measurement};
use crate::image_file;
use crate::packed::PackedScene;
use crate::scheduler::{self, Machine};
use crate::session::RenderRequest;
use crate::settings::DisplaySettings;
use crate::spectrum::Bins;
use crate::statistics::Statistics;
use crate::tracer::{CpuTracer, DEVICE_PANICKED, Device, Tracer, TracerName, TracingDevice, View};

/// What a still says of its maker.
const SOFTWARE: &str = concat!("Brilliance ", env!("CARGO_PKG_VERSION"));

/// How a still is ended early, and with how many threads it is traced.
#[derive(Clone, Copy, Debug, Default)]
pub struct StillLimits {
    /// Stop after this much tracing, at the end of the pass in progress (at least one pass).
    pub time: Option<Duration>,
    /// Threads that the processor traces with; 0 is all of them.
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
    /// The film's [noise](Film::measure_noise) when it was measured last; none after few passes.
    pub noise: Option<f32>,
    /// Seconds of tracing alone.
    pub tracing_seconds: f64,
    /// What traced it.
    pub tracer: TracerName,
    /// Why the processor traced it though a graphics device was to.
    pub warning: Option<String>,
    /// The film.
    pub film: Film,
}

impl Still {
    /// Traces `request` on `device` where its backend calls for that device, else on the
    /// processor. Where the device fails or the scene is too much for it, the processor begins
    /// anew, and the still has a warning.
    ///
    /// `progress` is told how many passes are done, of `request.pass_limit`: after each, or several
    /// times per second. Set `cancel` to end with [`RendererError::Cancelled`] within a pixel, or
    /// once the shaders are compiled where they have to be.
    ///
    /// # Errors
    /// An impossible scene, an empty picture, or a cancelled job.
    pub fn render(
        request: &RenderRequest,
        limits: StillLimits,
        device: Option<&TracingDevice>,
        cancel: &AtomicBool,
        mut progress: impl FnMut(u32, &Statistics),
    ) -> Result<Self, RendererError> {
        render_on(request, limits, device, cancel, &mut progress)
    }

    /// Writes a picture of what is `shown` to `path` by way of a temporary file, with the scene file
    /// `scene_toml` in its metadata.
    ///
    /// # Errors
    /// The file can't be written, or is to be an OpenEXR file of a heat map.
    pub fn write(
        &self,
        path: &Path,
        format: StillFormat,
        display: &DisplaySettings,
        shown: Shown,
        scene_toml: &str,
    ) -> Result<(), RendererError> {
        let metadata = [(image_file::SCENE_KEYWORD, scene_toml), ("Software", SOFTWARE)];
        let (film, size) = (&self.film, self.film.size());
        match format {
            StillFormat::Png8 => {
                let pixels = match shown {
                    Shown::Color => XyzImage::from_film(film).develop(display).to_rgba8_srgb(),
                    Shown::Heat(map) => CountImage::from_film(film).develop_rgba8(map),
                };
                image_file::write_png8(path, size, &pixels, &metadata)
            }
            StillFormat::Png16 => {
                let pixels = match shown {
                    Shown::Color => XyzImage::from_film(film).develop(display).to_rgb16_srgb(),
                    Shown::Heat(map) => CountImage::from_film(film).develop_rgb16(map),
                };
                image_file::write_png16(path, size, &pixels, &metadata)
            }
            StillFormat::Exr { .. } if shown != Shown::Color => {
                Err(RendererError::Invalid(format!(
                    "{}: an OpenEXR picture holds light and no heat map; name the picture .png",
                    path.display()
                )))
            }
            StillFormat::Exr { spectral } => {
                let image = XyzImage::from_film(film);
                let means = spectral.then(|| film.means());
                let bins = means.as_ref().map(|means| (film.bins(), means.as_slice()));
                image_file::write_exr(path, size, &image.linear_rgb(), bins, &metadata)
            }
        }
    }
}

fn render_on<D: Device>(
    request: &RenderRequest,
    limits: StillLimits,
    device: Option<&D>,
    cancel: &AtomicBool,
    progress: &mut dyn FnMut(u32, &Statistics),
) -> Result<Still, RendererError> {
    let [width, height] = request.size;
    if width == 0 || height == 0 || request.pass_limit == 0 {
        return Err(RendererError::Invalid(format!(
            "a still of {width}×{height} pixels and {} passes is empty; each must be 1 or more",
            request.pass_limit
        )));
    }
    let order = Order { request, time: limits.time, began: OnceCell::new(), cancel };
    let device = device.filter(|device| request.backend.uses_device(device.is_software()));
    let mut warning = None;
    if let Some(device) = device {
        let traced = catch_unwind(AssertUnwindSafe(|| order.trace(&device.prepare()?, progress)))
            .unwrap_or_else(|_| Err(RendererError::Graphics(DEVICE_PANICKED.to_owned())));
        match traced {
            Err(RendererError::Graphics(reason)) => warning = Some(reason),
            settled => return settled,
        }
    }
    let still = order.trace(&CpuTracer::new(limits.threads)?, progress)?;
    Ok(Still { warning, ..still })
}

/// A still to be traced, on one tracer or, where that fails, on another.
struct Order<'a> {
    request: &'a RenderRequest,
    time: Option<Duration>,
    /// When the first tracer began to trace.
    began: OnceCell<Instant>,
    cancel: &'a AtomicBool,
}

impl Order<'_> {
    fn trace<T: Tracer>(
        &self,
        tracer: &T,
        progress: &mut dyn FnMut(u32, &Statistics),
    ) -> Result<Still, RendererError> {
        let RenderRequest { size, trace, pass_limit, noise: goal, .. } = self.request;
        let bins = Bins::new(trace.bins);
        let scene = tracer.load(PackedScene::new(&self.request.scene, bins)?)?;
        let view = View::new(&self.request.camera, *size);
        let mut film = tracer.film(*size, bins, None)?;
        let mut statistics = Statistics::default();
        let mut passes = 0;
        let mut noise = None;
        let mut measured_at = next_measurement(0);
        let mut pass_seconds = f64::INFINITY;
        let machine = Machine::from(&tracer.name());
        let started = Instant::now();
        self.began.get_or_init(|| started);
        let is_good = |noise: Option<f32>| noise.is_some_and(|noise| goal.is_reached(noise));
        while passes < *pass_limit && (passes == 0 || !self.is_over()) && !is_good(noise) {
            let round = self.round(machine, pass_seconds, passes);
            let is_cancelled = || self.cancel.load(Ordering::Relaxed);
            let round_started = Instant::now();
            statistics += tracer.trace(&scene, &view, trace, &mut film, round, &is_cancelled)?;
            pass_seconds = round_started.elapsed().as_secs_f64() / f64::from(round);
            passes += round;
            if passes >= measured_at {
                noise = Some(tracer.measure_noise(&mut film, *goal)?);
                measured_at = next_measurement(passes);
            }
            progress(passes, &statistics);
        }
        let tracing_seconds = started.elapsed().as_secs_f64();
        let film = tracer.read(film)?;
        let tracer = tracer.name();
        Ok(Still { statistics, passes, noise, tracing_seconds, tracer, warning: None, film })
    }

    /// Number of passes to trace before the clock and the progress are looked at again.
    fn round(&self, machine: Machine, pass_seconds: f64, done: u32) -> u32 {
        let RenderRequest { pass_limit, noise, .. } = self.request;
        let round = scheduler::round(machine, pass_seconds, done, *pass_limit, *noise);
        match self.time_left() {
            Some(left) => ((left.as_secs_f64() / pass_seconds) as u32).clamp(1, round),
            None => round,
        }
    }

    fn is_over(&self) -> bool {
        self.time_left().is_some_and(|left| left.is_zero())
    }

    fn time_left(&self) -> Option<Duration> {
        let elapsed = self.began.get().map_or(Duration::ZERO, Instant::elapsed);
        self.time.map(|time| time.saturating_sub(elapsed))
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::scene_file::Document;
    use crate::settings::NoiseGoal;
    use crate::tracer::Backend;
    use crate::tracer::fake::{Call, FakeDevice, REASON};

    const PASSES: u32 = 5;

    fn render(device: &FakeDevice, backend: Backend) -> Result<Still, RendererError> {
        let document = Document::default();
        let request = RenderRequest {
            camera: document.scene.camera,
            scene: Arc::new(document.scene),
            size: [24, 16],
            trace: document.trace,
            pass_limit: PASSES,
            noise: NoiseGoal::NONE,
            backend,
        };
        let limits = StillLimits::default();
        let mut told = 0;
        let still = render_on(
            &request,
            limits,
            Some(device),
            &AtomicBool::new(false),
            &mut |passes, _| told = passes,
        )?;
        assert_eq!((still.passes, still.film.passes(), told), (PASSES, PASSES, PASSES));
        Ok(still)
    }

    fn is_on_device(still: &Still) -> bool {
        matches!(still.tracer, TracerName::Gpu { .. })
    }

    #[test]
    fn the_backend_and_the_device_say_what_traces() {
        for (device, backend, expected) in [
            (FakeDevice::hardware(), Backend::Auto, true),
            (FakeDevice::hardware(), Backend::Cpu, false),
            (FakeDevice::software(), Backend::Auto, false),
            (FakeDevice::software(), Backend::Gpu, true),
        ] {
            let still = render(&device, backend).expect("renders");
            assert_eq!((is_on_device(&still), still.warning), (expected, None));
        }
    }

    #[test]
    fn wherever_the_device_fails_the_processor_traces_all_passes() {
        let whole = render(&FakeDevice::hardware(), Backend::Cpu).expect("renders");
        let calls = [
            (Call::Prepare, 0),
            (Call::Load, 0),
            (Call::Film, 0),
            (Call::Trace, 1),
            (Call::Read, 0),
        ];
        for (call, panics) in calls.into_iter().flat_map(|call| [(call, false), (call, true)]) {
            let device = FakeDevice::failing_at(call.0, call.1);
            device.plan().panics = panics;
            let still = render(&device, Backend::Gpu).expect("the processor takes over");
            assert!(!is_on_device(&still));
            let warning = still.warning.expect("it is said");
            assert_eq!(warning.contains(REASON), !panics, "{call:?}: {warning}");
            assert!(still.film.sums() == whole.film.sums(), "{call:?}");
            assert_eq!(still.statistics, whole.statistics, "{call:?}");
        }
    }
}
