//! Meshes of a scene file, read from glTF files beside it.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry::{Occupied, Vacant};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::fault::Fault;
use super::path::relative;
use crate::import::gltf::{self, GltfObject};
use crate::material::{Material, TexelBudget};
use crate::scene::MeshSource;

/// A mesh as written: the glTF file, relative to the scene file, and which of its meshes.
#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MeshEntry {
    file: String,
    #[serde(default)]
    index: usize,
}

/// The glTF files of one scene, each read once.
pub(super) struct MeshFiles<'a> {
    base: &'a Path,
    /// By their canonical paths.
    files: BTreeMap<PathBuf, Vec<GltfObject>>,
}

impl<'a> MeshFiles<'a> {
    /// Paths start from the folder `base`.
    pub(super) fn new(base: &'a Path) -> Self {
        Self { base, files: BTreeMap::new() }
    }

    /// The mesh, and the material that it has in its own file, whose images are taken from the
    /// `budget`.
    pub(super) fn read(
        &mut self,
        entry: &MeshEntry,
        budget: &mut TexelBudget,
    ) -> Result<(MeshSource, Material), Fault> {
        let path = self.base.join(&entry.file);
        let key = path.canonicalize().unwrap_or_else(|_| path.clone());
        let objects = match self.files.entry(key) {
            Occupied(file) => file.into_mut(),
            Vacant(place) => {
                let scene = gltf::load_within(&path, budget)
                    .map_err(|error| Fault::at("file", error.to_string()))?;
                place.insert(scene.objects)
            }
        };
        let Some(object) = objects.get(entry.index) else {
            let (index, count) = (entry.index, objects.len());
            return Err(Fault::at(
                "index",
                format!("found {index}; {} has {count} meshes, counted from 0", path.display()),
            ));
        };
        let mesh = Arc::clone(&object.mesh);
        Ok((MeshSource { path, index: entry.index, mesh }, object.material.clone()))
    }
}

impl MeshEntry {
    pub(super) fn write(source: &MeshSource, base: &Path) -> Self {
        Self { file: relative(&source.path, base), index: source.index }
    }
}
