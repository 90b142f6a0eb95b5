//! Colours that the display cannot show.

/// Moves a colour of luminance `y` along the line to the white of equal luminance until each
/// channel lies in 0..=1. At `y` ≥ 1 only white is left.
///
/// S. W. Thomas, "Dispersive refraction in ray tracing", 1986, on colours outside the gamut.
pub(super) fn desaturate(rgb: [f32; 3], y: f32) -> [f32; 3] {
    if y >= 1.0 {
        return [1.0; 3];
    }
    let low = rgb[0].min(rgb[1]).min(rgb[2]);
    let high = rgb[0].max(rgb[1]).max(rgb[2]);
    if low >= 0.0 && high <= 1.0 {
        return rgb;
    }
    let above_black = if low < 0.0 { y / (y - low) } else { 1.0 };
    let below_white = if high > 1.0 { (1.0 - y) / (high - y) } else { 1.0 };
    let saturation = above_black.min(below_white);
    // Rounding may leave the boundary by one ulp; `clip` brings it back.
    clip(rgb.map(|channel| y + saturation * (channel - y)))
}

/// Cuts each channel off at 0 and 1, which shifts hue and luminance.
pub(super) fn clip(rgb: [f32; 3]) -> [f32; 3] {
    rgb.map(|channel| channel.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color;
    use glam::DVec3;

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
        assert_eq!(clip([-0.3, 0.6, 1.2]), [0.0, 0.6, 1.0]);
    }
}
