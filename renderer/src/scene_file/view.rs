//! The ground and the camera in a scene file.

use glam::Vec3;
use serde::{Deserialize, Serialize};

use super::angle;
use super::check::{in_range, positive, unit_vector};
use super::fault::{Fault, Under};
use super::spectrum::{Quantity, SpectrumEntry};
use crate::camera::Camera;
use crate::scene::Ground;

/// Allowed vertical field of view, in degrees.
const FOV_Y_DEGREES: std::ops::RangeInclusive<f64> = 0.01..=170.0;

#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct GroundEntry {
    height_mm: f32,
    #[serde(default = "five")]
    square_mm: f32,
    #[serde(default = "white_and_gray")]
    reflectance: [SpectrumEntry; 2],
}

fn five() -> f32 {
    5.0
}

fn white_and_gray() -> [SpectrumEntry; 2] {
    [SpectrumEntry::Flat(0.8), SpectrumEntry::Flat(0.3)]
}

impl GroundEntry {
    pub(super) fn read(self) -> Result<Ground, Fault> {
        let square = |index: usize, entry: SpectrumEntry| {
            entry.read(Quantity::Reflectance).under(index).under("reflectance")
        };
        let [first, second] = self.reflectance;
        Ok(Ground {
            height: self.height_mm,
            square: positive("square_mm", self.square_mm)?,
            reflectance: [square(0, first)?, square(1, second)?],
        })
    }

    pub(super) fn write(ground: &Ground) -> Self {
        let Ground { height, square, reflectance } = ground;
        let [first, second] = reflectance;
        Self {
            height_mm: *height,
            square_mm: *square,
            reflectance: [SpectrumEntry::write(first), SpectrumEntry::write(second)],
        }
    }
}

#[derive(Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CameraEntry {
    position_mm: Option<[f32; 3]>,
    target_mm: Option<[f32; 3]>,
    up: Option<[f32; 3]>,
    fov_y_degrees: Option<f64>,
}

impl CameraEntry {
    pub(super) fn read(self) -> Result<Camera, Fault> {
        let default = Camera::default();
        let fov_y_radians = match self.fov_y_degrees {
            Some(degrees) => angle::radians(in_range("fov_y_degrees", degrees, &FOV_Y_DEGREES)?),
            None => default.fov_y_radians,
        };
        let camera = Camera {
            position: self.position_mm.map_or(default.position, Vec3::from_array),
            target: self.target_mm.map_or(default.target, Vec3::from_array),
            up: self.up.map_or(Ok(default.up), |up| unit_vector("up", up))?,
            fov_y_radians,
        };
        let view = camera.target.as_dvec3() - camera.position.as_dvec3();
        let Some(forward) = view.try_normalize() else {
            return Err(Fault::at("position_mm", "the eye is on the target; move one of them"));
        };
        if forward.cross(camera.up.as_dvec3()).length() < 1e-4 {
            return Err(Fault::at(
                "up",
                "it is parallel to the view; give a direction that is upwards in the picture, \
                 such as [0, 1, 0] for a view from above",
            ));
        }
        Ok(camera)
    }

    pub(super) fn write(camera: &Camera) -> Self {
        let Camera { position, target, up, fov_y_radians } = camera;
        Self {
            position_mm: Some(position.to_array()),
            target_mm: Some(target.to_array()),
            up: Some(up.to_array()),
            fov_y_degrees: Some(angle::degrees(*fov_y_radians)),
        }
    }
}
