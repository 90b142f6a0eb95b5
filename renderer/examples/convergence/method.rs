//! The methods, each of which adds passes to a picture of its own.

use std::time::Instant;

use brilliance_renderer::develop::XyzImage;
use brilliance_renderer::error::RendererError;
use brilliance_renderer::film::Film;
use brilliance_renderer::packed::PackedScene;
use brilliance_renderer::settings::{Splitting, TraceSettings};
use brilliance_renderer::spectrum::Bins;
use brilliance_renderer::statistics::Statistics;
use brilliance_renderer::tracer::{CpuTracer, Tracer, View};

use crate::baseline::Baseline;
use crate::scene::ReferenceScene;

/// How a picture is made.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Method {
    /// By the program, with these settings.
    Split(TraceSettings),
    /// By one wavelength per path.
    MonteCarlo,
}

/// A method and its name in tables and plots.
pub(crate) struct Candidate {
    pub(crate) name: &'static str,
    pub(crate) method: Method,
}

/// Those that are compared; the first is what the others are held against.
pub(crate) fn all() -> Vec<Candidate> {
    let split = |splitting, bins| {
        Method::Split(TraceSettings { splitting, bins, ..TraceSettings::default() })
    };
    vec![
        Candidate { name: "Monte Carlo", method: Method::MonteCarlo },
        Candidate { name: "Paper", method: split(Splitting::Paper, 16) },
        Candidate { name: "Exact", method: split(Splitting::Exact, 16) },
        Candidate { name: "Exact, 32 bins", method: split(Splitting::Exact, 32) },
    ]
}

/// A picture in the making.
pub(crate) trait Picture {
    /// Adds passes of one camera ray per pixel, and returns the seconds that it took.
    fn add_passes(&mut self, passes: u32) -> Result<f64, RendererError>;

    /// The mean over the passes.
    fn image(&self) -> XyzImage;

    /// Rays per camera ray.
    fn mean_segments(&self) -> f64;
}

impl Method {
    /// An empty picture.
    pub(crate) fn start(&self, scene: &ReferenceScene) -> Result<Box<dyn Picture>, RendererError> {
        Ok(match self {
            Self::Split(settings) => Box::new(SplitPicture::new(scene, settings)?),
            Self::MonteCarlo => Box::new(Baseline::new(scene, 0)?),
        })
    }
}

/// A film, and all that its tracer needs.
struct SplitPicture {
    tracer: CpuTracer,
    scene: PackedScene,
    view: View,
    settings: TraceSettings,
    film: Film,
    statistics: Statistics,
}

impl SplitPicture {
    fn new(scene: &ReferenceScene, settings: &TraceSettings) -> Result<Self, RendererError> {
        let bins = Bins::new(settings.bins);
        Ok(Self {
            tracer: CpuTracer::new(0)?,
            scene: PackedScene::new(&scene.document.scene, bins)?,
            view: View::new(&scene.document.scene.camera, scene.size),
            settings: settings.clone(),
            film: Film::new(scene.size[0], scene.size[1], bins),
            statistics: Statistics::default(),
        })
    }
}

impl Picture for SplitPicture {
    fn add_passes(&mut self, passes: u32) -> Result<f64, RendererError> {
        let Self { tracer, scene, view, settings, film, statistics } = self;
        let start = Instant::now();
        *statistics += tracer.trace(scene, view, settings, film, passes, &|| false)?;
        Ok(start.elapsed().as_secs_f64())
    }

    fn image(&self) -> XyzImage {
        XyzImage::from_film(&self.film)
    }

    fn mean_segments(&self) -> f64 {
        self.statistics.mean_segments_per_camera_ray()
    }
}
