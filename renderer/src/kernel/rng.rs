//! Reproducible numbers: a hash per pixel, and low-discrepancy sequences over the passes.

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

/// The steps from pass to pass of a point on a light, in fixed point: the two-dimensional sequence of
/// Roberts 2018, 2³² over the powers of the root of x³ = x + 1. No sum of dyadic fractions, of which
/// the pixel's points are made, meets them.
pub const LIGHT_STEPS: [u32; 2] = [3_242_174_889, 2_447_445_414];
/// The step of the wavelength in its bin: 2³² over the golden ratio, which no sum of the others meets.
pub const WAVELENGTH_STEP: u32 = 2_654_435_769;
/// ½ in fixed point.
pub const MIDDLE: u32 = 1 << 31;

/// Permutes the digits of a binary fraction, each by a random choice that depends on the digits
/// before it: what was evenly spread stays so (the nested scrambling of Owen 1995, by the hash of
/// Burley 2020, *Practical Hash-based Owen Scrambling*, JCGT 9(4), listing 4).
#[inline]
pub fn scramble(fraction: u32, seed: u32) -> u32 {
    let mut word = fraction.reverse_bits().wrapping_add(seed);
    word ^= word.wrapping_mul(0x6c50_b47c);
    word ^= word.wrapping_mul(0xb82f_1e52);
    word ^= word.wrapping_mul(0xc7af_e638);
    word ^= word.wrapping_mul(0x8d22_f6e6);
    word.reverse_bits()
}

/// The second number of point `index` of the two-dimensional sequence of Sobol 1967; the first is
/// the index with its bits reversed.
#[inline]
pub fn sobol_second(index: u32) -> u32 {
    let mut fraction = 0;
    let mut direction = 1 << 31;
    let mut digits = index;
    while digits != 0 {
        fraction ^= direction * (digits & 1);
        direction ^= direction >> 1;
        digits >>= 1;
    }
    fraction
}

/// Two numbers in 0..1 that fill a pixel evenly as the passes go by, scrambled by the random word
/// `seed`. The first pass is in the middle of all pixels, so that it is a clean picture.
#[inline]
pub fn pixel_sample(seed: u32, pass_index: u32) -> [f32; 2] {
    if pass_index == 0 {
        return [0.5, 0.5];
    }
    let x = scramble(pass_index.reverse_bits(), hash(seed));
    let y = scramble(sobol_second(pass_index), hash(seed ^ 0x9e37_79b9));
    [unit_float(x), unit_float(y)]
}

/// A number in 0..1 that fills it evenly as the passes go by, by which what has the random word `seed`
/// lives or ends. The passes come in an order of its own, or what has come through one such choice
/// would always meet the next alike.
#[inline]
pub fn chance_sample(seed: u32, pass_index: u32) -> f32 {
    unit_float(scramble(pass_index, seed).reverse_bits())
}

/// Two numbers in 0..1 that fill a light evenly as the passes go by, shifted by the random word
/// `seed`.
#[inline]
pub fn light_sample(seed: u32, pass_index: u32) -> [f32; 2] {
    let x = hash(seed).wrapping_add(pass_index.wrapping_mul(LIGHT_STEPS[0]));
    let y = hash(seed ^ 0x9e37_79b9).wrapping_add(pass_index.wrapping_mul(LIGHT_STEPS[1]));
    [unit_float(x), unit_float(y)]
}

/// A number in 0..1 that fills a bin's wavelengths evenly as the passes go by, the middle first. It
/// is the same for all pixels, and so no noise of colours.
#[inline]
pub fn wavelength_sample(pass_index: u32) -> f32 {
    unit_float(MIDDLE.wrapping_add(pass_index.wrapping_mul(WAVELENGTH_STEP)))
}
