// The light of a fan, bin by bin: what a part of its interval deposits, and what energy it carries.

// A part of a fan's interval, made ready to be spread over the bins.
struct Band {
    range: BinRange,
    middle: f32,
    per_half_width: f32,
    weight: Parabola,
    path_mm: Parabola,
}

// A bin's part of a band.
struct BinPart {
    overlap: f32,
    position: f32,
    position_squared: f32,
}

// The part of the fan's interval between two positions in it.
fn band_of(fan: Fan, low: f32, high: f32) -> Band {
    let low_nm = wavelength_at(axis_position_in(fan, low));
    let high_nm = wavelength_at(axis_position_in(fan, high));
    let half_width = 0.5 * (fan.high - fan.low);
    var per_half_width = 0.0;
    if half_width > 0.0 {
        per_half_width = 1.0 / half_width;
    }
    return Band(
        bin_range(low_nm, high_nm),
        0.5 * (fan.low + fan.high),
        per_half_width,
        parabola_through(fan.weight),
        parabola_through(fan.path_mm),
    );
}

// What a band has of one of its bins.
fn bin_part(band: Band, bin: u32) -> BinPart {
    let overlap = bin_overlap(band.range, bin);
    var position: f32;
    var position_squared: f32;
    if overlap >= 1.0 {
        let moments = axis_moments(bin);
        position = moments.x - band.middle;
        position_squared =
            position * position + max(moments.y - moments.x * moments.x, 0.0);
    } else {
        // Simpson's rule over what is covered.
        let low = max(band.range.low, f32(bin));
        let high = min(band.range.high, f32(bin + 1u));
        let first = axis_position_of_bins(low) - band.middle;
        let second = axis_position_of_bins(0.5 * (low + high)) - band.middle;
        let third = axis_position_of_bins(high) - band.middle;
        position = (first + 4.0 * second + third) * (1.0 / 6.0);
        position_squared = (first * first + 4.0 * second * second + third * third) * (1.0 / 6.0);
    }
    position *= band.per_half_width;
    position_squared *= band.per_half_width * band.per_half_width;
    return BinPart(overlap, position, position_squared);
}

// The position on the axis of a wavelength that is counted in bins.
fn axis_position_of_bins(bins: f32) -> f32 {
    return axis_position_of(LAMBDA_MIN_NM + bins * frame.bin_width_nm);
}

// The fan's light in one bin: the mean of its weight over the covered wavelengths, times how much
// of the bin they are.
fn bin_weight(band: Band, part: BinPart) -> f32 {
    let weight = band.weight;
    let mean = weight.a * part.position_squared + 2.0 * weight.b * part.position + weight.c;
    return part.overlap * max(mean, 0.0);
}

// Transmittance e^(−α·d) of the path that the fan has still to pay for, in one bin.
fn fan_transmittance(fan: Fan, band: Band, part: BinPart, bin: u32) -> f32 {
    let row = materials[fan.absorber].absorption;
    let path_mm = max(parabola_at(band.path_mm, part.position), 0.0);
    return exp(-spectrum_value(row, bin) * path_mm);
}

// Adds radiance of row `radiance_row` over the part of the fan's interval between two positions in
// it.
fn deposit_band(fan: Fan, low: f32, high: f32, radiance_row: u32) {
    let band = band_of(fan, low, high);
    for (var bin = band.range.first; bin <= band.range.last; bin++) {
        let part = bin_part(band, bin);
        var value = bin_weight(band, part) * spectrum_value(radiance_row, bin);
        if fan.absorber != NONE {
            value *= fan_transmittance(fan, band, part, bin);
        }
        radiance[walk.walker * frame.bin_count + bin] += value;
    }
}

// The energy of a fan, in units of the camera ray's, before the absorption that its path has still
// to pay for.
fn fan_energy(fan: Fan) -> f32 {
    let band = band_of(fan, -1.0, 1.0);
    var energy = 0.0;
    for (var bin = band.range.first; bin <= band.range.last; bin++) {
        energy += bin_weight(band, bin_part(band, bin));
    }
    return energy / f32(frame.bin_count);
}

// The energy that a fan still carries at its end, after its path's absorption is booked.
fn retire_fan(fan: Fan) -> f32 {
    if fan.absorber == NONE {
        return fan_energy(fan);
    }
    let band = band_of(fan, -1.0, 1.0);
    var energy = 0.0;
    var absorbed = 0.0;
    for (var bin = band.range.first; bin <= band.range.last; bin++) {
        let part = bin_part(band, bin);
        let weight = bin_weight(band, part);
        let kept = fan_transmittance(fan, band, part, bin);
        energy += weight * kept;
        absorbed += weight * (1.0 - kept);
    }
    let per_bin = 1.0 / f32(frame.bin_count);
    walk.tally.absorbed += absorbed * per_bin;
    return energy * per_bin;
}
