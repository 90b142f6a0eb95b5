//! `brilliance [FILE]`: opens the window.

use std::path::Path;
use std::time::{Duration, Instant};

use anyhow::{anyhow, bail};
use brilliance_renderer::tracer::Backend;

use crate::opening::Opening;
use crate::window;

const RENDER_WITHOUT: &str = "`brilliance render SCENE -o OUT.png` renders a picture without one";

/// What is wrong with a file mostly shows within this time, and nobody notices it.
const PATIENCE: Duration = Duration::from_millis(150);

/// Opens the window on `file`, or on the default stone, to be traced by `backend`; the process
/// `started` then.
pub(super) fn view(file: Option<&Path>, backend: Backend, started: Instant) -> anyhow::Result<()> {
    let opening = match file {
        Some(path) => Opening::begin(path, PATIENCE)?,
        None => Opening::default(),
    };
    if display_is_missing() {
        bail!("there is no display to open a window on; {RENDER_WITHOUT}");
    }
    window::open(opening, backend, started).map_err(|error| anyhow!("{error}; {RENDER_WITHOUT}"))
}

/// Whether this is a system whose windows need a display server, and none is named.
fn display_is_missing() -> bool {
    let named = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    cfg!(all(unix, not(target_vendor = "apple")))
        && !["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"].into_iter().any(named)
}
