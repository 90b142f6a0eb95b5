//! Preset lights.
//!
//! Brightness is chosen for exposure 0: a white matte floor under one of these rigs has a radiance
//! near 1, which is an irradiance near π. Azimuths run from +x towards +y, the camera of a new
//! scene stands towards −y.

use std::f32::consts::{FRAC_PI_2, PI};

use glam::DVec3;

use crate::light::{DiscLight, Lights, SkyLight};
use crate::spectrum::{Illuminant, Spectrum};

/// Half-angle of the black cone that a face-up stone shows as the observer's head, in degrees.
const HEAD_DEGREES: f64 = 10.0;

/// A preset of lights.
#[derive(Clone, Copy, Debug)]
pub struct Rig {
    /// Its name in the menu and in scene files.
    pub name: &'static str,
    /// What it is and what it shows, in one sentence.
    pub description: &'static str,
    /// Makes the lights.
    pub lights: fn() -> Lights,
}

const RIGS: [Rig; 7] = [
    Rig {
        name: "Nine spots",
        description: "Nine small white spots and a dim room, as in Thomas 1986: strong fire.",
        lights: nine_spots,
    },
    Rig {
        name: "Jeweller's spots",
        description: "Five tiny halogen lamps over a dim shop: the hardest sparkle.",
        lights: jewellers_spots,
    },
    Rig {
        name: "Daylight",
        description: "The sun at 50° in a clear sky: a few intense flashes.",
        lights: daylight,
    },
    Rig {
        name: "Light tent",
        description: "Soft white light from nearly everywhere: shows brilliance, hides fire.",
        lights: light_tent,
    },
    Rig {
        name: "Office",
        description: "Rows of fluorescent panels under a white ceiling: broad, pale reflections.",
        lights: office,
    },
    Rig {
        name: "Candle",
        description: "One flame and its faint glow on the walls: warm, single flashes.",
        lights: candle,
    },
    Rig {
        name: "Dark field",
        description: "A ring of lamps near the horizon under a dark dome: shows leakage and edges.",
        lights: dark_field,
    },
];

/// The presets, in the order of the menu.
pub fn rigs() -> &'static [Rig] {
    &RIGS
}

/// Nine small spots spread irregularly over the upper hemisphere, and a dim hemisphere
/// (Thomas 1986, Fig. 7).
///
/// The paper does not print the positions; these are ours.
pub fn nine_spots() -> Lights {
    // Azimuth, elevation and angular radius in degrees, share of π of the irradiance.
    const SPOTS: [[f64; 4]; 9] = [
        [8.0, 62.0, 1.5, 0.16],
        [52.0, 38.0, 1.2, 0.14],
        [97.0, 71.0, 1.8, 0.16],
        [131.0, 27.0, 1.0, 0.12],
        [169.0, 53.0, 1.4, 0.14],
        [214.0, 34.0, 1.1, 0.12],
        [247.0, 66.0, 1.6, 0.16],
        [291.0, 24.0, 1.3, 0.12],
        [328.0, 45.0, 2.0, 0.14],
    ];
    let discs = SPOTS.iter().enumerate().map(|(index, &[azimuth, elevation, radius, share])| {
        let name = format!("Spot {}", index + 1);
        disc(name, [azimuth, elevation], radius, share as f32 * PI, illuminant(Illuminant::D65))
    });
    Lights {
        discs: discs.collect(),
        hemisphere: Some(SkyLight::daylight(0.25)),
        observer_shadow_radians: radians(HEAD_DEGREES),
        ..dark(0.03)
    }
}

/// A few tiny and intense halogen spots in a dim shop.
pub fn jewellers_spots() -> Lights {
    const SPOTS: [[f64; 2]; 5] =
        [[25.0, 58.0], [80.0, 72.0], [150.0, 47.0], [205.0, 64.0], [310.0, 52.0]];
    let halogen = Spectrum::BlackBody { kelvin: 3200.0 };
    let discs = SPOTS.iter().enumerate().map(|(index, &towards)| {
        disc(format!("Halogen {}", index + 1), towards, 0.5, 0.22 * PI, halogen.clone())
    });
    Lights {
        discs: discs.collect(),
        hemisphere: Some(SkyLight { radiance: 0.12, spectrum: halogen.clone() }),
        observer_shadow_radians: radians(HEAD_DEGREES),
        ..dark(0.02)
    }
}

/// The sun (angular radius 0.265°) and the sky.
pub fn daylight() -> Lights {
    let d65 = illuminant(Illuminant::D65);
    Lights {
        discs: vec![disc("Sun".to_owned(), [35.0, 50.0], 0.265, PI, d65)],
        hemisphere: Some(SkyLight::daylight(0.4)),
        observer_shadow_radians: radians(HEAD_DEGREES),
        ..dark(0.05)
    }
}

/// A bright hemisphere and four large soft discs.
pub fn light_tent() -> Lights {
    let d65 = illuminant(Illuminant::D65);
    let discs = [45.0, 135.0, 225.0, 315.0].iter().enumerate().map(|(index, &azimuth)| {
        disc(format!("Soft box {}", index + 1), [azimuth, 45.0], 20.0, 0.1 * PI, d65.clone())
    });
    Lights {
        discs: discs.collect(),
        hemisphere: Some(SkyLight::daylight(0.75)),
        observer_shadow_radians: radians(1.5 * HEAD_DEGREES),
        ..dark(0.05)
    }
}

/// Two rows of fluorescent panels, each panel three overlapping soft discs in a line.
pub fn office() -> Lights {
    let f11 = illuminant(Illuminant::F11);
    let mut discs = Vec::new();
    // Panels hang one length above the stone, beside, before and behind the observer.
    for (row, x) in [-0.55, 0.55].into_iter().enumerate() {
        for (column, y) in [-0.9, 0.0, 0.9].into_iter().enumerate() {
            for (part, offset) in [-0.16, 0.0, 0.16].into_iter().enumerate() {
                let towards = DVec3::new(x, y + offset, 1.0).normalize();
                discs.push(DiscLight {
                    name: format!("Panel {}.{}", 3 * row + column + 1, part + 1),
                    direction: towards.as_vec3(),
                    angular_radius_radians: radians(5.0),
                    radiance: 0.0,
                    spectrum: f11.clone(),
                });
            }
        }
    }
    let share = 0.75 * PI / discs.len() as f32;
    for light in &mut discs {
        light.radiance = share / light.solid_angle_steradians();
    }
    Lights {
        discs,
        hemisphere: Some(SkyLight { radiance: 0.35, spectrum: f11 }),
        observer_shadow_radians: radians(HEAD_DEGREES),
        ..dark(0.05)
    }
}

/// One candle at arm's length.
pub fn candle() -> Lights {
    let flame = Spectrum::BlackBody { kelvin: 1850.0 };
    Lights {
        discs: vec![disc("Flame".to_owned(), [60.0, 35.0], 0.8, 0.8 * PI, flame.clone())],
        hemisphere: Some(SkyLight { radiance: 0.06, spectrum: flame }),
        observer_shadow_radians: radians(HEAD_DEGREES),
        ..dark(0.01)
    }
}

/// Twelve lamps near the horizon, and nothing above.
pub fn dark_field() -> Lights {
    let d65 = illuminant(Illuminant::D65);
    let discs = (0..12_u8).map(|index| {
        let azimuth = 30.0 * f64::from(index);
        disc(format!("Lamp {}", index + 1), [azimuth, 12.0], 6.0, 0.25 * PI, d65.clone())
    });
    Lights { discs: discs.collect(), ..dark(0.01) }
}

/// The lights with the discs' radii multiplied by `size_factor` (to at most a half-sky), their
/// irradiance by `brightness_factor`, and hemisphere and environment by `ambient_factor`.
///
/// A larger disc of the same brightness is dimmer per solid angle: the size alone changes how soft
/// the light is, not how light the floor.
#[must_use]
pub fn scaled(
    lights: &Lights,
    size_factor: f32,
    brightness_factor: f32,
    ambient_factor: f32,
) -> Lights {
    let scaled_disc = |light: &DiscLight| {
        let radius = (light.angular_radius_radians * size_factor).clamp(f32::EPSILON, FRAC_PI_2);
        let mut scaled = DiscLight { angular_radius_radians: radius, ..light.clone() };
        let solid_angles = light.solid_angle_steradians() / scaled.solid_angle_steradians();
        // At size 1 not even the last bit may change, or the picture would start again.
        let dilution = if radius == light.angular_radius_radians { 1.0 } else { solid_angles };
        scaled.radiance *= brightness_factor * dilution;
        scaled
    };
    let scaled_sky =
        |sky: &SkyLight| SkyLight { radiance: sky.radiance * ambient_factor, ..sky.clone() };
    Lights {
        discs: lights.discs.iter().map(scaled_disc).collect(),
        hemisphere: lights.hemisphere.as_ref().map(scaled_sky),
        environment: lights.environment.as_ref().map(scaled_sky),
        ..lights.clone()
    }
}

fn illuminant(illuminant: Illuminant) -> Spectrum {
    Spectrum::Illuminant(illuminant)
}

fn radians(degrees: f64) -> f32 {
    degrees.to_radians() as f32
}

/// No light but a neutral backdrop of this radiance.
fn dark(backdrop_radiance: f32) -> Lights {
    Lights { backdrop: Some(SkyLight::daylight(backdrop_radiance)), ..Lights::default() }
}

/// A disc at an azimuth and elevation in degrees, that gives a surface facing it this irradiance.
fn disc(
    name: String,
    [azimuth, elevation]: [f64; 2],
    radius_degrees: f64,
    irradiance: f32,
    spectrum: Spectrum,
) -> DiscLight {
    let (sin_a, cos_a) = azimuth.to_radians().sin_cos();
    let (sin_e, cos_e) = elevation.to_radians().sin_cos();
    let mut light = DiscLight {
        name,
        direction: DVec3::new(cos_e * cos_a, cos_e * sin_a, sin_e).as_vec3(),
        angular_radius_radians: radians(radius_degrees),
        radiance: 1.0,
        spectrum,
    };
    light.radiance = irradiance / light.solid_angle_steradians();
    light
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Irradiance on a horizontal floor, without shadows.
    fn floor_irradiance(lights: &Lights) -> f32 {
        let discs: f32 = lights
            .discs
            .iter()
            .map(|disc| disc.radiance * disc.solid_angle_steradians() * disc.direction.z)
            .sum();
        let sky = lights.hemisphere.as_ref().map_or(0.0, |sky| sky.radiance);
        discs + PI * sky
    }

    #[test]
    fn a_white_floor_is_near_white_at_exposure_0() {
        for rig in rigs() {
            let radiance = floor_irradiance(&(rig.lights)()) / PI;
            assert!((0.4..=1.6).contains(&radiance), "{}: {radiance}", rig.name);
        }
    }

    #[test]
    fn directions_are_unit_vectors_above_the_horizon_and_discs_lie_wholly_above() {
        for rig in rigs() {
            for disc in (rig.lights)().discs {
                assert!(disc.direction.is_normalized(), "{}: {}", rig.name, disc.name);
                assert!(disc.direction.z > disc.angular_radius_radians.sin(), "{}", disc.name);
                assert!(disc.radiance > 0.0 && disc.radiance.is_finite());
            }
        }
    }

    #[test]
    fn scaling_by_1_changes_no_bit_and_size_keeps_the_floor_as_light_as_it_was() {
        for rig in rigs() {
            let lights = (rig.lights)();
            assert_eq!(scaled(&lights, 1.0, 1.0, 1.0), lights);
            let larger = scaled(&lights, 2.0, 1.0, 1.0);
            let ratio = floor_irradiance(&larger) / floor_irradiance(&lights);
            assert!((ratio - 1.0).abs() < 1e-5, "{}: {ratio}", rig.name);
            let brighter = scaled(&lights, 1.0, 3.0, 3.0);
            let ratio = floor_irradiance(&brighter) / floor_irradiance(&lights);
            assert!((ratio - 3.0).abs() < 1e-5, "{}: {ratio}", rig.name);
        }
    }
}
