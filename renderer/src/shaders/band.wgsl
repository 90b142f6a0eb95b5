// The light of a fan, bin by bin: what a part of its interval deposits, and what energy it carries.

// A part of a fan's interval, made ready to be spread over the bins.
struct Band {
    range: BinRange,
    ends: vec2f,
    axis: Parabola,
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
    return Band(
        bin_range(low_nm, high_nm),
        vec2f(low, high),
        parabola_through(fan.axis),
        parabola_through(fan.weight),
        parabola_through(fan.path_mm),
    );
}

// What a band has of one of its bins.
fn bin_part(band: Band, bin: u32) -> BinPart {
    let overlap = bin_overlap(band.range, bin);
    if overlap >= 1.0 && abs(band.axis.a) <= STRAIGHT * band.axis.b {
        let moments = axis_moments(bin);
        let per_position = 0.5 / band.axis.b;
        let position = (moments.x - band.axis.c) * per_position;
        let variance = moments.y * per_position * per_position;
        return BinPart(overlap, position, position * position + variance);
    }
    // Gauss's rule with two points over the positions that are covered, weighed by the wavelengths
    // that fall to each.
    var low = band.ends.x;
    var high = band.ends.y;
    if band.range.low < f32(bin) {
        low = position_where(band.axis, axis_position_of_bins(f32(bin)));
    }
    if band.range.high > f32(bin + 1u) {
        high = position_where(band.axis, axis_position_of_bins(f32(bin + 1u)));
    }
    let middle = 0.5 * (low + high);
    let offset = GAUSS_POINT * (high - low);
    let first = middle - offset;
    let second = middle + offset;
    let first_nm = wavelengths_per_position(band, first);
    let second_nm = wavelengths_per_position(band, second);
    let share = second_nm / max(first_nm + second_nm, 1e-12);
    let position = first + (second - first) * share;
    let position_squared = first * first + (second * second - first * first) * share;
    return BinPart(overlap, position, position_squared);
}

// How fast the wavelength changes with the position in the fan, up to a factor.
fn wavelengths_per_position(band: Band, position: f32) -> f32 {
    let axis_slope = max(half_slope_at(band.axis, position), 0.0);
    return axis_slope * wavelength_slope_at(parabola_at(band.axis, position));
}

// The position on the axis of a wavelength that is counted in bins.
fn axis_position_of_bins(bins: f32) -> f32 {
    return axis_position_of(LAMBDA_MIN_NM + bins * frame.bin_width_nm);
}

// The fan's light in one bin: the mean of its weight over the covered wavelengths, times how much
// of the bin they are. Where a parabola dips below 0, others are as much too high.
fn bin_weight(band: Band, part: BinPart) -> f32 {
    let weight = band.weight;
    let mean = weight.a * part.position_squared + 2.0 * weight.b * part.position + weight.c;
    return part.overlap * mean;
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
    let band = band_of(fan, -1.0, 1.0);
    var energy = 0.0;
    var absorbed = 0.0;
    for (var bin = band.range.first; bin <= band.range.last; bin++) {
        let part = bin_part(band, bin);
        let weight = bin_weight(band, part);
        var kept = 1.0;
        if fan.absorber != NONE {
            kept = fan_transmittance(fan, band, part, bin);
        }
        energy += weight * kept;
        absorbed += weight * (1.0 - kept);
    }
    let per_bin = 1.0 / f32(frame.bin_count);
    walk.tally.absorbed += absorbed * per_bin;
    return energy * per_bin;
}
