//! PNG.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, BufReader, Write};

use png::{BitDepth, ColorType, Decoder, Encoder, SrgbRenderingIntent};

/// Writes red, green, blue and alpha of 8 bits.
pub(super) fn write_rgba8(
    file: impl Write,
    size: [u32; 2],
    rgba8: &[u8],
    metadata: &[(&str, &str)],
) -> io::Result<()> {
    write(file, size, (ColorType::Rgba, BitDepth::Eight), rgba8, metadata)
}

/// Writes red, green and blue of 16 bits.
pub(super) fn write_rgb16(
    file: impl Write,
    size: [u32; 2],
    rgb16: &[u16],
    metadata: &[(&str, &str)],
) -> io::Result<()> {
    let bytes: Vec<u8> = rgb16.iter().flat_map(|code| code.to_be_bytes()).collect();
    write(file, size, (ColorType::Rgb, BitDepth::Sixteen), &bytes, metadata)
}

fn write(
    file: impl Write,
    [width, height]: [u32; 2],
    (color, depth): (ColorType, BitDepth),
    bytes: &[u8],
    metadata: &[(&str, &str)],
) -> io::Result<()> {
    let mut encoder = Encoder::new(file, width, height);
    encoder.set_color(color);
    encoder.set_depth(depth);
    encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    for &(keyword, text) in metadata {
        // UTF-8, where PNG's other two kinds of text are Latin-1.
        encoder.add_itxt_chunk(keyword.into(), text.into())?;
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(bytes)?;
    Ok(writer.finish()?)
}

/// Reads the texts before the pixels, whichever of PNG's three kinds they are.
pub(super) fn read_texts(file: File) -> io::Result<BTreeMap<String, String>> {
    let reader = Decoder::new(BufReader::new(file)).read_info()?;
    let info = reader.info();
    let mut texts = BTreeMap::new();
    for chunk in &info.uncompressed_latin1_text {
        texts.insert(chunk.keyword.clone(), chunk.text.clone());
    }
    // Decompressing in place is bounded, where `get_text` of a compressed chunk is not.
    for mut chunk in info.compressed_latin1_text.iter().cloned() {
        chunk.decompress_text()?;
        texts.insert(chunk.keyword.clone(), chunk.get_text()?);
    }
    for mut chunk in info.utf8_text.iter().cloned() {
        chunk.decompress_text()?;
        texts.insert(chunk.keyword.clone(), chunk.get_text()?);
    }
    Ok(texts)
}
