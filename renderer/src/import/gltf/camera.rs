//! Perspective cameras.

use std::f32::consts::PI;

use glam::{DMat4, DVec3};
use gltf::json;

use crate::camera::Camera;

/// The perspective cameras of the scene, each looking at the point of its axis nearest to `centre`,
/// so that orbiting turns about the stone.
///
/// Orthographic cameras are left out: the renderer's camera is a pinhole.
pub(super) fn cameras(
    root: &json::Root,
    worlds: &[Option<DMat4>],
    center: DVec3,
) -> Result<Vec<Camera>, String> {
    let mut cameras = Vec::new();
    for (index, (node, world)) in root.nodes.iter().zip(worlds).enumerate() {
        let (Some(world), Some(camera)) = (world, node.camera) else { continue };
        let camera = root.cameras.get(camera.value()).ok_or_else(|| {
            format!("node {index} names camera {}, which does not exist", camera.value())
        })?;
        let Some(perspective) = &camera.perspective else {
            log::warn!("node {index}: its camera is orthographic and is left out");
            continue;
        };
        if !(perspective.yfov > 0.0 && perspective.yfov < PI) {
            return Err(format!(
                "camera of node {index}: its field of view is {} radians; choose 0 to π",
                perspective.yfov
            ));
        }
        let position = world.transform_point3(DVec3::ZERO);
        let forward = world.transform_vector3(DVec3::NEG_Z).try_normalize();
        let up = world.transform_vector3(DVec3::Y).try_normalize();
        let (Some(forward), Some(up)) = (forward, up) else {
            return Err(format!("camera of node {index}: its scale is 0; reset it"));
        };
        let depth = (center - position).dot(forward);
        let depth = if depth > 0.0 { depth } else { 1.0 };
        cameras.push(Camera {
            position: position.as_vec3(),
            target: (position + forward * depth).as_vec3(),
            up: up.as_vec3(),
            fov_y_radians: perspective.yfov,
        });
    }
    Ok(cameras)
}
