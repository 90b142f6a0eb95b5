//! The format of the picture, from its file name and the options.

use std::path::Path;

use brilliance_renderer::still::StillFormat;
use clap::ValueEnum;

/// Bits per channel of a PNG.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum BitDepth {
    /// 8 bits per channel.
    #[value(name = "8")]
    Eight,
    /// 16 bits per channel.
    #[value(name = "16")]
    Sixteen,
}

/// The format for a picture named `path`.
///
/// # Errors
/// The extension is none of the known ones, or an option does not go with it.
pub(super) fn picture_format(
    path: &Path,
    bits: Option<BitDepth>,
    spectral: bool,
) -> Result<StillFormat, String> {
    let extension = path.extension().map(|extension| extension.to_string_lossy().to_lowercase());
    match (extension.as_deref(), bits, spectral) {
        (Some("png"), _, true) => {
            Err("a PNG can't hold spectral bins; name an .exr for --spectral".into())
        }
        (Some("png"), None | Some(BitDepth::Eight), false) => Ok(StillFormat::Png8),
        (Some("png"), Some(BitDepth::Sixteen), false) => Ok(StillFormat::Png16),
        (Some("exr"), None, spectral) => Ok(StillFormat::Exr { spectral }),
        (Some("exr"), Some(_), _) => {
            Err("an OpenEXR picture always has 32-bit floats; --bits is for a .png".into())
        }
        _ => Err(format!(
            "{}: the extension says no known format; name the picture .png or .exr",
            path.display()
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_extension_decides_in_any_case() {
        let format = |name: &str| picture_format(Path::new(name), None, false);
        assert_eq!(format("a.png"), Ok(StillFormat::Png8));
        assert_eq!(format("a.b.EXR"), Ok(StillFormat::Exr { spectral: false }));
        for name in ["a", "a.jpg", ".png", "png"] {
            assert!(format(name).unwrap_err().contains("name the picture .png or .exr"), "{name}");
        }
    }

    #[test]
    fn options_go_with_their_format_only() {
        let png = Path::new("a.png");
        let exr = Path::new("a.exr");
        let sixteen = Some(BitDepth::Sixteen);
        assert_eq!(picture_format(png, sixteen, false), Ok(StillFormat::Png16));
        assert_eq!(picture_format(exr, None, true), Ok(StillFormat::Exr { spectral: true }));
        assert!(picture_format(png, None, true).is_err());
        assert!(picture_format(exr, sixteen, false).is_err());
    }
}
