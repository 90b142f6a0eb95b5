//! The colours in which intervals of wavelengths are drawn.

use std::sync::LazyLock;

use glam::DVec3;

use crate::color;
use crate::spectrum::{Bins, Observer};

/// Steps of the spectrum that intervals are summed from: 2 nm each.
const STEPS: u32 = 175;
/// An interval is drawn as if it had at least this width, in nm.
const NARROWEST_NM: f64 = 2.0;

/// Linear Rec. 709 of each step, with the even spectrum as white.
static STEP_RGB: LazyLock<Vec<DVec3>> = LazyLock::new(|| {
    let steps = Observer::bin_weights(Bins::new(STEPS));
    let white = steps.iter().copied().sum();
    let rgb_from_xyz = color::rec709_from_xyz() * color::adaptation(white, color::d65_white());
    steps.into_iter().map(|xyz| rgb_from_xyz * xyz).collect()
});

/// The sRGB codes of an even spectrum between two wavelengths, as bright as a screen allows. All of
/// the spectrum is white; what is too pure for a screen is mixed with white of its luminance.
pub(super) fn light_color([low_nm, high_nm]: [f64; 2]) -> [u8; 3] {
    let bins = Bins::new(STEPS);
    let widening = (0.5 * (NARROWEST_NM - (high_nm - low_nm))).max(0.0);
    let (low_nm, high_nm) = (low_nm - widening, high_nm + widening);
    let rgb: DVec3 = STEP_RGB
        .iter()
        .enumerate()
        .map(|(step, rgb)| {
            let (from, to) = bins.range_nm(step);
            let (from, to) = (f64::from(from), f64::from(to));
            let covered = (to.min(high_nm) - from.max(low_nm)).max(0.0);
            *rgb * covered / (to - from)
        })
        .sum();
    let luminance = color::luminance(rgb).max(f64::MIN_POSITIVE);
    let darkest = rgb.min_element().min(0.0);
    let mixed = luminance + (rgb - luminance) * (luminance / (luminance - darkest));
    let bright = mixed / mixed.max_element().max(f64::MIN_POSITIVE);
    bright.to_array().map(|channel| (255.0 * color::srgb_encode(channel.max(0.0))).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_of_the_spectrum_is_white_and_its_parts_have_their_colours() {
        assert!(light_color([380.0, 730.0]).iter().all(|code| *code > 252));
        let [red, green, blue] = [640.0, 530.0, 450.0].map(|nm| light_color([nm, nm]));
        assert!(red[0] == 255 && red[1] < 120 && red[2] < 120, "{red:?}");
        assert!(green[1] == 255 && green[0] < 160 && green[2] < 160, "{green:?}");
        assert!(blue[2] == 255 && blue[0] < 160 && blue[1] < 120, "{blue:?}");
    }

    #[test]
    fn the_ends_of_the_spectrum_have_colours_too() {
        for nm in [380.0, 730.0] {
            assert_eq!(light_color([nm, nm]).into_iter().max(), Some(255), "{nm}");
        }
    }
}
