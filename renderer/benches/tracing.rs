//! Ray segments per second of the default stone, on one and on two threads and on the graphics
//! device, if there is one; passes per second of that at the sizes of windows.
#![expect(clippy::print_stdout, reason = "a benchmark prints what it measured")]

use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use brilliance_renderer::error::RendererError;
use brilliance_renderer::gpu::Graphics;
use brilliance_renderer::scene_file::Document;
use brilliance_renderer::session::RenderRequest;
use brilliance_renderer::still::{Still, StillLimits};
use brilliance_renderer::tracer::Backend;

const SIZE: [u32; 2] = [320, 200];
/// For tracers that have more to do at once than a small picture has pixels.
const WINDOW_SIZES: [[u32; 2]; 2] = [[1280, 800], [1920, 1080]];
const WARM_UP: Duration = Duration::from_millis(500);
const TIME: Duration = Duration::from_secs(3);

fn main() -> Result<(), RendererError> {
    for threads in [1, 2] {
        measure(&request(Backend::Cpu, SIZE), threads, None)?;
    }
    match Graphics::open(true) {
        Err(reason) => println!("tracing, GPU: {reason}"),
        Ok(graphics) => {
            measure(&request(Backend::Gpu, SIZE), 0, Some(&graphics))?;
            // Software would need a minute for each.
            for size in WINDOW_SIZES.into_iter().filter(|_| !graphics.is_software()) {
                measure(&request(Backend::Gpu, size), 0, Some(&graphics))?;
            }
        }
    }
    Ok(())
}

fn request(backend: Backend, size: [u32; 2]) -> RenderRequest {
    let document = Document::default();
    RenderRequest {
        camera: document.scene.camera,
        scene: Arc::new(document.scene),
        size,
        trace: document.trace,
        pass_limit: u32::MAX,
        backend,
    }
}

fn measure(
    request: &RenderRequest,
    threads: usize,
    graphics: Option<&Graphics>,
) -> Result<(), RendererError> {
    trace(request, WARM_UP, threads, graphics)?;
    let still = trace(request, TIME, threads, graphics)?;
    let per_second = |count: u64| count as f64 / still.tracing_seconds / 1e6;
    println!(
        "tracing, {}: {:.2} M ray segments/s, {:.3} M camera rays/s, {:.2} passes/s ({} passes of \
         {}x{} pixels in {:.2} s, {:.1} segments per camera ray, at most {})",
        still.tracer,
        per_second(still.statistics.segments),
        per_second(still.statistics.camera_rays),
        f64::from(still.passes) / still.tracing_seconds,
        still.passes,
        request.size[0],
        request.size[1],
        still.tracing_seconds,
        still.statistics.mean_segments_per_camera_ray(),
        still.statistics.max_segments_per_camera_ray,
    );
    if let Some(warning) = still.warning {
        println!("tracing, GPU: {warning}");
    }
    Ok(())
}

fn trace(
    request: &RenderRequest,
    time: Duration,
    threads: usize,
    graphics: Option<&Graphics>,
) -> Result<Still, RendererError> {
    let limits = StillLimits { time: Some(time), threads };
    Still::render(request, limits, graphics, &AtomicBool::new(false), |_, _| {})
}
