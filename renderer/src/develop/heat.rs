//! Heat maps: the colours that stand for what a pixel took to trace.
//!
//! The scales are fixed, so that a colour means the same number in every picture.

use bytemuck::NoUninit;

use crate::film::Counts;

/// A count of the film that colours can show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, NoUninit)]
#[repr(u32)]
pub enum HeatMap {
    /// Ray segments per camera ray.
    Rays,
    /// Interfaces met by the deepest ray of a camera ray's tree.
    Depth,
    /// The part of a camera ray's light that ended below the significance threshold.
    Pruned,
}

impl HeatMap {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Rays, Self::Depth, Self::Pruned];

    /// The ends of the logarithmic scale. What lies beyond has the colour of the end; nothing at all
    /// is [`NOTHING`].
    pub fn scale_ends(self) -> [f32; 2] {
        match self {
            Self::Rays => [1.0, 1e4],
            Self::Depth => [1.0, 256.0],
            Self::Pruned => [1e-5, 1.0],
        }
    }

    /// The sRGB codes of a mean count.
    pub fn color(self, mean: f32) -> [u8; 3] {
        codes(HeatScale::new(self).color(mean))
    }

    /// The count that is shown.
    pub(super) fn of(self, counts: &Counts) -> f32 {
        match self {
            Self::Rays => counts.rays,
            Self::Depth => counts.depth,
            Self::Pruned => counts.pruned,
        }
    }
}

/// The colour of a count of 0, sRGB-encoded: darker than any of [`VIRIDIS`].
pub const NOTHING: [u8; 3] = [0, 0, 0];

/// Number of knots of [`VIRIDIS`].
pub(super) const KNOTS: usize = 16;

/// The colour map *viridis* by S. van der Walt, N. J. Smith and E. Firing, 2015: colours that look
/// equally far apart and get steadily lighter, also to the colour-blind. These are every 17th of its
/// 256 colours, sRGB-encoded. In between it is straight to within two codes, but for seven of blue
/// next to the lightest.
///
/// Published at <https://bids.github.io/colormap> under CC0 1.0.
const VIRIDIS: [[u8; 3]; KNOTS] = [
    [0x44, 0x01, 0x54],
    [0x48, 0x1a, 0x6c],
    [0x47, 0x2f, 0x7d],
    [0x41, 0x44, 0x87],
    [0x39, 0x56, 0x8c],
    [0x31, 0x68, 0x8e],
    [0x2a, 0x78, 0x8e],
    [0x23, 0x88, 0x8e],
    [0x1f, 0x98, 0x8b],
    [0x22, 0xa8, 0x84],
    [0x35, 0xb7, 0x79],
    [0x54, 0xc5, 0x68],
    [0x7a, 0xd1, 0x51],
    [0xa5, 0xdb, 0x36],
    [0xd2, 0xe2, 0x1b],
    [0xfd, 0xe7, 0x25],
];

/// A scale of colours made ready for pixels, as shaders read it too.
#[derive(Clone, Copy, Debug, NoUninit)]
#[repr(C)]
pub(super) struct HeatScale {
    /// sRGB-encoded colours in 0..=1 at equal steps from the low end to the high one.
    knots: [[f32; 4]; KNOTS],
    /// sRGB-encoded colour of 0.
    nothing: [f32; 3],
    map: HeatMap,
    /// Binary logarithm of the low end.
    log2_low: f32,
    /// Knots per doubling.
    knots_per_octave: f32,
    padding: [f32; 2],
}

impl HeatScale {
    pub(super) fn new(map: HeatMap) -> Self {
        let encoded = |code: u8| f32::from(code) / 255.0;
        let [low, high] = map.scale_ends();
        Self {
            knots: VIRIDIS.map(|[r, g, b]| [encoded(r), encoded(g), encoded(b), 1.0]),
            nothing: NOTHING.map(encoded),
            map,
            log2_low: low.log2(),
            knots_per_octave: (KNOTS - 1) as f32 / (high / low).log2(),
            padding: [0.0; 2],
        }
    }

    /// The sRGB-encoded colour in 0..=1 of a mean count.
    pub(super) fn color(&self, mean: f32) -> [f32; 3] {
        if mean <= 0.0 {
            return self.nothing;
        }
        let place = (mean.log2() - self.log2_low) * self.knots_per_octave;
        let place = place.clamp(0.0, (KNOTS - 1) as f32);
        let knot = (place as usize).min(KNOTS - 2);
        let [below, above] = [self.knots[knot], self.knots[knot + 1]];
        let share = place - knot as f32;
        std::array::from_fn(|i| below[i] + share * (above[i] - below[i]))
    }
}

/// The sRGB codes of a colour.
pub(super) fn codes(encoded: [f32; 3]) -> [u8; 3] {
    encoded.map(|channel| (255.0 * channel + 0.5) as u8)
}

#[cfg(test)]
mod tests {
    use super::super::gpu::source;
    use super::*;
    use crate::shaders::HEAT;
    use crate::shaders::layout::{assert_twins, parse};

    #[test]
    fn the_shader_reads_a_scale_as_it_is_written() {
        let module = parse(&source(HEAT));
        assert_twins!(
            &module,
            HeatScale { knots, nothing, map, log2_low, knots_per_octave, padding }
        );
    }

    /// Colours of the published table of 256 that are none of the knots, by their numbers.
    #[test]
    fn between_the_knots_it_is_viridis() {
        for (number, published) in [
            (8, [0.277_018, 0.050_344, 0.375_715]),
            (25, [0.282_623, 0.140_926, 0.457_517]),
            (59, [0.239_346, 0.300_855, 0.540_844]),
            (128, [0.127_568, 0.566_949, 0.550_556]),
            (213, [0.565_498, 0.842_430, 0.262_877]),
            (247, [0.916_242, 0.896_091, 0.100_717]),
        ] {
            for map in HeatMap::ALL {
                let [low, high] = map.scale_ends();
                let mean = low * (high / low).powf(number as f32 / 255.0);
                for (found, published) in map.color(mean).into_iter().zip(published) {
                    let apart = (f64::from(found) - 255.0 * published).abs();
                    let most = if number > 238 { 7.5 } else { 2.5 };
                    assert!(apart < most, "{map:?} {number}: {found} for {}", 255.0 * published);
                }
            }
        }
    }
}
