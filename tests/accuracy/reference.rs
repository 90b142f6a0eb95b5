//! The film that the brute force records.

use brilliance_renderer::film::{Counts, Film};
use brilliance_renderer::kernel::camera::camera_ray;
use brilliance_renderer::spectrum::Bins;
use brilliance_renderer::tracer::View;
use rayon::prelude::*;

use crate::brute_force::World;
use crate::quadrature::Spectrograph;
use crate::scenes::Case;

/// What the first pass of a case should record.
pub(crate) struct Reference {
    pub(crate) film: Film,
    /// Of each pixel, whether a body is seen in it.
    pub(crate) shows_body: Vec<bool>,
    /// Rays followed for each pixel.
    pub(crate) segments: Vec<f64>,
}

struct Pixel {
    radiance: Vec<f32>,
    shows_body: bool,
    segments: u64,
}

impl Reference {
    /// Looks at least once in every `step_nm`.
    pub(crate) fn new(case: &Case, bins: Bins, step_nm: f64) -> Self {
        let view = View::new(&case.camera, case.size);
        let world = World::new(&case.scene, view.observer.as_dvec3());
        let radiances = world.emitters.radiances(bins);
        let [width, height] = case.size;
        let pixels: Vec<Pixel> = (0..width * height)
            .into_par_iter()
            .map(|i| {
                let ray = camera_ray(&view.frame, case.size, i % width, i / width, 0);
                let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
                let direction = direction.normalize();
                let mut spectrograph = Spectrograph::new(&world, origin, direction, step_nm);
                let means = spectrograph.bin_means(bins).into_iter().enumerate();
                let radiance = means.map(|(bin, shares)| {
                    let seen = radiances.iter().zip(shares.0).map(|(row, share)| row[bin] * share);
                    seen.sum::<f64>() as f32
                });
                Pixel {
                    radiance: radiance.collect(),
                    shows_body: world.shows_body(origin, direction),
                    segments: spectrograph.segments,
                }
            })
            .collect();
        let sums = pixels.iter().flat_map(|pixel| pixel.radiance.iter().copied()).collect();
        let counts = vec![Counts::default(); pixels.len()];
        Self {
            film: Film::from_sums(case.size, bins, (sums, counts), 1),
            shows_body: pixels.iter().map(|pixel| pixel.shows_body).collect(),
            segments: pixels.iter().map(|pixel| pixel.segments as f64).collect(),
        }
    }

    /// The mean of what each pixel has over those that show a body.
    pub(crate) fn mean_over_bodies(&self, values: impl Iterator<Item = f64>) -> f64 {
        let of_bodies = values.zip(&self.shows_body).filter(|(_, shows_body)| **shows_body);
        let count = self.shows_body.iter().filter(|shows_body| **shows_body).count();
        of_bodies.map(|(value, _)| value).sum::<f64>() / count as f64
    }
}
