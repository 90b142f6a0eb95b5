//! Rounds of several passes, and what they gain on which machine.

use super::Scheduler;
use crate::film::next_measurement;
use crate::settings::NoiseGoal;
use crate::tracer::TracerName;

/// What passes are traced by, which decides what they are guessed to cost and what a round of
/// several gains.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Machine {
    /// A processor, also one that poses as a graphics device.
    Processor,
    /// A graphics card.
    GraphicsCard,
}

impl Machine {
    /// Cost of a full pass per pixel before the first is measured, in seconds. A graphics card
    /// takes over from the processor, whose picture should stay until there is one of full
    /// resolution.
    pub(super) fn guess(self) -> f64 {
        match self {
            Self::Processor => 1e-5,
            Self::GraphicsCard => 1e-8,
        }
    }

    /// Longest pass that shares a round with others, in seconds. On a graphics card most of a pass
    /// may be spent waiting for its few heaviest pixels, so that two take hardly longer than one.
    fn longest_shared_pass(self) -> f64 {
        match self {
            Self::Processor => Scheduler::PUBLISH_SECONDS,
            Self::GraphicsCard => Scheduler::ROUND_SECONDS,
        }
    }
}

impl From<&TracerName> for Machine {
    fn from(tracer: &TracerName) -> Self {
        match tracer {
            TracerName::Gpu { is_software: false, .. } => Self::GraphicsCard,
            TracerName::Gpu { is_software: true, .. } | TracerName::Cpu { .. } => Self::Processor,
        }
    }
}

/// Number of passes to add in one round to a film of `done` passes that wants `limit` or `noise`,
/// where a pass takes `pass_seconds`; at least 1.
///
/// Passes that are long to look at come one by one. A round at most doubles the film, so that a new
/// picture shows its first pass at once and gets better at every look. Where pixels are left out it
/// ends when others might be.
pub(crate) fn round(
    machine: Machine,
    pass_seconds: f64,
    done: u32,
    limit: u32,
    noise: NoiseGoal,
) -> u32 {
    if pass_seconds > machine.longest_shared_pass() {
        return 1;
    }
    let wanted =
        if noise.adapts() { limit.min(next_measurement(done)) } else { limit }.saturating_sub(done);
    let most = done.min(wanted).max(1);
    // A cost of 0 gives an infinity, which the cast makes the largest number.
    ((Scheduler::ROUND_SECONDS / pass_seconds) as u32).max(2).min(most)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_round_is_whole_whatever_a_pass_costs() {
        for machine in [Machine::Processor, Machine::GraphicsCard] {
            for pass_seconds in [0.0, 1e-30, 0.033, 0.1, f64::INFINITY] {
                assert_eq!(round(machine, pass_seconds, 0, 9, NoiseGoal::NONE), 1);
                assert!(
                    (1..=4).contains(&round(machine, pass_seconds, 5, 9, NoiseGoal::NONE)),
                    "{pass_seconds}"
                );
                assert_eq!(round(machine, pass_seconds, 9, 9, NoiseGoal::NONE), 1);
            }
        }
    }
}
