// What coloured bodies leave of a ray: Beer–Lambert over the path and the bins of the interval.

// The bins that an interval of wavelengths meets.
struct BinRange {
    low: f32,
    high: f32,
    first: u32,
    last: u32,
}

// The bins between two wavelengths; at least one, which an interval without width covers by 0.
fn bin_range(low_nm: f32, high_nm: f32) -> BinRange {
    let per_nm = 1.0 / frame.bin_width_nm;
    let low = (low_nm - LAMBDA_MIN_NM) * per_nm;
    let high = (high_nm - LAMBDA_MIN_NM) * per_nm;
    let highest = f32(frame.bin_count - 1u);
    let first = clamp(floor(low), 0.0, highest);
    let last = clamp(ceil(high) - 1.0, first, highest);
    return BinRange(low, high, u32(first), u32(last));
}

// How much of `bin` the interval covers, in 0..=1.
fn bin_overlap(range: BinRange, bin: u32) -> f32 {
    let overlap = min(range.high, f32(bin + 1u)) - max(range.low, f32(bin));
    return max(overlap, 0.0);
}

// Transmittance e^(−α·d) of the path that the ray has still to pay for, in one bin.
fn transmittance(ray: Ray, bin: u32) -> f32 {
    let row = materials[ray.absorber].absorption;
    return exp(-spectrum_value(row, bin) * ray.path_mm);
}

// Mean of the path's transmittance over the ray's interval; 1 where nothing absorbs.
fn mean_transmittance(ray: Ray) -> f32 {
    if ray.absorber == NONE {
        return 1.0;
    }
    let range = bin_range(ray.lambda_low_nm, ray.lambda_high_nm);
    var sum = 0.0;
    var width = 0.0;
    for (var bin = range.first; bin <= range.last; bin++) {
        let overlap = bin_overlap(range, bin);
        sum += overlap * transmittance(ray, bin);
        width += overlap;
    }
    if width > 0.0 {
        return sum / width;
    }
    return 1.0;
}

// An upper bound of the path's transmittance, for the price of one exponential.
fn transmittance_bound(ray: Ray) -> f32 {
    if ray.absorber == NONE {
        return 1.0;
    }
    return exp(-materials[ray.absorber].least_absorption * ray.path_mm);
}
