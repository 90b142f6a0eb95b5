//! sRGB encoding to 8 bits by table, correctly rounded.

use std::sync::LazyLock;

use wide::f32x8;

use crate::color::srgb_encode;

/// Equal steps of linear light, narrower than the narrowest code: near black a code is
/// 1/(255·12.92) = 1/3295 wide, so that a step holds at most one boundary between codes.
const STEPS: usize = 4096;

/// The code of the start of each step, and where the codes begin.
pub(super) struct Srgb8 {
    code: [u8; STEPS + 1],
    /// Smallest linear value of each code; infinite past the last.
    threshold: [f32; 257],
}

impl Srgb8 {
    /// The table, made on first use.
    pub(super) fn get() -> &'static Self {
        static TABLE: LazyLock<Srgb8> = LazyLock::new(|| Srgb8 {
            code: std::array::from_fn(|step| rounded(step as f32 / STEPS as f32)),
            threshold: std::array::from_fn(smallest_linear),
        });
        &TABLE
    }

    /// The codes of linear channels in 0..=1: 255 times their sRGB encoding, rounded.
    pub(super) fn encode(&self, linear: f32x8) -> [u8; 8] {
        let steps = (linear * STEPS as f32).fast_trunc_int().to_array();
        let linear = linear.to_array();
        std::array::from_fn(|lane| {
            let code = self.code[(steps[lane] as usize).min(STEPS)];
            code + u8::from(linear[lane] >= self.threshold[usize::from(code) + 1])
        })
    }
}

/// The code by definition.
fn rounded(linear: f32) -> u8 {
    (255.0 * srgb_encode(linear.into())).round() as u8
}

/// The smallest value in 0..=1 with this code, found by bisection over the bits of the positive
/// floats, which are in order.
fn smallest_linear(code: usize) -> f32 {
    if code > 255 {
        return f32::INFINITY;
    }
    let (mut low, mut high) = (0, 1.0_f32.to_bits());
    while low < high {
        let middle = low.midpoint(high);
        if usize::from(rounded(f32::from_bits(middle))) < code {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    f32::from_bits(low)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_rounds_as_the_definition_does() {
        let encode = |linear: f32| Srgb8::get().encode(f32x8::splat(linear))[0];
        for code in 0..=255 {
            let edge = smallest_linear(code);
            for linear in [edge.next_down().max(0.0), edge, edge.next_up().min(1.0)] {
                assert_eq!(encode(linear), rounded(linear), "{linear:e}");
            }
        }
        for step in 0..=1_000_000 {
            let linear = step as f32 / 1e6;
            assert_eq!(encode(linear), rounded(linear), "{linear:e}");
        }
    }
}
