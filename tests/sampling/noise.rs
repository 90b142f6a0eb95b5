//! What is said of the noise is true.

use brilliance_renderer::film::{Counts, Film};
use brilliance_renderer::settings::NoiseGoal;
use brilliance_renderer::spectrum::Bins;

use crate::films::{Diamond, LONG, SIZE, relative_errors};

/// The 98th percentile over pixels of the error of each, or of the root mean square around it.
pub(crate) fn percentile_98(errors: &[f64]) -> f64 {
    let [width, height] = SIZE.map(|side| side as usize);
    let around = |x: usize, y: usize| {
        let rows = y.saturating_sub(1)..(y + 2).min(height);
        let squares: Vec<_> = rows
            .flat_map(|row| {
                let columns = x.saturating_sub(1)..(x + 2).min(width);
                columns.map(move |column| errors[row * width + column].powi(2))
            })
            .collect();
        let mean = squares.iter().sum::<f64>() / squares.len() as f64;
        mean.sqrt().max(errors[y * width + x].abs())
    };
    let mut pooled: Vec<_> = (0..width * height).map(|i| around(i % width, i / width)).collect();
    pooled.sort_by(f64::total_cmp);
    pooled[pooled.len() * 98 / 100]
}

/// Within a factor of 3, since few rays can't know what all of them missed.
#[test]
fn the_noise_of_a_diamond_is_what_a_long_film_shows_of_it() {
    let diamond = Diamond::new();
    for passes in [16, 32, 64, 128] {
        let (film, _, noise) = diamond.trace_to(NoiseGoal::NONE, passes);
        let expected = percentile_98(&relative_errors(&film, &LONG));
        let ratio = f64::from(noise) / expected;
        assert!((0.33..3.0).contains(&ratio), "{passes} passes: {noise} for {expected}");
    }
}

/// A film of one bin whose pixels found these numbers.
fn film_of(samples: &[&[f32]], width: u32) -> Film {
    let height = samples.len() as u32 / width;
    let mut film = Film::new(width, height, Bins::new(4));
    let (sums, counts) = film.sums_and_counts_mut();
    for ((sums, counts), samples) in sums.chunks_exact_mut(4).zip(counts).zip(samples) {
        for &found in *samples {
            for sum in &mut *sums {
                *sum += found;
            }
            let squares = found * found;
            *counts += Counts { samples: 1.0, squares, ..Counts::default() };
        }
    }
    film
}

/// By hand: 16 samples, half 1 and half 3, have a mean of 2, and a variance of 16/15. The error is
/// 1.25·√(16/15)/16^(3/4) = 0.161, and all pixels being alike it is divided by 2 + 2.
#[test]
fn the_noise_of_equal_pixels_is_as_by_hand() {
    let samples: Vec<f32> = (0..16).map(|i| if i < 8 { 1.0 } else { 3.0 }).collect();
    let mut film = film_of(&[samples.as_slice(); 12], 4);
    let noise = film.measure_noise(NoiseGoal::NONE);
    let expected = 1.25 * (16.0_f32 / 15.0).sqrt() / 8.0 / 4.0;
    // The histogram's buckets are an eighth of an octave wide.
    assert!((noise / expected).log2().abs() < 0.125, "{noise} for {expected}");
}

#[test]
fn even_light_darkness_and_what_is_no_number_have_no_noise() {
    for found in [0.0, 1.0, 1e-30, 1e15, f32::NAN, f32::INFINITY] {
        let samples = [found; 8];
        let noise = film_of(&[samples.as_slice(); 9], 3).measure_noise(NoiseGoal::default());
        assert!((0.0..1e-3).contains(&noise), "{found}: {noise}");
    }
    assert_eq!(Film::new(3, 3, Bins::new(4)).measure_noise(NoiseGoal::default()), 0.0);
    assert_eq!(Film::new(0, 5, Bins::new(4)).measure_noise(NoiseGoal::default()), 0.0);
}
