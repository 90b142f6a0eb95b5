//! `WIDTHxHEIGHT`: the size of a picture.

use std::str::FromStr;

use brilliance_renderer::scene_file::StillSettings;

/// Width and height in pixels, within what a still allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct ImageSize(pub(super) [u32; 2]);

impl FromStr for ImageSize {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (width, height) = text
            .split_once(['x', 'X', '×'])
            .ok_or("give width and height in pixels with an x between, such as 1280x800")?;
        let size = [parse_side("width", width)?, parse_side("height", height)?];
        let most = StillSettings::MAX_PIXELS;
        if size.map(u64::from).iter().product::<u64>() > most {
            return Err(format!("these are more than the {most} pixels a picture may have"));
        }
        Ok(Self(size))
    }
}

fn parse_side(name: &str, text: &str) -> Result<u32, String> {
    let allowed = StillSettings::SIDE;
    text.parse().ok().filter(|side| allowed.contains(side)).ok_or_else(|| {
        let (least, most) = allowed.into_inner();
        format!("the {name} must be a whole number of pixels from {least} to {most}")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_read() {
        assert_eq!("1280x800".parse(), Ok(ImageSize([1280, 800])));
        assert_eq!("1X16384".parse(), Ok(ImageSize([1, 16_384])));
    }

    #[test]
    fn impossible_sizes_are_refused_with_the_side_named() {
        for (text, word) in [
            ("640", "x between"),
            ("0x10", "width"),
            ("10x16385", "height"),
            ("10x", "height"),
            ("-1x10", "width"),
            ("1e2x10", "width"),
            ("1x2x3", "height"),
            ("16384x16384", "67108864 pixels"),
        ] {
            let fault = text.parse::<ImageSize>().unwrap_err();
            assert!(fault.contains(word), "{text}: {fault}");
        }
    }
}
