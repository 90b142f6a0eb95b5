//! What a dispatch is told: the twin of `Frame` in `shaders/packed.wgsl`.

use bytemuck::{Pod, Zeroable};
use glam::Vec3;

use crate::kernel::walk::TraceRules;
use crate::packed::{PackedGround, PackedSky};

/// The camera, the rules, the lights without a place, and the work to be done.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(super) struct Frame {
    /// The eye.
    pub(super) position: Vec3,
    /// Columns of the film.
    pub(super) width: u32,
    /// Unit vector towards the middle of the picture.
    pub(super) forward: Vec3,
    /// Rows of the film.
    pub(super) height: u32,
    /// From the middle to the right edge of the image plane.
    pub(super) right: Vec3,
    /// The film's row that is the band's first.
    pub(super) first_row: u32,
    /// From the middle to the upper edge of the image plane.
    pub(super) up: Vec3,
    /// Pixels of the band.
    pub(super) pixel_count: u32,
    /// By which rules rays are followed.
    pub(super) rules: TraceRules,
    /// The lights without a place.
    pub(super) sky: PackedSky,
    /// The ground.
    pub(super) ground: PackedGround,
    /// Number of the round's first pass.
    pub(super) first_pass: u32,
    /// Items of the round: pixels of the band times passes.
    pub(super) item_count: u32,
    /// Rays that each walker may follow.
    pub(super) budget: u32,
    /// Bins of the film.
    pub(super) bin_count: u32,
    /// Width of a bin.
    pub(super) bin_width_nm: f32,
    /// Number of disc lights.
    pub(super) disc_count: u32,
    /// Number of nodes over the bodies.
    pub(super) top_node_count: u32,
    /// The first of the walkers that get on; as many follow as are dispatched.
    pub(super) first_walker: u32,
}
