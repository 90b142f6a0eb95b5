//! Image files: PNG and OpenEXR, written to a temporary name and renamed.
//!
//! Both carry texts by keyword, so that the scene travels with its picture.

mod openexr;
mod png_file;

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::path::Path;

use crate::error::RendererError;
use crate::spectrum::Bins;
use crate::whole_file;

/// The metadata keyword of the scene file that made the picture.
pub const SCENE_KEYWORD: &str = "brilliance-scene";

/// The formats that are written, each known by its extension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImageFormat {
    /// Portable Network Graphics, `.png`.
    Png,
    /// OpenEXR, `.exr`.
    Exr,
}

impl ImageFormat {
    /// The format that the extension of `path` names, in upper or lower case.
    ///
    /// # Errors
    /// Any other extension, or none.
    pub fn of(path: &Path) -> Result<Self, RendererError> {
        let extension = path.extension().map(OsStr::to_ascii_lowercase);
        match extension.as_ref().and_then(|extension| extension.to_str()) {
            Some("png") => Ok(Self::Png),
            Some("exr") => Ok(Self::Exr),
            _ => Err(RendererError::File {
                path: path.into(),
                message: "unknown kind of image; end the file name in .png or .exr".into(),
            }),
        }
    }
}

/// Writes an sRGB PNG of 8 bits per channel. `rgba8` holds red, green, blue and alpha of each
/// pixel, row by row from the top; `metadata` holds keywords and texts.
///
/// # Errors
/// The file can't be written, the pixels don't fill the size, or a keyword is not 1 to 79 Latin-1
/// characters. An old file of the same name is then left as it was.
pub fn write_png8(
    path: &Path,
    size: [u32; 2],
    rgba8: &[u8],
    metadata: &[(&str, &str)],
) -> Result<(), RendererError> {
    check_count(size, 4, rgba8.len())?;
    whole_file::replace(path, |file| png_file::write_rgba8(file, size, rgba8, metadata))
}

/// Writes an sRGB PNG of 16 bits per channel. `rgb16` holds red, green and blue of each pixel, row
/// by row from the top; `metadata` holds keywords and texts.
///
/// # Errors
/// As [`write_png8`].
pub fn write_png16(
    path: &Path,
    size: [u32; 2],
    rgb16: &[u16],
    metadata: &[(&str, &str)],
) -> Result<(), RendererError> {
    check_count(size, 3, rgb16.len())?;
    whole_file::replace(path, |file| png_file::write_rgb16(file, size, rgb16, metadata))
}

/// Writes an OpenEXR file of 32-bit floats: linear Rec. 709 `R`, `G`, `B` and, with `spectral`, one
/// channel per bin from the mean radiances, the bins of a pixel side by side.
///
/// Spectral channels are named and marked after A. Fichet, R. Pacanowski and A. Wilkie, "An OpenEXR
/// Layout for Spectral Images", JCGT 10(3), 2021: `S0.384,000nm`, the unpolarised radiance of the
/// bin with this centre. Its absolute scale is the scene's.
///
/// # Errors
/// The file can't be written, the pixels don't fill the size, or a keyword is empty, longer than
/// 255 bytes or the name of a standard attribute. An old file of the same name is then left as it
/// was.
pub fn write_exr(
    path: &Path,
    size: [u32; 2],
    linear_rgb: &[[f32; 3]],
    spectral: Option<(Bins, &[f32])>,
    metadata: &[(&str, &str)],
) -> Result<(), RendererError> {
    check_count(size, 1, linear_rgb.len())?;
    if let Some((bins, means)) = spectral {
        check_count(size, bins.count(), means.len())?;
    }
    whole_file::replace(path, |file| openexr::write(file, size, linear_rgb, spectral, metadata))
}

/// Reads the texts of a PNG or OpenEXR file by keyword; [`SCENE_KEYWORD`] holds the scene.
///
/// # Errors
/// The file can't be read, or is neither PNG nor OpenEXR.
pub fn read_metadata(path: &Path) -> Result<BTreeMap<String, String>, RendererError> {
    let format = ImageFormat::of(path)?;
    let file = std::fs::File::open(path)
        .map_err(|source| RendererError::Io { path: path.into(), source })?;
    let read = match format {
        ImageFormat::Png => png_file::read_texts(file),
        ImageFormat::Exr => openexr::read_texts(file),
    };
    read.map_err(|fault| RendererError::File {
        path: path.into(),
        message: format!("can't be read as an image ({fault}); export it again"),
    })
}

/// Checks that `actual` numbers are `per_pixel` for every pixel of an image that is not empty.
fn check_count(size: [u32; 2], per_pixel: usize, actual: usize) -> Result<(), RendererError> {
    let [width, height] = size;
    let expected = (width as usize)
        .checked_mul(height as usize)
        .and_then(|pixels| pixels.checked_mul(per_pixel))
        .filter(|&count| count > 0);
    if expected == Some(actual) {
        return Ok(());
    }
    Err(RendererError::Invalid(format!(
        "an image of {width} × {height} pixels with {per_pixel} numbers each can't be made of \
         {actual} numbers; give it a size of at least 1 × 1 and all its pixels"
    )))
}
