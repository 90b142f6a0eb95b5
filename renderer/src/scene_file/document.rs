//! The document: what a scene file says.

use std::ffi::OsStr;
use std::io::{Read, Write};
use std::ops::RangeInclusive;
use std::path::Path;

use super::{format, gltf_scene};
use crate::camera::Camera;
use crate::cuts::RoundBrilliant;
use crate::error::RendererError;
use crate::image_file::{self, SCENE_KEYWORD};
use crate::material::{Dielectric, Dispersion, Material};
use crate::rigs;
use crate::scene::{Object, Scene, Shape, Transform};
use crate::settings::{DisplaySettings, NoiseGoal, TraceSettings};
use crate::whole_file;

/// Longest scene file that is read, in bytes.
const MAX_BYTES: u64 = 16 << 20;

/// Everything that makes a picture again: scene, tracing, display and the default still.
#[derive(Clone, Debug, PartialEq)]
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StillSettings {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Most passes.
    pub passes: u32,
    /// When it is good enough before that.
    pub noise: NoiseGoal,
}

impl StillSettings {
    /// Allowed width and height.
    pub const SIDE: RangeInclusive<u32> = 1..=16384;
    /// Most pixels.
    pub const MAX_PIXELS: u64 = 1 << 26;
    /// Allowed [`passes`](Self::passes).
    pub const PASSES: RangeInclusive<u32> = 1..=1_000_000;
}

impl Default for StillSettings {
    fn default() -> Self {
        Self { size: [1280, 800], passes: 64, noise: NoiseGoal::default() }
    }
}

impl Default for Document {
    /// What the program starts with: a round brilliant diamond in the showroom, with the paper's
    /// straight line for its index.
    fn default() -> Self {
        let diamond = Object {
            name: "Round brilliant".to_owned(),
            shape: Shape::RoundBrilliant(RoundBrilliant::default()),
            transform: Transform::default(),
            material: Material::Dielectric(Dielectric {
                name: "Diamond".to_owned(),
                dispersion: Dispersion::Linear { n_d: 2.417, dispersion_bg: 0.044 },
                absorption_per_mm: None,
            }),
            throws_light: false,
        };
        Self {
            scene: Scene {
                objects: vec![diamond],
                ground: None,
                lights: rigs::start(),
                camera: Camera::default(),
            },
            trace: TraceSettings::default(),
            display: DisplaySettings::default(),
            still: StillSettings::default(),
        }
    }
}

impl Document {
    /// Reads a scene file (`.toml`), the scene of a still (`.png`, `.exr`), or a mesh (`.gltf`,
    /// `.glb`), which is placed in the default lights where it has none.
    ///
    /// # Errors
    /// Names the file, the place, the key and the remedy.
    pub fn open(path: &Path) -> Result<Self, RendererError> {
        Self::open_with(path, &[])
    }

    /// Reads a file as [`open`](Self::open) does, with values that replace those of the file: each
    /// override is `key.path=value`, such as `trace.split_count=3` or
    /// `objects.0.material.n_d=1.9`.
    ///
    /// # Errors
    /// Names the file, the place or the override, the key and the remedy.
    pub fn open_with(path: &Path, overrides: &[String]) -> Result<Self, RendererError> {
        let fault = |message: String| RendererError::File { path: path.to_owned(), message };
        let base = path.parent().unwrap_or(Path::new(""));
        let extension = path.extension().map(OsStr::to_ascii_lowercase);
        match extension.as_ref().and_then(|extension| extension.to_str()) {
            Some("toml") => format::read(&text_of(path)?, base, overrides).map_err(fault),
            Some("gltf" | "glb") => {
                let document = gltf_scene::document(path)?;
                if overrides.is_empty() {
                    return Ok(document);
                }
                let text = document.to_toml(base);
                format::read(&text, base, overrides).map_err(fault)
            }
            Some("png" | "exr") => format::read(&text_in_still(path)?, base, overrides).map_err(fault),
            _ => Err(fault(
                "unknown kind of file; a scene is .toml, a mesh .gltf or .glb, a still .png or .exr"
                    .into(),
            )),
        }
    }

    /// Reads the text of a scene file; its paths start from the folder `base`.
    ///
    /// # Errors
    /// Names the place, the key and the remedy.
    pub fn from_toml(text: &str, base: &Path) -> Result<Self, RendererError> {
        format::read(text, base, &[]).map_err(RendererError::Invalid)
    }

    /// The document as TOML; paths are written relative to `base`, the folder of the file to be.
    pub fn to_toml(&self, base: &Path) -> String {
        format::write(self, base)
    }

    /// Writes the scene file by way of a temporary file in the same folder.
    ///
    /// # Errors
    /// The file can't be written.
    pub fn save(&self, path: &Path) -> Result<(), RendererError> {
        let text = self.to_toml(path.parent().unwrap_or(Path::new("")));
        whole_file::replace(path, |file| file.write_all(text.as_bytes()))
    }
}

/// The scene file that a still made by this program carries.
fn text_in_still(path: &Path) -> Result<String, RendererError> {
    image_file::read_metadata(path)?.remove(SCENE_KEYWORD).ok_or_else(|| RendererError::File {
        path: path.to_owned(),
        message: "the picture carries no scene; only stills made by Brilliance can be opened"
            .into(),
    })
}

fn text_of(path: &Path) -> Result<String, RendererError> {
    let io = |source| RendererError::Io { path: path.to_owned(), source };
    let fault = |message: String| RendererError::File { path: path.to_owned(), message };
    let mut bytes = Vec::new();
    let file = std::fs::File::open(path).map_err(io)?;
    file.take(MAX_BYTES + 1).read_to_end(&mut bytes).map_err(io)?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(fault(format!("a scene file has at most {MAX_BYTES} bytes")));
    }
    String::from_utf8(bytes).map_err(|error| {
        let offset = error.utf8_error().valid_up_to();
        fault(format!("byte {offset} is not UTF-8 text; save the scene file as UTF-8"))
    })
}
