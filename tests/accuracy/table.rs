//! The table: each splitting against the reference, on every stone under every light.

use brilliance_renderer::film::Film;
use brilliance_renderer::packed::PackedScene;
use brilliance_renderer::settings::{Splitting, TraceSettings};
use brilliance_renderer::spectrum::Bins;
use brilliance_renderer::tracer::{CpuTracer, Tracer, View};

use crate::difference::Difference;
use crate::reference::Reference;
use crate::scenes::{self, Case};

/// The reference looks at least once in so many nanometres.
const STEP_NM: f64 = 1.0;

const SPLITTINGS: [(&str, Splitting); 1] = [("Paper", Splitting::Paper)];

/// Weaker than the default, so that what differs is the splitting alone.
const SIGNIFICANCE_THRESHOLD: f32 = 1e-5;

fn settings(splitting: Splitting) -> TraceSettings {
    TraceSettings {
        splitting,
        significance_threshold: SIGNIFICANCE_THRESHOLD,
        max_depth: *TraceSettings::MAX_DEPTH.end(),
        ..TraceSettings::default()
    }
}

/// The first pass.
pub(crate) fn trace(tracer: &CpuTracer, case: &Case, settings: &TraceSettings) -> Film {
    let bins = Bins::new(settings.bins);
    let scene = PackedScene::new(&case.scene, bins).expect("the scene packs");
    let view = View::new(&case.camera, case.size);
    let mut film = Film::new(case.size[0], case.size[1], bins);
    tracer.trace(&scene, &view, settings, &mut film, 1, &|| false).expect("the pass completes");
    film
}

/// Mean segments of the camera rays that meet a body.
fn mean_segments(reference: &Reference, segments: impl Iterator<Item = f64>) -> f64 {
    let of_bodies = segments.zip(&reference.shows_body).filter(|(_, shows_body)| **shows_body);
    let count = reference.shows_body.iter().filter(|shows_body| **shows_body).count();
    of_bodies.map(|(segments, _)| segments).sum::<f64>() / count as f64
}

fn row(name: &str, splitting: &str, difference: &Difference, segments: f64) {
    let Difference { mean, high, worst, worst_pixel: [x, y] } = difference;
    println!(
        "| {name} | {splitting} | {mean:.3} | {high:.2} | {worst:.2} at {x}, {y} | {segments:.0} |"
    );
}

#[test]
fn each_splitting_against_every_wavelength_alone() {
    let tracer = CpuTracer::new(0).expect("threads start");
    println!("| scene | splitting | mean ΔE₀₀ | 99 % ΔE₀₀ | worst | segments per camera ray |");
    println!("|---|---|---|---|---|---|");
    for case in scenes::all() {
        let bins = Bins::new(TraceSettings::default().bins);
        let reference = Reference::new(&case, bins, STEP_NM);
        for (name, splitting) in SPLITTINGS {
            let film = trace(&tracer, &case, &settings(splitting));
            let difference = Difference::of(&film, &reference);
            let rays = film.counts().iter().map(|counts| f64::from(counts.rays));
            row(&case.name, name, &difference, mean_segments(&reference, rays));
        }
        let segments = reference.segments.iter().map(|&segments| segments as f64);
        println!("| {} | none | | | | {:.0} |", case.name, mean_segments(&reference, segments));
    }
}

#[test]
fn without_dispersion_nothing_is_split_and_both_tracers_agree() {
    let tracer = CpuTracer::new(0).expect("threads start");
    for case in scenes::all() {
        let case = case.undispersed();
        let settings = settings(Splitting::Paper);
        let bins = Bins::new(settings.bins);
        // All wavelengths are alike.
        let reference = Reference::new(&case, bins, f64::from(bins.width_nm()));
        let film = trace(&tracer, &case, &settings);
        let difference = Difference::of(&film, &reference);
        row(&case.name, "no dispersion", &difference, 0.0);
    }
}
