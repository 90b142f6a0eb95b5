//! The node tree: where each node of the scene stands in the world.

use glam::{DMat4, DQuat, DVec3, DVec4};
use gltf::json;

/// From glTF's frame (y up) to ours (z up): (x, y, z) becomes (x, −z, y).
const Z_UP_FROM_Y_UP: DMat4 = DMat4::from_cols(DVec4::X, DVec4::Z, DVec4::NEG_Y, DVec4::W);

/// The world transform of every node of the scene, z up; `None` for nodes outside it.
///
/// The scene is the file's default one, or its first.
pub(super) fn world_transforms(root: &json::Root) -> Result<Vec<Option<DMat4>>, String> {
    let number = root.scene.map_or(0, |scene| scene.value());
    let scene = root.scenes.get(number).ok_or_else(|| {
        format!("scene {number} does not exist; export the file with a default scene")
    })?;
    let mut worlds = vec![None; root.nodes.len()];
    let mut open: Vec<(usize, DMat4)> =
        scene.nodes.iter().map(|node| (node.value(), Z_UP_FROM_Y_UP)).collect();
    while let Some((index, parent)) = open.pop() {
        let node = root
            .nodes
            .get(index)
            .ok_or_else(|| format!("node {index} is named but does not exist; export again"))?;
        if worlds[index].is_some() {
            return Err(format!(
                "node {index} has two parents or is its own ancestor; \
                 nodes must form a tree, so export again"
            ));
        }
        let world = parent
            * local_transform(node).ok_or_else(|| {
                format!("node {index} has a rotation without length; give it a unit quaternion")
            })?;
        if !world.is_finite() {
            return Err(format!(
                "node {index} has a transform that is not finite; reset its scale"
            ));
        }
        worlds[index] = Some(world);
        open.extend(node.children.iter().flatten().map(|child| (child.value(), world)));
    }
    Ok(worlds)
}

/// The node's own matrix, or scale, then rotation, then translation.
fn local_transform(node: &json::Node) -> Option<DMat4> {
    if let Some(matrix) = node.matrix {
        return Some(DMat4::from_cols_array(&matrix.map(f64::from)));
    }
    let vector =
        |v: Option<[f32; 3]>, default| v.map_or(default, |v| DVec3::from_array(v.map(f64::from)));
    let rotation = match node.rotation {
        None => DQuat::IDENTITY,
        Some(rotation) => {
            let rotation = DVec4::from_array(rotation.0.map(f64::from));
            DQuat::from_vec4(rotation.try_normalize()?)
        }
    };
    Some(DMat4::from_scale_rotation_translation(
        vector(node.scale, DVec3::ONE),
        rotation,
        vector(node.translation, DVec3::ZERO),
    ))
}
