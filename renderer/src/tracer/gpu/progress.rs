//! How far the walkers have come: the twin of `Progress` in `shaders/walkers.wgsl`.

use bytemuck::{Pod, Zeroable};

use crate::statistics::{Ledger, Statistics};

/// Number of accounts.
pub(super) const ACCOUNT_COUNT: usize = 64;
/// Sums of an account: segments, and the five energies of the ledger.
pub(super) const SUM_COUNT: usize = 6;
/// Units of the energy of one camera ray.
pub(super) const ENERGY_UNIT: f32 = (1 << 30) as f32;

/// Sums of what some of the walkers did, the items at work included but for their number.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(super) struct Account {
    /// Items done.
    pub(super) items: u32,
    /// Of those, of settled pixels, which are done without a ray.
    pub(super) settled_items: u32,
    /// Most segments of one item.
    pub(super) max_segments: u32,
    /// Two words each, the lower one first; those of energies have a sign.
    pub(super) sums: [u32; 2 * SUM_COUNT],
}

/// The next item of the round to be taken, and the accounts of all rounds.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(super) struct Progress {
    /// At least the number of items of the round where all are taken.
    pub(super) next_item: u32,
    pub(super) accounts: [Account; ACCOUNT_COUNT],
}

impl Progress {
    /// Items done in all rounds.
    pub(super) fn items(&self) -> u64 {
        self.accounts.iter().map(|account| u64::from(account.items)).sum()
    }

    /// The accounts taken together; complete where all items that were begun are done.
    pub(super) fn statistics(&self) -> Statistics {
        let sum = |number: usize| -> i64 {
            let words = |account: &Account| [0, 1].map(|word| account.sums[2 * number + word]);
            let sums = self.accounts.iter().map(words);
            sums.map(|[low, high]| (u64::from(high) << 32 | u64::from(low)).cast_signed()).sum()
        };
        let energy = |number: usize| sum(number) as f64 / f64::from(ENERGY_UNIT);
        let settled = self.accounts.iter().map(|account| u64::from(account.settled_items));
        let camera_rays = self.items() - settled.sum::<u64>();
        let max_segments = self.accounts.iter().map(|account| account.max_segments).max();
        Statistics {
            camera_rays,
            segments: sum(0).cast_unsigned(),
            max_segments_per_camera_ray: max_segments.unwrap_or(0),
            ledger: Ledger {
                entered: camera_rays as f64,
                returned: energy(1),
                absorbed: energy(2),
                pruned: energy(3),
                cut_off: energy(4),
                lost: energy(5),
            },
        }
    }
}

/// Full turns of all walkers without effect after which they are given up.
const VAIN_TURNS: u32 = 3;

/// Notices that walkers get nowhere, which only a broken kernel can do: one that has work follows
/// at least one ray in each dispatch.
#[derive(Debug, Default)]
pub(super) struct Headway {
    reached: u64,
    vain_submissions: u32,
}

impl Headway {
    /// Looks at how far the work has come after one more submission, to one of `parts` parts of
    /// the walkers; true where the last ones changed nothing.
    pub(super) fn is_lacking(&mut self, progress: &Progress, parts: u32) -> bool {
        let reached = progress.items() + progress.statistics().segments;
        self.vain_submissions = if reached > self.reached { 0 } else { self.vain_submissions + 1 };
        self.reached = reached;
        self.vain_submissions >= VAIN_TURNS * parts
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn progress(items: u32, segments: u32) -> Progress {
        let mut progress = Progress::zeroed();
        progress.accounts[5].items = items;
        progress.accounts[9].sums[0] = segments;
        progress
    }

    #[test]
    fn rays_that_are_followed_are_headway_without_any_item_done() {
        let mut headway = Headway::default();
        for segments in 1..100 {
            assert!(!headway.is_lacking(&progress(0, segments), 1));
        }
    }

    #[test]
    fn it_is_lacking_once_all_walkers_had_their_turns() {
        for parts in [1, 4] {
            let mut headway = Headway::default();
            assert!(!headway.is_lacking(&progress(7, 80), parts));
            for _ in 1..VAIN_TURNS * parts {
                assert!(!headway.is_lacking(&progress(7, 80), parts));
            }
            assert!(headway.is_lacking(&progress(7, 80), parts));
        }
    }
}
