//! What can be asked of the program, and which askings make no sense.

use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::time::Duration;

use brilliance_renderer::scene_file::StillSettings;
use brilliance_renderer::settings::{NoiseGoal, TraceSettings};
use brilliance_renderer::still::StillFormat;
use brilliance_renderer::tracer::Backend;
use clap::builder::{RangedI64ValueParser, RangedU64ValueParser};
use clap::error::ErrorKind;
use clap::{Args, CommandFactory as _, Parser, Subcommand, value_parser};

use super::assignment::Assignment;
use super::backend::BackendChoice;
use super::draw::DrawArguments;
use super::image_size::ImageSize;
use super::inspect::InspectArguments;
use super::picture_format::{BitDepth, picture_format};
use super::shown::ShownChoice;
use super::spectrum::SpectrumArguments;

/// Most threads worth asking for.
const MAX_THREADS: u64 = 1024;

/// See gemstones as light makes them.
#[derive(Debug, Parser)]
#[command(version, about, args_conflicts_with_subcommands = true)]
pub(super) struct Arguments {
    /// Scene (.toml), mesh (.gltf, .glb) or still (.png, .exr) to show; a diamond without one
    pub(super) file: Option<PathBuf>,
    /// What traces; the window's menu can change it
    #[arg(long, value_enum, default_value_t)]
    pub(super) backend: BackendChoice,
    /// What to do instead of opening the window
    #[command(subcommand)]
    pub(super) command: Option<Command>,
}

/// What the program does without a window.
#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Render a picture to a file; needs no display
    Render(RenderArguments),
    /// Draw a stone in lines, from above, the side and below, its facets with name and angle
    Draw(DrawArguments),
    /// Print the tree of rays that one pixel of the picture is made of
    Inspect(InspectArguments),
    /// Print the spectrum of a pixel or of a region; needs no display
    Spectrum(SpectrumArguments),
}

/// A picture to render.
#[derive(Args, Debug)]
pub(super) struct RenderArguments {
    /// Scene (.toml), mesh (.gltf, .glb) or a still made before (.png, .exr)
    pub(super) scene: PathBuf,

    /// Picture to write: .png (developed, sRGB) or .exr (linear Rec. 709 radiance)
    #[arg(short, long, value_name = "OUT")]
    pub(super) output: PathBuf,

    /// Width and height in pixels [default: the scene's]
    #[arg(long, value_name = "WxH")]
    pub(super) size: Option<ImageSize>,

    /// Passes, each of one camera ray per pixel [default: the scene's]
    #[arg(long, value_name = "N", value_parser = within(StillSettings::PASSES))]
    pub(super) passes: Option<u32>,

    /// Stop when the noise is no more than this part of the light, such as 0.01 for 1 %, even if
    /// passes remain; 0 never does [default: the scene's]
    #[arg(long, value_name = "X", value_parser = parse_noise)]
    pub(super) noise: Option<f32>,

    /// Stop after this many seconds of tracing, even if passes remain (one is always traced)
    #[arg(long, value_name = "S", value_parser = parse_seconds)]
    pub(super) time: Option<Duration>,

    /// What traces
    #[arg(long, value_enum, default_value_t)]
    pub(super) backend: BackendChoice,

    /// Threads to trace with, on the processor [default: one per core]
    #[arg(long, value_name = "N",
        value_parser = RangedU64ValueParser::<usize>::new().range(1..=MAX_THREADS))]
    pub(super) threads: Option<usize>,

    /// Spectral bins of the film [default: the scene's]
    #[arg(long, value_name = "N", value_parser = within(TraceSettings::BINS))]
    pub(super) bins: Option<u32>,

    /// Change a value of the scene, named by its path in the scene file; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(super) assignments: Vec<Assignment>,

    /// What a PNG shows; heat maps have fixed logarithmic scales, and black where there is nothing
    #[arg(long, value_enum, default_value_t)]
    pub(super) show: ShownChoice,

    /// Bits per channel of a PNG [default: 8]
    #[arg(long, value_enum)]
    pub(super) bits: Option<BitDepth>,

    /// Add the film's spectral bins to an OpenEXR picture as channels
    #[arg(long)]
    pub(super) spectral: bool,

    /// Write what the tracing did as JSON
    #[arg(long, value_name = "FILE")]
    pub(super) stats: Option<PathBuf>,
}

impl Arguments {
    /// The arguments of the process. Where they are wrong, says how and exits with code 2.
    pub(super) fn parse_checked() -> Self {
        let arguments = Self::parse();
        let (name, checked) = match &arguments.command {
            Some(Command::Render(render)) => ("render", render.check()),
            Some(Command::Draw(draw)) => ("draw", draw.check()),
            Some(Command::Inspect(_) | Command::Spectrum(_)) | None => return arguments,
        };
        if let Err(fault) = checked {
            let mut command = Self::command();
            command.build();
            let command = command.find_subcommand_mut(name).cloned().unwrap_or(command);
            command.clone().error(ErrorKind::ArgumentConflict, fault).exit();
        }
        arguments
    }
}

impl RenderArguments {
    /// How the picture is written.
    ///
    /// # Errors
    /// The file name's extension says no known format, or an option does not go with it.
    pub(super) fn format(&self) -> Result<StillFormat, String> {
        picture_format(&self.output, self.bits, self.spectral)
    }

    /// What traces. Who says with how many threads wants the processor.
    pub(super) fn backend(&self) -> Backend {
        if self.threads.is_some() { Backend::Cpu } else { self.backend.into() }
    }

    /// What clap can't see: options that contradict each other.
    fn check(&self) -> Result<(), String> {
        if matches!(self.format()?, StillFormat::Exr { .. }) && self.show != ShownChoice::Color {
            return Err("an OpenEXR picture holds light; name a .png for a heat map".into());
        }
        self.check_files()?;
        self.check_assignments()?;
        if self.threads.is_some() && self.backend == BackendChoice::Gpu {
            return Err("--threads is for the processor; give --backend cpu with it".into());
        }
        Ok(())
    }

    fn check_files(&self) -> Result<(), String> {
        if same_file(&self.output, &self.scene) {
            return Err(format!(
                "-o {} would overwrite the scene; give the picture another name",
                self.output.display()
            ));
        }
        let Some(stats) = &self.stats else { return Ok(()) };
        for (path, what) in [(&self.output, "the picture"), (&self.scene, "the scene")] {
            if same_file(stats, path) {
                return Err(format!(
                    "--stats {} would overwrite {what}; give the statistics another name",
                    stats.display()
                ));
            }
        }
        Ok(())
    }

    fn check_assignments(&self) -> Result<(), String> {
        let options = [
            ("--size", self.size.is_some(), "still.size"),
            ("--passes", self.passes.is_some(), "still.passes"),
            ("--noise", self.noise.is_some(), "still.noise_target"),
            ("--bins", self.bins.is_some(), "trace.bins"),
        ];
        for (option, given, key) in options {
            if given && self.assignments.iter().any(|assignment| assignment.key() == key) {
                return Err(format!("{option} and --set {key}=… say the same; give one of them"));
            }
        }
        Ok(())
    }
}

/// A whole number in `allowed`.
pub(super) fn within(allowed: RangeInclusive<u32>) -> RangedI64ValueParser<u32> {
    value_parser!(u32).range(i64::from(*allowed.start())..=i64::from(*allowed.end()))
}

/// A noise that can be aimed at.
fn parse_noise(text: &str) -> Result<f32, String> {
    let allowed = NoiseGoal::TARGET;
    text.parse().ok().filter(|noise| allowed.contains(noise)).ok_or_else(|| {
        format!("give a part of the light from {} to {}", allowed.start(), allowed.end())
    })
}

/// A positive number of seconds.
fn parse_seconds(text: &str) -> Result<Duration, String> {
    text.parse()
        .ok()
        .filter(|seconds: &f64| *seconds > 0.0)
        .and_then(|seconds| Duration::try_from_secs_f64(seconds).ok())
        .ok_or_else(|| "give a positive number of seconds, such as 60 or 0.5".to_owned())
}

/// Whether two paths name one file, by way of links and dots where the files exist.
pub(super) fn same_file(a: &Path, b: &Path) -> bool {
    a == b || a.canonicalize().is_ok_and(|a| b.canonicalize().is_ok_and(|b| a == b))
}
