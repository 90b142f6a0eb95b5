//! What a pixel took to trace, and what was left out of it.

use std::mem::offset_of;
use std::ops::AddAssign;

use bytemuck::{Pod, Zeroable};

use crate::kernel::walk::Tally;

/// What a pixel's camera rays took to trace, what was left out of them, and how they differ: sums
/// over the camera rays, or their means.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Counts {
    /// Ray segments traced, shadow rays included.
    pub rays: f32,
    /// Interfaces met by the ray that had met most of them when it was traced.
    pub depth: f32,
    /// Energy below the significance threshold, in units of the camera ray's.
    pub pruned: f32,
    /// Camera rays; also where the others are means.
    pub samples: f32,
    /// Square of what a camera ray found: its radiance as the mean over the bins.
    pub squares: f32,
}

impl Counts {
    /// Number of counts.
    pub const LEN: usize = size_of::<Self>() / size_of::<f32>();
    /// Which of them is the number of camera rays.
    pub(crate) const SAMPLES: usize = offset_of!(Self, samples) / size_of::<f32>();
    /// Which of them is the sum of squares.
    pub(crate) const SQUARES: usize = offset_of!(Self, squares) / size_of::<f32>();

    /// The counts of one camera ray that found this radiance per bin.
    #[inline]
    pub fn of_sample(tally: &Tally, radiance: &[f32]) -> Self {
        let mean = radiance.iter().sum::<f32>() / radiance.len() as f32;
        Self {
            rays: tally.segments as f32,
            depth: tally.depth as f32,
            pruned: tally.pruned,
            samples: 1.0,
            squares: mean * mean,
        }
    }

    /// What makes sums over the pixel's camera rays means.
    #[inline]
    pub fn scale(&self) -> f32 {
        1.0 / self.samples.max(1.0)
    }

    /// The means where these are sums.
    #[must_use]
    pub fn mean(self) -> Self {
        let scale = self.scale();
        Self {
            rays: self.rays * scale,
            depth: self.depth * scale,
            pruned: self.pruned * scale,
            samples: self.samples,
            squares: self.squares * scale,
        }
    }
}

impl AddAssign for Counts {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        self.rays += other.rays;
        self.depth += other.depth;
        self.pruned += other.pruned;
        self.samples += other.samples;
        self.squares += other.squares;
    }
}
