// Floats by their bits: WGSL may take it for granted that there are no NaNs and no infinities, and
// then a comparison with them tells nothing.

// Whether these are the bits of a number.
fn is_finite(bits: u32) -> bool {
    return (bits & 0x7f800000u) != 0x7f800000u;
}
