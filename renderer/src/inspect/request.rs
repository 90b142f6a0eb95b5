//! What tree is asked for.

use std::sync::Arc;

use crate::camera::Camera;
use crate::error::RendererError;
use crate::scene::Scene;
use crate::settings::TraceSettings;

/// Everything that decides the tree of rays of one pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct RayTreeRequest {
    /// What is seen.
    pub scene: Arc<Scene>,
    /// Where it is seen from (the scene's own camera is not used).
    pub camera: Camera,
    /// Width and height of the picture in pixels.
    pub size: [u32; 2],
    /// Column and row of the pixel, both counted from 0 at the upper left corner.
    pub pixel: [u32; 2],
    /// The pass whose camera ray it is, counted from 0; pass 0 goes through the pixel's middle.
    pub pass_index: u32,
    /// How it is traced.
    pub trace: TraceSettings,
}

impl RayTreeRequest {
    /// Whether the pixel lies in the picture.
    ///
    /// # Errors
    /// It does not; the text says which pixels there are.
    pub fn check(&self) -> Result<(), RendererError> {
        let ([x, y], [width, height]) = (self.pixel, self.size);
        if x < width && y < height {
            return Ok(());
        }
        Err(RendererError::Invalid(format!(
            "pixel {x},{y} is outside of the picture, which has {width}x{height} pixels: columns 0 \
             to {} and rows 0 to {}",
            width.saturating_sub(1),
            height.saturating_sub(1),
        )))
    }
}
