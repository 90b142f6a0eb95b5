//! Errors over a setting, as a plot.

use std::error::Error;
use std::path::Path;

use plotters::prelude::*;

/// The errors on one scene.
pub(crate) struct Series {
    pub(crate) name: &'static str,
    /// The setting's value and the mean ΔE₀₀.
    pub(crate) points: Vec<(f64, f64)>,
}

const SIZE: (u32, u32) = (640, 400);
const COLORS: [RGBColor; 2] = [RGBColor(40, 96, 168), RGBColor(200, 84, 40)];
/// About the least difference that is seen.
const JUST_NOTICEABLE: f64 = 1.0;
/// Below this a plot need not tell errors apart.
const LEAST_ERROR: f64 = 1e-3;

/// Plots mean errors over a setting, both logarithmic.
pub(crate) fn write(path: &Path, setting: &str, all: &[Series]) -> Result<(), Box<dyn Error>> {
    let points = || all.iter().flat_map(|series| &series.points);
    let (low, high) = bounds(points().map(|point| point.0));
    let (_, most) = bounds(points().map(|point| point.1));
    let root = SVGBackend::new(path, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&root)
        .margin(16)
        .x_label_area_size(44)
        .y_label_area_size(64)
        .build_cartesian_2d((low..high).log_scale(), (LEAST_ERROR..2.0 * most).log_scale())?;
    chart
        .configure_mesh()
        .x_desc(setting)
        .y_desc("mean ΔE₀₀ from the converged picture")
        .label_style(("sans-serif", 14))
        .draw()?;
    let noticeable = [(low, JUST_NOTICEABLE), (high, JUST_NOTICEABLE)];
    chart.draw_series(LineSeries::new(noticeable, BLACK.mix(0.4)))?;
    for (series, color) in all.iter().zip(COLORS) {
        let points = || series.points.iter().map(|&(x, y)| (x, y.max(LEAST_ERROR)));
        chart
            .draw_series(LineSeries::new(points(), color.stroke_width(2)))?
            .label(series.name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 20, y)], color.stroke_width(2)));
        chart.draw_series(points().map(|at| Circle::new(at, 4, color.filled())))?;
    }
    chart.configure_series_labels().label_font(("sans-serif", 14)).draw()?;
    root.present()?;
    Ok(())
}

fn bounds(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::MAX, f64::MIN), |(low, high), value| (low.min(value), high.max(value)))
}
