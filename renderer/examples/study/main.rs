//! How many sub-rays, and how weak a ray, a picture needs: the tables and plots of `docs/study.md`.
//!
//! `cargo run --release --workspace --example study` traces them anew and writes the pictures into
//! `docs/study`, or into the folder that is named on the command line.
#![expect(clippy::print_stdout, reason = "the tables are for the page")]

mod error;
#[path = "../shared/plot.rs"]
mod plot;
#[path = "../shared/rmse.rs"]
mod rmse;
mod scene;
#[path = "../shared/strip.rs"]
mod strip;

use std::error::Error;
use std::path::{Path, PathBuf};

use brilliance_renderer::develop::XyzImage;
use brilliance_renderer::settings::{Splitting, TraceSettings};

use error::PictureError;
use plot::{Axes, Series};
use scene::StudyScene;

/// Split counts whose pictures are held against the converged one.
const SPLIT_COUNTS: [f32; 6] = [1.0, 2.0, 3.0, 6.0, 12.0, 24.0];
/// Of the converged picture: beyond what the program lets one choose.
const FINE_SPLIT_COUNT: f32 = 48.0;
/// Significance thresholds whose pictures are held against the converged one.
const THRESHOLDS: [f32; 5] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5];
const FINE_THRESHOLD: f32 = 1e-6;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os().nth(1).map_or_else(default_folder, PathBuf::from);
    std::fs::create_dir_all(&folder)?;
    let scenes = scene::all()?;
    let splitting = sweep(&scenes, &folder, "split-count", &split_settings())?;
    plot::write(&folder.join("split-count.svg"), &axes("split count K"), &splitting)?;
    let pruning = sweep(&scenes, &folder, "threshold", &threshold_settings())?;
    plot::write(&folder.join("threshold.svg"), &axes("significance threshold"), &pruning)?;
    Ok(())
}

/// Mean colour differences over a setting, with the least that is about to be seen.
fn axes(setting: &str) -> Axes<'_> {
    Axes {
        x: setting,
        y: "mean ΔE₀₀ from the converged picture",
        least_error: 1e-3,
        mark: Some((1.0, "")),
    }
}

fn default_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/study")
}

/// What one picture is traced by, and the value that stands for it in table and plot.
struct Candidate {
    value: f32,
    settings: TraceSettings,
}

/// The candidates of one setting, and the settings of the converged picture.
struct Sweep {
    candidates: Vec<Candidate>,
    converged: TraceSettings,
}

fn split_settings() -> Sweep {
    let settings = |split_count| TraceSettings {
        split_count,
        max_depth: *TraceSettings::MAX_DEPTH.end(),
        splitting: Splitting::Paper,
        ..TraceSettings::default()
    };
    Sweep {
        candidates: SPLIT_COUNTS.map(|value| Candidate { value, settings: settings(value) }).into(),
        converged: settings(FINE_SPLIT_COUNT),
    }
}

fn threshold_settings() -> Sweep {
    let settings = |significance_threshold| TraceSettings {
        significance_threshold,
        max_depth: *TraceSettings::MAX_DEPTH.end(),
        splitting: Splitting::Paper,
        ..TraceSettings::default()
    };
    Sweep {
        candidates: THRESHOLDS.map(|value| Candidate { value, settings: settings(value) }).into(),
        converged: settings(FINE_THRESHOLD),
    }
}

/// Traces every candidate on every scene with the same camera rays as the converged picture, so
/// that they differ by the setting alone; prints a table and writes a strip of pictures for each.
fn sweep(
    scenes: &[StudyScene],
    folder: &Path,
    name: &str,
    sweep: &Sweep,
) -> Result<Vec<Series>, Box<dyn Error>> {
    let mut series = Vec::new();
    for scene in scenes {
        let converged = scene.trace(&sweep.converged)?;
        println!("\n{}, {name}\n", scene.name);
        println!(
            "| {name} | rays per pixel | RMSE | mean ΔE₀₀ | 99 % ΔE₀₀ | blocks' ΔE₀₀ | light | pruned |"
        );
        println!("|---|---|---|---|---|---|---|---|");
        let mut pictures = Vec::new();
        let mut points = Vec::new();
        for Candidate { value, settings } in &sweep.candidates {
            let still = scene.trace(settings)?;
            let error =
                PictureError::between(&still.film, &converged.film, &scene.document.display);
            println!(
                "| {value} | {:.1} | {:.4} | {:.3} | {:.2} | {:.3} | {:.4} | {:.2} % |",
                still.statistics.mean_segments_per_camera_ray(),
                error.relative_rmse,
                error.mean_delta_e,
                error.high_delta_e,
                error.block_delta_e,
                error.luminance_ratio,
                100.0 * still.statistics.ledger.pruned / still.statistics.ledger.entered,
            );
            points.push((f64::from(*value), error.mean_delta_e));
            pictures.push(XyzImage::from_film(&still.film));
        }
        println!(
            "| converged | {:.1} | | | | | | |",
            converged.statistics.mean_segments_per_camera_ray()
        );
        pictures.push(XyzImage::from_film(&converged.film));
        let path = folder.join(format!("{name}-{}.png", scene.file_name));
        strip::write(&path, &pictures, &scene.document.display)?;
        series.push(Series { name: scene.name.into(), points });
    }
    Ok(series)
}
