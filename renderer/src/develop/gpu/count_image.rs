//! Mean counts in the memory of a graphics device.

use wgpu::{BindingResource, BufferUsages, TextureViewDescriptor};

use super::super::CountImage;
use super::super::heat::{HeatMap, HeatScale};
use super::{GpuDeveloper, developed_texture};
use crate::error::RendererError;
use crate::film::Counts;

/// Mean counts per pixel in the memory of a graphics device. Cloning shares it.
#[derive(Clone, Debug)]
pub struct GpuCountImage {
    developer: GpuDeveloper,
    /// The rays, the depth, the pruned light and 1, as `Rgba32Float`.
    texture: wgpu::Texture,
}

impl GpuCountImage {
    pub(super) fn new(developer: GpuDeveloper, texture: wgpu::Texture) -> Self {
        Self { developer, texture }
    }

    /// A heat map: sRGB-encoded, as an `Rgba8Unorm` texture that can also be viewed as
    /// `Rgba8UnormSrgb` and copied from.
    ///
    /// # Errors
    /// The device fails.
    pub fn develop(&self, map: HeatMap) -> Result<wgpu::Texture, RendererError> {
        let Self { developer, texture: counted } = self;
        let size = [counted.width(), counted.height()];
        developer.graphics.guard("develop the heat map", |device| {
            let developed = developed_texture(device, size);
            let [counted, written] = [counted, &developed]
                .map(|texture| texture.create_view(&TextureViewDescriptor::default()));
            let scale = HeatScale::new(map);
            let scale = developer.buffer(device, BufferUsages::UNIFORM, bytemuck::bytes_of(&scale));
            let resources = vec![
                scale.as_entire_binding(),
                BindingResource::TextureView(&counted),
                BindingResource::TextureView(&written),
            ];
            developer.submit(device, &developer.pipelines.heat, [(size, resources)]);
            developed
        })
    }

    /// The counts in the processor's memory.
    ///
    /// # Errors
    /// The device fails.
    pub fn read(&self) -> Result<CountImage, RendererError> {
        let texels = self.developer.graphics.read_texture(&self.texture)?;
        let texels = texels.chunks_exact(size_of::<[f32; 4]>());
        let means = texels.map(|texel| {
            let [rays, depth, pruned, _]: [f32; 4] = bytemuck::pod_read_unaligned(texel);
            Counts { rays, depth, pruned, ..Counts::default() }
        });
        Ok(CountImage {
            size: [self.texture.width(), self.texture.height()],
            means: means.collect(),
        })
    }
}
