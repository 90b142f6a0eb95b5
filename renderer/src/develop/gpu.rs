//! Developing on a graphics device: the film is neither traced again nor read back.

mod count_image;
mod expose;
mod noise;
mod region;
mod xyz_image;

use std::sync::Arc;

use wgpu::{BindingResource, BufferUsages, ComputePipeline, Device, TextureFormat, TextureUsages};

pub use count_image::GpuCountImage;
pub use expose::Band;
pub use xyz_image::GpuXyzImage;

use super::heat::KNOTS;
use super::tone_curve::REINHARD_WHITE;
use crate::error::RendererError;
use crate::film::{BUCKETS, BUCKETS_PER_OCTAVE, Counts, ERROR_PER_DEVIATION, LOG2_LEAST};
use crate::gpu::{Graphics, bind};
use crate::settings::ToneCurve;
use crate::shaders::{
    Constant, DEVELOP, EXPOSE, HEAT, NOISE, REGION, ROOTS, ShaderModule, append, print,
};

/// Side of the square of pixels, or of rows and bins, that a workgroup takes.
const WORKGROUP_SIDE: u32 = 8;

/// Exposes, develops and measures films in the memory of a graphics device. Cloning shares it.
#[derive(Clone, Debug)]
pub struct GpuDeveloper {
    graphics: Graphics,
    pipelines: Arc<Pipelines>,
}

/// The compiled shaders.
#[derive(Debug)]
struct Pipelines {
    expose: ComputePipeline,
    sum_rows: ComputePipeline,
    sum_roots: ComputePipeline,
    noise: ComputePipeline,
    develop: ComputePipeline,
    heat: ComputePipeline,
}

impl GpuDeveloper {
    /// Compiles the shaders for a device.
    ///
    /// # Errors
    /// The device refuses the shaders, or fails.
    pub fn new(graphics: &Graphics) -> Result<Self, RendererError> {
        let pipelines = graphics.guard("compile the shaders that develop", |device| {
            // What a device can't make shows now, and not with the first picture.
            let _ = (exposed_texture(device, [1, 1]), developed_texture(device, [1, 1]));
            Pipelines {
                expose: pipeline(device, "expose", EXPOSE),
                sum_rows: pipeline(device, "sum rows", REGION),
                sum_roots: pipeline(device, "sum roots", ROOTS),
                noise: pipeline(device, "noise", NOISE),
                develop: pipeline(device, "develop", DEVELOP),
                heat: pipeline(device, "heat", HEAT),
            }
        })?;
        Ok(Self { graphics: graphics.clone(), pipelines: Arc::new(pipelines) })
    }

    /// Runs `pipeline` over pixels, or bins and rows; each of `runs` binds its resources in the order of
    /// their numbers and says how many columns and rows it covers.
    fn submit<'a>(
        &self,
        device: &Device,
        pipeline: &ComputePipeline,
        runs: impl IntoIterator<Item = ([u32; 2], Vec<BindingResource<'a>>)>,
    ) {
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_pipeline(pipeline);
        for ([width, height], resources) in runs {
            let group = bind(device, &pipeline.get_bind_group_layout(0), resources);
            pass.set_bind_group(0, &group, &[]);
            let groups = [width, height].map(|pixels| pixels.div_ceil(WORKGROUP_SIDE));
            pass.dispatch_workgroups(groups[0], groups[1], 1);
        }
        drop(pass);
        self.graphics.hand_over(encoder.finish());
    }

    /// A buffer that holds `content`.
    fn buffer(&self, device: &Device, usage: BufferUsages, content: &[u8]) -> wgpu::Buffer {
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("develop"),
            size: content.len() as u64,
            usage: usage | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        self.graphics.queue().write_buffer(&buffer, 0, content);
        buffer
    }
}

/// A texture for X, Y and Z, or for the three counts.
fn exposed_texture(device: &Device, size: [u32; 2]) -> wgpu::Texture {
    texture(device, size, TextureFormat::Rgba32Float, &[])
}

/// A texture for sRGB codes, which a window may want to see as the light that they stand for.
fn developed_texture(device: &Device, size: [u32; 2]) -> wgpu::Texture {
    texture(device, size, TextureFormat::Rgba8Unorm, &[TextureFormat::Rgba8UnormSrgb])
}

/// A texture that shaders write to and then read.
fn texture(
    device: &Device,
    [width, height]: [u32; 2],
    format: TextureFormat,
    view_formats: &[TextureFormat],
) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some("develop"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: TextureUsages::STORAGE_BINDING
            | TextureUsages::TEXTURE_BINDING
            | TextureUsages::COPY_SRC,
        view_formats,
    })
}

/// The only entry point of `modules`.
fn pipeline(device: &Device, label: &str, modules: &[ShaderModule]) -> ComputePipeline {
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(label),
        source: wgpu::ShaderSource::Wgsl(source(modules).into()),
    });
    device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(label),
        layout: None,
        module: &module,
        entry_point: None,
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        cache: None,
    })
}

/// The modules behind the constants that they share with the processor.
pub(super) fn source(modules: &[ShaderModule]) -> String {
    let mut source = print([
        ("WORKGROUP_SIDE", Constant::U32(WORKGROUP_SIDE)),
        ("COLUMNS_PER_GROUP", Constant::U32(region::COLUMNS_PER_GROUP)),
        ("REINHARD", Constant::U32(ToneCurve::Reinhard as u32)),
        ("FILMIC", Constant::U32(ToneCurve::Filmic as u32)),
        ("REINHARD_WHITE", Constant::F32(REINHARD_WHITE)),
        ("COUNTS_LEN", Constant::U32(Counts::LEN as u32)),
        ("SAMPLES", Constant::U32(Counts::SAMPLES as u32)),
        ("SQUARES", Constant::U32(Counts::SQUARES as u32)),
        ("BUCKETS", Constant::U32(BUCKETS as u32)),
        ("BUCKETS_PER_OCTAVE", Constant::F32(BUCKETS_PER_OCTAVE)),
        ("LOG2_LEAST", Constant::F32(LOG2_LEAST)),
        ("ERROR_PER_DEVIATION", Constant::F32(ERROR_PER_DEVIATION)),
        ("KNOTS", Constant::U32(KNOTS as u32)),
    ]);
    append(&mut source, modules);
    source
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shaders::layout::parse;

    /// A module needs only what stands before it.
    #[test]
    fn every_prefix_of_the_shaders_is_valid() {
        for modules in [EXPOSE, REGION, ROOTS, NOISE, DEVELOP, HEAT] {
            for count in 0..=modules.len() {
                parse(&source(&modules[..count]));
            }
        }
    }
}
