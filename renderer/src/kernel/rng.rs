//! Reproducible numbers: a hash per pixel, and a low-discrepancy sequence over the passes.

/// Hashes one word (the output function of PCG-RXS-M-XS-32; O'Neill 2014).
#[inline]
pub fn hash(value: u32) -> u32 {
    let state = value.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    (word >> 22) ^ word
}

/// A number in 0..1 with 24 random bits.
#[inline]
pub fn unit_float(word: u32) -> f32 {
    (word >> 8) as f32 * (1.0 / 16_777_216.0)
}

/// The four-dimensional sequence of Roberts 2018 in fixed point: 2³² over the powers of the root of
/// x⁵ = x + 1. Two dimensions place the camera ray in its pixel, the other two choose points on
/// lights; were they the same two, a pixel's edge and a light's shadow would move as one.
pub const PIXEL_STEPS: [u32; 2] = [3_679_390_609, 3_152_041_523];
/// The steps of the other two dimensions.
pub const LIGHT_STEPS: [u32; 2] = [2_700_274_807, 2_313_257_605];
/// The step of the wavelength in its bin: 2³² over the golden ratio, which no sum of the others meets.
pub const WAVELENGTH_STEP: u32 = 2_654_435_769;
/// ½ in fixed point.
pub const MIDDLE: u32 = 1 << 31;

/// Two numbers in 0..1 that fill the pixel evenly as the passes go by, the middle first. They are
/// the same for all pixels: every pass is a clean picture, and only their mean is smooth.
#[inline]
pub fn pixel_sample(pass_index: u32) -> [f32; 2] {
    sample(PIXEL_STEPS, [MIDDLE, MIDDLE], pass_index)
}

/// Two numbers in 0..1 that fill a light evenly as the passes go by, shifted by the random word
/// `seed`.
#[inline]
pub fn light_sample(seed: u32, pass_index: u32) -> [f32; 2] {
    sample(LIGHT_STEPS, [hash(seed), hash(seed ^ 0x9e37_79b9)], pass_index)
}

/// A number in 0..1 that fills a bin's wavelengths evenly as the passes go by, the middle first. Like
/// that of the pixel it is the same for all pixels, and so no noise of colours.
#[inline]
pub fn wavelength_sample(pass_index: u32) -> f32 {
    unit_float(MIDDLE.wrapping_add(pass_index.wrapping_mul(WAVELENGTH_STEP)))
}

#[inline]
fn sample(steps: [u32; 2], start: [u32; 2], pass_index: u32) -> [f32; 2] {
    let x = start[0].wrapping_add(pass_index.wrapping_mul(steps[0]));
    let y = start[1].wrapping_add(pass_index.wrapping_mul(steps[1]));
    [unit_float(x), unit_float(y)]
}
