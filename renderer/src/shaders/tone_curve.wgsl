// Tone curves on luminance.

// The factor that takes the luminance `luminance` > 0 to the display's luminance. The same factor
// on red, green and blue keeps hue and saturation. Display luminances above 1 are left to the
// gamut.
//
// `Reinhard` is equation 4 of E. Reinhard et al., "Photographic Tone Reproduction for Digital
// Images", SIGGRAPH 2002. `Filmic` is K. Narkowicz's rational fit, "ACES Filmic Tone Mapping
// Curve", 2016, of the ACES reference rendering and sRGB output transforms; it takes 1 to 0.80
// and reaches white at 7.2.
fn gain(tone_curve: u32, luminance: f32) -> f32 {
    // Far above white in every curve, and its square is still finite.
    let y = min(luminance, 1e9);
    switch tone_curve {
        case REINHARD: {
            return (1.0 + y / (REINHARD_WHITE * REINHARD_WHITE)) / (1.0 + y);
        }
        case FILMIC: {
            return (2.51 * y + 0.03) / (y * (2.43 * y + 0.59) + 0.14);
        }
        default: {
            return 1.0;
        }
    }
}
