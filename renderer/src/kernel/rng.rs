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

/// Term `pass` of the R2 sequence (Roberts 2018), shifted by the random word `seed`: two numbers
/// in 0..1 that fill the unit square evenly as the passes go by.
#[inline]
pub fn sample_2d(seed: u32, pass: u32) -> [f32; 2] {
    // 2³² divided by the plastic number and by its square: the sequence in fixed point wraps by itself.
    let x = hash(seed).wrapping_add(pass.wrapping_mul(3_242_174_889));
    let y = hash(seed ^ 0x9e37_79b9).wrapping_add(pass.wrapping_mul(2_447_445_414));
    [unit_float(x), unit_float(y)]
}
