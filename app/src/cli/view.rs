//! `brilliance [FILE]`: opens the window.

use std::path::PathBuf;

use anyhow::{anyhow, bail};
use brilliance_renderer::scene_file::Document;

use crate::window;

const RENDER_WITHOUT: &str = "`brilliance render SCENE -o OUT.png` renders a picture without one";

/// Opens the window on `file`, or on the default stone.
pub(super) fn view(file: Option<PathBuf>) -> anyhow::Result<()> {
    let document = match &file {
        Some(path) => Document::open(path)?,
        None => Document::default(),
    };
    if display_is_missing() {
        bail!("there is no display to open a window on; {RENDER_WITHOUT}");
    }
    window::open(document, file).map_err(|error| anyhow!("{error}; {RENDER_WITHOUT}"))
}

/// Whether this is a system whose windows need a display server, and none is named.
fn display_is_missing() -> bool {
    let named = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    cfg!(all(unix, not(target_vendor = "apple")))
        && !["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"].into_iter().any(named)
}
