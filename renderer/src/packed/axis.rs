//! The dispersion axis: where wavelengths lie when they are spaced by what refraction makes of them.

use super::spectra::PackedMaterials;
use super::{AXIS_LEN, INDEX_TABLE_LEN};
use crate::spectrum::{Bins, LAMBDA_MIN_NM};

/// Points of a bin at which its moments are summed up.
const POINTS_PER_BIN: usize = 256;

/// Position on the axis of every nm from 380 to 730: 0 at the first, 1 at the last, and between them
/// in proportion to the index of the scene's most dispersive material. Without one it goes with the
/// wavelength.
pub(super) struct Axis {
    position_at_nm: Vec<f64>,
}

impl Axis {
    pub(super) fn of(materials: &PackedMaterials) -> Self {
        let tables = materials.index_tables.chunks_exact(INDEX_TABLE_LEN);
        let falling = tables.filter(|table| table.is_sorted_by(|a, b| a > b));
        let dispersion = |table: &&[f32]| table[0] - table[INDEX_TABLE_LEN - 1];
        let strongest = falling.max_by(|a, b| dispersion(a).total_cmp(&dispersion(b)));
        let last = (INDEX_TABLE_LEN - 1) as f64;
        let position = |i: usize| match strongest {
            Some(table) => f64::from(table[0] - table[i]) / f64::from(dispersion(&table)),
            None => i as f64 / last,
        };
        Self { position_at_nm: (0..INDEX_TABLE_LEN).map(position).collect() }
    }

    /// Wavelength, in nm above the shortest, at each of [`AXIS_LEN`] positions.
    fn nm_at_positions(&self) -> impl Iterator<Item = f64> + '_ {
        let mut i = 0;
        (0..AXIS_LEN).map(move |step| {
            let position = step as f64 / (AXIS_LEN - 1) as f64;
            while i + 2 < INDEX_TABLE_LEN && self.position_at_nm[i + 1] < position {
                i += 1;
            }
            let (low, high) = (self.position_at_nm[i], self.position_at_nm[i + 1]);
            i as f64 + (position - low) / (high - low)
        })
    }

    /// The axis as tracers read it: wavelengths in nm at [`AXIS_LEN`] positions, positions at every
    /// nm, and over the wavelengths of each bin the mean position and its variance.
    pub(super) fn tables(&self, bins: Bins) -> Vec<f32> {
        let nanometres = self.nm_at_positions().map(|nm| (f64::from(LAMBDA_MIN_NM) + nm) as f32);
        let positions = self.position_at_nm.iter().map(|&position| position as f32);
        let moments = (0..bins.count()).map(|bin| self.moments(bins, bin));
        let (means, variances): (Vec<_>, Vec<_>) = moments.unzip();
        let moments = means.into_iter().chain(variances).map(|moment| moment as f32);
        nanometres.chain(positions).chain(moments).collect()
    }

    /// Mean over a bin's wavelengths of the position, and its variance.
    fn moments(&self, bins: Bins, bin: usize) -> (f64, f64) {
        let mean_of = |value: &dyn Fn(f64) -> f64| {
            let points = (0..POINTS_PER_BIN).map(|i| {
                let part = (i as f64 + 0.5) / POINTS_PER_BIN as f64;
                let nm = (bin as f64 + part) * f64::from(bins.width_nm());
                value(interpolate(&self.position_at_nm, nm))
            });
            points.sum::<f64>() / POINTS_PER_BIN as f64
        };
        let mean = mean_of(&|position| position);
        (mean, mean_of(&|position| (position - mean).powi(2)))
    }

    /// The indices of a table of every nm at [`AXIS_LEN`] positions.
    pub(super) fn indices<'a>(&'a self, table: &'a [f32]) -> impl Iterator<Item = f32> + 'a {
        self.nm_at_positions().map(|nm| interpolate(table, nm) as f32)
    }
}

/// The value of a table at `nm` behind its first.
fn interpolate<N: Copy + Into<f64>>(table: &[N], nm: f64) -> f64 {
    let i = (nm as usize).min(table.len() - 2);
    let (low, high) = (table[i].into(), table[i + 1].into());
    low + (high - low) * (nm - i as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(index: impl Fn(f64) -> f64) -> Axis {
        let table = (0..INDEX_TABLE_LEN).map(|i| index(380.0 + i as f64) as f32);
        Axis::of(&PackedMaterials {
            materials: Vec::new(),
            index_tables: table.collect(),
            of_object: Vec::new(),
        })
    }

    #[test]
    fn positions_and_wavelengths_are_each_others_inverse() {
        for axis in [axis(|nm| 1.5 + 1e4 / (nm * nm)), axis(|_| 1.5), axis(|nm| 1.7 - 1e-4 * nm)] {
            for (step, nm) in axis.nm_at_positions().enumerate() {
                let position = step as f64 / (AXIS_LEN - 1) as f64;
                assert!((interpolate(&axis.position_at_nm, nm) - position).abs() < 1e-9, "{step}");
            }
        }
    }

    #[test]
    fn the_index_is_linear_in_the_position() {
        let index = |nm: f64| 2.38 + 13_000.0 / (nm * nm);
        let axis = axis(index);
        let table: Vec<_> = (0..INDEX_TABLE_LEN).map(|i| index(380.0 + i as f64) as f32).collect();
        let (first, last) = (index(380.0), index(730.0));
        for (step, n) in axis.indices(&table).enumerate() {
            let line = first + (last - first) * step as f64 / (AXIS_LEN - 1) as f64;
            assert!((f64::from(n) - line).abs() < 1e-6, "{step}: {n} {line}");
        }
    }

    #[test]
    fn without_dispersion_moments_are_those_of_the_wavelength() {
        let axis = axis(|_| 1.5);
        let bins = Bins::new(7);
        for bin in 0..7 {
            let (mean, variance) = axis.moments(bins, bin);
            assert!((mean - (bin as f64 + 0.5) / 7.0).abs() < 1e-9, "{bin}: {mean}");
            assert!((variance - 1.0 / (12.0 * 49.0)).abs() < 1e-6, "{bin}: {variance}");
        }
    }
}
