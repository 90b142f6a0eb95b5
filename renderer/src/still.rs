//! Pictures to keep: traced to a pass or time limit, with progress and cancel.

use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use crate::error::RendererError;
use crate::session::RenderRequest;
use crate::settings::DisplaySettings;
use crate::statistics::Statistics;

/// How a still is ended early.
#[derive(Clone, Copy, Debug, Default)]
pub struct StillLimits {
    /// Stop after this much tracing, at the end of the pass in progress (at least one pass).
    pub time: Option<Duration>,
    /// Threads to trace with; 0 is all of them.
    pub threads: usize,
}

/// File formats a still is written in, chosen by the file name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StillFormat {
    /// PNG, 8 bits per channel, sRGB, developed.
    Png8,
    /// PNG, 16 bits per channel, sRGB, developed.
    Png16,
    /// OpenEXR, 32-bit float, linear Rec. 709 RGB, undeveloped; with one channel per spectral bin on request.
    Exr {
        /// Adds the film's bins as channels.
        spectral: bool,
    },
}

/// A finished still.
pub struct Still {
    /// Counts of all passes.
    pub statistics: Statistics,
    /// Passes traced.
    pub passes: u32,
    /// Seconds of tracing alone.
    pub tracing_seconds: f64,
}

impl Still {
    /// Traces `request`. `progress` is told after each pass how many are done, of
    /// `request.pass_limit`; set `cancel` to end with [`RendererError::Cancelled`] within a tile.
    ///
    /// # Errors
    /// An impossible scene, or a cancelled job.
    pub fn render(
        _request: &RenderRequest,
        _limits: StillLimits,
        _cancel: &AtomicBool,
        _progress: impl FnMut(u32, &Statistics),
    ) -> Result<Self, RendererError> {
        Err(RendererError::Cancelled)
    }

    /// Writes the picture to `path` by way of a temporary file, with `scene_toml` in its metadata.
    ///
    /// # Errors
    /// The file can't be written.
    pub fn write(
        &self,
        _path: &Path,
        _format: StillFormat,
        _display: &DisplaySettings,
        _scene_toml: &str,
    ) -> Result<(), RendererError> {
        Ok(())
    }
}
