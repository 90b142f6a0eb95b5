//! The film: sums of spectral radiance per pixel, and of what it took to find them.

mod counts;
mod noise;
mod region;

pub use counts::Counts;
pub use noise::next_measurement;
pub(crate) use noise::{
    BUCKETS, BUCKETS_PER_OCTAVE, ERROR_PER_DEVIATION, LOG2_LEAST, NoiseHistogram,
    typical_brightness,
};
pub use region::{PixelRect, Region};

use rayon::prelude::*;

use crate::spectrum::Bins;

/// Radiance sums per pixel and spectral bin, and counts per pixel, over a number of passes, in which
/// not every pixel need have had a camera ray.
///
/// Memory is `width · height · (bins + 5) · 4` bytes: 133 MB of radiance and 41 MB of counts at
/// 1920×1080 with 16 bins.
#[derive(Clone, Debug)]
pub struct Film {
    width: u32,
    height: u32,
    bins: Bins,
    passes: u32,
    sums: Vec<f32>,
    counts: Vec<Counts>,
    /// Pixels that passes leave out.
    settled: Vec<bool>,
}

impl Film {
    /// Largest film of a still in bytes: 8192×8192 pixels of 16 bins.
    pub const MAX_BYTES: u64 = Self::bytes([8192, 8192], 16);

    /// Memory that a film of this size needs, wherever it is: a graphics device takes a word to mark
    /// a pixel.
    pub const fn bytes([width, height]: [u32; 2], bins: u32) -> u64 {
        let pixel = bins as usize * size_of::<f32>() + size_of::<Counts>() + size_of::<u32>();
        width as u64 * height as u64 * pixel as u64
    }

    /// An empty film.
    pub fn new(width: u32, height: u32, bins: Bins) -> Self {
        let pixels = width as usize * height as usize;
        let (sums, counts) = (vec![0.0; pixels * bins.count()], vec![Counts::default(); pixels]);
        Self { width, height, bins, passes: 0, sums, counts, settled: vec![false; pixels] }
    }

    /// A film of `passes` passes that were summed up elsewhere.
    ///
    /// # Panics
    /// The sums are not one per pixel and bin, or the counts not one per pixel.
    pub fn from_sums(
        [width, height]: [u32; 2],
        bins: Bins,
        (sums, counts): (Vec<f32>, Vec<Counts>),
        passes: u32,
    ) -> Self {
        let pixels = width as usize * height as usize;
        assert_eq!(sums.len(), pixels * bins.count(), "sums of a film");
        assert_eq!(counts.len(), pixels, "counts of a film");
        Self { width, height, bins, passes, sums, counts, settled: vec![false; pixels] }
    }

    /// Width and height in pixels.
    pub fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// The division of the spectrum.
    pub fn bins(&self) -> Bins {
        self.bins
    }

    /// Makes the film empty.
    pub fn clear(&mut self) {
        self.sums.fill(0.0);
        self.counts.fill(Counts::default());
        self.settled.fill(false);
        self.passes = 0;
    }

    /// Complete passes in the sums.
    pub fn passes(&self) -> u32 {
        self.passes
    }

    /// Radiance sums, row by row from the top, the bins of a pixel side by side.
    pub fn sums(&self) -> &[f32] {
        &self.sums
    }

    /// Sums of the counts, row by row from the top.
    pub fn counts(&self) -> &[Counts] {
        &self.counts
    }

    /// The radiance sums, to add a pass to; followed by [`complete_pass`](Self::complete_pass).
    pub fn sums_mut(&mut self) -> &mut [f32] {
        &mut self.sums
    }

    /// The same with the counts.
    pub fn sums_and_counts_mut(&mut self) -> (&mut [f32], &mut [Counts]) {
        (&mut self.sums, &mut self.counts)
    }

    /// The same, and which pixels the pass is to leave out.
    pub(crate) fn parts_mut(&mut self) -> (&mut [f32], &mut [Counts], &[bool]) {
        (&mut self.sums, &mut self.counts, &self.settled)
    }

    /// Counts the pass that was added to the sums.
    pub fn complete_pass(&mut self) {
        self.passes += 1;
    }

    /// Mean spectral radiance of all pixels over the camera rays of each, in the order of the sums.
    pub fn means(&self) -> Vec<f32> {
        let mut means = self.sums.clone();
        let pixels = means.par_chunks_exact_mut(self.bins.count()).zip(&self.counts);
        pixels.for_each(|(means, counts)| {
            let scale = counts.scale();
            for mean in means {
                *mean *= scale;
            }
        });
        means
    }

    /// Mean spectral radiance of the pixel at column `x`, row `y`, one value per bin.
    pub fn pixel(&self, x: u32, y: u32) -> Vec<f32> {
        let pixel = y as usize * self.width as usize + x as usize;
        let start = pixel * self.bins.count();
        let scale = self.counts[pixel].scale();
        self.sums[start..start + self.bins.count()].iter().map(|sum| sum * scale).collect()
    }

    /// Mean spectral radiance of the pixels of `rect` that lie in the film, one value per bin; 0
    /// where none does. A sum that is not finite counts as none.
    pub fn mean_spectrum(&self, rect: PixelRect) -> Vec<f32> {
        let scale_of = |pixel: usize| self.counts[pixel].scale();
        mean_in(&self.sums, scale_of, self.size(), self.bins, rect)
    }
}

/// [`Film::mean_spectrum`] of a film whose sums of a pixel become means by `scale_of` it.
pub(crate) fn mean_in(
    sums: &[f32],
    scale_of: impl Fn(usize) -> f32 + Sync,
    size: [u32; 2],
    bins: Bins,
    rect: PixelRect,
) -> Vec<f32> {
    let count = bins.count();
    let Some(rect) = rect.within(size) else { return vec![0.0; count] };
    let rows = rect.min[1] as usize..(rect.min[1] + rect.size[1]) as usize;
    let rows = rows.into_par_iter().map(|row| {
        let mut means = vec![0.0; count];
        let first = row * size[0] as usize + rect.min[0] as usize;
        for pixel in first..first + rect.size[0] as usize {
            let scale = f64::from(scale_of(pixel));
            for (mean, &sum) in means.iter_mut().zip(&sums[pixel * count..]) {
                *mean += if sum.is_finite() { scale * f64::from(sum) } else { 0.0 };
            }
        }
        means
    });
    let rows: Vec<_> = rows.collect();
    mean_of_pixels(rows.iter().flatten().copied(), bins, rect.count())
}

/// The mean of `pixels` pixels whose means, the bins side by side, were added up in parts.
pub(crate) fn mean_of_pixels(
    parts: impl Iterator<Item = f64>,
    bins: Bins,
    pixels: u64,
) -> Vec<f32> {
    let mut sums = vec![0.0; bins.count()];
    for (part, bin) in parts.zip((0..bins.count()).cycle()) {
        sums[bin] += part;
    }
    let scale = 1.0 / pixels.max(1) as f64;
    sums.into_iter().map(|sum| (sum * scale) as f32).collect()
}
