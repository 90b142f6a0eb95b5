//! How far the walkers have come: the twin of `Progress` in `shaders/walkers.wgsl`.

use bytemuck::{Pod, Zeroable};

use crate::statistics::{Ledger, Statistics};

/// Number of accounts.
pub(super) const ACCOUNT_COUNT: usize = 64;
/// Sums of an account: segments, and the five energies of the ledger.
pub(super) const SUM_COUNT: usize = 6;
/// Units of the energy of one camera ray.
pub(super) const ENERGY_UNIT: f32 = (1 << 30) as f32;

/// Sums over the items of some of the walkers.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(super) struct Account {
    /// Items done.
    pub(super) items: u32,
    /// Most segments of one item.
    pub(super) max_segments: u32,
    /// Two words each, the lower one first.
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

    /// The accounts taken together.
    pub(super) fn statistics(&self) -> Statistics {
        let sum = |number: usize| -> u64 {
            let words = |account: &Account| [0, 1].map(|word| account.sums[2 * number + word]);
            let sums = self.accounts.iter().map(words);
            sums.map(|[low, high]| u64::from(high) << 32 | u64::from(low)).sum()
        };
        let energy = |number: usize| sum(number) as f64 / f64::from(ENERGY_UNIT);
        let max_segments = self.accounts.iter().map(|account| account.max_segments).max();
        Statistics {
            camera_rays: self.items(),
            segments: sum(0),
            max_segments_per_camera_ray: max_segments.unwrap_or(0),
            ledger: Ledger {
                entered: self.items() as f64,
                returned: energy(1),
                absorbed: energy(2),
                pruned: energy(3),
                cut_off: energy(4),
                lost: energy(5),
            },
        }
    }
}
