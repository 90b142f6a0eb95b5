//! From sliders to pixels: the newest request wins, the UI never waits.

use std::sync::Arc;

use crate::camera::Camera;
use crate::scene::Scene;
use crate::settings::{DisplaySettings, TraceSettings};
use crate::statistics::Statistics;

/// Everything that decides the film. Equal requests need no work; a different one restarts.
#[derive(Clone, Debug, PartialEq)]
pub struct RenderRequest {
    /// What is seen.
    pub scene: Arc<Scene>,
    /// Where it is seen from (the scene's own camera is not used).
    pub camera: Camera,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// How it is traced.
    pub trace: TraceSettings,
    /// Passes after which the picture is done.
    pub pass_limit: u32,
}

/// A developed image, ready for the screen.
#[derive(Debug)]
pub struct Picture {
    /// Width and height in pixels; smaller than requested while previewing.
    pub size: [u32; 2],
    /// sRGB-encoded RGBA, row by row from the top.
    pub rgba8: Vec<u8>,
    /// Counts up with every picture published.
    pub serial: u64,
}

/// What the session is doing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Activity {
    /// No request yet.
    #[default]
    Idle,
    /// Reduced resolution while things change.
    Preview,
    /// Passes accumulate at full resolution.
    Accumulating,
    /// The pass limit is reached.
    Done,
    /// The request could not be traced; see [`Progress::error`].
    Failed,
}

/// Where the current request stands.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Progress {
    /// What the session is doing.
    pub activity: Activity,
    /// Passes in the film that is shown.
    pub passes: u32,
    /// Passes asked for.
    pub pass_limit: u32,
    /// Size of the film that is shown.
    pub size: [u32; 2],
    /// Counts of the film that is shown.
    pub statistics: Statistics,
    /// Seconds of tracing in the film that is shown.
    pub tracing_seconds: f64,
    /// Why the request failed.
    pub error: Option<String>,
}

/// A render thread that serves the newest request, and a develop thread that shows it.
pub struct Session {}

impl Session {
    /// Starts the threads. `on_update` is called from them whenever a new picture or new progress
    /// can be read.
    pub fn new(_on_update: impl Fn() + Send + Sync + 'static) -> Self {
        Self {}
    }

    /// Asks for a picture. Equal to the last request: nothing happens. Returns at once.
    pub fn request(&mut self, _request: RenderRequest) {}

    /// Develops the film with these settings from now on, without retracing. Returns at once.
    pub fn display(&mut self, _settings: DisplaySettings) {}

    /// Number of different requests made so far.
    pub fn requests_made(&self) -> u64 {
        0
    }

    /// The newest picture.
    pub fn picture(&self) -> Option<Arc<Picture>> {
        None
    }

    /// Where the newest request stands.
    pub fn progress(&self) -> Progress {
        Progress::default()
    }
}
