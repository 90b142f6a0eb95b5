//! Colours that the display cannot show.

use wide::f32x8;

/// Moves a colour of luminance `y` along the line to the white of equal luminance until each
/// channel lies in 0..=1. At `y` ≥ 1 only white is left.
///
/// S. W. Thomas, "Dispersive refraction in ray tracing", 1986, on colours outside the gamut.
pub(super) fn desaturate(rgb: [f32x8; 3], y: f32x8) -> [f32x8; 3] {
    let [zero, one] = [f32x8::ZERO, f32x8::ONE];
    let low = rgb[0].fast_min(rgb[1]).fast_min(rgb[2]);
    let high = rgb[0].fast_max(rgb[1]).fast_max(rgb[2]);
    let above_black = y / (y - low.fast_min(zero));
    let below_white = (one - y) / (high.fast_max(one) - y);
    let saturation = above_black.fast_min(below_white);
    let fits = low.simd_ge(zero) & high.simd_le(one);
    let is_white = y.simd_ge(one);
    // Rounding may leave the boundary by one ulp; `clip` brings it back.
    let moved = clip(rgb.map(|channel| y + saturation * (channel - y)));
    std::array::from_fn(|i| is_white.select(one, fits.select(rgb[i], moved[i])))
}

/// Cuts each channel off at 0 and 1, which shifts hue and luminance.
pub(super) fn clip(rgb: [f32x8; 3]) -> [f32x8; 3] {
    rgb.map(|channel| channel.fast_max(f32x8::ZERO).fast_min(f32x8::ONE))
}

#[cfg(test)]
mod tests {
    use super::{clip, f32x8};
    use crate::color;
    use glam::DVec3;

    fn desaturate(rgb: [f32; 3], y: f32) -> [f32; 3] {
        super::desaturate(rgb.map(f32x8::splat), f32x8::splat(y))
            .map(|channel| channel.to_array()[0])
    }

    fn luminance(rgb: [f32; 3]) -> f32 {
        color::luminance(DVec3::from_array(rgb.map(f64::from))) as f32
    }

    #[test]
    fn a_colour_inside_the_gamut_is_left_alone() {
        for rgb in [[0.2, 0.5, 0.7], [0.0, 1.0, 0.3], [0.0; 3]] {
            assert_eq!(desaturate(rgb, luminance(rgb)), rgb);
        }
    }

    #[test]
    fn a_colour_outside_moves_to_the_boundary_and_keeps_luminance_and_hue_line() {
        let outside = [
            [-0.3, 0.6, 0.2],
            [1.8, 0.1, 0.05],
            [-0.2, 1.4, -0.4],
            [2.5, -0.5, 0.7],
            [0.02, -0.01, 9.0],
        ];
        for rgb in outside {
            let y = luminance(rgb);
            let mapped = desaturate(rgb, y);
            assert!((luminance(mapped) - y).abs() < 1e-6, "{rgb:?} → {mapped:?}");
            let (low, high) = mapped.iter().fold((1.0_f32, 0.0_f32), |(low, high), &channel| {
                (low.min(channel), high.max(channel))
            });
            assert!(low >= 0.0 && high <= 1.0, "{rgb:?} → {mapped:?}");
            assert!(low < 1e-7 || high > 1.0 - 1e-6, "not on the boundary: {mapped:?}");
            let share = (mapped[0] - y) / (rgb[0] - y);
            assert!(share > 0.0 && share < 1.0);
            for channel in 0..3 {
                let on_line = y + share * (rgb[channel] - y);
                assert!((mapped[channel] - on_line).abs() < 1e-6, "{rgb:?} → {mapped:?}");
            }
        }
    }

    #[test]
    fn nothing_but_white_is_as_bright_as_white() {
        assert_eq!(desaturate([3.0, 0.9, 0.0], 1.28), [1.0; 3]);
        assert_eq!(desaturate([1.0; 3], 1.0), [1.0; 3]);
    }

    #[test]
    fn clipping_cuts_each_channel_on_its_own() {
        let clipped = clip([-0.3, 0.6, 1.2].map(f32x8::splat));
        assert_eq!(clipped, [0.0, 0.6, 1.0].map(f32x8::splat));
    }
}
