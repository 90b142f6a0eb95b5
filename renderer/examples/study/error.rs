//! How far a picture is from another.

use brilliance_renderer::color::{self, Lab};
use brilliance_renderer::develop::XyzImage;
use brilliance_renderer::film::Film;
use brilliance_renderer::settings::DisplaySettings;
use glam::DVec3;

/// Differences over all pixels.
pub(crate) struct PictureError {
    /// Root of the mean squared difference of linear RGB, over the mean luminance.
    pub(crate) relative_rmse: f64,
    /// Mean CIEDE2000 difference of the developed pixels.
    pub(crate) mean_delta_e: f64,
    /// Its 99th percentile.
    pub(crate) high_delta_e: f64,
}

impl PictureError {
    /// The differences of a film from the converged one.
    pub(crate) fn between(film: &Film, converged: &Film, display: &DisplaySettings) -> Self {
        let [image, reference] = [film, converged].map(XyzImage::from_film);
        let mut delta_e: Vec<f64> = labs(&image, display)
            .zip(labs(&reference, display))
            .map(|(found, wanted)| found.delta_e_2000(wanted))
            .collect();
        delta_e.sort_by(f64::total_cmp);
        Self {
            relative_rmse: relative_rmse(&image.linear_rgb(), &reference.linear_rgb()),
            mean_delta_e: delta_e.iter().sum::<f64>() / delta_e.len() as f64,
            high_delta_e: delta_e[(delta_e.len() - 1) * 99 / 100],
        }
    }
}

fn relative_rmse(found: &[[f32; 3]], wanted: &[[f32; 3]]) -> f64 {
    let rgb = |pixel: &[f32; 3]| DVec3::from_array(pixel.map(f64::from));
    let pairs = || found.iter().zip(wanted);
    let squares: f64 = pairs().map(|(a, b)| (rgb(a) - rgb(b)).length_squared()).sum();
    let luminance: f64 = wanted.iter().map(|pixel| color::luminance(rgb(pixel))).sum();
    (squares / (3 * wanted.len()) as f64).sqrt() / (luminance / wanted.len() as f64)
}

/// The pixels as a display shows them, beside its white.
fn labs(image: &XyzImage, display: &DisplaySettings) -> impl Iterator<Item = Lab> {
    let xyz_from_rgb = color::xyz_from_rec709();
    let white = color::d65_white();
    image
        .develop(display)
        .rgb
        .into_iter()
        .map(move |rgb| Lab::from_xyz(xyz_from_rgb * DVec3::from_array(rgb.map(f64::from)), white))
}
