//! Tracers beside each other, on the stone that the program starts with and on seven: one thread, all
//! threads, and the graphics device, if there is one.
#![expect(clippy::print_stdout, reason = "a benchmark prints what it measured")]

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use brilliance_renderer::error::RendererError;
use brilliance_renderer::gpu::Graphics;
use brilliance_renderer::scene_file::{self, Document, ShippedScene};
use brilliance_renderer::session::RenderRequest;
use brilliance_renderer::settings::NoiseGoal;
use brilliance_renderer::still::{Still, StillLimits};
use brilliance_renderer::tracer::{Backend, GpuTracer, TracerName, TracingDevice};

const SCENES: [&str; 2] = ["Diamond", "Seven diamonds"];
const WINDOW_SIZES: [[u32; 2]; 2] = [[1280, 800], [1920, 1080]];
/// For tracers that take seconds for a pass of a window.
const SMALL_SIZE: [u32; 2] = [320, 200];
const WARM_UP: Duration = Duration::from_millis(500);
const TIME: Duration = Duration::from_secs(3);

fn main() -> Result<(), RendererError> {
    let device = Graphics::open(true).and_then(|graphics| GpuTracer::new(&graphics));
    let device = device.map(|tracer| TracingDevice::from(Arc::new(tracer)));
    if let Err(reason) = &device {
        println!("no GPU: {reason}");
    }
    for scene in scene_file::scenes().iter().filter(|scene| SCENES.contains(&scene.name)) {
        print_table(scene, device.as_ref().ok())?;
    }
    Ok(())
}

/// Measures all tracers on one scene, and prints a row for each.
fn print_table(scene: &ShippedScene, device: Option<&TracingDevice>) -> Result<(), RendererError> {
    println!("\ntracing, {}", scene.name);
    println!(
        "{:<52} {:>12} {:>18} {:>18} {:>12}",
        "", "M segments/s", "passes/s 1280x800", "passes/s 1920x1080", "all threads"
    );
    // All threads come first, since the others are held against them.
    let all = measure(scene, 0, None)?;
    let one = measure(scene, 1, None)?;
    let gpu = device.map(|device| measure(scene, 0, Some(device))).transpose()?;
    for speed in [Some(&one), Some(&all), gpu.as_ref()].into_iter().flatten() {
        speed.print(all.segments_per_second);
    }
    Ok(())
}

/// What one tracer does with one scene.
struct Speed {
    tracer: TracerName,
    segments_per_second: f64,
    /// At the sizes of windows.
    passes_per_second: [f64; 2],
    /// Whether those were traced, or derived from the camera rays of a small picture.
    is_traced: bool,
    warning: Option<String>,
}

impl Speed {
    fn print(&self, all_threads: f64) {
        let mark = if self.is_traced { "" } else { "≈ " };
        let [small, large] = self.passes_per_second.map(|passes| format!("{mark}{passes:.3}"));
        println!(
            "{:<52} {:>12.2} {small:>18} {large:>18} {:>11.2}x",
            self.tracer.to_string(),
            self.segments_per_second / 1e6,
            self.segments_per_second / all_threads,
        );
        if let Some(warning) = &self.warning {
            println!("  not on the GPU: {warning}");
        }
    }
}

/// Traces the scene by `device`, or else by so many threads; 0 is all.
fn measure(
    scene: &ShippedScene,
    threads: usize,
    device: Option<&TracingDevice>,
) -> Result<Speed, RendererError> {
    let small = trace(scene, SMALL_SIZE, threads, device)?;
    let is_traced = matches!(small.tracer, TracerName::Gpu { is_software: false, .. });
    let stills = if is_traced {
        let trace_window = |size| trace(scene, size, threads, device);
        let [first, second] = WINDOW_SIZES.map(trace_window);
        [first?, second?].into()
    } else {
        vec![small]
    };
    let camera_rays = |still: &Still| per_second(still, still.statistics.camera_rays);
    // The last stands for the sizes that were not traced.
    let rates: Vec<_> = stills.iter().map(camera_rays).collect();
    let rate = |i: usize| rates[i.min(rates.len() - 1)];
    let pixels = WINDOW_SIZES.map(|[width, height]| f64::from(width) * f64::from(height));
    Ok(Speed {
        tracer: stills[0].tracer.clone(),
        segments_per_second: per_second(&stills[0], stills[0].statistics.segments),
        passes_per_second: [rate(0) / pixels[0], rate(1) / pixels[1]],
        is_traced,
        warning: stills[0].warning.clone(),
    })
}

fn per_second(still: &Still, count: u64) -> f64 {
    count as f64 / still.tracing_seconds
}

/// A still of as many passes as fit the time, after some to warm up.
fn trace(
    scene: &ShippedScene,
    size: [u32; 2],
    threads: usize,
    device: Option<&TracingDevice>,
) -> Result<Still, RendererError> {
    let document = Document::from_toml(scene.text, Path::new(""))?;
    let request = RenderRequest {
        camera: document.scene.camera,
        scene: Arc::new(document.scene),
        size,
        trace: document.trace,
        pass_limit: u32::MAX,
        noise: NoiseGoal::NONE,
        backend: if device.is_some() { Backend::Gpu } else { Backend::Cpu },
    };
    let render = |time| {
        let limits = StillLimits { time: Some(time), threads };
        Still::render(&request, limits, device, &AtomicBool::new(false), |_, _| {})
    };
    render(WARM_UP)?;
    render(TIME)
}
