//! Developing on a graphics device.

use crate::error::RendererError;
use crate::settings::DisplaySettings;

/// CIE XYZ per pixel in the memory of a graphics device. Cloning shares it.
#[derive(Clone, Debug)]
pub struct GpuXyzImage {
    size: [u32; 2],
}

impl GpuXyzImage {
    /// Width and height in pixels.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// The image as a display shows it.
    pub(super) fn develop(
        &self,
        _settings: &DisplaySettings,
    ) -> Result<wgpu::Texture, RendererError> {
        Err(RendererError::Graphics("not built yet".to_owned()))
    }
}
