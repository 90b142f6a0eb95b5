// CIE XYZ of a film.

// Rows of a film, and where they lie in the image.
struct Rows {
    // Pixels in a row.
    width: u32,
    // The image's row that is the buffer's first.
    first_row: u32,
    row_count: u32,
    bin_count: u32,
}

@group(0) @binding(0) var<uniform> rows: Rows;
// What radiance 1 in each bin adds to the mean over the film's passes.
@group(0) @binding(1) var<storage, read> weights: array<vec3f>;
// Radiance sums as bits, row by row from the top, the bins of a pixel side by side.
@group(0) @binding(2) var<storage, read> film: array<u32>;
@group(0) @binding(3) var exposed: texture_storage_2d<rgba32float, write>;

// Integrates the mean over the film's passes. A pixel that holds a NaN or an infinity is black.
fn from_film(pixel: u32) -> vec3f {
    let start = pixel * rows.bin_count;
    var xyz = vec3f(0.0);
    var is_color = true;
    for (var bin = 0u; bin < rows.bin_count; bin++) {
        let sum = film[start + bin];
        is_color &= is_finite(sum);
        xyz += weights[bin] * bitcast<f32>(sum);
    }
    is_color &= is_finite(bitcast<u32>(xyz.x + xyz.y + xyz.z));
    return select(vec3f(0.0), xyz, is_color);
}

@compute @workgroup_size(WORKGROUP_SIDE, WORKGROUP_SIDE)
fn expose(@builtin(global_invocation_id) at: vec3u) {
    if at.x >= rows.width || at.y >= rows.row_count {
        return;
    }
    let xyz = from_film(at.y * rows.width + at.x);
    textureStore(exposed, vec2u(at.x, rows.first_row + at.y), vec4f(xyz, 1.0));
}
