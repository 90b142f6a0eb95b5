//! What developing does to one colour, step by step.

use glam::{DVec3, Vec3};

use super::development::Development;
use crate::color::{self, Lab};
use crate::settings::DisplaySettings;
use crate::spectrum::Bins;

/// Differences of linear channels that only rounding makes.
const ROUNDING: f32 = 1e-5;

/// One colour on its way from the scene to the display: what developing makes of a pixel, by the
/// same code.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColorPath {
    /// CIE XYZ as the observer sees it in the scene.
    pub scene_xyz: DVec3,
    /// Linear Rec. 709 RGB, adapted to the display's white and exposed. Channels below 0 or above 1
    /// are colours that the display has not.
    pub exposed: [f32; 3],
    /// The same after the tone curve.
    pub toned: [f32; 3],
    /// The same as it is shown: each channel in 0..=1.
    pub shown: [f32; 3],
    /// The sRGB codes that are shown.
    pub srgb8: [u8; 3],
}

/// Why a display can't show a colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GamutFault {
    /// It is purer than any mixture of the display's three lights, at any luminance.
    TooPure,
    /// The display has the hue and purity, but not at this luminance.
    TooBright,
    /// It is at least as bright as the display's white, so that only white is left.
    BeyondWhite,
}

/// How far a colour was moved to be shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GamutShift {
    /// Why it was moved.
    pub fault: GamutFault,
    /// How much of its distance from the white of equal luminance was lost, in 0..=1: 1 is white.
    /// Clipping instead of gamut mapping turns the hue besides.
    pub towards_white: f64,
    /// Distance in the u′, v′ diagram.
    pub uv_prime: f64,
    /// Colour difference ΔE₀₀ beside the display's white.
    pub delta_e_2000: f64,
}

impl ColorPath {
    /// Develops `scene_xyz`, recorded by a film of these bins, as a pixel of that colour.
    pub fn new(scene_xyz: DVec3, bins: Bins, settings: &DisplaySettings) -> Self {
        let stages = Development::new(settings, bins).stages_of(scene_xyz.as_vec3().to_array());
        let encode = |channel: f32| (255.0 * color::srgb_encode(channel.into())).round() as u8;
        Self {
            scene_xyz,
            exposed: stages.exposed,
            toned: stages.toned,
            shown: stages.shown,
            srgb8: stages.shown.map(encode),
        }
    }

    /// Whether there is a colour at all: finite, and of more than no luminance.
    pub fn is_color(&self) -> bool {
        let exposed = Vec3::from(self.exposed);
        exposed.is_finite() && display_xyz(self.exposed).y > 0.0
    }

    /// CIE XYZ adapted to the display's white and exposed, before the tone curve.
    pub fn exposed_xyz(&self) -> DVec3 {
        display_xyz(self.exposed)
    }

    /// CIE XYZ of what is shown, in which the display's white has Y = 1.
    pub fn shown_xyz(&self) -> DVec3 {
        display_xyz(self.shown)
    }

    /// How the colour was moved because the display has not got it; none where it has, or where
    /// there is no colour.
    pub fn gamut_shift(&self) -> Option<GamutShift> {
        let mut channels = self.toned.iter().zip(&self.shown);
        if !self.is_color() || channels.all(|(toned, shown)| (toned - shown).abs() < ROUNDING) {
            return None;
        }
        let (wanted, shown) = (display_xyz(self.toned), self.shown_xyz());
        let low = self.toned.iter().fold(f32::INFINITY, |low, &channel| low.min(channel));
        let from_white = |rgb: [f32; 3], y: f64| (Vec3::from(rgb).as_dvec3() - y).length();
        let distance = from_white(self.toned, wanted.y).max(ROUNDING.into());
        let lost = 1.0 - from_white(self.shown, shown.y) / distance;
        let fault = if wanted.y >= 1.0 {
            GamutFault::BeyondWhite
        } else if low < 0.0 {
            GamutFault::TooPure
        } else {
            GamutFault::TooBright
        };
        let white = color::d65_white();
        Some(GamutShift {
            fault,
            towards_white: lost.clamp(0.0, 1.0),
            uv_prime: color::uv_prime(wanted).distance(color::uv_prime(shown)),
            delta_e_2000: Lab::from_xyz(wanted, white).delta_e_2000(Lab::from_xyz(shown, white)),
        })
    }
}

/// CIE XYZ of a linear display colour.
fn display_xyz(rgb: [f32; 3]) -> DVec3 {
    color::xyz_from_rec709() * Vec3::from(rgb).as_dvec3()
}
