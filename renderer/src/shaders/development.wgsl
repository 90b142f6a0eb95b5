// What develops pixels: one function behind every picture that a graphics device shows.

// Display settings made ready for pixels, as the processor reads them too.
//
// Each row makes one channel, exposed and adapted, from scene XYZ.
struct Development {
    // Linear Rec. 709 red.
    red_from_xyz: vec3f,
    tone_curve: u32,
    // Linear Rec. 709 green.
    green_from_xyz: vec3f,
    // 1 moves colours into the gamut, 0 clips them.
    gamut_mapping: u32,
    // Linear Rec. 709 blue.
    blue_from_xyz: vec3f,
    padding_0: u32,
    luminance_from_xyz: vec3f,
    padding_1: u32,
}

@group(0) @binding(0) var<uniform> development: Development;
@group(0) @binding(1) var exposed: texture_2d<f32>;
@group(0) @binding(2) var developed: texture_storage_2d<rgba8unorm, write>;

// sRGB codes of each pixel of `exposed`, with an opaque alpha.
@compute @workgroup_size(WORKGROUP_SIDE, WORKGROUP_SIDE)
fn rgba8(@builtin(global_invocation_id) at: vec3u) {
    if any(at.xy >= textureDimensions(exposed)) {
        return;
    }
    let rgb = develop(textureLoad(exposed, at.xy, 0).xyz);
    textureStore(developed, at.xy, vec4f(vec3f(encode(rgb)) / 255.0, 1.0));
}

// Linear display RGB in 0..=1. What is not a finite colour of positive luminance is black.
fn develop(xyz: vec3f) -> vec3f {
    let y = dot(development.luminance_from_xyz, xyz);
    let rgb = vec3f(
        dot(development.red_from_xyz, xyz),
        dot(development.green_from_xyz, xyz),
        dot(development.blue_from_xyz, xyz),
    );
    let is_color = y > 0.0 && is_finite(bitcast<u32>(rgb.r + rgb.g + rgb.b));
    if !is_color {
        return vec3f(0.0);
    }
    let gain = gain(development.tone_curve, y);
    let curved = rgb * gain;
    if development.gamut_mapping == 1u {
        return desaturate(curved, y * gain);
    }
    return clip(curved);
}
