//! The walkers' memory: the twin of the buffers in `shaders/walk.wgsl` and `shaders/walkers.wgsl`.

use wgpu::{BindGroup, BufferUsages, DeviceType};

use super::pipeline::{WORKGROUP_SIZE, WalkPipeline};
use super::progress::Progress;
use crate::error::RendererError;
use crate::gpu::{Graphics, bind};
use crate::kernel::fan_walk::FAN_STACK_LEN;
use crate::kernel::ray::Ray;
use crate::kernel::walk::STACK_LEN;
use crate::settings::TraceSettings;
use crate::shaders::Frame;

/// A ray in an array of the shader, where vectors start at multiples of 16 bytes.
pub(super) const RAY_BYTES: u64 = size_of::<Ray>().next_multiple_of(16) as u64;
/// A fan in an array of the shader, whose numbers fill up its vectors.
pub(super) const FAN_BYTES: u64 = 160;
/// Rays that wait for one walker, or fans: as many bytes of either.
pub(super) const STACK_BYTES: u64 = STACK_LEN as u64 * RAY_BYTES;
const _: () = assert!(FAN_STACK_LEN as u64 * FAN_BYTES <= STACK_BYTES);
/// Radiance that one walker has found.
const RADIANCE_BYTES: u64 = *TraceSettings::BINS.end() as u64 * size_of::<f32>() as u64;
/// `Walker` of the shader: where its walk stands, its tally, its item and what that came to.
pub(super) const WALKER_BYTES: u64 = 64;

/// The counter that `Progress` begins with.
const NEXT_ITEM_BYTES: u64 = size_of::<u32>() as u64;

/// A number of walkers, what they remember, and what they are told.
#[derive(Debug)]
pub(super) struct Walkers {
    groups: u32,
    frame: wgpu::Buffer,
    states: wgpu::Buffer,
    progress: wgpu::Buffer,
    walk_group: BindGroup,
}

impl Walkers {
    /// As many walkers as suit the device, or as its memory has room for.
    ///
    /// # Errors
    /// There is no room even for a few, or the device fails.
    pub(super) fn new(graphics: &Graphics, pipeline: &WalkPipeline) -> Result<Self, RendererError> {
        let fitting = graphics.largest_binding() / STACK_BYTES;
        let mut groups =
            wanted_groups(graphics.device_type()).min((fitting / u64::from(WORKGROUP_SIZE)) as u32);
        loop {
            match graphics.guard("hold the waiting rays", |d| Self::create(d, pipeline, groups)) {
                Err(_) if groups > 1 && graphics.loss().is_none() => groups /= 2,
                made => return made,
            }
        }
    }

    fn create(device: &wgpu::Device, pipeline: &WalkPipeline, groups: u32) -> Self {
        let buffer = |label, size, usage| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size,
                usage,
                mapped_at_creation: false,
            })
        };
        let (storage, copy_to) = (BufferUsages::STORAGE, BufferUsages::COPY_DST);
        let each = u64::from(groups * WORKGROUP_SIZE);
        let frame = size_of::<Frame>() as u64;
        let frame = buffer("frame", frame, storage | copy_to);
        let stack = buffer("stack", each * STACK_BYTES, storage);
        let radiance = buffer("radiance", each * RADIANCE_BYTES, storage);
        let states = buffer("walkers", each * WALKER_BYTES, storage | copy_to);
        let progress = size_of::<Progress>() as u64;
        let progress = buffer("progress", progress, storage | copy_to | BufferUsages::COPY_SRC);
        let walk_group = bind(
            device,
            &pipeline.walk_layout,
            [&frame, &stack, &radiance].map(wgpu::Buffer::as_entire_binding),
        );
        Self { groups, frame, states, progress, walk_group }
    }

    /// Number of workgroups that they fill.
    pub(super) fn groups(&self) -> u32 {
        self.groups
    }

    /// What the next dispatch is told.
    pub(super) fn frame(&self) -> &wgpu::Buffer {
        &self.frame
    }

    /// How far the work has come.
    pub(super) fn progress(&self) -> &wgpu::Buffer {
        &self.progress
    }

    /// The frame, the stacks and the radiance, for the kernel.
    pub(super) fn walk_group(&self) -> &BindGroup {
        &self.walk_group
    }

    /// A buffer of a film, and the walkers that write to it, for the kernel.
    pub(super) fn film_group(
        &self,
        device: &wgpu::Device,
        pipeline: &WalkPipeline,
        film: &wgpu::Buffer,
    ) -> BindGroup {
        let buffers = [film, &self.states, &self.progress];
        bind(device, &pipeline.film_layout, buffers.map(wgpu::Buffer::as_entire_binding))
    }

    /// Makes the walkers forget all that they were at, and the counts with it.
    pub(super) fn forget_all(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.clear_buffer(&self.states, 0, None);
        encoder.clear_buffer(&self.progress, 0, None);
    }

    /// Lets walkers that are done with their items begin with the first again.
    pub(super) fn forget_items(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.clear_buffer(&self.progress, 0, Some(NEXT_ITEM_BYTES));
    }
}

/// Workgroups that keep a device of some kind busy, for a price in memory that it can pay: 20 kB of
/// waiting rays per walker are 335 MB on a card of its own and 168 MB where the memory is shared
/// with the processor.
///
/// Few walkers ever fill their stacks (98 of 256 rays were the most in the shipped scenes with the
/// default settings), but none may lose a ray to another's want of room.
fn wanted_groups(device_type: DeviceType) -> u32 {
    match device_type {
        DeviceType::DiscreteGpu => 256,
        DeviceType::IntegratedGpu | DeviceType::VirtualGpu | DeviceType::Other => 128,
        DeviceType::Cpu => 16,
    }
}
