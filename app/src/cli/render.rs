//! `brilliance render`: a picture without a window.

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use anyhow::{anyhow, ensure};
use brilliance_renderer::error::RendererError;
use brilliance_renderer::film::Film;
use brilliance_renderer::gpu::Graphics;
use brilliance_renderer::scene_file::Document;
use brilliance_renderer::session::RenderRequest;
use brilliance_renderer::still::{Still, StillLimits};
use brilliance_renderer::tracer::{Backend, TracingDevice};
use brilliance_renderer::whole_file;

use super::arguments::RenderArguments;
use super::assignment::open_with;
use super::progress::Progress;
use super::report::Report;
use super::say;

/// What [`StillLimits::threads`] takes for one thread per processor.
const ALL_THREADS: usize = 0;

/// Renders, writes the picture and the statistics, and says what was done.
pub(super) fn render(arguments: &RenderArguments) -> anyhow::Result<()> {
    let cancel = cancelled_by_ctrl_c()?;
    let format = arguments.format().map_err(|fault| anyhow!(fault))?;
    // A mistyped folder should be told now, not after an hour of tracing.
    for path in [Some(&arguments.output), arguments.stats.as_ref()].into_iter().flatten() {
        whole_file::check(path)?;
    }

    let document = open(arguments)?;
    check_film(&document)?;
    let threads = arguments.threads.unwrap_or(ALL_THREADS);
    let limits = StillLimits { time: arguments.time, threads };
    let still =
        trace(&document, arguments.backend(), limits, &cancel).map_err(|error| {
            match error.downcast_ref() {
                Some(RendererError::Cancelled) => anyhow!("cancelled; no picture was written"),
                _ => error,
            }
        })?;
    let base = arguments.output.parent().unwrap_or(Path::new(""));
    let (display, shown) = (&document.display, arguments.show.into());
    still.write(&arguments.output, format, display, shown, &document.to_toml(base))?;

    let report = Report::new(arguments, &document, &still);
    if let Some(path) = &arguments.stats {
        report.write(path)?;
    }
    report.print()
}

/// The document of the scene file with the changes the command line asks for.
fn open(arguments: &RenderArguments) -> anyhow::Result<Document> {
    let mut document = open_with(&arguments.scene, &arguments.assignments)?;
    if let Some(size) = arguments.size {
        document.still.size = size.0;
    }
    if let Some(passes) = arguments.passes {
        document.still.passes = passes;
    }
    if let Some(noise) = arguments.noise {
        document.still.noise.target = noise;
    }
    if let Some(bins) = arguments.bins {
        document.trace.bins = bins;
    }
    Ok(document)
}

/// Traces the document's still with a progress bar, until `cancel` comes true.
///
/// # Errors
/// Those of [`Still::render`], or there is no graphics device where one is asked for.
pub(super) fn trace(
    document: &Document,
    backend: Backend,
    limits: StillLimits,
    cancel: &AtomicBool,
) -> anyhow::Result<Still> {
    let request = RenderRequest {
        scene: Arc::new(document.scene.clone()),
        camera: document.scene.camera,
        size: document.still.size,
        trace: document.trace.clone(),
        pass_limit: document.still.passes,
        noise: document.still.noise,
        backend,
    };
    let device = open_graphics(backend)?.map(TracingDevice::from);
    let progress = Progress::new(request.pass_limit);
    let show = |passes, _: &_| progress.show(passes);
    let still = Still::render(&request, limits, device.as_ref(), cancel, show);
    drop(progress);
    let still = still?;
    if let Some(warning) = &still.warning {
        say(&format!("traced on the CPU, since the graphics device could not: {warning}"));
    }
    Ok(still)
}

/// The graphics device to trace on, if any.
fn open_graphics(backend: Backend) -> anyhow::Result<Option<Graphics>> {
    match backend {
        Backend::Cpu => Ok(None),
        Backend::Auto => Ok(Graphics::open(false)
            .inspect_err(|reason| log::info!("traced on the CPU: {reason}"))
            .ok()),
        Backend::Gpu => {
            let graphics = Graphics::open(true)?;
            if graphics.is_software() {
                say(&format!(
                    "{} is a graphics device made of software, slower than --backend cpu",
                    graphics.name()
                ));
            }
            Ok(Some(graphics))
        }
    }
}

/// A flag that Ctrl-C sets from now on.
pub(super) fn cancelled_by_ctrl_c() -> anyhow::Result<Arc<AtomicBool>> {
    let cancel = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&cancel);
    ctrlc::set_handler(move || flag.store(true, Ordering::Relaxed))?;
    Ok(cancel)
}

/// Refuses a film that would not fit into the memory of most machines.
pub(super) fn check_film(document: &Document) -> anyhow::Result<()> {
    let [width, height] = document.still.size;
    let bins = document.trace.bins;
    let bytes = Film::bytes(document.still.size, bins);
    let in_gib = |bytes: u64| bytes as f64 / f64::from(1 << 30);
    ensure!(
        bytes <= Film::MAX_BYTES,
        "{width}x{height} pixels with {bins} spectral bins need {:.2} GiB, more than the {:.2} GiB \
         a film may take; ask for a smaller --size or fewer --bins",
        in_gib(bytes),
        in_gib(Film::MAX_BYTES),
    );
    Ok(())
}
