//! Fans that are sent on: they wait to be followed, or go into the books.

use glam::{Vec3, Vec3A};

use crate::kernel::band::{fan_energy, retire_fan};
use crate::kernel::fan::{Fan, axis_width, white_fan};
use crate::kernel::rng;
use crate::kernel::walk::{Fate, RayStack, TraceRules, Walk};
use crate::packed::{NONE, PackedScene};

/// Fans that can wait at once. As with rays, what leaves a convex stone ends at once; what would not
/// fit is counted as cut off.
pub const FAN_STACK_LEN: usize = 128;

/// How many times as likely those live that a camera ray makes at its first surface: they are few, and
/// what is mirrored there would be grainy.
pub const FIRST_GRACE: f32 = 10.0;

/// Part of a fan that is supposed to be left, at least, whatever its path has absorbed.
pub const LEAST_KEPT: f32 = 1e-3;

impl RayStack<Fan> {
    /// An empty stack of fans.
    pub fn of_fans() -> Self {
        Self::of(white_fan(Vec3::ZERO, Vec3::Z, 0), FAN_STACK_LEN)
    }
}

/// Puts a fan on the stack, or into the books where it is too weak, too deep or too much.
#[inline]
pub fn send_fan(walk: &mut Walk<'_, Fan>, mut fan: Fan) {
    if walk.keeps_all {
        walk.keep(&fan);
        return;
    }
    let threshold = walk.rules.significance_threshold;
    let fate = fate_of_fan(walk, &mut fan, threshold);
    if fate == Fate::Kept {
        walk.push(&fan);
    }
}

/// What becomes of a fan that is sent on; one that is not kept goes into the books.
///
/// A fan that carries less energy than `threshold` lives on by chance, and then carries as much more
/// as others like it lose. What is gained and lost is booked as pruned: in the mean nothing.
#[inline]
pub fn fate_of_fan(walk: &mut Walk<'_, Fan>, fan: &mut Fan, threshold: f32) -> Fate {
    let mut fate = Fate::Kept;
    if fan.depth > walk.rules.max_depth {
        fate = Fate::TooDeep;
    } else if walk.waiting() == FAN_STACK_LEN as u32 {
        fate = Fate::TooMany;
    }
    if fate != Fate::Kept {
        let energy = retire_fan(walk, fan);
        walk.tally.cut_off += energy;
        return fate;
    }
    let mut chance = energy_bound(walk.scene, fan) / threshold;
    if fan.depth <= 1 {
        chance *= FIRST_GRACE;
    }
    if chance >= 1.0 {
        return fate;
    }
    // Before what its path has absorbed: that is booked where those end that live.
    let energy = fan_energy(walk.scene, fan);
    if rng::chance_sample(fan.seed, walk.pass_index) >= chance {
        walk.tally.pruned += energy;
        return Fate::TooWeak;
    }
    walk.tally.pruned -= energy * (1.0 / chance - 1.0);
    fan.weight /= chance;
    fate
}

/// About the energy of a fan, after the least that its path may have absorbed.
#[inline]
pub fn energy_bound(scene: &PackedScene, fan: &Fan) -> f32 {
    significance_bound(scene, fan) * axis_width(fan)
}

/// The largest of the fan's weights, after the least that its path may have absorbed: but no more than
/// nearly all of it, so that chance makes none much larger than it was.
#[inline]
pub fn significance_bound(scene: &PackedScene, fan: &Fan) -> f32 {
    let weight = largest(fan.weight);
    if fan.absorber == NONE {
        return weight;
    }
    let path_mm = least_of(fan.path_mm).max(0.0);
    let kept = (-scene.materials[fan.absorber as usize].least_absorption * path_mm).exp();
    weight * kept.max(LEAST_KEPT)
}

/// The largest of the values at the nodes.
#[inline]
pub fn largest(values: Vec3A) -> f32 {
    values.x.max(values.y).max(values.z)
}

/// The least of the values at the nodes.
#[inline]
pub fn least_of(values: Vec3A) -> f32 {
    values.x.min(values.y).min(values.z)
}

/// Whether the fan carries enough for its wavelengths to be told apart where they part.
#[inline]
pub fn is_worth_dividing(rules: &TraceRules, fan: &Fan) -> bool {
    largest(fan.weight) * axis_width(fan) >= rules.cut_threshold
}
