//! The rays that a filter lets through, in an order.

use super::filter::Filter;
use super::traced::Traced;

/// In which order the rays are listed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Order {
    /// Each before those that came of it.
    #[default]
    Tree,
    /// The most significant first.
    Strongest,
}

/// Rays of one tree, chosen again only for another filter or order: there may be 200 000.
#[derive(Debug, Default)]
pub(super) struct Rows {
    chosen_by: Option<(Filter, Order)>,
    ids: Vec<u32>,
}

impl Rows {
    /// Ids of the rays of `traced`, which is the same until these rows are dropped.
    pub(super) fn choose(&mut self, traced: &Traced, filter: Filter, order: Order) -> &[u32] {
        if self.chosen_by != Some((filter, order)) {
            let all: &mut dyn Iterator<Item = u32> = match order {
                Order::Tree => &mut (0..traced.tree.rays.len() as u32),
                Order::Strongest => &mut traced.strongest.iter().copied(),
            };
            self.ids = all.filter(|&id| filter.admits(traced, id)).collect();
            self.chosen_by = Some((filter, order));
        }
        &self.ids
    }
}
