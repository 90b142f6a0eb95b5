// The brightness of a film's pixels.

// Rows of a film, and what is wanted of their noise.
struct NoiseRows {
    // Pixels in a row.
    width: u32,
    row_count: u32,
    bin_count: u32,
    // The row of the sums that the first row's sums are written to.
    first_sum: u32,
    // The square of the mean of the roots of the brightness of all pixels.
    typical_brightness: f32,
    // The noise at which pixels are settled.
    noise_target: f32,
    // Whether pixels settle at all.
    is_adaptive: u32,
    padding: u32,
}

@group(0) @binding(0) var<uniform> rows: NoiseRows;
// Sums as bits: radiance row by row from the top, the bins of a pixel side by side; behind those of
// all rows the counts, `COUNTS_LEN` numbers per pixel; behind those a word per pixel that is 1 where
// it is settled.
@group(0) @binding(1) var<storage, read_write> film: array<u32>;

// One of the counts of a pixel.
fn count_of(pixel: u32, count: u32) -> f32 {
    let first_count = rows.width * rows.row_count * rows.bin_count;
    return bitcast<f32>(film[first_count + pixel * COUNTS_LEN + count]);
}

// Mean radiance of a pixel over bins and camera rays; 0 where there is none.
fn brightness(pixel: u32) -> f32 {
    var sum = 0.0;
    for (var bin = 0u; bin < rows.bin_count; bin++) {
        sum += bitcast<f32>(film[pixel * rows.bin_count + bin]);
    }
    let mean = sum / f32(rows.bin_count) / max(count_of(pixel, SAMPLES), 1.0);
    return select(0.0, max(mean, 0.0), is_finite(bitcast<u32>(mean)));
}
