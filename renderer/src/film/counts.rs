//! What a pixel took to trace, and what was left out of it.

use std::ops::AddAssign;

use bytemuck::{Pod, Zeroable};

use crate::kernel::walk::Tally;

/// What a pixel's camera rays took to trace, and what was left out of them: sums over the passes of
/// a film, or their mean.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Counts {
    /// Ray segments traced, shadow rays included.
    pub rays: f32,
    /// Interfaces met by the ray that had met most of them when it was traced.
    pub depth: f32,
    /// Energy below the significance threshold, in units of the camera ray's.
    pub pruned: f32,
}

impl Counts {
    /// Number of counts.
    pub const LEN: usize = size_of::<Self>() / size_of::<f32>();

    /// The mean where these are sums over `passes` passes.
    #[must_use]
    pub fn mean(self, passes: u32) -> Self {
        let passes = passes.max(1) as f32;
        Self { rays: self.rays / passes, depth: self.depth / passes, pruned: self.pruned / passes }
    }
}

impl From<&Tally> for Counts {
    fn from(tally: &Tally) -> Self {
        Self { rays: tally.segments as f32, depth: tally.depth as f32, pruned: tally.pruned }
    }
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.rays += other.rays;
        self.depth += other.depth;
        self.pruned += other.pruned;
    }
}
