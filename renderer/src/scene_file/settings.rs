//! Trace, display and still settings in a scene file.

use serde::de::value::MapAccessDeserializer;
use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use super::StillSettings;
use super::check::{choose, in_range};
use super::fault::{Fault, Under};
use crate::settings::{
    DisplaySettings, NoiseGoal, Splitting, ToneCurve, TraceSettings, WhitePoint,
};

#[derive(Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct TraceEntry {
    splitting: Option<String>,
    split_count: Option<f32>,
    significance_threshold: Option<f32>,
    roulette_threshold: Option<f32>,
    max_depth: Option<u32>,
    perturb: Option<bool>,
    bins: Option<u32>,
}

const SPLITTINGS: [(&str, Splitting); 2] =
    [("paper", Splitting::Paper), ("exact", Splitting::Exact)];

impl TraceEntry {
    pub(super) fn read(self) -> Result<TraceSettings, Fault> {
        let default = TraceSettings::default();
        let splitting = match self.splitting {
            Some(name) => choose(&name, &SPLITTINGS).under("splitting")?,
            None => default.splitting,
        };
        Ok(TraceSettings {
            splitting,
            split_count: in_range(
                "split_count",
                self.split_count.unwrap_or(default.split_count),
                &TraceSettings::SPLIT_COUNT,
            )?,
            significance_threshold: in_range(
                "significance_threshold",
                self.significance_threshold.unwrap_or(default.significance_threshold),
                &TraceSettings::SIGNIFICANCE_THRESHOLD,
            )?,
            roulette_threshold: in_range(
                "roulette_threshold",
                self.roulette_threshold.unwrap_or(default.roulette_threshold),
                &TraceSettings::ROULETTE_THRESHOLD,
            )?,
            max_depth: in_range(
                "max_depth",
                self.max_depth.unwrap_or(default.max_depth),
                &TraceSettings::MAX_DEPTH,
            )?,
            perturb: self.perturb.unwrap_or(default.perturb),
            bins: in_range("bins", self.bins.unwrap_or(default.bins), &TraceSettings::BINS)?,
        })
    }

    pub(super) fn write(settings: &TraceSettings) -> Self {
        let TraceSettings {
            splitting,
            split_count,
            significance_threshold,
            roulette_threshold,
            max_depth,
            perturb,
            bins,
        } = settings;
        let splitting = match splitting {
            Splitting::Paper => "paper",
            Splitting::Exact => "exact",
        };
        Self {
            splitting: Some(splitting.to_owned()),
            split_count: Some(*split_count),
            significance_threshold: Some(*significance_threshold),
            roulette_threshold: Some(*roulette_threshold),
            max_depth: Some(*max_depth),
            perturb: Some(*perturb),
            bins: Some(*bins),
        }
    }
}

#[derive(Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct DisplayEntry {
    exposure_ev: Option<f32>,
    white_point: Option<WhitePointEntry>,
    tone_curve: Option<String>,
    gamut_mapping: Option<bool>,
}

/// The name of a white point, or a table with a temperature.
#[derive(Serialize)]
#[serde(untagged)]
enum WhitePointEntry {
    Named(String),
    Table(TemperatureTable),
}

#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct TemperatureTable {
    kelvin: f32,
}

const WHITE_POINTS: [(&str, WhitePoint); 4] = [
    ("D65", WhitePoint::D65),
    ("D50", WhitePoint::D50),
    ("A", WhitePoint::A),
    ("equal-energy", WhitePoint::EqualEnergy),
];

const TONE_CURVES: [(&str, ToneCurve); 3] = [
    ("linear", ToneCurve::Linear),
    ("reinhard", ToneCurve::Reinhard),
    ("filmic", ToneCurve::Filmic),
];

impl<'de> Deserialize<'de> for WhitePointEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Forms;

        impl<'de> Visitor<'de> for Forms {
            type Value = WhitePointEntry;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("the name of a white point, or a table with `kelvin`")
            }

            fn visit_str<E>(self, name: &str) -> Result<WhitePointEntry, E> {
                Ok(WhitePointEntry::Named(name.to_owned()))
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<WhitePointEntry, A::Error> {
                TemperatureTable::deserialize(MapAccessDeserializer::new(map))
                    .map(WhitePointEntry::Table)
            }
        }

        deserializer.deserialize_any(Forms)
    }
}

impl WhitePointEntry {
    fn read(self) -> Result<WhitePoint, Fault> {
        match self {
            Self::Named(name) => choose(&name, &WHITE_POINTS),
            Self::Table(TemperatureTable { kelvin }) => {
                in_range("kelvin", kelvin, &DisplaySettings::TEMPERATURE_KELVIN)
                    .map(WhitePoint::Temperature)
            }
        }
    }

    fn write(white_point: WhitePoint) -> Self {
        let name = match white_point {
            WhitePoint::D65 => "D65",
            WhitePoint::D50 => "D50",
            WhitePoint::A => "A",
            WhitePoint::EqualEnergy => "equal-energy",
            WhitePoint::Temperature(kelvin) => return Self::Table(TemperatureTable { kelvin }),
        };
        Self::Named(name.to_owned())
    }
}

impl DisplayEntry {
    pub(super) fn read(self) -> Result<DisplaySettings, Fault> {
        let default = DisplaySettings::default();
        let white_point = match self.white_point {
            Some(entry) => entry.read().under("white_point")?,
            None => default.white_point,
        };
        let tone_curve = match self.tone_curve {
            Some(name) => choose(&name, &TONE_CURVES).under("tone_curve")?,
            None => default.tone_curve,
        };
        Ok(DisplaySettings {
            exposure_ev: in_range(
                "exposure_ev",
                self.exposure_ev.unwrap_or(default.exposure_ev),
                &DisplaySettings::EXPOSURE_EV,
            )?,
            white_point,
            tone_curve,
            gamut_mapping: self.gamut_mapping.unwrap_or(default.gamut_mapping),
        })
    }

    pub(super) fn write(settings: &DisplaySettings) -> Self {
        let DisplaySettings { exposure_ev, white_point, tone_curve, gamut_mapping } = settings;
        let tone_curve = match tone_curve {
            ToneCurve::Linear => "linear",
            ToneCurve::Reinhard => "reinhard",
            ToneCurve::Filmic => "filmic",
        };
        Self {
            exposure_ev: Some(*exposure_ev),
            white_point: Some(WhitePointEntry::write(*white_point)),
            tone_curve: Some(tone_curve.to_owned()),
            gamut_mapping: Some(*gamut_mapping),
        }
    }
}

#[derive(Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct StillEntry {
    size: Option<[u32; 2]>,
    passes: Option<u32>,
    noise_target: Option<f32>,
    adaptive: Option<bool>,
}

impl StillEntry {
    pub(super) fn read(self) -> Result<StillSettings, Fault> {
        let default = StillSettings::default();
        let size = self.size.unwrap_or(default.size);
        for (index, &pixels) in size.iter().enumerate() {
            in_range("size", pixels, &StillSettings::SIDE).map_err(|fault| {
                Fault::at(index, format!("{} pixels", fault.message())).under("size")
            })?;
        }
        let pixels = u64::from(size[0]) * u64::from(size[1]);
        if pixels > StillSettings::MAX_PIXELS {
            let allowed = StillSettings::MAX_PIXELS;
            return Err(Fault::at("size", format!("{pixels} pixels are more than {allowed}")));
        }
        let passes = self.passes.unwrap_or(default.passes);
        let target = self.noise_target.unwrap_or(default.noise.target);
        Ok(StillSettings {
            size,
            passes: in_range("passes", passes, &StillSettings::PASSES)?,
            noise: NoiseGoal {
                target: in_range("noise_target", target, &NoiseGoal::TARGET)?,
                is_adaptive: self.adaptive.unwrap_or(default.noise.is_adaptive),
            },
        })
    }

    pub(super) fn write(settings: &StillSettings) -> Self {
        let StillSettings { size, passes, noise: NoiseGoal { target, is_adaptive } } = settings;
        Self {
            size: Some(*size),
            passes: Some(*passes),
            noise_target: Some(*target),
            adaptive: Some(*is_adaptive),
        }
    }
}
