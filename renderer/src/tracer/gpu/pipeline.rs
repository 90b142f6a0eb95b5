//! The compiled kernel, and what a device must have to run it.

use std::sync::{Arc, OnceLock};

use wgpu::{
    BindGroupLayout, BindGroupLayoutEntry, BindingType, BufferBindingType, ComputePipeline,
    PipelineLayout, ShaderStages,
};

use super::progress::{ACCOUNT_COUNT, ENERGY_UNIT, SUM_COUNT};
use super::walkers::STACK_BYTES;
use crate::error::RendererError;
use crate::film::Counts;
use crate::gpu::Graphics;
use crate::settings::Splitting;
use crate::shaders::{
    Constant, FAN_WALKERS, KERNEL, RAY_WALKERS, ShaderModule, append, join, print,
};

/// Walkers of a workgroup.
pub(super) const WORKGROUP_SIZE: u32 = 64;
/// Arrays of a scene. With those of the work there are 16, and many devices take no more.
pub(super) const SCENE_BUFFERS: u32 = 10;
/// The frame, the stack and the radiance; the film, the walkers and the progress.
const WORK_BUFFERS: u32 = 6;

/// The kernel compiled for a device, for each splitting when it is first asked for, with the layouts
/// of its three groups of bindings. Cloning shares it.
#[derive(Clone, Debug)]
pub(super) struct WalkPipeline {
    pub(super) scene_layout: BindGroupLayout,
    pub(super) walk_layout: BindGroupLayout,
    pub(super) film_layout: BindGroupLayout,
    layout: PipelineLayout,
    rays: Arc<OnceLock<ComputePipeline>>,
    fans: Arc<OnceLock<ComputePipeline>>,
}

impl WalkPipeline {
    /// Compiles nothing yet.
    ///
    /// # Errors
    /// The device lacks something that the kernel needs, or fails.
    pub(super) fn new(graphics: &Graphics) -> Result<Self, RendererError> {
        check(graphics)?;
        graphics.guard("make ready to trace", |device| {
            let scene_layout = layout(device, "scene", &[READ; SCENE_BUFFERS as usize]);
            let walk_layout = layout(device, "walk", &[READ, WRITE, WRITE]);
            let film_layout = layout(device, "film", &[WRITE, WRITE, WRITE]);
            let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: Some("walkers"),
                bind_group_layouts: &[Some(&scene_layout), Some(&walk_layout), Some(&film_layout)],
                ..Default::default()
            });
            let [rays, fans] = Default::default();
            Self { scene_layout, walk_layout, film_layout, layout, rays, fans }
        })
    }

    /// What follows rays divided like this; the first time it is compiled.
    ///
    /// # Errors
    /// The device refuses the kernel, or fails.
    pub(super) fn of(
        &self,
        graphics: &Graphics,
        splitting: Splitting,
    ) -> Result<&ComputePipeline, RendererError> {
        let (compiled, walkers) = match splitting {
            Splitting::Paper => (&self.rays, RAY_WALKERS),
            Splitting::Exact => (&self.fans, FAN_WALKERS),
        };
        if let Some(pipeline) = compiled.get() {
            return Ok(pipeline);
        }
        // Not within the lock: two that ask at once rather compile it twice.
        let pipeline = graphics
            .guard("compile the tracer", |device| compile(device, &self.layout, walkers))?;
        Ok(compiled.get_or_init(|| pipeline))
    }
}

fn compile(
    device: &wgpu::Device,
    layout: &PipelineLayout,
    walkers: &[ShaderModule],
) -> ComputePipeline {
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("walkers"),
        source: wgpu::ShaderSource::Wgsl(source(walkers).into()),
    });
    device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some("walkers"),
        layout: Some(layout),
        module: &module,
        entry_point: Some("walk_items"),
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        cache: None,
    })
}

/// The kernel and the walkers that run it.
fn source(walkers: &[ShaderModule]) -> String {
    let mut source = print([
        ("WORKGROUP_SIZE", Constant::U32(WORKGROUP_SIZE)),
        ("ACCOUNT_COUNT", Constant::U32(ACCOUNT_COUNT as u32)),
        ("SUM_COUNT", Constant::U32(SUM_COUNT as u32)),
        ("ENERGY_UNIT", Constant::F32(ENERGY_UNIT)),
        ("COUNTS_LEN", Constant::U32(Counts::LEN as u32)),
    ]);
    source.push_str(&join(KERNEL));
    append(&mut source, walkers);
    source
}

/// What the device has of each thing that the kernel needs.
fn check(graphics: &Graphics) -> Result<(), RendererError> {
    let limits = graphics.device().limits();
    let storage_buffers = SCENE_BUFFERS + WORK_BUFFERS;
    for (what, has, needed) in [
        (
            "storage buffers at once",
            limits.max_storage_buffers_per_shader_stage.into(),
            storage_buffers.into(),
        ),
        ("groups of bindings", limits.max_bind_groups.into(), 3),
        (
            "invocations in a workgroup",
            limits
                .max_compute_invocations_per_workgroup
                .min(limits.max_compute_workgroup_size_x)
                .into(),
            WORKGROUP_SIZE.into(),
        ),
        ("bytes in a buffer", graphics.largest_binding(), u64::from(WORKGROUP_SIZE) * STACK_BYTES),
    ] {
        if has < needed {
            return Err(RendererError::Graphics(format!(
                "the graphics device {} can't trace: it takes {has} {what}, and {needed} are \
                 needed; trace on the CPU",
                graphics.name()
            )));
        }
    }
    Ok(())
}

const READ: BufferBindingType = BufferBindingType::Storage { read_only: true };
const WRITE: BufferBindingType = BufferBindingType::Storage { read_only: false };

fn layout(device: &wgpu::Device, label: &str, buffers: &[BufferBindingType]) -> BindGroupLayout {
    let entries = (0..).zip(buffers).map(|(binding, &ty)| BindGroupLayoutEntry {
        binding,
        visibility: ShaderStages::COMPUTE,
        ty: BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None },
        count: None,
    });
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some(label),
        entries: &entries.collect::<Vec<_>>(),
    })
}

#[cfg(test)]
mod tests {
    use super::super::progress::{Account, Progress};
    use super::super::walkers::{FAN_BYTES, RAY_BYTES, WALKER_BYTES};
    use super::*;
    use crate::shaders::Frame;
    use crate::shaders::layout::{assert_twins, layout_of, parse};

    #[test]
    fn both_sides_lay_out_the_same_structs() {
        let module = &parse(&source(RAY_WALKERS));
        assert_twins!(
            module,
            Frame {
                position,
                width,
                forward,
                height,
                right,
                first_row,
                up,
                pixel_count,
                rules,
                sky,
                ground,
                first_pass,
                item_count,
                budget,
                bin_count,
                bin_width_nm,
                disc_count,
                top_node_count,
                first_walker,
                instance_count,
                axis,
                padding,
            }
        );
        assert_twins!(module, Account { items, settled_items, max_segments, sums });
        assert_twins!(module, Progress { next_item, accounts });
        assert_eq!(layout_of(module, "Walker").0 as u64, WALKER_BYTES);
        assert_eq!(layout_of(module, "Ray").0 as u64, RAY_BYTES);
        assert_eq!(layout_of(module, "Fan").0 as u64, FAN_BYTES);
    }
}
