// Light that has found the eye: deposits on the pixel's bins.

// Adds radiance of row `radiance_row`, reflected by row `reflectance` unless that is `NONE`, scaled
// by `scale`, evenly over the ray's interval.
fn deposit(ray: Ray, radiance_row: u32, reflectance: u32, scale: f32) {
    let weight = ray.significance * scale;
    let range = bin_range(ray.lambda_low_nm, ray.lambda_high_nm);
    for (var bin = range.first; bin <= range.last; bin++) {
        var value = weight * bin_overlap(range, bin) * spectrum_value(radiance_row, bin);
        if reflectance != NONE {
            value *= spectrum_value(reflectance, bin);
        }
        if ray.absorber != NONE {
            value *= transmittance(ray, bin);
        }
        radiance[walk.walker * frame.bin_count + bin] += value;
    }
}
