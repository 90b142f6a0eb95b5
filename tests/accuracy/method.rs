//! The splittings that are compared, and what is asked of them.

use brilliance_renderer::film::Film;
use brilliance_renderer::packed::PackedScene;
use brilliance_renderer::settings::{Splitting, TraceSettings};
use brilliance_renderer::spectrum::Bins;
use brilliance_renderer::tracer::{CpuTracer, Tracer, View};

use crate::difference::Difference;
use crate::reference::Reference;
use crate::scenes::Case;

const FINE_THRESHOLD: f32 = 1e-6;

/// One way to divide the spectrum.
pub(crate) struct Method {
    pub(crate) name: &'static str,
    pub(crate) splitting: Splitting,
    /// Largest mean and 99th percentile of the colour differences with fine settings, if it claims any.
    pub(crate) bounds: Option<[f64; 2]>,
}

pub(crate) const METHODS: [Method; 2] = [
    Method { name: "Paper", splitting: Splitting::Paper, bounds: None },
    Method { name: "Exact", splitting: Splitting::Exact, bounds: Some([0.2, 1.0]) },
];

impl Method {
    /// The settings that the program begins with, with this splitting.
    pub(crate) fn settings(&self) -> TraceSettings {
        TraceSettings { splitting: self.splitting, ..TraceSettings::default() }
    }

    /// The same with a threshold below which nothing is seen to be left out.
    pub(crate) fn fine_settings(&self) -> TraceSettings {
        TraceSettings {
            significance_threshold: FINE_THRESHOLD,
            roulette_threshold: FINE_THRESHOLD,
            ..self.settings()
        }
    }

    /// Weight or energy below which the settings follow no ray for certain.
    fn threshold(&self, settings: &TraceSettings) -> f32 {
        match self.splitting {
            Splitting::Paper => settings.significance_threshold,
            Splitting::Exact => settings.roulette_threshold,
        }
    }

    /// Traces the case and holds it against the reference.
    pub(crate) fn compare(
        &self,
        case: &Case,
        reference: &Reference,
        settings: &TraceSettings,
        bounds: Option<[f64; 2]>,
    ) -> Comparison {
        let film = trace(case, settings);
        let difference = Difference::of(&film, reference);
        let Difference { mean, high, worst, worst_pixel: [x, y] } = difference;
        let (scene, name, threshold) = (&case.name, self.name, self.threshold(settings));
        let rays = film.counts().iter().map(|counts| f64::from(counts.rays));
        let segments = reference.mean_over_bodies(rays);
        let row = format!(
            "| {scene} | {name} | {threshold:.0e} | {mean:.3} | {high:.2} | {worst:.1} at {x}, {y} \
             | {segments:.0} |"
        );
        let exceeds = |[mean_bound, high_bound]: [f64; 2]| mean > mean_bound || high > high_bound;
        let fault = bounds
            .is_some_and(exceeds)
            .then(|| format!("{row}\nworst is {}", difference.worst_spectra(&film, reference)));
        Comparison { row, fault }
    }
}

/// What a picture's comparison comes to.
pub(crate) struct Comparison {
    /// The row of the table.
    pub(crate) row: String,
    /// What exceeds the method's bounds, with the spectra of the worst pixel.
    pub(crate) fault: Option<String>,
}

/// The head of the table.
pub(crate) const HEAD: &str = "| scene | splitting | threshold | mean ΔE₀₀ | 99 % ΔE₀₀ | worst | segments |\n\
     |---|---|---|---|---|---|---|";

/// The first pass.
pub(crate) fn trace(case: &Case, settings: &TraceSettings) -> Film {
    let tracer = CpuTracer::new(0).expect("threads start");
    let bins = Bins::new(settings.bins);
    let scene = PackedScene::new(&case.scene, bins).expect("the scene packs");
    let view = View::new(&case.camera, case.size);
    let mut film = Film::new(case.size[0], case.size[1], bins);
    tracer.trace(&scene, &view, settings, &mut film, 1, &|| false).expect("the pass completes");
    film
}
