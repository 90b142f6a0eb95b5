//! What the kernel is told beside the scene.

use brilliance_renderer::kernel::walk::TraceRules;
use brilliance_renderer::packed::{PackedGround, PackedSky};
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

use super::World;

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(super) struct Frame {
    position: Vec3,
    width: u32,
    forward: Vec3,
    height: u32,
    right: Vec3,
    first_row: u32,
    up: Vec3,
    pixel_count: u32,
    rules: TraceRules,
    sky: PackedSky,
    ground: PackedGround,
    first_pass: u32,
    item_count: u32,
    budget: u32,
    bin_count: u32,
    bin_width_nm: f32,
    disc_count: u32,
    top_node_count: u32,
    walker_count: u32,
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
