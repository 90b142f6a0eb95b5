// Reproducible numbers: a hash per pixel, and low-discrepancy sequences over the passes.

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

// Permutes the digits of a binary fraction, each by a random choice that depends on the digits
// before it: what was evenly spread stays so (the nested scrambling of Owen 1995, by the hash of
// Burley 2020, *Practical Hash-based Owen Scrambling*, JCGT 9(4), listing 4).
fn scramble(fraction: u32, seed: u32) -> u32 {
    var word = reverseBits(fraction) + seed;
    word ^= word * 0x6c50b47cu;
    word ^= word * 0xb82f1e52u;
    word ^= word * 0xc7afe638u;
    word ^= word * 0x8d22f6e6u;
    return reverseBits(word);
}

// The second number of point `index` of the two-dimensional sequence of Sobol 1967; the first is
// the index with its bits reversed.
fn sobol_second(index: u32) -> u32 {
    var fraction = 0u;
    var direction = 1u << 31u;
    var digits = index;
    while digits != 0u {
        fraction ^= direction * (digits & 1u);
        direction ^= direction >> 1u;
        digits >>= 1u;
    }
    return fraction;
}

// Two numbers in 0..1 that fill a pixel evenly as the passes go by, scrambled by the random word
// `seed`. The first pass is in the middle of all pixels, so that it is a clean picture.
fn pixel_sample(seed: u32, pass_index: u32) -> vec2f {
    if pass_index == 0u {
        return vec2f(0.5, 0.5);
    }
    let x = scramble(reverseBits(pass_index), hash(seed));
    let y = scramble(sobol_second(pass_index), hash(seed ^ 0x9e3779b9u));
    return vec2f(unit_float(x), unit_float(y));
}

// A number in 0..1 that fills it evenly as the passes go by, by which what has the random word `seed`
// lives or ends. The passes come in an order of its own, or what has come through one such choice
// would always meet the next alike.
fn chance_sample(seed: u32, pass_index: u32) -> f32 {
    return unit_float(reverseBits(scramble(pass_index, seed)));
}

// Two numbers in 0..1 that fill a light evenly as the passes go by, shifted by the random word
// `seed`.
fn light_sample(seed: u32, pass_index: u32) -> vec2f {
    let x = hash(seed) + pass_index * LIGHT_STEPS.x;
    let y = hash(seed ^ 0x9e3779b9u) + pass_index * LIGHT_STEPS.y;
    return vec2f(unit_float(x), unit_float(y));
}

// A number in 0..1 that fills a bin's wavelengths evenly as the passes go by, the middle first. It
// is the same for all pixels, and so no noise of colours.
fn wavelength_sample(pass_index: u32) -> f32 {
    return unit_float(MIDDLE + pass_index * WAVELENGTH_STEP);
}
