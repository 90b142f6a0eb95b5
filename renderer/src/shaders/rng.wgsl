// Reproducible numbers: a hash per pixel, and a low-discrepancy sequence over the passes.

// Hashes one word (the output function of PCG-RXS-M-XS-32; O'Neill 2014).
fn hash(value: u32) -> u32 {
    let state = value * 747796405u + 2891336453u;
    let word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

// A number in 0..1 with 24 random bits.
fn unit_float(word: u32) -> f32 {
    return f32(word >> 8u) * (1.0 / 16777216.0);
}

// Two numbers in 0..1 that fill the pixel evenly as the passes go by, the middle first. They are
// the same for all pixels: every pass is a clean picture, and only their mean is smooth.
fn pixel_sample(pass_index: u32) -> vec2f {
    return sample(PIXEL_STEPS, vec2u(MIDDLE), pass_index);
}

// Two numbers in 0..1 that fill a light evenly as the passes go by, shifted by the random word
// `seed`.
fn light_sample(seed: u32, pass_index: u32) -> vec2f {
    return sample(LIGHT_STEPS, vec2u(hash(seed), hash(seed ^ 0x9e3779b9u)), pass_index);
}

// A number in 0..1 that fills a bin's wavelengths evenly as the passes go by, the middle first. Like
// that of the pixel it is the same for all pixels, and so no noise of colours.
fn wavelength_sample(pass_index: u32) -> f32 {
    return unit_float(MIDDLE + pass_index * WAVELENGTH_STEP);
}

fn sample(steps: vec2u, start: vec2u, pass_index: u32) -> vec2f {
    let x = start.x + pass_index * steps.x;
    let y = start.y + pass_index * steps.y;
    return vec2f(unit_float(x), unit_float(y));
}
