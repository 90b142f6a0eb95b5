//! A graphics device develops films to the same pictures as the processor.

mod films;
mod heat;
mod views;

use std::sync::LazyLock;

use brilliance_renderer::color::srgb_decode;
use brilliance_renderer::develop::{
    Band, GpuCountImage, GpuDeveloper, GpuXyzImage, HeatMap, XyzImage,
};
use brilliance_renderer::error::RendererError;
use brilliance_renderer::film::{Film, PixelRect};
use brilliance_renderer::gpu::Graphics;
use brilliance_renderer::settings::{DisplaySettings, ToneCurve, WhitePoint};
use brilliance_renderer::spectrum::Bins;
use films::{bands, complete_pass, film_of, film_of_all_sorts, uniform_numbers};
use views::load;
use wgpu::{TextureFormat, TextureUsages};

static GRAPHICS: LazyLock<Graphics> =
    LazyLock::new(|| Graphics::open(true).expect("a graphics device"));
static DEVELOPER: LazyLock<GpuDeveloper> =
    LazyLock::new(|| GpuDeveloper::new(&GRAPHICS).expect("its shaders"));

fn expose(film: &Film, bands: &[Band]) -> GpuXyzImage {
    expose_both(film, bands).0
}

fn expose_both(film: &Film, bands: &[Band]) -> (GpuXyzImage, GpuCountImage) {
    DEVELOPER.expose(film.size(), film.bins(), bands).expect("an exposed film")
}

fn all_settings(exposures: &[f32]) -> Vec<DisplaySettings> {
    let mut all = Vec::new();
    let temperature = WhitePoint::Temperature(3000.0);
    for tone_curve in [ToneCurve::Linear, ToneCurve::Reinhard, ToneCurve::Filmic] {
        for white_point in
            [WhitePoint::EqualEnergy, WhitePoint::D65, WhitePoint::D50, WhitePoint::A, temperature]
        {
            for gamut_mapping in [true, false] {
                all.extend(exposures.iter().map(|&exposure_ev| DisplaySettings {
                    exposure_ev,
                    white_point,
                    tone_curve,
                    gamut_mapping,
                }));
            }
        }
    }
    all
}

/// Codes between black and white, and those of them that are not the processor's.
#[derive(Default)]
struct Codes {
    between: usize,
    different: usize,
}

impl Codes {
    /// Develops on both and finds no code that differs by more than one.
    fn compare(&mut self, image: &GpuXyzImage, film: &Film, settings: &DisplaySettings) {
        let expected = XyzImage::from_film(film).develop_rgba8(settings);
        let texture = image.develop(settings).expect("a developed picture");
        assert_eq!([texture.width(), texture.height()], film.size());
        let found = GRAPHICS.read_texture(&texture).expect("its codes");
        assert_eq!(found.len(), expected.len());
        let bins = film.bins().count();
        for (pixel, (found, expected)) in found.chunks(4).zip(expected.chunks(4)).enumerate() {
            let sums = &film.sums()[pixel * bins..][..bins];
            assert_eq!(found[3], 255, "the alpha of {sums:?}");
            for (found, expected) in found.iter().zip(expected).take(3) {
                let difference = found.abs_diff(*expected);
                assert!(difference <= 1, "{found} for {expected} of {sums:?} by {settings:?}");
                self.between += usize::from((1..255).contains(expected));
                self.different += usize::from(difference);
            }
        }
    }

    fn different_share(&self) -> f64 {
        self.different as f64 / self.between as f64
    }
}

/// What either rounds differently is a code only where it lies on the edge between two: within some
/// 20 roundings of 6e-8 of the 255 edges, that is for 3e-4 of all values at most.
#[test]
fn every_film_develops_as_on_the_processor_by_every_setting() {
    let mut codes = Codes::default();
    for (bins, passes) in [(4, 1), (16, 7), (32, 64), (64, 3)] {
        let film = film_of_all_sorts(bins, passes, 1500);
        let image = expose(&film, &bands(&film, &[]));
        for settings in all_settings(&[-10.0, -3.3, 0.0, 0.7, 4.0, 10.0]) {
            codes.compare(&image, &film, &settings);
        }
    }
    println!("{} of {} codes differ by one", codes.different, codes.between);
    assert!(codes.different_share() < 3e-4, "{} of {} differ", codes.different, codes.between);
}

/// Each bin adds a rounding of half an epsilon, and so do its weight and the processor's result.
#[test]
fn exposing_integrates_as_the_processor_does() {
    for (bins, passes) in [(4, 1), (5, 3), (16, 1000), (64, 7)] {
        let film = film_of_all_sorts(bins, passes, 100);
        let expected = XyzImage::from_film(&film);
        let found = expose(&film, &bands(&film, &[])).read().unwrap();
        assert_eq!((found.size, found.bins), (expected.size, expected.bins));
        assert_eq!(found.xyz.len(), expected.xyz.len());
        let tolerance = 0.5 * f32::EPSILON * (bins + 3) as f32;
        for (found, expected) in found.xyz.as_flattened().iter().zip(expected.xyz.as_flattened()) {
            let error = (found - expected).abs();
            assert!(error <= tolerance * expected.abs(), "{found} for {expected}, {bins} bins");
        }
    }
}

#[test]
fn what_is_no_colour_is_black_and_does_not_spread() {
    let bins = Bins::new(8);
    let mut film = Film::new(5, 1, bins);
    film.sums_mut().fill(0.5);
    film.sums_mut()[3] = f32::NAN;
    film.sums_mut()[bins.count() + 2] = f32::INFINITY;
    film.sums_mut()[2 * bins.count() + 7] = f32::NEG_INFINITY;
    film.sums_mut()[3 * bins.count()] = -f32::NAN;
    complete_pass(&mut film);
    let image = expose(&film, &bands(&film, &[]));
    assert_eq!(image.read().unwrap().xyz[..4], [[0.0; 3]; 4]);
    for settings in all_settings(&[0.0]) {
        let codes = GRAPHICS.read_texture(&image.develop(&settings).unwrap()).unwrap();
        assert_eq!(codes[..16], [0, 0, 0, 255].repeat(4));
        assert!(codes[16..19].iter().all(|&code| code > 80), "{codes:?}");
    }
}

#[test]
fn a_film_in_bands_is_the_film() {
    let film = film_of_all_sorts(16, 3, 200);
    let height = film.size()[1];
    let whole = expose(&film, &bands(&film, &[])).read().unwrap();
    for ends in [vec![8], vec![1], vec![height - 1], vec![3, 4, 10], (1..height).collect()] {
        let found = expose(&film, &bands(&film, &ends)).read().unwrap();
        assert_eq!(found.xyz, whole.xyz, "bands that end before rows {ends:?}");
    }
}

#[test]
fn the_mean_spectrum_of_a_region_is_the_processors() {
    for (bins, passes) in [(4, 1), (16, 3), (64, 1)] {
        let film = film_of_all_sorts(bins, passes, 600);
        let [width, height] = film.size();
        let bands = bands(&film, &[2, height / 2]);
        for rect in [
            PixelRect { min: [0, 0], size: [width, height] },
            PixelRect { min: [3, 1], size: [9, height / 2 + 3] },
            PixelRect { min: [width - 1, height - 2], size: [1, 1] },
            PixelRect { min: [2, height / 2], size: [width, 1] },
            PixelRect { min: [width, height], size: [8, 8] },
        ] {
            let found = DEVELOPER
                .mean_spectrum(film.size(), film.bins(), &bands, rect)
                .expect("a spectrum");
            let expected = film.mean_spectrum(rect);
            // The radiances lie up to 36 orders of magnitude apart, and some are negative.
            let scale = expected.iter().fold(0.0_f32, |scale, mean| scale.max(mean.abs()));
            for (found, expected) in found.iter().zip(&expected) {
                assert!((found - expected).abs() <= 1e-6 * scale, "{rect:?}: {found} {expected}");
            }
            assert_eq!(scale > 0.0, rect.within(film.size()).is_some());
        }
    }
}

#[test]
fn a_picture_of_any_size_develops_to_its_edges() {
    let mut codes = Codes::default();
    for size in [[1, 1], [1, 17], [8, 8], [9, 7], [130, 3], [64, 65]] {
        let bins = Bins::new(16);
        let pixels = (size[0] * size[1]) as usize;
        let mut uniform = uniform_numbers();
        let spectra: Vec<Vec<f32>> =
            (0..pixels).map(|_| (0..16).map(|_| 0.1 + uniform()).collect()).collect();
        let film = film_of(&spectra, size, bins, 2);
        let image = expose(&film, &bands(&film, &[]));
        assert_eq!(image.size(), size);
        codes.compare(&image, &film, &DisplaySettings::default());
    }
    assert!(codes.different_share() < 1e-3, "{} of {} differ", codes.different, codes.between);
}

#[test]
fn a_change_of_exposure_needs_the_film_no_more() {
    let film = film_of_all_sorts(16, 1, 100);
    let bands = bands(&film, &[2]);
    let image = expose(&film, &bands);
    for Band { buffer, .. } in &bands {
        let wiped = vec![0; buffer.size() as usize];
        GRAPHICS.queue().write_buffer(buffer, 0, &wiped);
        GRAPHICS.queue().submit([]);
        buffer.destroy();
    }
    drop(bands);
    let mut codes = Codes::default();
    for exposure_ev in [0.0, 2.0, -1.0] {
        let settings = DisplaySettings { exposure_ev, ..DisplaySettings::default() };
        codes.compare(&image, &film, &settings);
    }
}

/// Middle grey of 18 % is code 118 of 255.
#[test]
fn black_middle_grey_and_white_have_their_codes() {
    let greys = [0.0, 0.18, 1.0].map(|radiance| vec![radiance; 16]);
    let film = film_of(&greys, [3, 1], Bins::new(16), 5);
    let settings = DisplaySettings {
        white_point: WhitePoint::EqualEnergy,
        tone_curve: ToneCurve::Linear,
        ..DisplaySettings::default()
    };
    let texture = expose(&film, &bands(&film, &[])).develop(&settings).unwrap();
    let codes = GRAPHICS.read_texture(&texture).unwrap();
    assert_eq!(codes, [0, 0, 0, 255, 118, 118, 118, 255, 255, 255, 255, 255]);
}

#[test]
fn the_picture_can_be_viewed_encoded_and_linear() {
    let film = film_of_all_sorts(16, 1, 200);
    let image = expose(&film, &bands(&film, &[]));
    let texture = image.develop(&DisplaySettings::default()).unwrap();
    assert_eq!(texture.format(), TextureFormat::Rgba8Unorm);
    let usage =
        TextureUsages::STORAGE_BINDING | TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_SRC;
    assert!(texture.usage().contains(usage));
    let codes = GRAPHICS.read_texture(&texture).unwrap();
    let encoded = load(&texture, TextureFormat::Rgba8Unorm);
    let linear = load(&texture, TextureFormat::Rgba8UnormSrgb);
    for (i, code) in codes.iter().enumerate() {
        let value = f64::from(*code) / 255.0;
        let decoded = if i % 4 == 3 { value } else { srgb_decode(value) };
        assert!((f64::from(encoded[i]) - value).abs() < 1e-6, "{} for {code}", encoded[i]);
        // Direct3D's functional specification, 3.2.3.7, allows decoding half a code.
        let tolerance = 0.5 / 255.0;
        assert!((f64::from(linear[i]) - decoded).abs() < tolerance, "{} for {code}", linear[i]);
    }
}

#[test]
fn a_size_that_no_texture_can_have_is_an_error_of_the_device() {
    let largest = GRAPHICS.device().limits().max_texture_dimension_2d;
    for size in [[largest + 1, 1], [1, largest + 1], [0, 5], [5, 0]] {
        let result = DEVELOPER.expose(size, Bins::new(4), &[]);
        let Err(RendererError::Graphics(text)) = result else { panic!("{size:?} was taken") };
        let named = format!("{} × {}", size[0], size[1]);
        assert!(text.contains(&named) && text.contains(&largest.to_string()), "{text}");
    }
}

#[test]
fn a_lost_device_is_an_error_and_no_panic() {
    let graphics = Graphics::open(true).unwrap();
    let developer = GpuDeveloper::new(&graphics).unwrap();
    let size = [16, 9];
    let bins = Bins::new(4);
    let (image, counts) = developer.expose(size, bins, &[]).unwrap();
    // A device that is destroyed is lost as soon as it has no more work.
    image.read().unwrap();
    graphics.device().destroy();
    let errors = [
        developer.expose(size, bins, &[]).err(),
        image.develop(&DisplaySettings::default()).err(),
        image.read().err(),
        counts.develop(HeatMap::Rays).err(),
        counts.read().err(),
        GpuDeveloper::new(&graphics).err(),
    ];
    for error in errors {
        let error = error.expect("a lost device can do nothing");
        assert!(matches!(error, RendererError::Graphics(_)), "{error}");
    }
}
