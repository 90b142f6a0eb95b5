//! What tracing cost and where the energy went.

use std::ops::AddAssign;

use serde::Serialize;

use crate::kernel::walk::Tally;

/// Where the energy of the camera rays went, in units of one camera ray over the whole spectrum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Ledger {
    /// Energy of the camera rays.
    pub entered: f64,
    /// Reached a light, the sky, the dark or an opaque surface.
    pub returned: f64,
    /// Absorbed inside coloured stones.
    pub absorbed: f64,
    /// Ended below the significance threshold.
    pub pruned: f64,
    /// Ended at the maximum depth, or because the ray stack was full.
    pub cut_off: f64,
    /// Lost where a ray slipped through a mesh; should be 0.
    pub lost: f64,
}

impl Ledger {
    /// The books of one camera ray.
    pub fn of_tally(tally: &Tally) -> Self {
        Self {
            entered: 1.0,
            returned: f64::from(tally.returned),
            absorbed: f64::from(tally.absorbed),
            pruned: f64::from(tally.pruned),
            cut_off: f64::from(tally.cut_off),
            lost: f64::from(tally.lost),
        }
    }

    /// Entered minus everything accounted for; 0 but for rounding.
    pub fn imbalance(&self) -> f64 {
        self.entered - self.returned - self.absorbed - self.pruned - self.cut_off - self.lost
    }
}

impl AddAssign for Ledger {
    fn add_assign(&mut self, other: Self) {
        self.entered += other.entered;
        self.returned += other.returned;
        self.absorbed += other.absorbed;
        self.pruned += other.pruned;
        self.cut_off += other.cut_off;
        self.lost += other.lost;
    }
}

/// Counts of one pass, or of several added up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Statistics {
    /// Camera rays, one per pass and pixel that the pass does not leave out.
    pub camera_rays: u64,
    /// Ray segments traced: camera rays, sub-rays, reflections and shadow rays.
    pub segments: u64,
    /// Most segments that one camera ray needed.
    pub max_segments_per_camera_ray: u32,
    /// Energy.
    pub ledger: Ledger,
}

impl Statistics {
    /// Mean number of segments per camera ray; 0 before the first.
    pub fn mean_segments_per_camera_ray(&self) -> f64 {
        if self.camera_rays == 0 { 0.0 } else { self.segments as f64 / self.camera_rays as f64 }
    }
}

impl AddAssign for Statistics {
    fn add_assign(&mut self, other: Self) {
        self.camera_rays += other.camera_rays;
        self.segments += other.segments;
        self.max_segments_per_camera_ray =
            self.max_segments_per_camera_ray.max(other.max_segments_per_camera_ray);
        self.ledger += other.ledger;
    }
}
