//! How many rays of a tree ended how.

use super::end::RayEnd;
use super::tree::RayTree;

/// Numbers of rays by what ended them; together they are all rays of a tree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayCounts {
    /// Became other rays at an interface.
    pub interfaces: u64,
    /// Met a matte surface.
    pub matte: u64,
    /// Saw a light.
    pub lights: u64,
    /// Saw the backdrop.
    pub backdrop: u64,
    /// Met no surface and saw no light.
    pub dark: u64,
    /// Were too weak to be followed.
    pub pruned: u64,
    /// Were cut off by a limit.
    pub cut_off: u64,
    /// Slipped through a mesh.
    pub lost: u64,
    /// Did not fit into the record.
    pub unrecorded: u64,
}

impl RayCounts {
    /// The counts of a tree.
    pub fn of(tree: &RayTree) -> Self {
        let mut counts = Self { unrecorded: tree.unrecorded_rays, ..Self::default() };
        for ray in &tree.rays {
            *match ray.end {
                RayEnd::Interface(_) => &mut counts.interfaces,
                RayEnd::Matte { .. } => &mut counts.matte,
                RayEnd::Lights { .. } => &mut counts.lights,
                RayEnd::Backdrop => &mut counts.backdrop,
                RayEnd::Dark { .. } => &mut counts.dark,
                RayEnd::Pruned => &mut counts.pruned,
                RayEnd::CutOff { .. } => &mut counts.cut_off,
                RayEnd::Lost => &mut counts.lost,
            } += 1;
        }
        counts
    }

    /// All rays.
    pub fn total(&self) -> u64 {
        self.interfaces
            + self.matte
            + self.lights
            + self.backdrop
            + self.dark
            + self.pruned
            + self.cut_off
            + self.lost
            + self.unrecorded
    }
}
