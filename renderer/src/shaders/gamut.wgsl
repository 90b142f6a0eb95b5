// Colours that the display cannot show.

// Moves a colour of luminance `y` along the line to the white of equal luminance until each
// channel lies in 0..=1. At `y` ≥ 1 only white is left.
//
// S. W. Thomas, "Dispersive refraction in ray tracing", 1986, on colours outside the gamut.
fn desaturate(rgb: vec3f, y: f32) -> vec3f {
    if y >= 1.0 {
        return vec3f(1.0);
    }
    let low = min(min(rgb.r, rgb.g), rgb.b);
    let high = max(max(rgb.r, rgb.g), rgb.b);
    if low >= 0.0 && high <= 1.0 {
        return rgb;
    }
    let above_black = y / (y - min(low, 0.0));
    let below_white = (1.0 - y) / (max(high, 1.0) - y);
    let saturation = min(above_black, below_white);
    // Rounding may leave the boundary by one ulp; `clip` brings it back.
    return clip(y + saturation * (rgb - y));
}

// Cuts each channel off at 0 and 1, which shifts hue and luminance.
fn clip(rgb: vec3f) -> vec3f {
    return min(max(rgb, vec3f(0.0)), vec3f(1.0));
}
