// A fan that ends at a matte surface: its wavelengths meet it at different places.

// Deposits the light that the surface at `hit` sends back along the fan, which ends there: ray by ray,
// each of a part of the interval. All ask for the same points of the lights, so that shadows have no
// colours.
fn shade_fan(fan: Fan, hit: Hit) {
    let weight = parabola_through(fan.weight);
    let path_mm = parabola_through(fan.path_mm);
    let count = matte_ray_count(fan);
    let place = wavelength_sample(walk.pass_index);
    let step = 2.0 / f32(count);
    for (var i = 0u; i < count; i++) {
        let low = f32(i) * step - 1.0;
        let high = low + step;
        let position = low + step * place;
        var ray = ray_in_fan(fan, position);
        ray.lambda_low_nm = wavelength_at(axis_position_in(fan, low));
        ray.lambda_high_nm = wavelength_at(axis_position_in(fan, high));
        let middle = parabola_at(weight, 0.5 * (low + high));
        let ends = parabola_at(weight, low) + parabola_at(weight, high);
        ray.significance = max((4.0 * middle + ends) * (1.0 / 6.0), 0.0);
        ray.absorber = fan.absorber;
        ray.path_mm = max(parabola_at(path_mm, position), 0.0);
        walk.seed = fan.seed;
        shade_diffuse(ray, hit);
    }
    walk.tally.returned += retire_fan(fan);
}

// Rays that a fan is divided into at a matte surface: one per bin where its wavelengths arrive apart,
// else as many as its weight varies.
fn matte_ray_count(fan: Fan) -> u32 {
    let width_nm = wavelength_at(fan.axis.z) - wavelength_at(fan.axis.x);
    // Rounding must not make one more of whole bins.
    let bins = max(ceil(width_nm / frame.bin_width_nm - 1e-3), 1.0);
    if is_dispersed(fan) {
        return u32(bins);
    }
    let strongest = largest(fan.weight);
    let variation = (strongest - least_of(fan.weight)) / max(strongest, 1e-12);
    return u32(clamp(ceil(variation / WEIGHT_TOLERANCE), 1.0, bins));
}
