//! What a dispatch is told: the twin of `Frame` in `packed.wgsl`.

use bytemuck::{Pod, Zeroable};
use glam::Vec3;

use crate::camera::CameraFrame;
use crate::kernel::walk::TraceRules;
use crate::packed::{PackedGround, PackedScene, PackedSky};

/// The camera, the rules, the lights without a place, and the work to be done.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Frame {
    /// The eye.
    pub position: Vec3,
    /// Columns of the film.
    pub width: u32,
    /// Unit vector towards the middle of the picture.
    pub forward: Vec3,
    /// Rows of the film.
    pub height: u32,
    /// From the middle to the right edge of the image plane.
    pub right: Vec3,
    /// The film's row that is the band's first.
    pub first_row: u32,
    /// From the middle to the upper edge of the image plane.
    pub up: Vec3,
    /// Pixels of the band.
    pub pixel_count: u32,
    /// By which rules rays are followed.
    pub rules: TraceRules,
    /// The lights without a place.
    pub sky: PackedSky,
    /// The ground.
    pub ground: PackedGround,
    /// Number of the round's first pass.
    pub first_pass: u32,
    /// Items of the round: pixels of the band times passes.
    pub item_count: u32,
    /// Rays that each walker may follow.
    pub budget: u32,
    /// Bins of the film.
    pub bin_count: u32,
    /// Width of a bin.
    pub bin_width_nm: f32,
    /// Number of disc lights.
    pub disc_count: u32,
    /// Number of nodes over the bodies.
    pub top_node_count: u32,
    /// The first of the walkers that get on; as many follow as are dispatched.
    pub first_walker: u32,
    /// Number of bodies.
    pub instance_count: u32,
    /// First number of the dispersion axis.
    pub axis: u32,
    /// Fills the struct to a multiple of 16 bytes.
    pub padding: [u32; 2],
}

impl Frame {
    /// What a scene has to say; the rest is 0.
    pub fn of(scene: &PackedScene) -> Self {
        Self {
            sky: scene.sky,
            ground: scene.ground,
            bin_count: scene.bins.count() as u32,
            bin_width_nm: scene.bins.width_nm(),
            disc_count: scene.discs.len() as u32,
            top_node_count: scene.top_nodes.len() as u32,
            instance_count: scene.instances.len() as u32,
            axis: scene.axis,
            ..Self::zeroed()
        }
    }

    /// The same for a film of `size` that `camera` exposes by `rules`.
    #[must_use]
    pub fn seen(self, camera: &CameraFrame, [width, height]: [u32; 2], rules: TraceRules) -> Self {
        let CameraFrame { position, forward, right, up } = *camera;
        Self { position, width, forward, height, right, up, rules, ..self }
    }
}
