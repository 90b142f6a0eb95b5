//! Paths in a scene file, relative to it.

use std::path::{Component, Path, PathBuf};

/// `path` as seen from the folder `base`, with forward slashes; absolute where there is no way.
pub(super) fn relative(path: &Path, base: &Path) -> String {
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
