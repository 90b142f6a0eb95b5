//! What is printed on a matte surface.

use std::sync::Arc;

use glam::Vec3;

use super::Image;

/// An image on a matte surface, of which it takes light away: white leaves the surface as it is.
///
/// A texel's reflectance is the smooth one of its colour ([`Spectrum::Rgb`]); between texels it is
/// mixed from the nearest four. Rays have no footprint: where texels are finer than pixels, it is
/// the passes that average them.
///
/// [`Spectrum::Rgb`]: crate::spectrum::Spectrum::Rgb
#[derive(Clone, Debug)]
pub struct Print {
    /// The image.
    pub image: Arc<Image>,
    /// How it lies on the surface.
    pub layout: Layout,
    /// What is beyond the image, to its sides and above and below it.
    pub outside: [Outside; 2],
    /// Linear sRGB that each texel is multiplied by, each channel in 0..=1.
    pub tint: [f32; 3],
}

impl PartialEq for Print {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.image, &other.image)
            && self.layout == other.layout
            && self.outside == other.outside
            && self.tint == other.tint
    }
}

/// How an image lies on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Layout {
    /// Projected straight onto all that faces one side.
    Planar(Planar),
    /// By the texture coordinates of the mesh.
    Coordinates,
}

/// An image that is projected straight onto a body; its middle is the body's origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Planar {
    /// Unit vector in the body's frame towards whom the image faces.
    pub facing: Vec3,
    /// Unit vector in the body's frame, at right angles to `facing`: upwards in the image.
    pub up: Vec3,
    /// Width and height in millimetres of the body's frame, greater than 0.
    pub size_mm: [f32; 2],
}

/// What a surface shows beyond the image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Outside {
    /// Nothing: the surface is bare there.
    Bare,
    /// The outermost texels.
    Edge,
    /// The image again.
    Repeat,
    /// The image again, each time mirrored.
    Mirror,
}
