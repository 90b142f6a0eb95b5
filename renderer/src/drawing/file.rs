//! Drawings as files.

use std::ffi::OsStr;
use std::io::Write as _;
use std::path::Path;

use super::sheet::Sheet;
use crate::error::RendererError;
use crate::image_file::write_png8;
use crate::whole_file;

const MM_PER_INCH: f64 = 25.4;

/// The formats that drawings are written in, each known by its extension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SheetFormat {
    /// Scalable Vector Graphics, `.svg`.
    Svg,
    /// Portable Network Graphics, `.png`.
    Png,
}

impl SheetFormat {
    /// The format that the extension of `path` names, in upper or lower case.
    ///
    /// # Errors
    /// Any other extension, or none.
    pub fn of(path: &Path) -> Result<Self, RendererError> {
        let extension = path.extension().map(OsStr::to_ascii_lowercase);
        match extension.as_ref().and_then(|extension| extension.to_str()) {
            Some("svg") => Ok(Self::Svg),
            Some("png") => Ok(Self::Png),
            _ => Err(RendererError::File {
                path: path.into(),
                message: "unknown kind of drawing; end the file name in .svg or .png".into(),
            }),
        }
    }
}

impl Sheet {
    /// Dots per inch of a picture that nothing else is said about.
    pub const DPI: f64 = 200.0;

    /// Width and height in pixels at `dpi` dots per inch.
    pub fn size_at(&self, dpi: f64) -> [u32; 2] {
        self.size_mm.to_array().map(|side| (side / MM_PER_INCH * dpi).round() as u32)
    }

    /// Writes the drawing in the format that the extension of `path` names; a PNG has `size` pixels.
    ///
    /// # Errors
    /// An unknown extension, a size that [`to_rgba8`](Self::to_rgba8) refuses, or a file that can't
    /// be written. An old file of the same name is then left as it was.
    pub fn save(&self, path: &Path, size: [u32; 2]) -> Result<(), RendererError> {
        match SheetFormat::of(path)? {
            SheetFormat::Svg => {
                let svg = self.to_svg();
                whole_file::replace(path, |file| file.write_all(svg.as_bytes()))
            }
            SheetFormat::Png => {
                let pixels = self.to_rgba8(size)?;
                write_png8(path, size, &pixels, &[("Title", &self.title)])
            }
        }
    }
}
