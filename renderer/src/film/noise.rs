//! Noise: how far the pixels of a film may be from what endless passes would make of them.
//!
//! What a camera ray finds is taken as one number, its radiance as the mean over the bins, since
//! nothing before developing knows an observer. A pixel whose *n* camera rays found numbers of mean
//! *m* and variance *v* is off by about 1.25·√v·n^(−3/4): the points of a pixel are scrambled nets,
//! which at an edge do better than chance by n^(−1/4) (Owen 1997; the factor is measured on diamonds).
//! That is divided by *m* + *t*, where *t* is the square of the mean of √m over the film: what is
//! tolerable in the dark depends on the whole picture, but little on its few brightest pixels.
//!
//! The noise of a pixel is that, or the root mean square of it over the pixel and its neighbours where
//! that is more: a pixel whose few rays all missed a glint that a neighbour found is not taken for
//! settled.

use rayon::prelude::*;

use super::Film;
use super::counts::Counts;
use crate::settings::NoiseGoal;

/// Passes before which nothing is known of the noise.
const FIRST_PASSES: u32 = 8;
/// Least number of passes between two measurements.
const FEWEST_PASSES: u32 = 4;
/// Binary logarithm of the least noise that is told from none.
pub(crate) const LOG2_LEAST: f32 = -12.0;
/// Buckets per doubling of the noise.
pub(crate) const BUCKETS_PER_OCTAVE: f32 = 8.0;
/// Buckets of the histogram, the first of which holds what is less than the least noise.
pub(crate) const BUCKETS: usize = 128;
/// Of error per standard deviation, where there is one camera ray.
pub(crate) const ERROR_PER_DEVIATION: f32 = 1.25;
/// Part of the pixels whose noise that of the film is no less than.
const SHARE: f64 = 0.98;

/// The number of passes after which the noise is measured next, where it was after `passes`: often
/// enough that few camera rays go to pixels that are settled, and at runs of points that fill a
/// pixel evenly.
pub fn next_measurement(passes: u32) -> u32 {
    if passes < FIRST_PASSES {
        return FIRST_PASSES;
    }
    let octave = 1 << passes.ilog2();
    let step = (octave / 4).max(FEWEST_PASSES);
    (passes / step + 1).saturating_mul(step)
}

/// How many pixels have how much noise, in buckets of equal ratios.
#[derive(Clone, Debug)]
pub(crate) struct NoiseHistogram {
    counts: Vec<u32>,
}

impl NoiseHistogram {
    /// Of pixels that were counted elsewhere.
    pub(crate) fn of_counts(counts: Vec<u32>) -> Self {
        Self { counts }
    }

    fn empty() -> Self {
        Self { counts: vec![0; BUCKETS] }
    }

    /// The noise that 98 of 100 pixels do not exceed.
    pub(crate) fn percentile_98(&self) -> f32 {
        let pixels: u64 = self.counts.iter().map(|&count| u64::from(count)).sum();
        let below = SHARE * pixels as f64;
        let mut counted = 0.0;
        for (bucket, &count) in self.counts.iter().enumerate() {
            let count = f64::from(count);
            if counted + count < below {
                counted += count;
                continue;
            }
            let inside = if count > 0.0 { (below - counted) / count } else { 0.0 };
            let octaves = (bucket as f64 + inside) / f64::from(BUCKETS_PER_OCTAVE);
            return if bucket == 0 { 0.0 } else { (octaves as f32 + LOG2_LEAST).exp2() };
        }
        0.0
    }

    fn count(&mut self, noise: f32) {
        self.counts[bucket_of(noise)] += 1;
    }

    fn add(mut self, other: Self) -> Self {
        for (count, more) in self.counts.iter_mut().zip(other.counts) {
            *count += more;
        }
        self
    }
}

impl Film {
    /// The noise that 98 of 100 pixels do not exceed, as a part of their brightness and the
    /// picture's; 0 is none. Marks the pixels that later passes leave out by `goal`.
    pub fn measure_noise(&mut self, goal: NoiseGoal) -> f32 {
        let brightness = self.brightness();
        let roots: f64 = brightness.iter().map(|mean| f64::from(mean.sqrt())).sum();
        let typical = typical_brightness(roots, brightness.len());
        let counts = self.counts.par_iter();
        let variances: Vec<_> = counts
            .zip(&brightness)
            .map(|(counts, &mean)| relative_variance(counts, mean, typical))
            .collect();
        let width = self.width as usize;
        let rows = self.settled.par_chunks_exact_mut(width.max(1)).enumerate();
        let histogram = rows.fold(NoiseHistogram::empty, |mut histogram, (y, row)| {
            for (x, is_settled) in row.iter_mut().enumerate() {
                let noise = pooled_noise(&variances, width, x, y);
                *is_settled = goal.settles(noise);
                histogram.count(noise);
            }
            histogram
        });
        histogram.reduce(NoiseHistogram::empty, NoiseHistogram::add).percentile_98()
    }

    /// Mean radiance of each pixel over bins and camera rays; 0 where there is none.
    fn brightness(&self) -> Vec<f32> {
        let bins = self.bins.count();
        let pixels = self.sums.par_chunks_exact(bins).zip(&self.counts);
        let means = pixels.map(|(sums, counts)| {
            let mean = sums.iter().sum::<f32>() / bins as f32 * counts.scale();
            if mean.is_finite() { mean.max(0.0) } else { 0.0 }
        });
        means.collect()
    }
}

/// The square of the mean of the roots of `pixels` pixels' brightness, the sum of which is `roots`.
pub(crate) fn typical_brightness(roots: f64, pixels: usize) -> f32 {
    (roots / pixels.max(1) as f64).powi(2) as f32
}

/// Square of the error that the mean of a pixel is expected to have, as a part of it and of what is
/// typical; 0 where it is not known.
fn relative_variance(counts: &Counts, mean: f32, typical: f32) -> f32 {
    let samples = counts.samples;
    let scale = mean + typical;
    if samples < 2.0 || scale <= 0.0 {
        return 0.0;
    }
    let variance = (counts.squares - samples * mean * mean) / (samples - 1.0);
    let error = ERROR_PER_DEVIATION / scale;
    let relative = error * error * variance / (samples * samples.sqrt());
    if relative.is_finite() { relative.max(0.0) } else { 0.0 }
}

/// The relative error of a pixel, or its root mean square over the pixel and its neighbours where that
/// is more. Where it is above a limit, it is so too at a pixel around whose own error is.
fn pooled_noise(variances: &[f32], width: usize, x: usize, y: usize) -> f32 {
    let mut sum = 0.0;
    let mut pixels = 0.0;
    let height = variances.len() / width;
    for row in y.saturating_sub(1)..(y + 2).min(height) {
        for column in x.saturating_sub(1)..(x + 2).min(width) {
            sum += variances[row * width + column];
            pixels += 1.0;
        }
    }
    variances[y * width + x].max(sum / pixels).sqrt()
}

/// The place of a noise in the histogram.
fn bucket_of(noise: f32) -> usize {
    let bucket = (noise.max(LOG2_LEAST.exp2()).log2() - LOG2_LEAST) * BUCKETS_PER_OCTAVE;
    bucket.clamp(0.0, (BUCKETS - 1) as f32) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measurements_come_ever_more_slowly() {
        let mut passes = 0;
        let measured: Vec<_> = std::iter::repeat_with(|| {
            passes = next_measurement(passes);
            passes
        })
        .take(16)
        .collect();
        assert_eq!(measured, [8, 12, 16, 20, 24, 28, 32, 40, 48, 56, 64, 80, 96, 112, 128, 160]);
        // From anywhere to the same places.
        assert_eq!((next_measurement(5), next_measurement(13), next_measurement(63)), (8, 16, 64));
        assert_eq!(next_measurement(u32::MAX), u32::MAX);
    }

    #[test]
    fn ninety_eight_of_a_hundred_pixels_are_below_the_noise() {
        let noise_of = |noises: &[f32]| {
            let mut histogram = NoiseHistogram::empty();
            for &noise in noises {
                histogram.count(noise);
            }
            histogram.percentile_98()
        };
        assert_eq!(noise_of(&[]), 0.0);
        assert_eq!(noise_of(&[0.0; 50]), 0.0);
        let bucket_width = (1.0 / BUCKETS_PER_OCTAVE).exp2();
        for noise in [0.001, 0.02, 0.7, 3.0] {
            let found = noise_of(&[noise; 1000]);
            assert!(found / noise < bucket_width && noise / found < bucket_width, "{found}");
            // Two pixels in a hundred may have any noise, three may not.
            let mut noises = vec![0.5 * noise; 1000];
            noises[..19].fill(10.0);
            assert!(noise_of(&noises) < noise);
            noises[..30].fill(10.0);
            assert!(noise_of(&noises) > 8.0);
        }
    }
}
