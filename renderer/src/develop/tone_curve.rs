//! Tone curves on luminance.

use wide::f32x8;

use crate::settings::ToneCurve;

/// The smallest luminance that [`ToneCurve::Reinhard`] shows as white: two stops above radiance 1.
pub(super) const REINHARD_WHITE: f32 = 4.0;

impl ToneCurve {
    /// The factor that takes the luminance `y` > 0 to the display's luminance. The same factor on
    /// red, green and blue keeps hue and saturation. Display luminances above 1 are left to the
    /// gamut.
    ///
    /// `Reinhard` is equation 4 of E. Reinhard et al., "Photographic Tone Reproduction for Digital
    /// Images", SIGGRAPH 2002. `Filmic` is K. Narkowicz's rational fit, "ACES Filmic Tone Mapping
    /// Curve", 2016, of the ACES reference rendering and sRGB output transforms; it takes 1 to 0.80
    /// and reaches white at 7.2.
    pub(super) fn gain(self, y: f32x8) -> f32x8 {
        // Far above white in every curve, and its square is still finite.
        let y = y.fast_min(f32x8::splat(1e9));
        match self {
            Self::Linear => f32x8::ONE,
            Self::Reinhard => (1.0 + y / (REINHARD_WHITE * REINHARD_WHITE)) / (1.0 + y),
            Self::Filmic => (2.51 * y + 0.03) / (y * (2.43 * y + 0.59) + 0.14),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(curve: ToneCurve, y: f32) -> f32 {
        curve.gain(f32x8::splat(y)).to_array()[0] * y
    }

    #[test]
    fn reinhard_shows_its_white_level_as_white() {
        assert!((shown(ToneCurve::Reinhard, REINHARD_WHITE) - 1.0).abs() < 1e-6);
        assert!((shown(ToneCurve::Reinhard, 0.01) - 0.01).abs() < 1e-4);
    }

    #[test]
    fn filmic_goes_through_the_points_of_its_formula() {
        // 2.54/3.16, and the root 7.24 of 0.08·y² − 0.56·y − 0.14 where the fit crosses 1.
        assert!((shown(ToneCurve::Filmic, 1.0) - 0.803_797_5).abs() < 1e-6);
        let white = (0.56 + (0.56_f32 * 0.56 + 4.0 * 0.08 * 0.14).sqrt()) / 0.16;
        assert!((shown(ToneCurve::Filmic, white) - 1.0).abs() < 1e-6);
    }

    #[test]
    fn the_brightest_floats_are_still_white() {
        for curve in [ToneCurve::Linear, ToneCurve::Reinhard, ToneCurve::Filmic] {
            assert!(shown(curve, 1e30) >= 1.0, "{curve:?}");
        }
    }

    #[test]
    fn a_brighter_scene_is_never_shown_darker() {
        for curve in [ToneCurve::Linear, ToneCurve::Reinhard, ToneCurve::Filmic] {
            let mut before = 0.0;
            for step in 1..4000 {
                let now = shown(curve, 1e-4 * 1.004_f32.powi(step));
                assert!(now >= before, "{curve:?}");
                before = now;
            }
        }
    }
}
