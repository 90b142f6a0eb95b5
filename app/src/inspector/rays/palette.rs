//! The colours of intervals of wavelengths on the screen, by the program's own observer, white and
//! gamut mapping.

use std::sync::LazyLock;

use brilliance_renderer::color::srgb_encode;
use brilliance_renderer::develop::XyzImage;
use brilliance_renderer::film::Film;
use brilliance_renderer::settings::{DisplaySettings, ToneCurve, WhitePoint};
use brilliance_renderer::spectrum::{Bins, LAMBDA_MAX_NM, LAMBDA_MIN_NM};
use eframe::egui::Color32;

/// Bins of the film that intervals are developed from: 2 nm each.
const BINS: u32 = 175;
/// Intervals developed at a time: a film of 3 MB.
const BATCH: usize = 4096;
/// The narrowest interval that has a colour of its own, in nm.
const NARROWEST_NM: f32 = 2.0;

/// The colours of single wavelengths, every [`NARROWEST_NM`].
static WAVELENGTHS: LazyLock<Vec<Color32>> = LazyLock::new(|| {
    let steps = ((LAMBDA_MAX_NM - LAMBDA_MIN_NM) / NARROWEST_NM) as u32;
    let intervals: Vec<_> =
        (0..=steps).map(|i| [LAMBDA_MIN_NM + i as f32 * NARROWEST_NM; 2]).collect();
    colors(&intervals)
});

/// The colour of one wavelength in nm.
pub(super) fn color_at(lambda_nm: f32) -> Color32 {
    let position = ((lambda_nm - LAMBDA_MIN_NM) / NARROWEST_NM).round().max(0.0) as usize;
    WAVELENGTHS[position.min(WAVELENGTHS.len() - 1)]
}

/// The colour of an even spectrum between each two wavelengths in nm, as bright as the screen
/// allows. All of the spectrum is white.
pub(super) fn colors(intervals: &[[f32; 2]]) -> Vec<Color32> {
    intervals.chunks(BATCH).flat_map(develop).collect()
}

fn develop(intervals: &[[f32; 2]]) -> Vec<Color32> {
    let bins = Bins::new(BINS);
    let mut film = Film::new(intervals.len() as u32, 1, bins);
    for (sums, &interval) in film.sums_mut().chunks_exact_mut(bins.count()).zip(intervals) {
        let [low, high] = widened(interval);
        for (bin, sum) in sums.iter_mut().enumerate() {
            let (from, to) = bins.range_nm(bin);
            *sum = (to.min(high) - from.max(low)).max(0.0) / bins.width_nm();
        }
    }
    let settings = DisplaySettings {
        // Far below white, where no channel is brought down by the gamut mapping.
        exposure_ev: -6.0,
        white_point: WhitePoint::EqualEnergy,
        tone_curve: ToneCurve::Linear,
        gamut_mapping: true,
    };
    XyzImage::from_film(&film).develop(&settings).rgb.into_iter().map(brightest).collect()
}

fn widened([low, high]: [f32; 2]) -> [f32; 2] {
    if high - low >= NARROWEST_NM {
        return [low, high];
    }
    let middle = (0.5 * (low + high))
        .clamp(LAMBDA_MIN_NM + 0.5 * NARROWEST_NM, LAMBDA_MAX_NM - 0.5 * NARROWEST_NM);
    [middle - 0.5 * NARROWEST_NM, middle + 0.5 * NARROWEST_NM]
}

/// The colour turned up until its largest channel is full.
fn brightest(rgb: [f32; 3]) -> Color32 {
    let most = rgb.into_iter().fold(f32::MIN_POSITIVE, f32::max);
    let [r, g, b] =
        rgb.map(|channel| (255.0 * srgb_encode(f64::from(channel / most))).round() as u8);
    Color32::from_rgb(r, g, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_whole_spectrum_is_white_and_its_parts_have_their_colours() {
        let whole = colors(&[[LAMBDA_MIN_NM, LAMBDA_MAX_NM]])[0];
        assert!(whole.r() > 252 && whole.g() > 252 && whole.b() > 252, "{whole:?}");
        let [red, green, blue] = [650.0, 530.0, 450.0].map(color_at);
        assert!(red.r() == 255 && red.g() < 90 && red.b() < 90, "{red:?}");
        assert!(green.g() == 255 && green.r() < 160 && green.b() < 160, "{green:?}");
        assert!(blue.b() == 255 && blue.r() < 160 && blue.g() < 120, "{blue:?}");
    }

    #[test]
    fn ends_and_intervals_without_width_have_colours_too() {
        for lambda_nm in [0.0, LAMBDA_MIN_NM, 729.9, LAMBDA_MAX_NM, 1e6] {
            assert_ne!(color_at(lambda_nm), Color32::BLACK);
        }
        assert_eq!(colors(&[[500.0, 500.0], [600.0, 600.1]]).len(), 2);
    }
}
