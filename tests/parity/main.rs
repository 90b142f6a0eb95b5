//! The GPU in step with the CPU, on any device there is, software included.

mod adaptive;
mod cases;
mod device;
mod exact;
mod films;
mod limits;
mod loss;
mod rounds;
#[path = "../shapes.rs"]
mod shapes;

use std::sync::LazyLock;

use brilliance_renderer::film::Film;
use brilliance_renderer::gpu::Graphics;
use brilliance_renderer::statistics::Statistics;
use brilliance_renderer::tracer::{CpuTracer, GpuTracer, Tracer};

use cases::Case;

/// One for most tests: software takes seconds to compile the kernel.
static TRACER: LazyLock<GpuTracer> =
    LazyLock::new(|| GpuTracer::new(&graphics()).expect("the device can trace"));

/// A device of the test's own. A machine without any fails the test rather than passing it unseen.
fn graphics() -> Graphics {
    Graphics::open(true).unwrap_or_else(|error| {
        panic!("these tests need a graphics device, be it software (mesa-vulkan-drivers): {error}")
    })
}

/// A device with lower limits than it could have.
fn limited_graphics(limit: impl Fn(&mut wgpu::Limits)) -> Graphics {
    Graphics::open_restricted(true, limit).expect("the device takes lower limits")
}

/// All passes of a case in one call.
fn trace<T: Tracer>(tracer: &T, case: &Case) -> (T::Film, Statistics) {
    let scene = tracer.load(case.packed()).expect("the scene loads");
    let mut film = tracer.film(case.size, case.bins(), None).expect("there is room for the film");
    let statistics = tracer
        .trace(&scene, &case.view(), case.settings(), &mut film, case.passes, &|| false)
        .expect("the scene is traced");
    (film, statistics)
}

/// The film as the processor makes it.
fn cpu_film(case: &Case) -> (Film, Statistics) {
    trace(&CpuTracer::new(0).expect("there are threads"), case)
}

/// Sum over all pixels and bins.
fn total(film: &Film) -> f64 {
    film.sums().iter().map(|&sum| f64::from(sum)).sum()
}

/// How far two sums are apart, relative to the first.
fn relative(a: f64, b: f64) -> f64 {
    (b - a).abs() / a.abs()
}
