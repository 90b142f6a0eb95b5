//! Errors over what they depend on, both logarithmic.

use std::error::Error;
use std::path::Path;

use plotters::prelude::*;

/// The errors of one kind.
pub(crate) struct Series {
    pub(crate) name: String,
    /// What the error depends on, and the error.
    pub(crate) points: Vec<(f64, f64)>,
}

/// What a plot says beside its series.
pub(crate) struct Axes<'a> {
    pub(crate) x: &'a str,
    pub(crate) y: &'a str,
    /// Below this the plot need not tell errors apart.
    pub(crate) least_error: f64,
    /// An error that is marked by a line across, with what it means.
    pub(crate) mark: Option<(f64, &'a str)>,
}

const SIZE: (u32, u32) = (640, 400);
const COLORS: [RGBColor; 4] =
    [RGBColor(40, 96, 168), RGBColor(200, 84, 40), RGBColor(56, 140, 72), RGBColor(128, 64, 152)];

/// Plots all series.
pub(crate) fn write(path: &Path, axes: &Axes<'_>, all: &[Series]) -> Result<(), Box<dyn Error>> {
    let points = || all.iter().flat_map(|series| &series.points);
    let (low, high) = bounds(points().map(|point| point.0));
    let (_, most) = bounds(points().map(|point| point.1));
    let root = SVGBackend::new(path, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&root)
        .margin(16)
        .x_label_area_size(44)
        .y_label_area_size(64)
        .build_cartesian_2d((low..high).log_scale(), (axes.least_error..2.0 * most).log_scale())?;
    chart.configure_mesh().x_desc(axes.x).y_desc(axes.y).label_style(("sans-serif", 14)).draw()?;
    if let Some((error, meaning)) = axes.mark {
        let line = LineSeries::new([(low, error), (high, error)], BLACK.mix(0.4));
        let mark = chart.draw_series(line)?;
        if !meaning.is_empty() {
            mark.label(meaning)
                .legend(|(x, y)| PathElement::new([(x, y), (x + 20, y)], BLACK.mix(0.4)));
        }
    }
    for (series, color) in all.iter().zip(COLORS) {
        let points = || series.points.iter().map(|&(x, y)| (x, y.max(axes.least_error)));
        chart
            .draw_series(LineSeries::new(points(), color.stroke_width(2)))?
            .label(&series.name)
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
