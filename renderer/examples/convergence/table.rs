//! The curves as tables.

use std::fmt::Write;

use crate::convergence::{Curve, Measure, PictureError, Reference};
use crate::scene::ReferenceScene;

/// What stands above all tables.
pub(crate) const PREFACE: &str = "# Error over time: the tables\n\n\
    Made by the example `convergence`; [what they mean](../convergence.md).\n";

/// The tables of one scene; the first curve is what the others are held against.
pub(crate) fn section(scene: &ReferenceScene, reference: &Reference, curves: &[Curve]) -> String {
    let mut text = format!("\n## {}\n\n", scene.name);
    let noise = reference.error;
    let lines = [
        format!(
            "The converged picture itself is off by {:.5} (linear) and {:.5} (shown).",
            noise.linear, noise.shown
        ),
        String::new(),
        "| method | passes | seconds | linear RMSE | shown RMSE | light |".into(),
        "|---|---|---|---|---|---|".into(),
    ];
    for line in lines {
        text.push_str(&line);
        text.push('\n');
    }
    for curve in curves {
        for point in &curve.points {
            let PictureError { linear, shown, light } = point.error;
            // Writing to a string can't fail.
            let _ = writeln!(
                text,
                "| {} | {} | {:.3} | {linear:.4} | {shown:.4} | {light:.4} |",
                curve.name, point.passes, point.seconds
            );
        }
    }
    text.push_str(&speeds(curves));
    if let Some((baseline, others)) = curves.split_first() {
        text.push_str(&equal_errors(baseline, others));
    }
    text
}

fn speeds(curves: &[Curve]) -> String {
    let mut text =
        String::from("\n| method | rays per camera ray | million rays/s |\n|---|---|---|\n");
    for curve in curves {
        let millions = curve.segments_per_second / 1e6;
        let _ = writeln!(
            text,
            "| {} | {:.1} | {millions:.1} |",
            curve.name, curve.segments_per_camera_ray
        );
    }
    text
}

/// How many times sooner the others are where the baseline is at each of its points.
fn equal_errors(baseline: &Curve, others: &[Curve]) -> String {
    let mut text = format!("\n| {}: seconds | linear RMSE |", baseline.name);
    for curve in others {
        let _ = write!(text, " {}: times sooner |", curve.name);
    }
    text.push_str(" shown RMSE |");
    for curve in others {
        let _ = write!(text, " {}: times sooner |", curve.name);
    }
    text.push_str("\n|---|---|---|");
    text.push_str(&"---|".repeat(2 * others.len()));
    text.push('\n');
    for point in &baseline.points {
        let _ = write!(text, "| {:.3} |", point.seconds);
        for measure in [Measure::Linear, Measure::Shown] {
            let error = point.error.by(measure);
            let _ = write!(text, " {error:.4} |");
            for curve in others {
                let seconds = curve.seconds_to(error, measure);
                let times = seconds.map_or("never".into(), |s| format!("{:.2}", point.seconds / s));
                let _ = write!(text, " {times} |");
            }
        }
        text.push('\n');
    }
    text
}
