//! Images to print on matte surfaces: PNG and JPEG files, and those that ship.

use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock};

use ::image::metadata::Orientation;
use ::image::{DynamicImage, ImageDecoder, ImageError, ImageFormat, ImageReader, Limits};

use crate::color::{srgb_decode, srgb_encode};
use crate::error::RendererError;
use crate::whole_file;

/// A picture in sRGB codes of 8 bits.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Where it came from.
    pub origin: ImageOrigin,
    /// Width and height in texels, each 1 to [`MAX_SIDE`](Self::MAX_SIDE).
    pub size: [u32; 2],
    /// Row by row from the top, red in the lowest byte, then green and blue; the highest is 0.
    pub texels: Vec<u32>,
}

/// Where an image came from, and so how a scene file names it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ImageOrigin {
    /// A PNG or JPEG file.
    File(PathBuf),
    /// An image that ships, by its name.
    Library(&'static str),
    /// The texture that a mesh brings from its own file, by its name there.
    Mesh(String),
}

/// What becomes of an image's alpha.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Alpha {
    /// What is transparent shows white.
    OverWhite,
    /// All is opaque.
    Ignored,
}

/// The texels that the images of a scene may still have.
#[derive(Clone, Copy, Debug)]
pub struct TexelBudget {
    used: u64,
    limit: u64,
}

impl TexelBudget {
    /// Of so many texels in all.
    pub fn new(limit: usize) -> Self {
        Self { used: 0, limit: limit as u64 }
    }

    /// Takes the texels of an image of `size`.
    ///
    /// # Errors
    /// So many are not left; the text names the limit and the remedy.
    pub fn take(&mut self, [width, height]: [u32; 2]) -> Result<(), String> {
        self.used += u64::from(width) * u64::from(height);
        if self.used <= self.limit {
            return Ok(());
        }
        let Self { used, limit } = self;
        Err(format!(
            "with it the images have {used} texels; {limit} are allowed in all, so make them smaller"
        ))
    }
}

impl Default for TexelBudget {
    /// Of a scene.
    fn default() -> Self {
        Self::new(Image::MAX_TEXELS)
    }
}

/// Images that ship: the name and the PNG file.
const LIBRARY: [(&str, &[u8]); 1] =
    [("The word prism", include_bytes!("../../../assets/images/word-prism.png"))];

impl Image {
    /// Largest width and height.
    pub const MAX_SIDE: u32 = 8192;
    /// Most texels of all the images of a scene: half a gigabyte.
    pub const MAX_TEXELS: usize = 1 << 27;
    /// Most bytes of an image file.
    pub const MAX_FILE_BYTES: u64 = 1 << 28;

    /// Reads a PNG or JPEG file; what is transparent shows white.
    ///
    /// # Errors
    /// The file can't be read, is neither, is broken or is too large.
    pub fn open(path: &Path, budget: &mut TexelBudget) -> Result<Self, RendererError> {
        let bytes = whole_file::read(path, Self::MAX_FILE_BYTES)
            .map_err(|source| RendererError::Io { path: path.to_owned(), source })?;
        Self::decode(ImageOrigin::File(path.to_owned()), &bytes, Alpha::OverWhite, budget)
            .map_err(|message| RendererError::File { path: path.to_owned(), message })
    }

    /// Reads the bytes of a PNG or JPEG file, whose texels are taken from the `budget` before any is
    /// decoded. Colours are taken for sRGB, and 16 bits are rounded to 8.
    ///
    /// # Errors
    /// What is wrong with the image, and the remedy.
    pub fn decode(
        origin: ImageOrigin,
        bytes: &[u8],
        alpha: Alpha,
        budget: &mut TexelBudget,
    ) -> Result<Self, String> {
        let Ok(format @ (ImageFormat::Png | ImageFormat::Jpeg)) = ::image::guess_format(bytes)
        else {
            return Err("the image is neither PNG nor JPEG; convert it to one of them".into());
        };
        let pixels = decoded(format, bytes, budget)?.into_rgba8();
        let size = pixels.dimensions().into();
        let texel = |[red, green, blue, coverage]: [u8; 4]| match alpha {
            Alpha::OverWhite => texel_on_white([red, green, blue, coverage]),
            Alpha::Ignored => u32::from_le_bytes([red, green, blue, 0]),
        };
        let texels = pixels.pixels().map(|pixel| texel(pixel.0)).collect();
        Ok(Self { origin, size, texels })
    }

    /// The image that ships under this name, in upper or lower case.
    pub fn of_library(name: &str) -> Option<Arc<Self>> {
        static IMAGES: LazyLock<Vec<Arc<Image>>> = LazyLock::new(|| {
            let decoded = |&(name, bytes): &(&'static str, &[u8])| {
                let (origin, budget) = (ImageOrigin::Library(name), &mut TexelBudget::default());
                Image::decode(origin, bytes, Alpha::OverWhite, budget).ok().map(Arc::new)
            };
            LIBRARY.iter().filter_map(decoded).collect()
        });
        let is_named = |known: &&Arc<Self>| known.name().eq_ignore_ascii_case(name.trim());
        IMAGES.iter().find(is_named).map(Arc::clone)
    }

    /// The names of the images that ship.
    pub fn library_names() -> impl Iterator<Item = &'static str> {
        LIBRARY.iter().map(|(name, _)| *name)
    }

    /// What the user knows it by: the name of the file, or the one it has in the library or mesh.
    pub fn name(&self) -> String {
        match &self.origin {
            ImageOrigin::File(path) => {
                path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
            }
            ImageOrigin::Library(name) => (*name).to_owned(),
            ImageOrigin::Mesh(name) => name.clone(),
        }
    }
}

/// The picture as its file says it is to be turned.
fn decoded(
    format: ImageFormat,
    bytes: &[u8],
    budget: &mut TexelBudget,
) -> Result<DynamicImage, String> {
    let in_words = |fault: ImageError| fault_in_words(&fault);
    let mut limits = Limits::no_limits();
    limits.max_image_width = Some(Image::MAX_SIDE);
    limits.max_image_height = Some(Image::MAX_SIDE);
    // Eight bytes for each texel of the largest image, and as much again to decode it.
    limits.max_alloc = Some(16 * u64::from(Image::MAX_SIDE).pow(2));
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    reader.limits(limits);
    let mut decoder = reader.into_decoder().map_err(in_words)?;
    budget.take(decoder.dimensions().into())?;
    let orientation = decoder.orientation().unwrap_or(Orientation::NoTransforms);
    let mut pixels = DynamicImage::from_decoder(decoder).map_err(in_words)?;
    pixels.apply_orientation(orientation);
    Ok(pixels)
}

fn fault_in_words(fault: &ImageError) -> String {
    match fault {
        ImageError::Limits(_) => {
            let side = Image::MAX_SIDE;
            format!("the image is larger than {side} × {side} texels; make it smaller")
        }
        _ => format!("the image is broken ({fault}); save or export it again"),
    }
}

/// Red, green, blue and alpha laid over white, in linear light.
fn texel_on_white([red, green, blue, alpha]: [u8; 4]) -> u32 {
    let over_white = |code: u8| {
        if alpha == u8::MAX {
            return u32::from(code);
        }
        let alpha = f64::from(alpha) / 255.0;
        let linear = alpha * srgb_decode(f64::from(code) / 255.0) + 1.0 - alpha;
        (255.0 * srgb_encode(linear)).round() as u32
    };
    over_white(red) | over_white(green) << 8 | over_white(blue) << 16
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_image_that_ships_can_be_had() {
        for name in Image::library_names() {
            let image = Image::of_library(&name.to_uppercase()).expect(name);
            assert_eq!(image.name(), name);
            assert_eq!(image.texels.len(), (image.size[0] * image.size[1]) as usize);
        }
        assert!(Image::of_library("prism").is_none());
    }

    /// The bytes of a file with these pixels.
    fn file(pixels: &DynamicImage, format: ImageFormat) -> Vec<u8> {
        let mut bytes = Cursor::new(Vec::new());
        pixels.write_to(&mut bytes, format).expect("the image is encoded");
        bytes.into_inner()
    }

    fn decode(bytes: &[u8]) -> Result<Image, String> {
        let origin = ImageOrigin::Mesh("test".to_owned());
        Image::decode(origin, bytes, Alpha::OverWhite, &mut TexelBudget::default())
    }

    #[test]
    fn grey_and_coloured_images_of_8_and_16_bits_are_read() {
        use ::image::{GrayAlphaImage, ImageBuffer, Luma, LumaA, Rgb, RgbImage};
        let rgb = RgbImage::from_fn(2, 3, |x, y| Rgb([10 * x as u8, 20 * y as u8, 200]));
        let read = decode(&file(&rgb.into(), ImageFormat::Png)).expect("it is read");
        assert_eq!(read.size, [2, 3]);
        assert_eq!(read.texels[3], 0xc8_14_0a, "second row, second column");
        let grey16: ImageBuffer<Luma<u16>, Vec<u16>> =
            ImageBuffer::from_pixel(1, 1, Luma([0x8080]));
        let read = decode(&file(&grey16.into(), ImageFormat::Png)).expect("it is read");
        assert_eq!(read.texels, [0x80_80_80]);
        let clear = GrayAlphaImage::from_pixel(1, 1, LumaA([0, 0]));
        let read = decode(&file(&clear.into(), ImageFormat::Png)).expect("it is read");
        assert_eq!(read.texels, [0xff_ff_ff]);
        let rgb = RgbImage::from_pixel(16, 8, Rgb([200, 100, 50]));
        let read = decode(&file(&rgb.into(), ImageFormat::Jpeg)).expect("it is read");
        assert_eq!(read.size, [16, 8]);
        let [red, green, blue, _] = read.texels[9].to_le_bytes();
        assert!(red.abs_diff(200) < 4 && green.abs_diff(100) < 4 && blue.abs_diff(50) < 4);
    }

    #[test]
    fn what_is_no_image_is_refused_in_words() {
        let png = file(&DynamicImage::new_luma8(40, 30), ImageFormat::Png);
        for bytes in [&b"P6 not read"[..], b"", &png[..4]] {
            assert!(decode(bytes).expect_err("no image").contains("neither PNG nor JPEG"));
        }
        for length in 8..png.len() - 12 {
            assert!(decode(&png[..length]).expect_err("cut off").contains("broken"));
        }
        let wide = file(&DynamicImage::new_luma8(Image::MAX_SIDE + 1, 1), ImageFormat::Png);
        assert!(decode(&wide).expect_err("too wide").contains("8192 × 8192"));
        let widest = file(&DynamicImage::new_luma8(Image::MAX_SIDE, 1), ImageFormat::Png);
        assert_eq!(decode(&widest).expect("it is read").size, [8192, 1]);
    }

    /// An image that is too large is refused by its header: its texels are not even there.
    #[test]
    fn images_share_a_budget() {
        let png = file(&DynamicImage::new_luma8(40, 30), ImageFormat::Png);
        // The signature, the header, and where the texels begin.
        let header = &png[..8 + 25 + 8];
        let mut budget = TexelBudget::new(2 * 40 * 30 + 1);
        let mut read = |bytes: &[u8]| {
            Image::decode(ImageOrigin::Library("test"), bytes, Alpha::Ignored, &mut budget)
        };
        assert!(read(&png).is_ok() && read(&png).is_ok());
        let fault = read(header).expect_err("it is full");
        assert!(fault.contains("3600 texels; 2401 are allowed"), "{fault}");
    }

    #[test]
    fn what_is_transparent_shows_white() {
        assert_eq!(texel_on_white([1, 2, 3, 255]), 0x03_02_01);
        assert_eq!(texel_on_white([1, 2, 3, 0]), 0xff_ff_ff);
        // Half of the light of black and half of that of white: 0.498 is code 187.
        assert_eq!(texel_on_white([0, 0, 0, 128]), 0xbb_bb_bb);
    }
}
