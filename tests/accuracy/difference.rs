//! How far a film is from the reference, where bodies are seen.

use std::fmt::Write;

use brilliance_renderer::develop::XyzImage;
use brilliance_renderer::film::Film;
use brilliance_renderer::settings::DisplaySettings;

use crate::reference::Reference;

/// CIEDE2000 differences of the developed pixels that show a body.
pub(crate) struct Difference {
    pub(crate) mean: f64,
    /// 99th percentile.
    pub(crate) high: f64,
    /// The largest.
    pub(crate) worst: f64,
    /// Column and row of the largest.
    pub(crate) worst_pixel: [u32; 2],
}

impl Difference {
    pub(crate) fn of(film: &Film, reference: &Reference) -> Self {
        let display = DisplaySettings::default();
        let [found, wanted] =
            [film, &reference.film].map(|film| XyzImage::from_film(film).develop(&display));
        let pairs = found.labs().zip(wanted.labs()).enumerate();
        let mut all: Vec<(f64, usize)> = pairs
            .filter(|(i, _)| reference.shows_body[*i])
            .map(|(i, (found, wanted))| (found.delta_e_2000(wanted), i))
            .collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (worst, pixel) = *all.last().expect("a body is in the picture");
        let width = film.size()[0] as usize;
        Self {
            mean: all.iter().map(|(delta_e, _)| delta_e).sum::<f64>() / all.len() as f64,
            high: all[(all.len() - 1) * 99 / 100].0,
            worst,
            worst_pixel: [(pixel % width) as u32, (pixel / width) as u32],
        }
    }

    /// The spectra of the worst pixel, side by side.
    pub(crate) fn worst_spectra(&self, film: &Film, reference: &Reference) -> String {
        let [x, y] = self.worst_pixel;
        let mut lines = format!("pixel {x}, {y}: nm, found, wanted\n");
        let pairs = film.pixel(x, y).into_iter().zip(reference.film.pixel(x, y));
        for (bin, (found, wanted)) in pairs.enumerate() {
            let (low_nm, high_nm) = film.bins().range_nm(bin);
            writeln!(lines, "{low_nm:.0}–{high_nm:.0} {found:.5} {wanted:.5}")
                .expect("a string takes it");
        }
        lines
    }
}
