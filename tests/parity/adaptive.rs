//! Passes that leave out settled pixels.

use brilliance_renderer::film::{Film, next_measurement};
use brilliance_renderer::settings::NoiseGoal;
use brilliance_renderer::statistics::Statistics;
use brilliance_renderer::tracer::{CpuTracer, GpuTracer, Tracer};

use super::cases::{self, Case};
use super::films::compare;
use super::{TRACER, limited_graphics, relative};

const GOAL: NoiseGoal = NoiseGoal { target: 0.03, is_adaptive: true };
const PASSES: u32 = 16;

/// The case's film after passes that left out pixels, what it took and its noise.
fn trace_adaptively<T: Tracer>(tracer: &T, case: &Case) -> (Film, Statistics, f32) {
    let scene = tracer.load(case.packed()).expect("the scene loads");
    let mut film = tracer.film(case.size, case.bins(), None).expect("there is room for the film");
    let (mut statistics, mut noise, mut passes) = (Statistics::default(), 0.0, 0);
    while passes < PASSES {
        let more = next_measurement(passes) - passes;
        let (view, settings) = (case.view(), case.settings());
        statistics += tracer
            .trace(&scene, &view, settings, &mut film, more, &|| false)
            .expect("the passes are traced");
        noise = tracer.measure_noise(&mut film, GOAL).expect("the noise is measured");
        passes += more;
    }
    (tracer.read(film).expect("the film is read"), statistics, noise)
}

fn assert_in_step(case: &Case, tracer: &GpuTracer) {
    let cpu = CpuTracer::new(0).expect("there are threads");
    let (cpu, cpu_statistics, cpu_noise) = trace_adaptively(&cpu, case);
    let (gpu, gpu_statistics, gpu_noise) = trace_adaptively(tracer, case);
    compare(case, &cpu, &gpu).expect("the films are the same");
    assert!(relative(cpu_noise.into(), gpu_noise.into()) < 0.01, "{cpu_noise} {gpu_noise}");
    let rays = [cpu_statistics, gpu_statistics].map(|statistics| statistics.camera_rays as f64);
    assert!(relative(rays[0], rays[1]) < 2e-3, "{rays:?}");
    let pixels = f64::from(case.size[0] * case.size[1]);
    let share = (rays[0] / pixels - 8.0) / 8.0;
    assert!((0.1..0.9).contains(&share), "{share} of the pixels are traced on");
    let ledger = gpu_statistics.ledger;
    assert_eq!(ledger.entered, rays[1]);
    assert!(ledger.imbalance().abs() < 1e-5 * ledger.entered, "{ledger:?}");
    // A pixel at the limit may fall on either side.
    let pairs = cpu.counts().iter().zip(gpu.counts());
    let apart = pairs.filter(|(cpu, gpu)| cpu.samples != gpu.samples).count();
    assert!((apart as f64) < 0.01 * pixels, "{apart} of {pixels} pixels");
    let counted: f64 = gpu.counts().iter().map(|counts| f64::from(counts.samples)).sum();
    assert_eq!(counted, rays[1]);
}

#[test]
fn both_tracers_leave_out_the_same_pixels() {
    assert_in_step(&cases::small_diamond(), &TRACER);
}

/// Pixels at the seam look at neighbours in their own band alone, which few notice.
#[test]
fn films_in_bands_do_so_too() {
    let graphics = limited_graphics(|limits| limits.max_storage_buffer_binding_size = 3 << 19);
    let tracer = GpuTracer::new(&graphics).expect("the device can trace");
    assert_in_step(&cases::banded(), &tracer);
}
