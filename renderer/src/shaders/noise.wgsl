// The noise of a film's pixels: how many have how much, and which are settled.

@group(0) @binding(2) var<storage, read_write> histogram: array<atomic<u32>, BUCKETS>;

// The histogram of one workgroup, which is added to that of the film at the end.
var<workgroup> group_histogram: array<atomic<u32>, BUCKETS>;

@compute @workgroup_size(WORKGROUP_SIDE, WORKGROUP_SIDE)
fn measure_noise(
    @builtin(global_invocation_id) at: vec3u,
    @builtin(local_invocation_index) index: u32,
) {
    if at.x < rows.width && at.y < rows.row_count {
        let noise = pooled_noise(at.x, at.y);
        let pixel_count = rows.width * rows.row_count;
        let first_mark = pixel_count * (rows.bin_count + COUNTS_LEN);
        let is_settled = rows.is_adaptive != 0u && noise <= rows.noise_target;
        film[first_mark + at.y * rows.width + at.x] = u32(is_settled);
        atomicAdd(&group_histogram[bucket_of(noise)], 1u);
    }
    workgroupBarrier();
    for (var bucket = index; bucket < BUCKETS; bucket += WORKGROUP_SIDE * WORKGROUP_SIDE) {
        let count = atomicLoad(&group_histogram[bucket]);
        if count > 0u {
            atomicAdd(&histogram[bucket], count);
        }
    }
}

// Square of the error that the mean of a pixel is expected to have, as a part of it and of what is
// typical; 0 where it is not known.
fn relative_variance(pixel: u32) -> f32 {
    let samples = count_of(pixel, SAMPLES);
    let mean = brightness(pixel);
    let scale = mean + rows.typical_brightness;
    if samples < 2.0 || scale <= 0.0 {
        return 0.0;
    }
    let variance = (count_of(pixel, SQUARES) - samples * mean * mean) / (samples - 1.0);
    let error = ERROR_PER_DEVIATION / scale;
    let relative = error * error * variance / (samples * sqrt(samples));
    return select(0.0, max(relative, 0.0), is_finite(bitcast<u32>(relative)));
}

// The relative error of a pixel, or its root mean square over the pixel and its neighbours where that
// is more. Where it is above a limit, it is so too at a pixel around whose own error is.
fn pooled_noise(x: u32, y: u32) -> f32 {
    var sum = 0.0;
    var pixels = 0.0;
    for (var row = max(y, 1u) - 1u; row < min(y + 2u, rows.row_count); row++) {
        for (var column = max(x, 1u) - 1u; column < min(x + 2u, rows.width); column++) {
            sum += relative_variance(row * rows.width + column);
            pixels += 1.0;
        }
    }
    return sqrt(max(relative_variance(y * rows.width + x), sum / pixels));
}

// The place of a noise in the histogram.
fn bucket_of(noise: f32) -> u32 {
    let bucket = (log2(max(noise, exp2(LOG2_LEAST))) - LOG2_LEAST) * BUCKETS_PER_OCTAVE;
    return u32(clamp(bucket, 0.0, f32(BUCKETS - 1u)));
}
