//! The whole scene file: tables at the top, and the way from text to document and back.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::Document;
use super::fault::{Fault, Under};
use super::light::LightsEntry;
use super::mesh_file::MeshFiles;
use super::object::ObjectEntry;
use super::print::ImageFiles;
use super::settings::{DisplayEntry, StillEntry, TraceEntry};
use super::tree::{Node, Place, line_and_column};
use super::view::{CameraEntry, GroundEntry};
use crate::camera::Camera;
use crate::scene::Scene;

/// The version of the format that is written, and the only one that is read.
const FORMAT: u32 = 1;

#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct DocumentEntry {
    format: u32,
    #[serde(default)]
    still: StillEntry,
    #[serde(default)]
    trace: TraceEntry,
    #[serde(default)]
    display: DisplayEntry,
    camera: Option<CameraEntry>,
    lights: Option<LightsEntry>,
    ground: Option<GroundEntry>,
    #[serde(default)]
    objects: Vec<ObjectEntry>,
}

/// Reads a scene file with its overrides (`key.path=value`); `base` is the folder that its paths
/// start from. An error is a text that names the place and the remedy.
pub(super) fn read(text: &str, base: &Path, overrides: &[String]) -> Result<Document, String> {
    let in_words = |place: Option<Place>, fault: &Fault| match place {
        None => fault.to_string(),
        Some(Place::Text(offset)) => {
            let (line, column) = line_and_column(text, offset);
            format!("line {line}, column {column}: {fault}")
        }
        Some(Place::Override(index)) => format!("override `{}`: {fault}", overrides[index]),
    };
    let mut tree = Node::parse(text).map_err(|(place, fault)| in_words(place, &fault))?;
    for (index, override_text) in overrides.iter().enumerate() {
        tree.apply_override(index, override_text)
            .map_err(|fault| in_words(Some(Place::Override(index)), &fault))?;
    }
    DocumentEntry::deserialize(&tree)
        .and_then(|entry| entry.read(base))
        .map_err(|fault| in_words(Some(tree.place(&fault.path())), &fault))
}

/// The document as TOML, paths relative to `base`.
pub(super) fn write(document: &Document, base: &Path) -> String {
    // Entries hold nothing but tables with text keys and numbers that TOML has.
    toml::to_string(&DocumentEntry::write(document, base))
        .unwrap_or_else(|error| unreachable!("an entry that TOML cannot say: {error}"))
}

impl DocumentEntry {
    fn read(self, base: &Path) -> Result<Document, Fault> {
        if self.format != FORMAT {
            let message = format!("found {}; this program reads format {FORMAT}", self.format);
            return Err(Fault::at("format", message));
        }
        let (mut meshes, mut images) = (MeshFiles::new(base), ImageFiles::new(base));
        let objects = self
            .objects
            .into_iter()
            .enumerate()
            .map(|(index, object)| object.read(index, &mut meshes, &mut images).under(index))
            .collect::<Result<_, _>>()
            .under("objects")?;
        let start = Document::default();
        Ok(Document {
            scene: Scene {
                objects,
                ground: self.ground.map(GroundEntry::read).transpose().under("ground")?,
                lights: self
                    .lights
                    .map_or(Ok(start.scene.lights), LightsEntry::read)
                    .under("lights")?,
                camera: self
                    .camera
                    .map_or(Ok(Camera::default()), CameraEntry::read)
                    .under("camera")?,
            },
            trace: self.trace.read().under("trace")?,
            display: self.display.read().under("display")?,
            still: self.still.read().under("still")?,
        })
    }

    fn write(document: &Document, base: &Path) -> Self {
        let Document { scene, trace, display, still } = document;
        let Scene { objects, ground, lights, camera } = scene;
        Self {
            format: FORMAT,
            still: StillEntry::write(still),
            trace: TraceEntry::write(trace),
            display: DisplayEntry::write(display),
            camera: Some(CameraEntry::write(camera)),
            lights: Some(LightsEntry::write(lights)),
            ground: ground.as_ref().map(GroundEntry::write),
            objects: objects.iter().map(|object| ObjectEntry::write(object, base)).collect(),
        }
    }
}
