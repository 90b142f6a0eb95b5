//! What a session tells of its work.

use crate::develop::{Pixels, Shown};
use crate::statistics::Statistics;
use crate::tracer::TracerName;

/// A developed image, ready for the screen.
#[derive(Debug)]
pub struct Picture {
    /// Width and height in pixels; smaller than requested while previewing.
    pub size: [u32; 2],
    /// Its pixels.
    pub pixels: Pixels,
    /// What they show.
    pub shown: Shown,
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
    /// All passes are done, or the noise is no more than is wanted.
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
    /// The film's [noise](crate::film::Film::measure_noise) when it was measured last; none after
    /// few passes.
    pub noise: Option<f32>,
    /// The noise at which the picture is done; 0 where only the passes decide.
    pub noise_target: f32,
    /// Size of the film that is shown.
    pub size: [u32; 2],
    /// Counts of the film that is shown.
    pub statistics: Statistics,
    /// Seconds of tracing in the film that is shown.
    pub tracing_seconds: f64,
    /// Why the request failed.
    pub error: Option<String>,
    /// What traced the film that is shown; none before the first.
    pub tracer: Option<TracerName>,
}

impl Progress {
    /// Whether the noise is no more than is wanted.
    pub fn has_reached_noise_target(&self) -> bool {
        self.noise_target > 0.0 && self.noise.is_some_and(|noise| noise <= self.noise_target)
    }
}
