// What a film shows: CIE XYZ and mean counts.

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
// What radiance 1 in each bin adds to X, Y and Z.
@group(0) @binding(1) var<storage, read> weights: array<vec3f>;
// Sums as bits: radiance row by row from the top, the bins of a pixel side by side; behind those of
// all rows the counts, `COUNTS_LEN` numbers per pixel.
@group(0) @binding(2) var<storage, read> film: array<u32>;
@group(0) @binding(3) var exposed: texture_storage_2d<rgba32float, write>;
@group(0) @binding(4) var counted: texture_storage_2d<rgba32float, write>;

// Where the counts of a pixel begin.
fn counts_of(pixel: u32) -> u32 {
    return rows.width * rows.row_count * rows.bin_count + pixel * COUNTS_LEN;
}

// What makes sums over the pixel's camera rays means.
fn scale_of(pixel: u32) -> f32 {
    return 1.0 / max(bitcast<f32>(film[counts_of(pixel) + SAMPLES]), 1.0);
}

// Integrates the mean over the pixel's camera rays. A pixel that holds a NaN or an infinity is black.
fn from_film(pixel: u32) -> vec3f {
    let start = pixel * rows.bin_count;
    var xyz = vec3f(0.0);
    var is_color = true;
    for (var bin = 0u; bin < rows.bin_count; bin++) {
        let sum = film[start + bin];
        is_color &= is_finite(sum);
        xyz += weights[bin] * bitcast<f32>(sum);
    }
    xyz *= scale_of(pixel);
    is_color &= is_finite(bitcast<u32>(xyz.x + xyz.y + xyz.z));
    return select(vec3f(0.0), xyz, is_color);
}

// The rays, the depth and the pruned light of one camera ray, as the mean over those of the pixel.
fn mean_counts(pixel: u32) -> vec3f {
    let start = counts_of(pixel);
    let sums = vec3u(film[start], film[start + 1u], film[start + 2u]);
    return bitcast<vec3f>(sums) * scale_of(pixel);
}

@compute @workgroup_size(WORKGROUP_SIDE, WORKGROUP_SIDE)
fn expose(@builtin(global_invocation_id) at: vec3u) {
    if at.x >= rows.width || at.y >= rows.row_count {
        return;
    }
    let pixel = at.y * rows.width + at.x;
    let texel = vec2u(at.x, rows.first_row + at.y);
    textureStore(exposed, texel, vec4f(from_film(pixel), 1.0));
    textureStore(counted, texel, vec4f(mean_counts(pixel), 1.0));
}
