//! The tree of rays as indented lines.

use std::io::{self, Write};

use brilliance_renderer::inspect::{RayCounts, RayEnd, RayTree, RecordedRay};

use crate::ray_words;

/// Steps of indentation after which the depth is told by its number only.
const MOST_STEPS: u32 = 32;

/// Writes totals, and then a line for each ray, below and to the right of the one that it came of.
pub(super) fn write(out: &mut impl Write, tree: &RayTree) -> io::Result<()> {
    write_totals(out, tree)?;
    for ray in &tree.rays {
        write_ray(out, ray)?;
    }
    if tree.is_truncated {
        writeln!(
            out,
            "… and {} more, which are in the totals only",
            ray_words::rays(tree.unrecorded_rays)
        )?;
    }
    Ok(())
}

fn write_totals(out: &mut impl Write, tree: &RayTree) -> io::Result<()> {
    let ([x, y], [width, height]) = (tree.pixel, tree.size_px);
    let counts = RayCounts::of(tree);
    let ledger = &tree.ledger;
    let percent = |energy: f64| ray_words::percent(energy as f32);
    let bins = tree.radiance_per_bin.len().max(1);
    let radiance: f64 = tree.radiance_per_bin.iter().map(|&bin| f64::from(bin)).sum();
    let splitting = ray_words::splitting(tree.splitting);
    writeln!(out, "pixel {x},{y} of {width}x{height}, pass {}, {splitting}", tree.pass_index)?;
    writeln!(out, "{}: {}", ray_words::rays(counts.total()), ray_words::counts(&counts))?;
    writeln!(
        out,
        "energy: {} returned, {} absorbed, {} pruned, {} cut off, {} lost; mean radiance {:.4}",
        percent(ledger.returned),
        percent(ledger.absorbed),
        percent(ledger.pruned),
        percent(ledger.cut_off),
        percent(ledger.lost),
        radiance / bins as f64,
    )?;
    writeln!(out)
}

fn write_ray(out: &mut impl Write, ray: &RecordedRay) -> io::Result<()> {
    let steps = ray.depth.min(MOST_STEPS) as usize;
    write!(
        out,
        "{:3} {:indent$}{} {:.1}–{:.1} nm, significance {:.3e}",
        ray.depth,
        "",
        ray_words::kind(ray.kind),
        ray.lambda_low_nm,
        ray.lambda_high_nm,
        ray.significance,
        indent = 2 * steps,
    )?;
    if ray.energy_gained > 0.0 {
        write!(out, " ({:.3e} of its energy gained by chance)", ray.energy_gained)?;
    }
    if ray.spread_degrees > 0.0 {
        write!(out, ", spread {:.3}°", ray.spread_degrees)?;
    }
    if let Some(path_mm) = ray.path_mm {
        write!(out, ", {path_mm:.3} mm")?;
    }
    write!(out, " → {}", ray_words::end(&ray.end))?;
    if let RayEnd::Interface(event) = &ray.end {
        write!(out, " {}", ray_words::interface(event))?;
    }
    if !ray.radiance_per_bin.is_empty() {
        write!(out, ", adds {:.3e}", ray.mean_radiance())?;
    }
    if ray.unrecorded_children > 0 {
        write!(out, ", {} rays of it are not listed", ray.unrecorded_children)?;
    }
    writeln!(out)
}
