//! Errors of all methods on one scene, while their pictures grow.

use brilliance_renderer::color;
use brilliance_renderer::develop::XyzImage;
use brilliance_renderer::error::RendererError;

use crate::baseline::Baseline;
use crate::method::{Candidate, Picture};
use crate::rmse::{relative_rmse, rmse};
use crate::scene::ReferenceScene;

/// The converged picture's passes begin far beyond those of the others: its error is its own.
const REFERENCE_FIRST_PASS: u32 = 1 << 30;

/// A picture after some passes.
#[derive(Clone, Copy)]
pub(crate) struct Point {
    pub(crate) passes: u32,
    /// Of tracing, on all threads.
    pub(crate) seconds: f64,
    pub(crate) error: PictureError,
}

/// How far a picture is from the converged one.
#[derive(Clone, Copy)]
pub(crate) struct PictureError {
    /// RMSE of linear RGB over the mean luminance.
    pub(crate) linear: f64,
    /// RMSE of channels in 0..=1 after exposure, clipping and sRGB encoding.
    pub(crate) shown: f64,
    /// Mean luminance over that of the converged picture.
    pub(crate) light: f64,
}

/// A kind of error.
#[derive(Clone, Copy)]
pub(crate) enum Measure {
    Linear,
    Shown,
}

impl PictureError {
    pub(crate) fn by(&self, measure: Measure) -> f64 {
        match measure {
            Measure::Linear => self.linear,
            Measure::Shown => self.shown,
        }
    }
}

/// A method's way to the converged picture.
pub(crate) struct Curve {
    pub(crate) name: &'static str,
    pub(crate) points: Vec<Point>,
    /// What is there after an eighth of the time.
    pub(crate) early_picture: XyzImage,
    pub(crate) segments_per_camera_ray: f64,
    pub(crate) segments_per_second: f64,
}

/// How long methods are followed.
#[derive(Clone, Copy)]
pub(crate) struct Effort {
    /// Passes of the converged picture.
    pub(crate) reference_passes: u32,
    /// Seconds after which a method's passes are doubled no more.
    pub(crate) seconds: f64,
}

/// A converged picture, and how far it is from converged.
pub(crate) struct Reference {
    pub(crate) image: XyzImage,
    exposure: f64,
    /// By the difference of its two halves.
    pub(crate) error: PictureError,
}

impl Reference {
    /// Traces it by the baseline, which makes no errors but of chance.
    pub(crate) fn trace(scene: &ReferenceScene, effort: Effort) -> Result<Self, RendererError> {
        let half = effort.reference_passes / 2;
        let mut baseline = Baseline::new(scene, REFERENCE_FIRST_PASS)?;
        baseline.add_passes(half)?;
        let first_half = baseline.image();
        baseline.add_passes(half)?;
        let image = baseline.image();
        let exposure = f64::from(scene.document.display.exposure_ev).exp2();
        let nothing = PictureError { linear: 0.0, shown: 0.0, light: 1.0 };
        let reference = Self { image, exposure, error: nothing };
        // Half of the difference of the halves, which is what the first is off by from the mean.
        let error = reference.error_of(&first_half);
        Ok(Self { error, ..reference })
    }

    /// How far `image` is from this one.
    pub(crate) fn error_of(&self, image: &XyzImage) -> PictureError {
        let (found, wanted) = (image.linear_rgb(), self.image.linear_rgb());
        let shown = |pixels: &[[f32; 3]]| -> Vec<[f32; 3]> {
            pixels.iter().map(|rgb| rgb.map(|channel| self.show(channel))).collect()
        };
        PictureError {
            linear: relative_rmse(&found, &wanted),
            shown: rmse(&shown(&found), &shown(&wanted)),
            light: luminance(image) / luminance(&self.image),
        }
    }

    fn show(&self, channel: f32) -> f32 {
        color::srgb_encode((f64::from(channel) * self.exposure).clamp(0.0, 1.0)) as f32
    }
}

fn luminance(image: &XyzImage) -> f64 {
    image.xyz.iter().map(|xyz| f64::from(xyz[1])).sum()
}

/// Doubles the passes of all methods in turn, so that whatever else the machine does meets them alike.
pub(crate) fn follow(
    scene: &ReferenceScene,
    reference: &Reference,
    candidates: &[Candidate],
    effort: Effort,
) -> Result<Vec<Curve>, RendererError> {
    let mut growing = Vec::new();
    for candidate in candidates {
        // Threads and tables are ready then.
        candidate.method.start(scene)?.add_passes(2)?;
        growing.push(Growing::new(scene, candidate)?);
    }
    while growing.iter().any(|growing| growing.seconds() < effort.seconds) {
        for growing in &mut growing {
            if growing.seconds() < effort.seconds {
                growing.double(reference, EARLY * effort.seconds)?;
            }
        }
    }
    Ok(growing.into_iter().map(|growing| growing.finish(scene)).collect())
}

/// When pictures are kept, as a part of the time.
const EARLY: f64 = 1.0 / 8.0;

/// A picture in the making, and its way so far.
struct Growing {
    name: &'static str,
    picture: Box<dyn Picture>,
    points: Vec<Point>,
    early_picture: Option<XyzImage>,
}

impl Growing {
    fn new(scene: &ReferenceScene, candidate: &Candidate) -> Result<Self, RendererError> {
        let picture = candidate.method.start(scene)?;
        Ok(Self { name: candidate.name, picture, points: Vec::new(), early_picture: None })
    }

    fn seconds(&self) -> f64 {
        self.points.last().map_or(0.0, |point| point.seconds)
    }

    fn double(&mut self, reference: &Reference, early_seconds: f64) -> Result<(), RendererError> {
        let passes = self.points.last().map_or(0, |point| point.passes);
        let more = passes.max(1);
        let seconds = self.seconds() + self.picture.add_passes(more)?;
        let image = self.picture.image();
        let error = reference.error_of(&image);
        self.points.push(Point { passes: passes + more, seconds, error });
        if seconds >= early_seconds {
            self.early_picture.get_or_insert(image);
        }
        Ok(())
    }

    fn finish(self, scene: &ReferenceScene) -> Curve {
        let segments_per_camera_ray = self.picture.mean_segments();
        let camera_rays = f64::from(scene.size[0] * scene.size[1]);
        let passes_per_second = self.points.last().map_or(0.0, |p| f64::from(p.passes) / p.seconds);
        Curve {
            name: self.name,
            early_picture: self.early_picture.unwrap_or_else(|| self.picture.image()),
            points: self.points,
            segments_per_camera_ray,
            segments_per_second: segments_per_camera_ray * camera_rays * passes_per_second,
        }
    }
}

impl Curve {
    /// Seconds in which this method reaches `error`; between two points both are taken as powers of
    /// each other. None where it never does.
    pub(crate) fn seconds_to(&self, error: f64, measure: Measure) -> Option<f64> {
        let reached = self.points.iter().position(|point| point.error.by(measure) <= error)?;
        let after = &self.points[reached];
        let Some(before) = reached.checked_sub(1).map(|i| &self.points[i]) else {
            return Some(after.seconds);
        };
        let [high, low] = [before, after].map(|point| point.error.by(measure).ln());
        let part = if high > low { (high - error.ln()) / (high - low) } else { 1.0 };
        Some((before.seconds.ln() + part * (after.seconds / before.seconds).ln()).exp())
    }
}
