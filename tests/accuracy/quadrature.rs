//! Means over bins of what changes by leaps: one wavelength in every nanometre, and more where it
//! leaps or may do so unseen. In a strongly dispersed pixel a nanometre is wider than a small light.

use brilliance_renderer::spectrum::Bins;
use glam::DVec3;

use crate::brute_force::{Leaf, Seen, World};
use crate::emitters::Shares;

/// Leaps are found to within this part of a step.
const FINEST_STEP: f64 = 1.0 / 256.0;
/// Radiance over a step, in nm, that a leap may have without being looked for. A white surface has a
/// radiance of 1.
const SMALL_LEAP_NM: f64 = 3e-3;

/// Part of the radiance of all discs that a path is feared to meet that is not there at both ends of a
/// step: about a disc's part of all directions, with some awe.
const FEAR: f64 = 5e-4;
/// How far, as a part of its length, the way between two directions may be off from straight.
const BEND: f64 = 0.25;

/// What is seen at one wavelength.
struct Look {
    lambda_nm: f64,
    seen: Seen,
}

/// A camera ray over the whole spectrum.
pub(crate) struct Spectrograph<'a> {
    world: &'a World,
    origin: DVec3,
    direction: DVec3,
    levels: Vec<f64>,
    /// Radiance that a path is feared to meet that begins or ends within a step.
    fear: f64,
    step_nm: f64,
    /// Rays followed.
    pub(crate) segments: u64,
}

impl<'a> Spectrograph<'a> {
    /// Looks at least once in every `step_nm`.
    pub(crate) fn new(world: &'a World, origin: DVec3, direction: DVec3, step_nm: f64) -> Self {
        let levels = world.emitters.levels().collect();
        let fear = FEAR * world.emitters.disc_levels().sum::<f64>();
        Self { world, origin, direction, levels, fear, step_nm, segments: 0 }
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
            let end = self.look(low_nm + width_nm * f64::from(step) / steps);
            self.integrate(&start, &end, &mut sum);
            start = end;
        }
        Shares(sum.0.map(|share| share / width_nm))
    }

    /// Adds the integral between two wavelengths: the trapezium, unless there is a leap in it that
    /// can be brought down to a finer step.
    fn integrate(&mut self, start: &Look, end: &Look, sum: &mut Shares) {
        let width_nm = end.lambda_nm - start.lambda_nm;
        if width_nm > FINEST_STEP * self.step_nm && self.leap(start, end) * width_nm > SMALL_LEAP_NM
        {
            let middle = self.look(0.5 * (start.lambda_nm + end.lambda_nm));
            self.integrate(start, &middle, sum);
            self.integrate(&middle, end, sum);
            return;
        }
        for ((sum, start), end) in sum.0.iter_mut().zip(start.seen.shares.0).zip(end.seen.shares.0)
        {
            *sum += 0.5 * (start + end) * width_nm;
        }
    }

    /// The radiance by which two wavelengths differ, and what may shine between them alone.
    fn leap(&self, start: &Look, end: &Look) -> f64 {
        let shares = start.seen.shares.0.iter().zip(end.seen.shares.0).zip(&self.levels);
        let leap: f64 = shares.map(|((one, other), level)| (one - other).abs() * level).sum();
        leap + self.hidden(&start.seen.ends, &end.seen.ends)
    }

    /// The radiance of the discs that rays pass between two wavelengths: on the way from one direction
    /// to the other where both have the same path, anywhere where a path begins or ends in between.
    fn hidden(&self, start: &[Leaf], end: &[Leaf]) -> f64 {
        let emitters = &self.world.emitters;
        let (mut start, mut end) = (start.iter().peekable(), end.iter().peekable());
        let mut hidden = 0.0;
        loop {
            let one = start.next_if(|one| end.peek().is_none_or(|other| one.path <= other.path));
            let path = one.map_or(u64::MAX, |one| one.path);
            let other = end.next_if(|other| other.path <= path);
            hidden += match (one, other) {
                (Some(one), Some(other)) => {
                    let margin = BEND * one.direction.distance(other.direction);
                    one.significance
                        * emitters.hidden_between(one.direction, other.direction, margin)
                }
                (Some(alone), None) | (None, Some(alone)) => alone.significance * self.fear,
                (None, None) => return hidden,
            };
        }
    }

    fn look(&mut self, lambda_nm: f64) -> Look {
        let seen = self.world.look(self.origin, self.direction, lambda_nm);
        self.segments += seen.segments;
        Look { lambda_nm, seen }
    }
}
