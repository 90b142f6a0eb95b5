// Heat maps: the colours that stand for what a pixel took to trace.

// A scale of colours made ready for pixels, as the processor reads it too.
struct HeatScale {
    // sRGB-encoded colours in 0..=1 at equal steps from the low end to the high one.
    knots: array<vec4f, KNOTS>,
    // sRGB-encoded colour of 0.
    nothing: vec3f,
    // Which of the counts is shown, in the order of the texture's channels.
    map: u32,
    // Binary logarithm of the low end.
    log2_low: f32,
    // Knots per doubling.
    knots_per_octave: f32,
    padding: vec2f,
}

@group(0) @binding(0) var<uniform> scale: HeatScale;
@group(0) @binding(1) var counts: texture_2d<f32>;
@group(0) @binding(2) var developed: texture_storage_2d<rgba8unorm, write>;

// sRGB codes of each pixel of `counts`, with an opaque alpha.
@compute @workgroup_size(WORKGROUP_SIDE, WORKGROUP_SIDE)
fn rgba8(@builtin(global_invocation_id) at: vec3u) {
    if any(at.xy >= textureDimensions(counts)) {
        return;
    }
    let encoded = heat_color(textureLoad(counts, at.xy, 0)[scale.map]);
    let codes = vec3u(255.0 * encoded + 0.5);
    textureStore(developed, at.xy, vec4f(vec3f(codes) / 255.0, 1.0));
}

// The sRGB-encoded colour in 0..=1 of a mean count.
fn heat_color(mean: f32) -> vec3f {
    if mean <= 0.0 {
        return scale.nothing;
    }
    let place = clamp((log2(mean) - scale.log2_low) * scale.knots_per_octave, 0.0, f32(KNOTS - 1u));
    let knot = min(u32(place), KNOTS - 2u);
    return mix(scale.knots[knot].rgb, scale.knots[knot + 1u].rgb, place - f32(knot));
}
