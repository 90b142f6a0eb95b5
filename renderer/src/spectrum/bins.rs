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
        (self.edge_nm(index) as f32, self.edge_nm(index + 1) as f32)
    }

    /// Wavelength in the middle of bin `index`, in nm.
    pub fn center_nm(self, index: usize) -> f64 {
        0.5 * (self.edge_nm(index) + self.edge_nm(index + 1))
    }

    /// Wavelength at which bin `index` begins and bin `index` − 1 ends, in nm; `index` counts from
    /// 0 to the number of bins.
    pub(super) fn edge_nm(self, index: usize) -> f64 {
        let (low, high) = (f64::from(LAMBDA_MIN_NM), f64::from(LAMBDA_MAX_NM));
        low + (high - low) * index as f64 / f64::from(self.count)
    }

    /// Both ends of every bin in nm, in order.
    pub(super) fn ranges_nm(self) -> impl Iterator<Item = (f64, f64)> {
        (0..self.count()).map(move |index| (self.edge_nm(index), self.edge_nm(index + 1)))
    }
}
