//! What a render did: one line for people, JSON for programs.

use std::io::Write as _;
use std::path::Path;

use anyhow::Context as _;
use brilliance_renderer::scene_file::Document;
use brilliance_renderer::settings::Splitting;
use brilliance_renderer::statistics::Statistics;
use brilliance_renderer::still::Still;
use brilliance_renderer::tracer::{Backend, TracerName};
use brilliance_renderer::whole_file;
use serde::Serialize;

use super::arguments::RenderArguments;

/// What a render did.
#[derive(Debug, Serialize)]
pub(super) struct Report {
    /// Version of the program.
    version: &'static str,
    /// What traced.
    backend: Backend,
    /// The graphics device that traced; none for the processor.
    device: Option<String>,
    /// Threads that traced; none for a graphics device.
    threads: Option<usize>,
    /// The same in words.
    #[serde(skip)]
    tracer: String,
    /// The scene file, as the user named it.
    scene: String,
    /// The picture, as the user named it.
    output: String,
    /// Width and height in pixels.
    size: [u32; 2],
    /// How rays were divided.
    splitting: Splitting,
    /// Spectral bins of the film.
    bins: u32,
    /// Passes traced.
    passes: u32,
    /// The film's noise when it was measured last; none after few passes.
    noise: Option<f32>,
    /// The noise that was aimed at; 0 for none.
    noise_target: f32,
    /// Seconds of tracing alone.
    tracing_seconds: f64,
    /// Ray segments over `tracing_seconds`.
    segments_per_second: f64,
    /// Camera rays, segments and the energy ledger.
    #[serde(flatten)]
    statistics: Statistics,
}

impl Report {
    /// Puts together what is known after the render.
    pub(super) fn new(arguments: &RenderArguments, document: &Document, still: &Still) -> Self {
        let (backend, device, threads) = match &still.tracer {
            TracerName::Cpu { threads } => (Backend::Cpu, None, Some(*threads)),
            TracerName::Gpu { device, .. } => (Backend::Gpu, Some(device.clone()), None),
        };
        Self {
            version: env!("CARGO_PKG_VERSION"),
            backend,
            device,
            threads,
            tracer: still.tracer.to_string(),
            scene: arguments.scene.display().to_string(),
            output: arguments.output.display().to_string(),
            size: document.still.size,
            splitting: document.trace.splitting,
            bins: document.trace.bins,
            passes: still.passes,
            noise: still.noise,
            noise_target: document.still.noise.target,
            tracing_seconds: still.tracing_seconds,
            segments_per_second: still.statistics.segments as f64
                / still.tracing_seconds.max(f64::MIN_POSITIVE),
            statistics: still.statistics,
        }
    }

    /// Writes the report as JSON by way of a temporary file.
    pub(super) fn write(&self, path: &Path) -> anyhow::Result<()> {
        let json = serde_json::to_string_pretty(self)?;
        Ok(whole_file::replace(path, |file| writeln!(file, "{json}"))?)
    }

    /// Says on the standard output what was done.
    pub(super) fn print(&self) -> anyhow::Result<()> {
        writeln!(std::io::stdout(), "{}", self.line()).context("the standard output is closed")
    }

    fn line(&self) -> String {
        let Self { output, size: [width, height], tracer, passes, statistics, .. } = self;
        let ledger = &statistics.ledger;
        let noise = self.noise.map(|noise| format!(" to a noise of {:.2} %", 100.0 * noise));
        let percent = |energy: f64| 100.0 * energy / ledger.entered.max(f64::MIN_POSITIVE);
        format!(
            "{output}: {width}x{height} pixels, {passes} {}{} in {:.2} s on {tracer}; \
             {} camera rays, {} ray segments ({}/s, at most {} for one camera ray); \
             energy: {:.3} % returned, {:.3} % absorbed, {:.3} % pruned, {:.3} % cut off, \
             {:.3} % lost",
            if *passes == 1 { "pass" } else { "passes" },
            noise.unwrap_or_default(),
            self.tracing_seconds,
            with_prefix(statistics.camera_rays as f64),
            with_prefix(statistics.segments as f64),
            with_prefix(self.segments_per_second),
            statistics.max_segments_per_camera_ray,
            percent(ledger.returned),
            percent(ledger.absorbed),
            percent(ledger.pruned),
            percent(ledger.cut_off),
            percent(ledger.lost),
        )
    }
}

/// A count to three digits: 12.3 M.
fn with_prefix(count: f64) -> String {
    let prefixes = [(1e12, " T"), (1e9, " G"), (1e6, " M"), (1e3, " k")];
    let (scale, prefix) =
        prefixes.into_iter().find(|(scale, _)| count >= *scale).unwrap_or((1.0, ""));
    let value = count / scale;
    let decimals = match value {
        _ if prefix.is_empty() || value >= 100.0 => 0,
        10.0.. => 1,
        _ => 2,
    };
    format!("{value:.decimals$}{prefix}")
}

#[cfg(test)]
mod tests {
    use super::with_prefix;

    #[test]
    fn counts_keep_three_digits() {
        assert_eq!(with_prefix(0.0), "0");
        assert_eq!(with_prefix(999.0), "999");
        assert_eq!(with_prefix(1234.0), "1.23 k");
        assert_eq!(with_prefix(65_536_000.0), "65.5 M");
        assert_eq!(with_prefix(123.4e9), "123 G");
    }
}
