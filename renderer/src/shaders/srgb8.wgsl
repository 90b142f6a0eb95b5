// sRGB encoding to 8 bits (IEC 61966-2-1:1999), where the processor looks it up in a table.

// The codes of linear channels in 0..=1: 255 times their sRGB encoding, rounded.
fn encode(linear: vec3f) -> vec3u {
    let joint = vec3f(0.0031308);
    let straight = 12.92 * linear;
    let curved = 1.055 * pow(max(linear, joint), vec3f(1.0 / 2.4)) - 0.055;
    let encoded = select(curved, straight, linear <= joint);
    return vec3u(255.0 * encoded + 0.5);
}
