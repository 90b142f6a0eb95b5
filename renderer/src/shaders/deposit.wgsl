// Light that has found the eye: deposits on the pixel's bins.

// What is left of light that a matte surface sends back.
struct Reflectance {
    row: u32,
    primaries: u32,
    weights: vec3f,
}

// Of light that meets no surface: all of it.
const WHOLE = Reflectance(NONE, NONE, vec3f(0.0));

// Of a surface with nothing printed on it.
fn bare(row: u32) -> Reflectance {
    return Reflectance(row, NONE, vec3f(0.0));
}

// The mean over `bin` of what a print reflects.
fn print_value(reflectance: Reflectance, bin: u32) -> f32 {
    let red = spectrum_value(reflectance.primaries, bin);
    let green = spectrum_value(reflectance.primaries + 1u, bin);
    let blue = spectrum_value(reflectance.primaries + 2u, bin);
    return dot(reflectance.weights, vec3f(red, green, blue));
}

// Adds radiance of row `radiance_row` as it is reflected, scaled by `scale`, evenly over the ray's
// interval.
fn deposit(ray: Ray, radiance_row: u32, reflectance: Reflectance, scale: f32) {
    let weight = ray.significance * scale;
    let range = bin_range(ray.lambda_low_nm, ray.lambda_high_nm);
    for (var bin = range.first; bin <= range.last; bin++) {
        var value = weight * bin_overlap(range, bin) * spectrum_value(radiance_row, bin);
        if reflectance.row != NONE {
            value *= spectrum_value(reflectance.row, bin);
        }
        if reflectance.primaries != NONE {
            value *= print_value(reflectance, bin);
        }
        if ray.absorber != NONE {
            value *= transmittance(ray, bin);
        }
        radiance[walk.walker * frame.bin_count + bin] += value;
    }
}
