//! The lights of each preset.
//!
//! Brightness is chosen for exposure 0: a white matte floor under one of these rigs has a radiance
//! near 1, which is an irradiance near π. Azimuths run from +x towards +y, the camera of a new
//! scene stands towards −y.

use std::f32::consts::PI;

use glam::DVec3;

use crate::light::{DiscLight, Lights, SkyLight};
use crate::spectrum::{Illuminant, Spectrum};

/// Half-angle of the black cone that a face-up stone shows as the observer's head, in degrees.
const HEAD_DEGREES: f64 = 10.0;

/// Six soft boxes and nine small spots in a dark room.
pub(crate) fn showroom() -> Lights {
    // Azimuth, elevation and angular radius in degrees, radiance.
    const SOFT_BOXES: [[f64; 4]; 6] = [
        [30.0, 55.0, 20.0, 1.1],
        [85.0, 25.0, 12.0, 0.4],
        [150.0, 40.0, 16.0, 0.7],
        [210.0, 20.0, 12.0, 0.5],
        [265.0, 60.0, 14.0, 0.9],
        [330.0, 25.0, 15.0, 0.6],
    ];
    // Azimuth, elevation and angular radius in degrees, share of π of the irradiance.
    const SPOTS: [[f64; 4]; 9] = [
        [8.0, 62.0, 1.5, 0.16],
        [52.0, 38.0, 1.2, 0.14],
        [97.0, 71.0, 1.6, 0.16],
        [131.0, 27.0, 1.2, 0.13],
        [169.0, 53.0, 1.3, 0.14],
        [214.0, 34.0, 1.2, 0.13],
        [247.0, 66.0, 1.5, 0.16],
        [291.0, 24.0, 1.3, 0.13],
        [328.0, 45.0, 1.6, 0.14],
    ];
    let soft_boxes = SOFT_BOXES.iter().enumerate().map(|(i, &[azimuth, elevation, radius, l])| {
        let name = format!("Soft box {}", i + 1);
        let light = disc(name, [azimuth, elevation], radius, 1.0, illuminant(Illuminant::D65));
        DiscLight { radiance: l as f32, ..light }
    });
    Lights {
        discs: soft_boxes.chain(spots(&SPOTS)).collect(),
        hemisphere: Some(SkyLight::daylight(0.05)),
        observer_shadow_radians: radians(HEAD_DEGREES),
        ..dark(0.02)
    }
}

/// Nine small spots spread irregularly over the upper hemisphere, and a dim hemisphere
/// (Thomas 1986, Fig. 7).
///
/// The paper does not print the positions; these are ours. The hemisphere is dim enough for what it
/// says of its diamonds: but for a few sparkles they return little light.
pub(crate) fn nine_spots() -> Lights {
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
    Lights {
        discs: spots(&SPOTS).collect(),
        hemisphere: Some(SkyLight::daylight(0.1)),
        observer_shadow_radians: radians(HEAD_DEGREES),
        ..dark(0.03)
    }
}

/// A few tiny and intense halogen spots in a dim shop.
pub(crate) fn jewellers_spots() -> Lights {
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
pub(crate) fn daylight() -> Lights {
    let d65 = illuminant(Illuminant::D65);
    Lights {
        discs: vec![disc("Sun".to_owned(), [35.0, 50.0], 0.265, PI, d65)],
        hemisphere: Some(SkyLight::daylight(0.4)),
        observer_shadow_radians: radians(HEAD_DEGREES),
        ..dark(0.05)
    }
}

/// A bright hemisphere and four large soft discs.
pub(crate) fn light_tent() -> Lights {
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
pub(crate) fn office() -> Lights {
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
pub(crate) fn candle() -> Lights {
    let flame = Spectrum::BlackBody { kelvin: 1850.0 };
    Lights {
        discs: vec![disc("Flame".to_owned(), [60.0, 35.0], 0.8, 0.8 * PI, flame.clone())],
        hemisphere: Some(SkyLight { radiance: 0.06, spectrum: flame }),
        observer_shadow_radians: radians(HEAD_DEGREES),
        ..dark(0.01)
    }
}

/// Twelve lamps near the horizon, and nothing above.
pub(crate) fn dark_field() -> Lights {
    let d65 = illuminant(Illuminant::D65);
    let discs = (0..12_u8).map(|index| {
        let azimuth = 30.0 * f64::from(index);
        disc(format!("Lamp {}", index + 1), [azimuth, 12.0], 6.0, 0.25 * PI, d65.clone())
    });
    Lights { discs: discs.collect(), ..dark(0.01) }
}

/// Daylight spots from azimuth, elevation and angular radius in degrees, and share of π of the
/// irradiance.
fn spots(spots: &[[f64; 4]]) -> impl Iterator<Item = DiscLight> {
    spots.iter().enumerate().map(|(i, &[azimuth, elevation, radius, share])| {
        let name = format!("Spot {}", i + 1);
        disc(name, [azimuth, elevation], radius, share as f32 * PI, illuminant(Illuminant::D65))
    })
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
