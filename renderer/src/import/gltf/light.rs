//! Punctual lights (`KHR_lights_punctual`) as distant discs.

use std::f64::consts::PI;

use glam::{DMat4, DVec3};
use gltf::json;
use json::extensions::scene::khr_lights_punctual::{Light, Type};
use json::validation::Checked;

use crate::light::DiscLight;
use crate::spectrum::{Illuminant, Spectrum};

/// Angular radius given to lights that have none: the sun's, 16 arc minutes.
const ANGULAR_RADIUS_RADIANS: f64 = 16.0 / 60.0 * PI / 180.0;

/// The lights of the scene as `centre` sees them.
///
/// A directional light of intensity E gives the irradiance E; a point or spot light of intensity I
/// at distance d gives I/d². Lights that don't reach the centre are left out.
pub(super) fn lights(
    root: &json::Root,
    worlds: &[Option<DMat4>],
    center: DVec3,
) -> Result<Vec<DiscLight>, String> {
    let mut discs = Vec::new();
    for (index, (node, world)) in root.nodes.iter().zip(worlds).enumerate() {
        let reference = node.extensions.as_ref().and_then(|all| all.khr_lights_punctual.as_ref());
        let (Some(world), Some(reference)) = (world, reference) else { continue };
        let light = root.get(reference.light).ok_or_else(|| {
            format!("node {index} names light {}, which does not exist", reference.light.value())
        })?;
        let name = light.name.clone().or_else(|| node.name.clone());
        let name = name.unwrap_or_else(|| format!("light {}", discs.len() + 1));
        let disc = disc(name, light, *world, center)
            .map_err(|fault| format!("light of node {index}: {fault}"))?;
        discs.extend(disc);
    }
    Ok(discs)
}

fn disc(
    name: String,
    light: &Light,
    world: DMat4,
    center: DVec3,
) -> Result<Option<DiscLight>, String> {
    let Checked::Valid(kind) = light.type_ else {
        return Err("its type is unknown; choose directional, point or spot".to_owned());
    };
    let strongest = light.color.iter().copied().fold(0.0, f32::max);
    let is_sound = |value: f32| value.is_finite() && value >= 0.0;
    if !light.color.iter().copied().chain([light.intensity]).all(is_sound) {
        return Err("its colour or intensity is not a finite positive number".to_owned());
    }
    let axis = world.transform_vector3(DVec3::NEG_Z).normalize_or_zero();
    let from_light = center - world.transform_point3(DVec3::ZERO);
    let (towards, reach) = match kind {
        Type::Directional => (-axis, 1.0),
        Type::Point => (-from_light.normalize_or_zero(), from_light.length_squared().recip()),
        Type::Spot => {
            let direction = from_light.normalize_or_zero();
            let share = spot_share(light, axis.dot(direction));
            (-direction, share / from_light.length_squared())
        }
    };
    let irradiance = f64::from(light.intensity * strongest) * reach;
    // A disc of radiance L and angular radius ρ gives the irradiance π·L·sin²ρ.
    let radiance = (irradiance / (PI * ANGULAR_RADIUS_RADIANS.sin().powi(2))) as f32;
    if towards == DVec3::ZERO || !radiance.is_finite() || radiance <= 0.0 {
        return Ok(None);
    }
    let hue = light.color.map(|channel| channel / strongest);
    Ok(Some(DiscLight {
        name,
        direction: towards.as_vec3(),
        angular_radius_radians: ANGULAR_RADIUS_RADIANS as f32,
        radiance,
        // glTF's white is that of sRGB.
        spectrum: if hue == [1.0; 3] {
            Spectrum::Illuminant(Illuminant::D65)
        } else {
            Spectrum::Rgb(hue)
        },
    }))
}

/// How much of a spot's intensity goes in the direction at this cosine from its axis, with the
/// falloff that `KHR_lights_punctual` recommends.
fn spot_share(light: &Light, cos: f64) -> f64 {
    let spot = light.spot.clone().unwrap_or_default();
    let cos_outer = f64::from(spot.outer_cone_angle).cos();
    let cos_inner = f64::from(spot.inner_cone_angle).cos();
    ((cos - cos_outer) / (cos_inner - cos_outer).max(1e-3)).clamp(0.0, 1.0).powi(2)
}
