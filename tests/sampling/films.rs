//! Films of a diamond, pass by pass.

use std::sync::{Arc, LazyLock};

use brilliance_renderer::camera::Camera;
use brilliance_renderer::film::{Film, next_measurement};
use brilliance_renderer::packed::PackedScene;
use brilliance_renderer::scene_file::Document;
use brilliance_renderer::session::RenderRequest;
use brilliance_renderer::settings::{NoiseGoal, TraceSettings};
use brilliance_renderer::spectrum::Bins;
use brilliance_renderer::statistics::Statistics;
use brilliance_renderer::tracer::{Backend, CpuTracer, Tracer, View};
use glam::Vec3;

pub(crate) const SIZE: [u32; 2] = [48, 48];

/// What films are compared with.
pub(crate) static LONG: LazyLock<Film> = LazyLock::new(|| {
    let diamond = Diamond::new();
    let mut film = diamond.film();
    diamond.trace(&mut film, 1024);
    film
});

/// Some facets of a diamond, traced with a good deal of chance.
pub(crate) struct Diamond {
    tracer: CpuTracer,
    scene: PackedScene,
    view: View,
    trace: TraceSettings,
}

impl Diamond {
    pub(crate) fn new() -> Self {
        let RenderRequest { scene, camera, trace, .. } = request(NoiseGoal::NONE, 0);
        let scene = PackedScene::new(&scene, Bins::new(trace.bins)).expect("it packs");
        let tracer = CpuTracer::new(0).expect("there are threads");
        Self { tracer, scene, view: View::new(&camera, SIZE), trace }
    }

    pub(crate) fn film(&self) -> Film {
        Film::new(SIZE[0], SIZE[1], Bins::new(self.trace.bins))
    }

    /// Adds passes.
    pub(crate) fn trace(&self, film: &mut Film, passes: u32) -> Statistics {
        let (scene, view, trace) = (&self.scene, &self.view, &self.trace);
        self.tracer.trace(scene, view, trace, film, passes, &|| false).expect("it is traced")
    }

    /// A film of so many passes that leave out what `goal` says; what it took, and its noise.
    pub(crate) fn trace_to(&self, goal: NoiseGoal, passes: u32) -> (Film, Statistics, f32) {
        let (mut film, mut statistics, mut noise) = (self.film(), Statistics::default(), 0.0);
        while film.passes() < passes {
            let more = next_measurement(film.passes()).min(passes) - film.passes();
            statistics += self.trace(&mut film, more);
            noise = film.measure_noise(goal);
        }
        (film, statistics, noise)
    }
}

/// Asks for the same as a still.
pub(crate) fn request(noise: NoiseGoal, pass_limit: u32) -> RenderRequest {
    let document = Document::default();
    let camera = document.scene.camera;
    let target = Vec3::new(1.2, -0.8, 0.0);
    RenderRequest {
        camera: Camera { target, fov_y_radians: 0.12 * camera.fov_y_radians, ..camera },
        scene: Arc::new(document.scene),
        size: SIZE,
        trace: TraceSettings { roulette_threshold: 0.03, ..document.trace },
        pass_limit,
        noise,
        backend: Backend::Cpu,
    }
}

/// Radiance of each pixel, summed over the bins.
pub(crate) fn brightness(film: &Film) -> Vec<f64> {
    let means = film.means();
    let pixels = means.chunks_exact(film.bins().count());
    pixels.map(|bins| bins.iter().map(|&mean| f64::from(mean)).sum()).collect()
}

/// The errors of a film's pixels as a part of what it has there and typically.
pub(crate) fn relative_errors(film: &Film, long: &Film) -> Vec<f64> {
    let (found, expected) = (brightness(film), brightness(long));
    let roots: f64 = found.iter().map(|mean| mean.sqrt()).sum();
    let typical = (roots / found.len() as f64).powi(2);
    let pairs = found.iter().zip(&expected);
    pairs.map(|(found, expected)| (found - expected) / (found + typical)).collect()
}
