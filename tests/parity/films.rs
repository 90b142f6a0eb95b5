//! Whole films of both tracers side by side.

use std::time::Instant;

use brilliance_renderer::film::Film;
use brilliance_renderer::gpu::Graphics;
use brilliance_renderer::statistics::Statistics;
use brilliance_renderer::tracer::{CpuTracer, GpuTracer, Tracer};

use super::cases::{self, Case};
use super::graphics;

fn film_of<T: Tracer>(tracer: &T, case: &Case) -> (Film, Statistics) {
    let t0 = Instant::now();
    let scene = tracer.load(case.packed()).expect("the scene loads");
    let mut film = tracer.film(case.size, case.bins(), None).expect("there is room for the film");
    let statistics = tracer
        .trace(&scene, &case.view(), case.settings(), &mut film, case.passes, &|| false)
        .expect("the scene is traced");
    let t = t0.elapsed();
    eprintln!("{} {:?} {statistics:?}", case.name, t);
    (tracer.read(film).expect("the film is read"), statistics)
}

#[test]
fn explore() {
    let graphics: Graphics = graphics();
    let t0 = Instant::now();
    let gpu = GpuTracer::new(&graphics).unwrap();
    eprintln!("new {:?}", t0.elapsed());
    let cpu = CpuTracer::new(0).unwrap();
    for case in [
        cases::diamond(),
        cases::seven_diamonds(),
        cases::mesh(),
        cases::prism(),
        cases::nested(),
        cases::furnace(),
    ] {
        let (a, sa) = film_of(&cpu, &case);
        let (b, sb) = film_of(&gpu, &case);
        let mean = |f: &Film| f.sums().iter().map(|&v| f64::from(v)).sum::<f64>();
        eprintln!(
            "mean {} {} rel {:e} segs {}",
            mean(&a),
            mean(&b),
            mean(&b) / mean(&a) - 1.0,
            sb.segments as f64 / sa.segments as f64 - 1.0
        );
        let n = a.bins().count();
        for bin in 0..n {
            let m =
                |f: &Film| f.sums().iter().skip(bin).step_by(n).map(|&v| f64::from(v)).sum::<f64>();
            eprint!("{:.1e} ", m(&b) / m(&a) - 1.0);
        }
        eprintln!();
        let mut diffs: Vec<f32> = a
            .sums()
            .chunks(n)
            .zip(b.sums().chunks(n))
            .map(|(a, b)| {
                let d: f32 = a.iter().zip(b).map(|(a, b)| (a - b).abs()).sum();
                let s: f32 = a.iter().sum();
                d / s.max(1e-3)
            })
            .collect();
        diffs.sort_by(f32::total_cmp);
        for q in [0.5, 0.75, 0.9, 0.95, 0.99, 0.999] {
            eprint!("{q}: {:.1e}  ", diffs[(q * diffs.len() as f64) as usize]);
        }
        eprintln!(" max {}", diffs[diffs.len() - 1]);
    }
}
