//! The two kinds of settings. Changing [`TraceSettings`] restarts the film; changing
//! [`DisplaySettings`] only develops it again.

use std::ops::RangeInclusive;

use bytemuck::NoUninit;
use serde::{Deserialize, Serialize};

/// How a dispersed ray is divided over the spectrum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Splitting {
    /// Thomas 1986, to the letter: equal wavelength steps, prorated light overlap.
    Paper,
    /// Three wavelengths per interval, each on its own way; the interval is divided where the ways part
    /// and lights are cut out of it.
    #[default]
    Exact,
}

/// Everything that decides what the film records, beside the scene and the camera.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TraceSettings {
    /// How dispersed rays are divided.
    pub splitting: Splitting,
    /// K: sub-rays that should hit the smallest light (Thomas 1986 found six; [`Splitting::Paper`]).
    pub split_count: f32,
    /// Rays whose weight falls below this are ended and their energy counted as pruned
    /// ([`Splitting::Paper`]).
    pub significance_threshold: f32,
    /// Fans that carry less than this part of the camera ray's energy live on by chance, and then carry
    /// more, so that in the mean nothing is lost ([`Splitting::Exact`]). Fans that carry less than
    /// [`cut_share`](Self::cut_share) of that are not divided any more.
    pub roulette_threshold: f32,
    /// Interfaces a ray may meet before it is cut off: a back-up to the significance. In a diamond
    /// tilted by 35°, 32 interfaces keep 98.8 % of the light that enters it, 256 nearly all.
    pub max_depth: u32,
    /// Spreads the incident interval over the sub-rays (`perturb`); off shows the clumping of Fig. 3.
    pub perturb: bool,
    /// Number of spectral bins of the film over 380–730 nm.
    pub bins: u32,
}

impl TraceSettings {
    /// Allowed [`split_count`](Self::split_count).
    pub const SPLIT_COUNT: RangeInclusive<f32> = 0.0..=24.0;
    /// Allowed [`significance_threshold`](Self::significance_threshold).
    pub const SIGNIFICANCE_THRESHOLD: RangeInclusive<f32> = 1e-6..=0.5;
    /// Allowed [`roulette_threshold`](Self::roulette_threshold).
    pub const ROULETTE_THRESHOLD: RangeInclusive<f32> = 1e-6..=0.5;
    /// [`roulette_threshold`](Self::roulette_threshold) of drafts.
    pub const DRAFT_ROULETTE: f32 = 0.2;
    /// Allowed [`max_depth`](Self::max_depth).
    pub const MAX_DEPTH: RangeInclusive<u32> = 1..=1024;
    /// Allowed [`bins`](Self::bins).
    pub const BINS: RangeInclusive<u32> = 4..=64;
}

impl TraceSettings {
    /// Energy below which a fan is not divided, over that below which it lives by chance. That makes
    /// errors that passes don't take away, so they are small beside those of chance; but in a draft, which
    /// is of one pass, parts that lived by chance would be specks of colour.
    pub fn cut_share(&self) -> f32 {
        if self.roulette_threshold < Self::DRAFT_ROULETTE { 0.1 } else { 3.0 }
    }

    /// The same with less effort, for a picture that is shown for a moment while things change:
    /// about a tenth of the rays in a diamond, by the same rules.
    #[must_use]
    pub fn draft(&self) -> Self {
        Self {
            split_count: self.split_count.min(1.0),
            significance_threshold: self.significance_threshold.max(1e-2),
            roulette_threshold: self.roulette_threshold.max(Self::DRAFT_ROULETTE),
            max_depth: self.max_depth.min(24),
            ..self.clone()
        }
    }
}

impl Default for TraceSettings {
    fn default() -> Self {
        Self {
            splitting: Splitting::Exact,
            split_count: 6.0,
            significance_threshold: 1e-3,
            roulette_threshold: 0.003,
            max_depth: 256,
            perturb: true,
            bins: 16,
        }
    }
}

/// When a picture is good enough, and which pixels its later passes trace. Changing it restarts
/// nothing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct NoiseGoal {
    /// The picture is done when its [noise](crate::film::Film::measure_noise) is no more than
    /// this; 0 for any noise until all passes are done.
    pub target: f32,
    /// Passes leave out the pixels that have no more noise than the target.
    pub is_adaptive: bool,
}

impl NoiseGoal {
    /// Allowed [`target`](Self::target).
    pub const TARGET: RangeInclusive<f32> = 0.0..=0.1;
    /// All passes for all pixels.
    pub const NONE: Self = Self { target: 0.0, is_adaptive: false };

    /// Whether there is a target.
    pub fn is_set(self) -> bool {
        self.target > 0.0
    }

    /// Whether a picture of this noise is done.
    pub fn is_reached(self, noise: f32) -> bool {
        self.is_set() && noise <= self.target
    }

    /// Whether passes may leave out pixels.
    pub fn adapts(self) -> bool {
        self.is_set() && self.is_adaptive
    }

    /// Whether passes leave out a pixel of this noise.
    pub fn settles(self, noise: f32) -> bool {
        self.adapts() && noise <= self.target
    }
}

impl Default for NoiseGoal {
    fn default() -> Self {
        Self { target: 0.02, is_adaptive: true }
    }
}

/// How luminance above the display's white is brought into range.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, NoUninit, Serialize, Deserialize)]
#[repr(u32)]
#[serde(rename_all = "kebab-case")]
pub enum ToneCurve {
    /// Proportional up to white, clipped above it.
    Linear,
    /// Reinhard 2002 with a white level: gentle shoulder.
    Reinhard,
    /// A film-like toe and shoulder.
    #[default]
    Filmic,
}

/// The light that is shown as neutral.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum WhitePoint {
    /// The equal-energy spectrum.
    EqualEnergy,
    /// CIE standard illuminant D65.
    #[default]
    D65,
    /// CIE standard illuminant D50.
    D50,
    /// CIE standard illuminant A.
    A,
    /// A black body of this temperature in kelvin.
    Temperature(f32),
}

/// Everything that decides how a finished film looks; none of it retraces a ray.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DisplaySettings {
    /// Exposure in stops: 0 shows radiance 1 as luminance 1.
    pub exposure_ev: f32,
    /// The light that is shown as neutral.
    pub white_point: WhitePoint,
    /// How bright values are compressed.
    pub tone_curve: ToneCurve,
    /// Desaturates colours outside the display's gamut towards the white of equal luminance;
    /// off clips each channel.
    pub gamut_mapping: bool,
}

impl DisplaySettings {
    /// Allowed [`exposure_ev`](Self::exposure_ev).
    pub const EXPOSURE_EV: RangeInclusive<f32> = -10.0..=10.0;
    /// Allowed temperature of [`WhitePoint::Temperature`].
    pub const TEMPERATURE_KELVIN: RangeInclusive<f32> = 1500.0..=20000.0;
}

impl Default for DisplaySettings {
    fn default() -> Self {
        Self {
            exposure_ev: 0.0,
            white_point: WhitePoint::default(),
            tone_curve: ToneCurve::default(),
            gamut_mapping: true,
        }
    }
}
