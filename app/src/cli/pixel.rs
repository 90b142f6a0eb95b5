//! `X,Y`: a pixel.

use std::str::FromStr;

/// Column and row of a pixel, counted from 0 at the upper left corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pixel(pub(super) [u32; 2]);

impl FromStr for Pixel {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        text.split_once(',')
            .and_then(|(x, y)| Some(Self([x.trim().parse().ok()?, y.trim().parse().ok()?])))
            .ok_or_else(|| {
                "give the pixel's column and row, counted from 0 at the upper left corner, with a \
                 comma between, such as 320,200"
                    .to_owned()
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_are_read() {
        assert_eq!("320,200".parse(), Ok(Pixel([320, 200])));
        assert_eq!("0, 7".parse(), Ok(Pixel([0, 7])));
        for text in ["", "3", "3;4", "3,4,5", "-1,2", "1.5,2", ","] {
            assert!(text.parse::<Pixel>().is_err(), "{text}");
        }
    }
}
