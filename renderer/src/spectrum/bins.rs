//! The film's equal division of the traced range.

use super::{LAMBDA_MAX_NM, LAMBDA_MIN_NM};

/// `count` equal bins over 380–730 nm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bins {
    count: u32,
}

impl Bins {
    /// Divides the traced range into `count` bins, at least one.
    pub fn new(count: u32) -> Self {
        Self { count: count.max(1) }
    }

    /// Number of bins.
    pub fn count(self) -> usize {
        self.count as usize
    }

    /// Width of each bin in nm.
    pub fn width_nm(self) -> f32 {
        (LAMBDA_MAX_NM - LAMBDA_MIN_NM) / self.count as f32
    }

    /// Shortest and longest wavelength of bin `index`, in nm.
    pub fn range_nm(self, index: usize) -> (f32, f32) {
        let edge = |i: usize| {
            LAMBDA_MIN_NM + (LAMBDA_MAX_NM - LAMBDA_MIN_NM) * (i as f32 / self.count as f32)
        };
        (edge(index), edge(index + 1))
    }
}
