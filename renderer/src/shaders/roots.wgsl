// Sums of the roots of the brightness of a film's pixels.

@group(0) @binding(2) var<storage, read_write> sums: array<f32>;

// Adds up the roots of some columns of a row, so that the rounding stays small.
@compute @workgroup_size(WORKGROUP_SIDE, WORKGROUP_SIDE)
fn sum_roots(@builtin(global_invocation_id) at: vec3u) {
    let groups = (rows.width + COLUMNS_PER_GROUP - 1u) / COLUMNS_PER_GROUP;
    if at.x >= groups || at.y >= rows.row_count {
        return;
    }
    let first = at.x * COLUMNS_PER_GROUP;
    let end = min(first + COLUMNS_PER_GROUP, rows.width);
    var sum = 0.0;
    for (var column = first; column < end; column++) {
        sum += sqrt(brightness(at.y * rows.width + column));
    }
    sums[(rows.first_sum + at.y) * groups + at.x] = sum;
}
