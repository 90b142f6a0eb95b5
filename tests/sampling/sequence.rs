//! The points of a pixel are spread evenly after every number of passes.

use brilliance_renderer::kernel::camera::pixel_seed;
use brilliance_renderer::kernel::rng::{hash, pixel_sample, scramble, sobol_second, unit_float};

/// Pixels that are looked at.
const SEEDS: u32 = 40;

/// The point of a pass before the first one is moved to the middle.
fn scrambled_point(seed: u32, index: u32) -> [f32; 2] {
    let x = scramble(index.reverse_bits(), hash(seed));
    let y = scramble(sobol_second(index), hash(seed ^ 0x9e37_79b9));
    [unit_float(x), unit_float(y)]
}

/// Square of the L2 star discrepancy by the formula of Warnock 1972, in two dimensions.
fn squared_discrepancy(points: &[[f64; 2]]) -> f64 {
    let count = points.len() as f64;
    let single: f64 = points.iter().map(|[x, y]| (1.0 - x * x) * (1.0 - y * y)).sum();
    let pairs = points
        .iter()
        .flat_map(|a| points.iter().map(move |b| (1.0 - a[0].max(b[0])) * (1.0 - a[1].max(b[1]))));
    1.0 / 9.0 - single / (2.0 * count) + pairs.sum::<f64>() / (count * count)
}

/// What [`squared_discrepancy`] is for random points in the mean: (½ⁿ − ⅓ⁿ) / count, n = 2.
fn squared_discrepancy_of_chance(count: usize) -> f64 {
    (0.25 - 1.0 / 9.0) / count as f64
}

/// Sobol's first two dimensions are a (0, 2)-sequence in base 2 (Niederreiter 1987), and Owen's
/// scrambling leaves them one: each run of 2ᵐ points from a multiple of 2ᵐ on has one point in each
/// rectangle of 2⁻ᵃ by 2⁻ᵇ, a + b = m.
#[test]
fn every_elementary_interval_has_its_point() {
    for seed in (0..SEEDS).map(hash) {
        for m in 0..=8_u32 {
            for run in 0..3 {
                let points = (run << m..(run + 1) << m).map(|i| scrambled_point(seed, i));
                let points: Vec<_> = points.collect();
                for a in 0..=m {
                    let mut is_met = vec![false; 1 << m];
                    for [x, y] in &points {
                        let column = (x * (1 << a) as f32) as usize;
                        let row = (y * (1 << (m - a)) as f32) as usize;
                        is_met[(row << a) + column] = true;
                    }
                    assert!(is_met.iter().all(|&is_met| is_met), "{m} {run} {a}");
                }
            }
        }
    }
}

/// The square discrepancy of random points is 5/36 over their number in the mean; here it falls by as
/// much again.
#[test]
fn every_number_of_passes_fills_the_pixel_better_than_chance() {
    let pixels = (0..SEEDS).map(hash).map(|seed| {
        let points = (0..256).map(|pass| pixel_sample(seed, pass).map(f64::from));
        points.collect::<Vec<_>>()
    });
    let pixels: Vec<_> = pixels.collect();
    for count in 2..=256 {
        let chance = squared_discrepancy_of_chance(count);
        let ratios = pixels.iter().map(|points| squared_discrepancy(&points[..count]) / chance);
        let ratios: Vec<_> = ratios.collect();
        let mean = ratios.iter().sum::<f64>() / ratios.len() as f64;
        assert!(mean < (9.0 / count as f64).min(1.0), "{count} points: {mean} of chance");
        let worst = ratios.iter().fold(0.0, |worst: f64, &ratio| worst.max(ratio));
        assert!(worst < 18.0 / count as f64, "{count} points: {worst} of chance at worst");
    }
}

#[test]
fn the_first_pass_is_in_the_middle_and_neighbours_part_after_it() {
    let pixels: Vec<_> = (0..6).flat_map(|y| (0..6).map(move |x| pixel_seed(x, y))).collect();
    assert!(pixels.iter().all(|&seed| pixel_sample(seed, 0) == [0.5, 0.5]));
    for pass in 1..20 {
        let mut points: Vec<_> = pixels.iter().map(|&seed| pixel_sample(seed, pass)).collect();
        assert!(points.iter().flatten().all(|number| (0.0..1.0).contains(number)));
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        assert!(points.is_sorted_by(|a, b| a[0] < b[0]), "two pixels have a point in common");
    }
}

/// The points that 4096 pixels have in one pass fill the square as random ones do: scrambling
/// prefers no place.
#[test]
fn no_place_in_the_pixel_is_preferred() {
    for pass in [1, 2, 5, 63] {
        let mut hits = [0_u32; 64];
        for seed in (0..4096).map(|x| pixel_seed(x % 64, x / 64)) {
            let [x, y] = pixel_sample(seed, pass);
            hits[(8.0 * x) as usize + 8 * (8.0 * y) as usize] += 1;
        }
        // χ² of 63 degrees of freedom is above 120 once in 50 000 times.
        let chi_squared: f64 =
            hits.iter().map(|&hits| (f64::from(hits) - 64.0).powi(2) / 64.0).sum();
        assert!(chi_squared < 120.0, "pass {pass}: {chi_squared}");
    }
}
