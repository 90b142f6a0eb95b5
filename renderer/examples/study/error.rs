//! How far a picture is from another.

use brilliance_renderer::develop::XyzImage;
use brilliance_renderer::film::Film;
use brilliance_renderer::settings::DisplaySettings;
use glam::Vec3;

use crate::rmse::relative_rmse;

/// Side of the blocks of pixels whose means are compared too: what an eye that stands back sees, or
/// more passes of fewer pixels.
const BLOCK_SIDE: usize = 5;

/// Differences over all pixels.
pub(crate) struct PictureError {
    /// Root of the mean squared difference of linear RGB, over the mean luminance.
    pub(crate) relative_rmse: f64,
    /// Mean CIEDE2000 difference of the developed pixels.
    pub(crate) mean_delta_e: f64,
    /// Its 98th percentile.
    pub(crate) high_delta_e: f64,
    /// Mean CIEDE2000 difference of the means over blocks of pixels.
    pub(crate) block_delta_e: f64,
    /// Mean luminance over that of the converged picture.
    pub(crate) luminance_ratio: f64,
}

impl PictureError {
    /// The differences of a film from the converged one.
    pub(crate) fn between(film: &Film, converged: &Film, display: &DisplaySettings) -> Self {
        let [image, reference] = [film, converged].map(XyzImage::from_film);
        let delta_e = delta_e(&image, &reference, display);
        let blocks = self::delta_e(&blocks(&image), &blocks(&reference), display);
        Self {
            relative_rmse: relative_rmse(&image.linear_rgb(), &reference.linear_rgb()),
            mean_delta_e: mean(&delta_e),
            high_delta_e: delta_e[(delta_e.len() - 1) * 99 / 100],
            block_delta_e: mean(&blocks),
            luminance_ratio: luminance(&image) / luminance(&reference),
        }
    }
}

fn luminance(image: &XyzImage) -> f64 {
    image.xyz.iter().map(|xyz| f64::from(xyz[1])).sum()
}

/// The differences of all pixels, the least first.
fn delta_e(image: &XyzImage, reference: &XyzImage, display: &DisplaySettings) -> Vec<f64> {
    let [image, reference] = [image, reference].map(|image| image.develop(display));
    let pairs = image.labs().zip(reference.labs());
    let mut delta_e: Vec<f64> = pairs.map(|(found, wanted)| found.delta_e_2000(wanted)).collect();
    delta_e.sort_by(f64::total_cmp);
    delta_e
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// The means over whole blocks of pixels.
fn blocks(image: &XyzImage) -> XyzImage {
    let [width, height] = image.size.map(|side| side as usize / BLOCK_SIDE);
    let pixel = |x: usize, y: usize| Vec3::from(image.xyz[y * image.size[0] as usize + x]);
    let block = |x: usize, y: usize| {
        let pixels = (0..BLOCK_SIDE * BLOCK_SIDE)
            .map(|i| pixel(x * BLOCK_SIDE + i % BLOCK_SIDE, y * BLOCK_SIDE + i / BLOCK_SIDE));
        (pixels.sum::<Vec3>() / (BLOCK_SIDE * BLOCK_SIDE) as f32).to_array()
    };
    let xyz = (0..width * height).map(|i| block(i % width, i / width)).collect();
    XyzImage { size: [width as u32, height as u32], bins: image.bins, xyz }
}
