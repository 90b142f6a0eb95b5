// Sums of a region of a film, row by row and bin by bin.

// The rows of a region that lie in one buffer of the film.
struct RegionRows {
    // Pixels in a row of the film.
    width: u32,
    // The region's first column, and its first row as the buffer counts them.
    first_column: u32,
    first_row: u32,
    column_count: u32,
    row_count: u32,
    bin_count: u32,
    // The row of `sums` that the first row's sums are written to.
    first_sum: u32,
    // Where the buffer's counts begin.
    first_count: u32,
}

@group(0) @binding(0) var<uniform> region: RegionRows;
// Sums as bits: radiance row by row from the top, the bins of a pixel side by side; behind those of
// all rows the counts, `COUNTS_LEN` numbers per pixel.
@group(0) @binding(1) var<storage, read> film: array<u32>;
@group(0) @binding(2) var<storage, read_write> sums: array<f32>;

// Adds up the means of one bin in one row of the region. A sum that is not finite counts as none. Columns are
// added in groups, so that the rounding grows with the number of groups and not of columns.
@compute @workgroup_size(WORKGROUP_SIDE, WORKGROUP_SIDE)
fn sum_row(@builtin(global_invocation_id) at: vec3u) {
    let bin = at.x;
    let row = at.y;
    if bin >= region.bin_count || row >= region.row_count {
        return;
    }
    let first = (region.first_row + row) * region.width + region.first_column;
    var sum = 0.0;
    for (var column = 0u; column < region.column_count; column += COLUMNS_PER_GROUP) {
        var group = 0.0;
        let end = min(column + COLUMNS_PER_GROUP, region.column_count);
        for (var pixel = first + column; pixel < first + end; pixel++) {
            let value = film[pixel * region.bin_count + bin];
            if is_finite(value) {
                let samples = bitcast<f32>(film[region.first_count + pixel * COUNTS_LEN + SAMPLES]);
                group += bitcast<f32>(value) / max(samples, 1.0);
            }
        }
        sum += group;
    }
    sums[(region.first_sum + row) * region.bin_count + bin] = sum;
}
