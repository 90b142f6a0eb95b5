//! Ray segments per second of the default stone, on one and on two threads.
#![expect(clippy::print_stdout, reason = "a benchmark prints what it measured")]

use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use brilliance_renderer::error::RendererError;
use brilliance_renderer::scene_file::Document;
use brilliance_renderer::session::RenderRequest;
use brilliance_renderer::still::{Still, StillLimits};
use brilliance_renderer::tracer::Backend;

const SIZE: [u32; 2] = [320, 200];
const WARM_UP: Duration = Duration::from_millis(500);
const TIME: Duration = Duration::from_secs(3);

fn main() -> Result<(), RendererError> {
    let document = Document::default();
    let request = RenderRequest {
        camera: document.scene.camera,
        scene: Arc::new(document.scene),
        size: SIZE,
        trace: document.trace,
        pass_limit: u32::MAX,
        backend: Backend::Cpu,
    };
    for threads in [1, 2] {
        trace(&request, threads, WARM_UP)?;
        let still = trace(&request, threads, TIME)?;
        let per_second = |count: u64| count as f64 / still.tracing_seconds / 1e6;
        println!(
            "tracing, {threads} thread(s): {:.2} M ray segments/s, {:.3} M camera rays/s \
             ({} passes of {}x{} pixels in {:.2} s, {:.1} segments per camera ray, at most {})",
            per_second(still.statistics.segments),
            per_second(still.statistics.camera_rays),
            still.passes,
            SIZE[0],
            SIZE[1],
            still.tracing_seconds,
            still.statistics.mean_segments_per_camera_ray(),
            still.statistics.max_segments_per_camera_ray,
        );
    }
    Ok(())
}

fn trace(request: &RenderRequest, threads: usize, time: Duration) -> Result<Still, RendererError> {
    let limits = StillLimits { time: Some(time), threads };
    Still::render(request, limits, None, &AtomicBool::new(false), |_, _| {})
}
