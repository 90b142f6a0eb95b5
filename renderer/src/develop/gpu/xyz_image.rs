//! CIE XYZ in the memory of a graphics device.

use wgpu::{BindingResource, BufferUsages, TextureViewDescriptor};

use super::super::XyzImage;
use super::super::development::Development;
use super::{GpuDeveloper, developed_texture};
use crate::error::RendererError;
use crate::settings::DisplaySettings;
use crate::spectrum::Bins;

/// CIE XYZ per pixel in the memory of a graphics device. Cloning shares it.
#[derive(Clone, Debug)]
pub struct GpuXyzImage {
    developer: GpuDeveloper,
    /// X, Y, Z and 1, as `Rgba32Float`.
    texture: wgpu::Texture,
    /// The film's division of the spectrum, which white lights are seen through too.
    bins: Bins,
}

impl GpuXyzImage {
    pub(super) fn new(developer: GpuDeveloper, texture: wgpu::Texture, bins: Bins) -> Self {
        Self { developer, texture, bins }
    }

    /// Width and height in pixels.
    pub fn size(&self) -> [u32; 2] {
        [self.texture.width(), self.texture.height()]
    }

    /// The image as a display shows it: sRGB-encoded, as an `Rgba8Unorm` texture that can also be
    /// viewed as `Rgba8UnormSrgb` and copied from.
    ///
    /// # Errors
    /// The device fails.
    pub fn develop(&self, settings: &DisplaySettings) -> Result<wgpu::Texture, RendererError> {
        let development = Development::new(settings, self.bins);
        let Self { developer, texture: exposed, .. } = self;
        developer.graphics.guard("develop the picture", |device| {
            let developed = developed_texture(device, self.size());
            let [exposed, written] = [exposed, &developed]
                .map(|texture| texture.create_view(&TextureViewDescriptor::default()));
            let development =
                developer.buffer(device, BufferUsages::UNIFORM, bytemuck::bytes_of(&development));
            let resources = vec![
                development.as_entire_binding(),
                BindingResource::TextureView(&exposed),
                BindingResource::TextureView(&written),
            ];
            developer.submit(device, &developer.pipelines.develop, [(self.size(), resources)]);
            developed
        })
    }

    /// The image in the processor's memory.
    ///
    /// # Errors
    /// The device fails.
    pub fn read(&self) -> Result<XyzImage, RendererError> {
        let texels = self.developer.graphics.read_texture(&self.texture)?;
        let texels = texels.chunks_exact(size_of::<[f32; 4]>());
        let xyz = texels.map(|texel| {
            let [x, y, z, _]: [f32; 4] = bytemuck::pod_read_unaligned(texel);
            [x, y, z]
        });
        Ok(XyzImage { size: self.size(), bins: self.bins, xyz: xyz.collect() })
    }
}
