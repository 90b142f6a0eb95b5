//! Mean counts of a film.

use rayon::prelude::*;

use super::PIXELS_PER_TASK;
use super::heat::{HeatMap, HeatScale, codes};
use crate::film::{Counts, Film};

/// Mean counts per pixel over its camera rays.
#[derive(Clone, Debug)]
pub struct CountImage {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Means of one camera ray, row by row from the top.
    pub means: Vec<Counts>,
}

impl CountImage {
    /// The means of the film so far.
    pub fn from_film(film: &Film) -> Self {
        let counts = film.counts().par_iter().with_min_len(PIXELS_PER_TASK);
        let means = counts.copied().map(Counts::mean).collect();
        Self { size: film.size(), means }
    }

    /// A heat map: sRGB-encoded, 8 bits per channel, with an opaque alpha.
    pub fn develop_rgba8(&self, map: HeatMap) -> Vec<u8> {
        let scale = HeatScale::new(map);
        let mut rgba8 = vec![255; 4 * self.means.len()];
        rgba8
            .par_chunks_mut(4 * PIXELS_PER_TASK)
            .zip(self.means.par_chunks(PIXELS_PER_TASK))
            .for_each(|(rgba8, means)| {
                for (rgba8, means) in rgba8.chunks_exact_mut(4).zip(means) {
                    rgba8[..3].copy_from_slice(&codes(scale.color(map.of(means))));
                }
            });
        rgba8
    }

    /// A heat map: sRGB-encoded, 16 bits per channel, red, green, blue.
    pub fn develop_rgb16(&self, map: HeatMap) -> Vec<u16> {
        let scale = HeatScale::new(map);
        let encode = |channel: f32| (65535.0 * channel).round() as u16;
        let means = self.means.par_iter().with_min_len(PIXELS_PER_TASK);
        means.flat_map_iter(|means| scale.color(map.of(means)).map(encode)).collect()
    }
}
