//! Means over bins of what changes by leaps: one wavelength in every nanometre, and more where it
//! leaps.

use brilliance_renderer::spectrum::Bins;
use glam::DVec3;

use crate::brute_force::{Seen, World};
use crate::emitters::Shares;

/// Leaps are found to within this part of a step.
const FINEST_STEP: f64 = 1.0 / 256.0;
/// Radiance over a step, in nm, that a leap may have without being looked for. A white surface has a
/// radiance of 1.
const SMALL_LEAP_NM: f64 = 2e-3;

/// A camera ray over the whole spectrum.
pub(crate) struct Spectrograph<'a> {
    world: &'a World,
    origin: DVec3,
    direction: DVec3,
    levels: Vec<f64>,
    step_nm: f64,
    /// Rays followed.
    pub(crate) segments: u64,
}

impl<'a> Spectrograph<'a> {
    /// Looks at least once in every `step_nm`.
    pub(crate) fn new(world: &'a World, origin: DVec3, direction: DVec3, step_nm: f64) -> Self {
        let levels = world.emitters.levels().collect();
        Self { world, origin, direction, levels, step_nm, segments: 0 }
    }

    /// Mean shares of all emitters in each bin.
    pub(crate) fn bin_means(&mut self, bins: Bins) -> Vec<Shares> {
        (0..bins.count()).map(|bin| self.mean_over(bins.range_nm(bin))).collect()
    }

    fn mean_over(&mut self, (low_nm, high_nm): (f32, f32)) -> Shares {
        let (low_nm, width_nm) = (f64::from(low_nm), f64::from(high_nm - low_nm));
        let steps = (width_nm / self.step_nm).ceil();
        let mut sum = Shares::default();
        let mut start = self.look(low_nm);
        for step in 1..=steps as u32 {
            let end_nm = low_nm + width_nm * f64::from(step) / steps;
            let end = self.look(end_nm);
            self.integrate((end_nm - width_nm / steps, start), (end_nm, end), &mut sum);
            start = end;
        }
        Shares(sum.0.map(|share| share / width_nm))
    }

    /// Adds the integral between two wavelengths: the trapezium, unless there is a leap in it that
    /// can be brought down to a finer step.
    fn integrate(&mut self, start: (f64, Shares), end: (f64, Shares), sum: &mut Shares) {
        let width_nm = end.0 - start.0;
        if width_nm > FINEST_STEP * self.step_nm
            && self.leap(&start.1, &end.1) * width_nm > SMALL_LEAP_NM
        {
            let middle_nm = 0.5 * (start.0 + end.0);
            let middle = (middle_nm, self.look(middle_nm));
            self.integrate(start, middle, sum);
            self.integrate(middle, end, sum);
            return;
        }
        for ((sum, start), end) in sum.0.iter_mut().zip(start.1.0).zip(end.1.0) {
            *sum += 0.5 * (start + end) * width_nm;
        }
    }

    /// The radiance by which two wavelengths differ.
    fn leap(&self, one: &Shares, other: &Shares) -> f64 {
        let shares = one.0.iter().zip(other.0).zip(&self.levels);
        shares.map(|((one, other), level)| (one - other).abs() * level).sum()
    }

    fn look(&mut self, lambda_nm: f64) -> Shares {
        let Seen { shares, segments } = self.world.look(self.origin, self.direction, lambda_nm);
        self.segments += segments;
        shares
    }
}
