//! Films of all kinds of pixels.

use std::ops::Range;

use brilliance_renderer::develop::Band;
use brilliance_renderer::film::{Counts, Film};
use brilliance_renderer::spectrum::{Bins, Illuminant, Spectrum};
use wgpu::BufferUsages;
use wgpu::util::DeviceExt;

use crate::GRAPHICS;

/// No multiple of a workgroup's side.
const WIDTH: u32 = 37;

/// Luminances that are to be told apart from black and white by exposure.
const LEVELS: [f32; 13] = [1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6];

/// Radiances of `bins` bins that are no colours, dark and bright spectral colours, whites, and
/// `random` spectra of all levels.
fn spectra(bins: Bins, random: usize) -> Vec<Vec<f32>> {
    let flat = |radiance: f32| vec![radiance; bins.count()];
    let but_one = |base: f32, bin: usize, radiance: f32| {
        let mut spectrum = flat(base);
        spectrum[bin] = radiance;
        spectrum
    };
    let mut spectra = vec![flat(0.0), flat(-0.5), but_one(0.4, 1, -0.2), flat(1e30)];
    for wrong in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        spectra.extend([0, 1, bins.count() - 1].map(|bin| but_one(0.5, bin, wrong)));
        spectra.push(flat(wrong));
    }
    let lights = [Spectrum::Illuminant(Illuminant::D65), Spectrum::BlackBody { kelvin: 1900.0 }];
    let lights = lights.map(|light| light.bin_means(bins));
    for level in LEVELS {
        spectra.push(flat(level));
        spectra.extend((0..bins.count()).map(|bin| but_one(0.0, bin, level)));
        let scaled = |light: &Vec<f32>| light.iter().map(|radiance| level * radiance).collect();
        spectra.extend(lights.iter().map(scaled));
    }
    let mut uniform = uniform_numbers();
    spectra.extend((0..random).map(|_| {
        let level = 10_f32.powf(8.0 * uniform() - 4.0);
        (0..bins.count()).map(|_| level * uniform().powi(4)).collect()
    }));
    spectra
}

/// Numbers in 0..1, the same in every run (D. E. Knuth's MMIX generator).
pub(crate) fn uniform_numbers() -> impl FnMut() -> f32 {
    let mut state = 1_u64;
    move || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1_u64 << 24) as f32
    }
}

/// A film with these means in its first pixels and black after them.
pub(crate) fn film_of(
    spectra: &[Vec<f32>],
    [width, height]: [u32; 2],
    bins: Bins,
    passes: u32,
) -> Film {
    let mut film = Film::new(width, height, bins);
    let means = spectra.iter().flatten();
    film.sums_mut().iter_mut().zip(means).for_each(|(sum, mean)| *sum = passes as f32 * mean);
    (0..passes).for_each(|_| complete_pass(&mut film));
    film
}

/// Counts a camera ray of each pixel.
pub(crate) fn complete_pass(film: &mut Film) {
    film.sums_and_counts_mut().1.iter_mut().for_each(|counts| counts.samples += 1.0);
    film.complete_pass();
}

/// A film of all kinds of pixels.
pub(crate) fn film_of_all_sorts(bins: u32, passes: u32, random: usize) -> Film {
    let bins = Bins::new(bins);
    let spectra = spectra(bins, random);
    let height = (spectra.len() as u32).div_ceil(WIDTH);
    film_of(&spectra, [WIDTH, height], bins, passes)
}

/// A black film with counts of all magnitudes, and none at all.
pub(crate) fn film_of_counts(passes: u32) -> Film {
    let levels = || (-60..=60).map(|level| 10_f32.powf(0.125 * level as f32));
    let mut means = vec![Counts::default()];
    means.extend(levels().map(|mean| Counts { rays: mean, ..Counts::default() }));
    means.extend(levels().map(|mean| Counts { depth: mean, ..Counts::default() }));
    means.extend(levels().map(|mean| Counts { pruned: mean, ..Counts::default() }));
    let mut uniform = uniform_numbers();
    means.extend((0..3000).map(|_| Counts {
        rays: 10_f32.powf(4.2 * uniform()),
        depth: 256.0 * uniform(),
        pruned: 10_f32.powf(-6.0 * uniform()),
        ..Counts::default()
    }));
    let height = (means.len() as u32).div_ceil(WIDTH);
    let mut film = Film::new(WIDTH, height, Bins::new(4));
    for (sums, mean) in film.sums_and_counts_mut().1.iter_mut().zip(means) {
        (0..passes).for_each(|_| *sums += mean);
    }
    (0..passes).for_each(|_| complete_pass(&mut film));
    film
}

/// Rows of a film in a buffer of the device.
fn band(film: &Film, rows: Range<u32>) -> Band {
    let width = film.size()[0] as usize;
    let pixels = rows.start as usize * width..rows.end as usize * width;
    let bins = film.bins().count();
    let sums = &film.sums()[bins * pixels.start..bins * pixels.end];
    let mut contents = bytemuck::cast_slice(sums).to_vec();
    contents.extend_from_slice(bytemuck::cast_slice::<Counts, u8>(&film.counts()[pixels]));
    let buffer = GRAPHICS.device().create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: None,
        contents: &contents,
        usage: BufferUsages::STORAGE | BufferUsages::COPY_DST,
    });
    Band { first_row: rows.start, rows: rows.end - rows.start, buffer }
}

/// The film in bands that end before these rows, and at its last.
pub(crate) fn bands(film: &Film, ends: &[u32]) -> Vec<Band> {
    let height = film.size()[1];
    let starts = [0].into_iter().chain(ends.iter().copied());
    let ends = ends.iter().copied().chain([height]);
    starts.zip(ends).map(|(start, end)| band(film, start..end)).collect()
}
