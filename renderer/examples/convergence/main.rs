//! Error over time of each method: the tables and plots of `docs/convergence.md`.
//!
//! `cargo run --release --workspace --example convergence` traces them and writes into
//! `docs/convergence`. Two words may follow: the passes of the converged pictures, and the seconds that
//! each method is followed for.
#![expect(clippy::print_stdout, reason = "it takes minutes, and tells how far it is")]

mod baseline;
mod convergence;
mod method;
#[path = "../shared/plot.rs"]
mod plot;
#[path = "../shared/rmse.rs"]
mod rmse;
mod scene;
#[path = "../shared/strip.rs"]
mod strip;
mod table;
mod wavelengths;

use std::error::Error;
use std::path::Path;

use convergence::{Curve, Effort, Measure, Reference};
use plot::{Axes, Series};
use scene::ReferenceScene;

const REFERENCE_PASSES: u32 = 16_384;
const SECONDS: f64 = 10.0;

fn main() -> Result<(), Box<dyn Error>> {
    let mut words = std::env::args().skip(1);
    let effort = Effort {
        reference_passes: words.next().map_or(Ok(REFERENCE_PASSES), |word| word.parse())?,
        seconds: words.next().map_or(Ok(SECONDS), |word| word.parse())?,
    };
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/convergence");
    std::fs::create_dir_all(&folder)?;
    let candidates = method::all();
    let mut tables = String::from(table::PREFACE);
    for scene in scene::all()? {
        println!("{}: the converged picture, {} passes", scene.name, effort.reference_passes);
        let reference = Reference::trace(&scene, effort)?;
        println!("{}: {} methods, {} s each", scene.name, candidates.len(), effort.seconds);
        let curves = convergence::follow(&scene, &reference, &candidates, effort)?;
        let section = table::section(&scene, &reference, &curves);
        println!("{section}");
        tables.push_str(&section);
        plot_both(&folder, &scene, &reference, &curves)?;
        let mut pictures: Vec<_> = curves.into_iter().map(|curve| curve.early_picture).collect();
        pictures.push(reference.image);
        let path = folder.join(format!("{}.png", scene.file_name));
        strip::write(&path, &pictures, &scene.document.display)?;
    }
    std::fs::write(folder.join("tables.md"), tables)?;
    Ok(())
}

/// One plot for each kind of error.
fn plot_both(
    folder: &Path,
    scene: &ReferenceScene,
    reference: &Reference,
    curves: &[Curve],
) -> Result<(), Box<dyn Error>> {
    let measures = [
        ("linear", Measure::Linear, "RMSE of linear RGB over the mean luminance"),
        ("shown", Measure::Shown, "RMSE after clipping and sRGB encoding"),
    ];
    for (kind, measure, y) in measures {
        let noise = reference.error.by(measure);
        let axes = Axes {
            x: "seconds of tracing",
            y,
            least_error: 0.5 * noise,
            mark: Some((noise, "the converged picture's own")),
        };
        let series = curves.iter().map(|curve| Series {
            name: curve.name.into(),
            points: curve.points.iter().map(|p| (p.seconds, p.error.by(measure))).collect(),
        });
        let path = folder.join(format!("{}-{kind}.svg", scene.file_name));
        plot::write(&path, &axes, &series.collect::<Vec<_>>())?;
    }
    Ok(())
}
