//! Fans that are sent on: they wait to be followed, or go into the books.

use glam::{Vec3, Vec3A};

use crate::kernel::band::retire_fan;
use crate::kernel::fan::{Fan, axis_width, white_fan};
use crate::kernel::walk::{Fate, RayStack, TraceRules, Walk};
use crate::packed::{NONE, PackedScene};

/// Fans that can wait at once. As with rays, what leaves a convex stone ends at once; what would not
/// fit is counted as cut off.
pub const FAN_STACK_LEN: usize = 128;

impl RayStack<Fan> {
    /// An empty stack of fans.
    pub fn of_fans() -> Self {
        Self::of(white_fan(Vec3::ZERO, Vec3::Z), FAN_STACK_LEN)
    }
}

/// Puts a fan on the stack, or into the books where it is too weak, too deep or too much.
#[inline]
pub fn send_fan(walk: &mut Walk<'_, Fan>, fan: &Fan) {
    let fate = fate_of_fan(walk.scene, walk.rules, fan, walk.waiting());
    if fate == Fate::Kept {
        walk.push(fan);
        return;
    }
    let energy = retire_fan(walk, fan);
    if fate == Fate::TooWeak {
        walk.tally.pruned += energy;
    } else {
        walk.tally.cut_off += energy;
    }
}

/// What becomes of a fan that is sent on while `waiting` others wait.
#[inline]
pub fn fate_of_fan(scene: &PackedScene, rules: &TraceRules, fan: &Fan, waiting: u32) -> Fate {
    if significance_bound(scene, fan) < rules.significance_threshold {
        return Fate::TooWeak;
    }
    if fan.depth > rules.max_depth {
        return Fate::TooDeep;
    }
    if waiting == FAN_STACK_LEN as u32 {
        return Fate::TooMany;
    }
    Fate::Kept
}

/// The largest of the fan's weights, after the least that its path may have absorbed.
#[inline]
pub fn significance_bound(scene: &PackedScene, fan: &Fan) -> f32 {
    let weight = largest(fan.weight);
    if fan.absorber == NONE {
        return weight;
    }
    let path_mm = fan.path_mm.x.min(fan.path_mm.y).min(fan.path_mm.z).max(0.0);
    weight * (-scene.materials[fan.absorber as usize].least_absorption * path_mm).exp()
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
