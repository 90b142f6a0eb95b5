//! OpenEXR.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, BufReader, Seek, Write};

use exr::meta::MetaData;
use exr::meta::attribute::Chromaticities;
use exr::prelude::{
    AnyChannel, AnyChannels, AttributeValue, Encoding, FlatSamples, Image, Layer, LayerAttributes,
    SmallVec, Text, Vec2, WritableImage,
};
use glam::DVec2;

use crate::color::{D65_XY, REC709_PRIMARIES_XY};
use crate::spectrum::Bins;

/// Writes `R`, `G`, `B` and the spectral channels, all 32-bit floats in compressed scan lines.
pub(super) fn write(
    file: impl Write + Seek,
    [width, height]: [u32; 2],
    linear_rgb: &[[f32; 3]],
    spectral: Option<(Bins, &[f32])>,
    metadata: &[(&str, &str)],
) -> io::Result<()> {
    let mut channels: SmallVec<[_; 4]> = SmallVec::new();
    for (index, name) in ["R", "G", "B"].into_iter().enumerate() {
        let samples = linear_rgb.iter().map(|pixel| pixel[index]).collect();
        channels.push(AnyChannel::new(name, FlatSamples::F32(samples)));
    }
    let mut attributes = LayerAttributes::default();
    for &(keyword, text) in metadata {
        attributes.other.insert(utf8(keyword), AttributeValue::Text(utf8(text)));
    }
    if let Some((bins, means)) = spectral {
        for index in 0..bins.count() {
            let samples = means.iter().skip(index).step_by(bins.count()).copied().collect();
            let name = utf8(&channel_name(bins.center_nm(index)));
            channels.push(AnyChannel::new(name, FlatSamples::F32(samples)));
        }
        for (name, text) in [("spectralLayoutVersion", "1.0"), ("emissiveUnits", "W.m^-2.sr^-1")] {
            attributes.other.insert(utf8(name), AttributeValue::Text(utf8(text)));
        }
    }
    let size = Vec2(width as usize, height as usize);
    let layer = Layer::new(size, attributes, Encoding::SMALL_LOSSLESS, AnyChannels::sort(channels));
    let mut image = Image::from_layer(layer);
    image.attributes.chromaticities = Some(rec709());
    image.write().to_buffered(file).map_err(into_io)
}

/// Reads the texts of the first layer, but not those that the standard names.
pub(super) fn read_texts(file: File) -> io::Result<BTreeMap<String, String>> {
    let file = MetaData::read_from_buffered(BufReader::new(file), false).map_err(into_io)?;
    let mut texts = BTreeMap::new();
    for header in file.headers.iter().take(1) {
        for (keyword, value) in &header.own_attributes.other {
            if let AttributeValue::Text(text) = value {
                let string = |text: &Text| String::from_utf8_lossy(text.as_slice()).into_owned();
                texts.insert(string(keyword), string(text));
            }
        }
    }
    Ok(texts)
}

/// `S0` is the first Stokes component; the decimal sign is a comma because a point divides layers.
fn channel_name(lambda_nm: f64) -> String {
    let lambda_nm = format!("{lambda_nm:.3}").replace('.', ",");
    format!("S0.{lambda_nm}nm")
}

/// OpenEXR texts are UTF-8; the library's own conversion knows only Latin-1.
fn utf8(text: &str) -> Text {
    Text::from_slice_unchecked(text.as_bytes())
}

fn rec709() -> Chromaticities {
    let vec2 = |xy: DVec2| Vec2(xy.x as f32, xy.y as f32);
    let [red, green, blue] = REC709_PRIMARIES_XY.map(vec2);
    Chromaticities { red, green, blue, white: vec2(D65_XY) }
}

fn into_io(error: exr::error::Error) -> io::Error {
    match error {
        exr::error::Error::Io(error) => error,
        other => io::Error::other(other.to_string()),
    }
}
