//! Pictures side by side.

use std::path::Path;

use brilliance_renderer::develop::XyzImage;
use brilliance_renderer::settings::DisplaySettings;
use image::imageops::{FilterType, replace, resize};
use image::{ImageResult, Rgba, RgbaImage};

/// Pixels of the strip for each of the picture, so that single ones are seen.
const MAGNIFICATION: u32 = 3;
const GAP: u32 = 6;

/// Writes all pictures, from the left to the right.
pub(crate) fn write(
    path: &Path,
    pictures: &[XyzImage],
    display: &DisplaySettings,
) -> ImageResult<()> {
    let mut strip = RgbaImage::new(0, 0);
    for (picture, number) in pictures.iter().zip(0_u32..) {
        let [columns, rows] = picture.size;
        let [width, height] = [columns, rows].map(|side| side * MAGNIFICATION);
        if number == 0 {
            let all = pictures.len() as u32 * (width + GAP) - GAP;
            strip = RgbaImage::from_pixel(all, height, Rgba([255; 4]));
        }
        let codes = picture.develop_rgba8(display);
        let Some(picture) = RgbaImage::from_raw(columns, rows, codes) else { continue };
        let picture = resize(&picture, width, height, FilterType::Nearest);
        replace(&mut strip, &picture, i64::from(number * (width + GAP)), 0);
    }
    strip.save(path)
}
