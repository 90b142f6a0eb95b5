//! A part of a picture, whatever the number of its pixels.

use std::fmt;

/// A rectangle of a picture in fractions of its width and height, from the upper left corner: a
/// draft and the whole film show the same there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Region {
    min: [f64; 2],
    max: [f64; 2],
}

/// A rectangle of a film's pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelRect {
    /// Column and row of the upper left pixel, from the upper left of the film.
    pub min: [u32; 2],
    /// Width and height in pixels, each at least 1.
    pub size: [u32; 2],
}

impl Region {
    /// The whole picture.
    pub const WHOLE: Self = Self { min: [0.0; 2], max: [1.0; 2] };

    /// The rectangle between two opposite corners, in any order, as far as it lies in the picture.
    pub fn between(corner: [f64; 2], opposite: [f64; 2]) -> Self {
        let pick = |pick: fn(f64, f64) -> f64| {
            std::array::from_fn(|axis| pick(corner[axis], opposite[axis]).clamp(0.0, 1.0))
        };
        Self { min: pick(f64::min), max: pick(f64::max) }
    }

    /// The region of the pixel that holds the point `at`, in fractions, of a picture of `size`.
    pub fn of_pixel_at(at: [f64; 2], size: [u32; 2]) -> Self {
        let pixel = std::array::from_fn(|axis| pixel_at(at[axis], size[axis]));
        Self::of(PixelRect { min: pixel, size: [1, 1] }, size)
    }

    /// The region that these pixels of a picture of `size` cover.
    pub fn of(pixels: PixelRect, size: [u32; 2]) -> Self {
        let fraction = |pixel: [u32; 2]| {
            std::array::from_fn(|axis| f64::from(pixel[axis]) / f64::from(size[axis].max(1)))
        };
        let end = std::array::from_fn(|axis| pixels.min[axis].saturating_add(pixels.size[axis]));
        Self::between(fraction(pixels.min), fraction(end))
    }

    /// The upper left corner, in fractions.
    pub fn min(&self) -> [f64; 2] {
        self.min
    }

    /// The lower right corner, in fractions.
    pub fn max(&self) -> [f64; 2] {
        self.max
    }

    /// The pixels of a film of `size` whose centres lie inside; where there is none between two
    /// sides, the one in the middle. Never empty.
    pub fn pixels(&self, size: [u32; 2]) -> PixelRect {
        let spans: [[u32; 2]; 2] = std::array::from_fn(|axis| {
            let (low, high, count) = (self.min[axis], self.max[axis], size[axis]);
            let first_centre_after = |side: f64| (side * f64::from(count) - 0.5).ceil() as u32;
            let first = first_centre_after(low);
            let end = first_centre_after(high).min(count);
            if first < end {
                [first, end - first]
            } else {
                [pixel_at(0.5 * (low + high), count), 1]
            }
        });
        PixelRect { min: spans.map(|[first, _]| first), size: spans.map(|[_, count]| count) }
    }
}

impl PixelRect {
    /// Number of pixels.
    pub fn count(&self) -> u64 {
        u64::from(self.size[0]) * u64::from(self.size[1])
    }

    /// Column and row of the pixel in the middle, the upper left of them where there are several.
    pub fn middle(&self) -> [u32; 2] {
        [0, 1].map(|axis| self.min[axis] + self.size[axis].saturating_sub(1) / 2)
    }

    /// The part that lies in a film of `size`; none where nothing does.
    pub fn within(&self, size: [u32; 2]) -> Option<Self> {
        let cut = std::array::from_fn(|axis| {
            self.size[axis].min(size[axis].saturating_sub(self.min[axis]))
        });
        (cut[0] > 0 && cut[1] > 0).then_some(Self { min: self.min, size: cut })
    }
}

impl fmt::Display for PixelRect {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { min: [x, y], size: [width, height] } = self;
        match self.count() {
            1 => write!(formatter, "pixel {x}, {y}"),
            _ => write!(formatter, "{width} \u{d7} {height} pixels at {x}, {y}"),
        }
    }
}

/// The pixel of `count` in a line that holds the fraction `at`.
fn pixel_at(at: f64, count: u32) -> u32 {
    ((at * f64::from(count)).floor() as u32).min(count.saturating_sub(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_is_its_own_region() {
        for size in [[1, 1], [7, 3], [1920, 1080], [8191, 8192]] {
            for share in [[0.0, 0.0], [0.3, 0.9], [0.999_999_9, 0.5], [1.0, 1.0]] {
                let min = std::array::from_fn(|axis| pixel_at(share[axis], size[axis]));
                let pixel = PixelRect { min, size: [1, 1] };
                assert_eq!(Region::of_pixel_at(share, size), Region::of(pixel, size));
                assert_eq!(Region::of(pixel, size).pixels(size), pixel, "{size:?}");
            }
        }
    }

    #[test]
    fn a_region_covers_the_same_part_of_a_draft() {
        let region = Region::of(PixelRect { min: [96, 24], size: [32, 48] }, [320, 240]);
        assert_eq!(region.pixels([320, 240]), PixelRect { min: [96, 24], size: [32, 48] });
        assert_eq!(region.pixels([40, 30]), PixelRect { min: [12, 3], size: [4, 6] });
        // A pixel is smaller than those of a draft: the one that it lies in.
        let pixel = Region::of(PixelRect { min: [101, 239], size: [1, 1] }, [320, 240]);
        assert_eq!(pixel.pixels([40, 30]), PixelRect { min: [12, 29], size: [1, 1] });
    }

    #[test]
    fn what_is_dragged_beyond_the_picture_stops_at_its_edge() {
        let region = Region::between([1.4, 0.5], [0.5, -3.0]);
        assert_eq!((region.min(), region.max()), ([0.5, 0.0], [1.0, 0.5]));
        assert_eq!(region.pixels([100, 10]), PixelRect { min: [50, 0], size: [50, 5] });
        let outside = Region::between([2.0, 2.0], [3.0, 3.0]);
        assert_eq!(outside.pixels([100, 10]), PixelRect { min: [99, 9], size: [1, 1] });
        let nowhere = Region::between([f64::NAN; 2], [f64::NAN; 2]).pixels([4, 4]);
        assert_eq!(nowhere.size, [1, 1]);
    }

    #[test]
    fn a_rectangle_of_pixels_is_cut_at_the_film() {
        let rect = PixelRect { min: [3, 1], size: [4, 4] };
        assert_eq!(rect.within([5, 9]), Some(PixelRect { min: [3, 1], size: [2, 4] }));
        assert_eq!(rect.within([3, 9]), None);
        assert_eq!(rect.count(), 16);
        assert_eq!(rect.to_string(), "4 \u{d7} 4 pixels at 3, 1");
        let pixel = PixelRect { min: rect.middle(), size: [1, 1] };
        assert_eq!(pixel.to_string(), "pixel 4, 2");
    }
}
