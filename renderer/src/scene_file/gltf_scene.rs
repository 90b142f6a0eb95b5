//! glTF files as scenes of their own.

use std::path::Path;

use glam::Vec3;

use super::Document;
use crate::accel::Bounds;
use crate::camera::Camera;
use crate::cuts::RoundBrilliant;
use crate::error::RendererError;
use crate::import::gltf::{self, GltfScene};
use crate::scene::{MeshSource, Object, Scene, Shape, Transform};

/// The bodies of the file, with its camera and lights, or the default ones where it has none.
pub(super) fn document(path: &Path) -> Result<Document, RendererError> {
    let gltf = gltf::load(path)?;
    let start = Document::default();
    let objects = objects(path, &gltf);
    let camera =
        gltf.cameras.first().copied().unwrap_or_else(|| framing(&gltf, start.scene.camera));
    let mut lights = start.scene.lights.clone();
    if !gltf.lights.is_empty() {
        lights.discs = gltf.lights;
    }
    Ok(Document { scene: Scene { objects, lights, camera, ..start.scene }, ..start })
}

/// The bodies of the file as objects that remember where they came from.
fn objects(path: &Path, gltf: &GltfScene) -> Vec<Object> {
    let object = |(index, object): (usize, &gltf::GltfObject)| Object {
        name: object.name.clone(),
        shape: Shape::Mesh(MeshSource { path: path.to_owned(), index, mesh: object.mesh.clone() }),
        transform: Transform::default(),
        material: object.material.clone(),
        throws_light: false,
    };
    gltf.objects.iter().enumerate().map(object).collect()
}

/// `camera` moved along its view until the meshes fill the picture as the start stone does.
fn framing(gltf: &GltfScene, camera: Camera) -> Camera {
    let bounds =
        Bounds::of(gltf.objects.iter().flat_map(|object| object.mesh.positions.iter().copied()));
    let radius = 0.5 * (bounds.max - bounds.min).max_element();
    if !radius.is_finite() || radius <= 0.0 {
        return camera;
    }
    let away = (camera.position - camera.target).normalize_or(Vec3::Z);
    let start_radius = 0.5 * RoundBrilliant::default().diameter_mm;
    let distance = camera.position.distance(camera.target) * radius / start_radius;
    let target = bounds.center();
    Camera { position: target + away * distance, target, ..camera }
}
