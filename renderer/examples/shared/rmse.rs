//! Root mean squared differences of pictures.

use brilliance_renderer::color;
use glam::DVec3;

/// Root of the mean squared difference of linear RGB, over the mean luminance of `wanted`.
pub(crate) fn relative_rmse(found: &[[f32; 3]], wanted: &[[f32; 3]]) -> f64 {
    let luminance: f64 = wanted.iter().map(|pixel| color::luminance(rgb(pixel))).sum();
    rmse(found, wanted) / (luminance / wanted.len() as f64)
}

/// Root of the mean squared difference over all channels of all pixels.
pub(crate) fn rmse(found: &[[f32; 3]], wanted: &[[f32; 3]]) -> f64 {
    let pairs = found.iter().zip(wanted);
    let squares: f64 = pairs.map(|(a, b)| (rgb(a) - rgb(b)).length_squared()).sum();
    (squares / (3 * wanted.len()) as f64).sqrt()
}

fn rgb(pixel: &[f32; 3]) -> DVec3 {
    DVec3::from_array(pixel.map(f64::from))
}
