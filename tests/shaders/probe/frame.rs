//! What the kernel is told beside the scene.

use brilliance_renderer::kernel::walk::TraceRules;
use brilliance_renderer::packed::{PackedGround, PackedSky};
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

use super::World;

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(crate) struct Frame {
    pub(crate) position: Vec3,
    pub(crate) width: u32,
    pub(crate) forward: Vec3,
    pub(crate) height: u32,
    pub(crate) right: Vec3,
    pub(crate) first_row: u32,
    pub(crate) up: Vec3,
    pub(crate) pixel_count: u32,
    pub(crate) rules: TraceRules,
    pub(crate) sky: PackedSky,
    pub(crate) ground: PackedGround,
    pub(crate) first_pass: u32,
    pub(crate) item_count: u32,
    pub(crate) budget: u32,
    pub(crate) bin_count: u32,
    pub(crate) bin_width_nm: f32,
    pub(crate) disc_count: u32,
    pub(crate) top_node_count: u32,
    pub(crate) first_walker: u32,
}

impl Frame {
    pub(super) fn new(world: &World) -> Self {
        let World { scene, camera, size, rules, .. } = world;
        Self {
            position: camera.position,
            width: size[0],
            forward: camera.forward,
            height: size[1],
            right: camera.right,
            up: camera.up,
            pixel_count: size[0] * size[1],
            rules: *rules,
            sky: scene.sky,
            ground: scene.ground,
            bin_count: scene.bins.count() as u32,
            bin_width_nm: scene.bins.width_nm(),
            disc_count: scene.discs.len() as u32,
            top_node_count: scene.top_nodes.len() as u32,
            ..Self::zeroed()
        }
    }
}
