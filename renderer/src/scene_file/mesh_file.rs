//! Meshes of a scene file, read from glTF files beside it.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry::{Occupied, Vacant};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::fault::Fault;
use crate::import::gltf::{self, GltfObject};
use crate::material::Material;
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
    files: BTreeMap<PathBuf, Vec<GltfObject>>,
}

impl<'a> MeshFiles<'a> {
    /// Paths start from the folder `base`.
    pub(super) fn new(base: &'a Path) -> Self {
        Self { base, files: BTreeMap::new() }
    }

    /// The mesh, and the material that it has in its own file.
    pub(super) fn read(&mut self, entry: &MeshEntry) -> Result<(MeshSource, Material), Fault> {
        let path = self.base.join(&entry.file);
        let objects = match self.files.entry(path.clone()) {
            Occupied(file) => file.into_mut(),
            Vacant(place) => {
                let scene = gltf::load(&path).map_err(|e| Fault::at("file", e.to_string()))?;
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

/// `path` as seen from the folder `base`, with forward slashes; absolute where there is no way.
fn relative(path: &Path, base: &Path) -> String {
    let inner = path.strip_prefix(base).map(Path::to_path_buf);
    let chosen = inner
        .ok()
        .or_else(|| way_up_and_down(path, base))
        .unwrap_or_else(|| std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf()));
    chosen.to_string_lossy().replace(std::path::MAIN_SEPARATOR, "/")
}

/// From `base` up to the folder that both share, and down to `path`.
fn way_up_and_down(path: &Path, base: &Path) -> Option<PathBuf> {
    let (path, base) = (std::path::absolute(path).ok()?, std::path::absolute(base).ok()?);
    let shared = path.components().zip(base.components()).take_while(|(a, b)| a == b).count();
    let up: Vec<Component> = base.components().skip(shared).collect();
    // A step up in `base` would need the file system to be undone; without a shared root there is
    // no way at all.
    if shared == 0 || up.contains(&Component::ParentDir) {
        return None;
    }
    let up = up.iter().map(|_| Component::ParentDir);
    Some(up.chain(path.components().skip(shared)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_written_from_the_scene_file() {
        for (path, base, wanted) in [
            ("/gems/stone.glb", "/gems", "stone.glb"),
            ("/gems/a/stone.glb", "/gems", "a/stone.glb"),
            ("/gems/stone.glb", "/gems/scenes", "../stone.glb"),
            ("/gems/stone.glb", "/other/scenes", "../../gems/stone.glb"),
            ("scenes/stone.glb", "scenes", "stone.glb"),
            ("stone.glb", "scenes", "../stone.glb"),
            ("stone.glb", "", "stone.glb"),
        ] {
            assert_eq!(relative(Path::new(path), Path::new(base)), wanted, "{path} from {base}");
        }
    }
}
