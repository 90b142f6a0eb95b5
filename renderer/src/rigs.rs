//! Preset lights, and the turning up and down of lights as a whole.

mod presets;

use std::f32::consts::FRAC_PI_2;

use crate::light::{DiscLight, Lights, SkyLight};

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

const RIGS: [Rig; 8] = [
    Rig {
        name: "Showroom",
        description: "Soft boxes and small spots in a dark room: light, dark and fire at once.",
        lights: presets::showroom,
    },
    Rig {
        name: "Nine spots",
        description: "Nine small white spots and a dim room, as in Thomas 1986: strong fire.",
        lights: presets::nine_spots,
    },
    Rig {
        name: "Jeweller's spots",
        description: "Five tiny halogen lamps over a dim shop: the hardest sparkle.",
        lights: presets::jewellers_spots,
    },
    Rig {
        name: "Daylight",
        description: "The sun at 50° in a clear sky: a few intense flashes.",
        lights: presets::daylight,
    },
    Rig {
        name: "Light tent",
        description: "Soft white light from nearly everywhere: shows brilliance, hides fire.",
        lights: presets::light_tent,
    },
    Rig {
        name: "Office",
        description: "Rows of fluorescent panels under a white ceiling: broad, pale reflections.",
        lights: presets::office,
    },
    Rig {
        name: "Candle",
        description: "One flame and its faint glow on the walls: warm, single flashes.",
        lights: presets::candle,
    },
    Rig {
        name: "Dark field",
        description: "A ring of lamps near the horizon under a dark dome: shows leakage and edges.",
        lights: presets::dark_field,
    },
];

/// The preset that a new scene has.
pub fn start() -> Lights {
    presets::showroom()
}

/// The presets, in the order of the menu.
pub fn rigs() -> &'static [Rig] {
    &RIGS
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

#[cfg(test)]
mod tests {
    use std::f32::consts::PI;

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
