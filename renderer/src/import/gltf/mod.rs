//! glTF 2.0 files, text and binary.
//!
//! One unit of the file is taken as one millimetre and nothing is rescaled: the attenuation
//! distance of a volume is in the same unit, so a stone modelled at any size keeps its colour.
//! The file's y-up frame is turned to z-up: (x, y, z) becomes (x, −z, y).
//!
//! Read: every mesh of the scene with its node transforms, KHR materials, punctual lights and
//! perspective cameras, and the base colour textures of opaque materials. Not read: other textures,
//! skins, morph targets, animations, and compressed geometry (Draco, meshopt), which is refused by
//! name.
//!
//! The JSON types of the `gltf` crate are used without its document layer, which panics on some
//! broken files; here every index and range is checked where it is followed.

mod accessor;
mod buffers;
mod camera;
mod container;
mod light;
mod material;
mod nodes;
mod surface;
mod texture;

use std::path::Path;
use std::sync::Arc;

use glam::{DMat4, DVec3, Vec3};
use gltf::json;

use crate::camera::Camera;
use crate::error::RendererError;
use crate::light::DiscLight;
use crate::material::{Material, TexelBudget};
use crate::mesh::Mesh;
use accessor::Accessors;
use buffers::Buffers;
use surface::Surface;
use texture::Images;

/// Most vertices and indices a scene may draw: four for each triangle of the largest mesh.
const MAX_EFFORT: u64 = 4 * Mesh::MAX_TRIANGLES as u64;

/// What a glTF file shows.
#[derive(Debug)]
pub struct GltfScene {
    /// The meshes of the scene's nodes in file order; a node whose mesh has several materials gives
    /// one object per material.
    pub objects: Vec<GltfObject>,
    /// Punctual lights as distant discs, in the order of their nodes.
    pub lights: Vec<DiscLight>,
    /// Perspective cameras, in the order of their nodes.
    pub cameras: Vec<Camera>,
}

/// One body of a glTF file.
#[derive(Debug)]
pub struct GltfObject {
    /// Name of the node, or of its mesh, or the node's number.
    pub name: String,
    /// The triangles, with the node's world transform applied.
    pub mesh: Arc<Mesh>,
    /// What it is made of. A dielectric's mesh is closed.
    pub material: Material,
}

/// Reads the file at `path` and the buffers it names beside it.
///
/// # Errors
/// The file can't be read, is malformed or truncated, has nothing to show, needs an unknown
/// extension, or gives a refracting material to a mesh that is not closed. The text names the file,
/// the place in it and the remedy.
pub fn load(path: &Path) -> Result<GltfScene, RendererError> {
    load_within(path, &mut TexelBudget::default())
}

/// Reads the file at `path` as one of several, whose images have one `budget`.
///
/// # Errors
/// As [`load`].
pub fn load_within(path: &Path, budget: &mut TexelBudget) -> Result<GltfScene, RendererError> {
    let file = container::read_file(path)
        .map_err(|source| RendererError::Io { path: path.to_owned(), source })?;
    parse(path, &file, budget)
}

/// Reads a file that is in memory already. `path` names it in errors and is where the buffers are
/// looked for that are not in the file itself.
///
/// # Errors
/// As [`load`].
pub fn load_from_memory(path: &Path, file: &[u8]) -> Result<GltfScene, RendererError> {
    parse(path, file, &mut TexelBudget::default())
}

fn parse(path: &Path, file: &[u8], budget: &mut TexelBudget) -> Result<GltfScene, RendererError> {
    let folder = path.parent().unwrap_or(Path::new(""));
    read(file, folder, budget)
        .map_err(|message| RendererError::File { path: path.to_owned(), message })
}

fn read(file: &[u8], folder: &Path, budget: &mut TexelBudget) -> Result<GltfScene, String> {
    let (root, blob) = container::parse(file)?;
    let buffers = Buffers::load(&root, blob, folder)?;
    let worlds = nodes::world_transforms(&root)?;
    let accessors = Accessors::new(&root, &buffers);
    let mut images = Images::new(&root, &accessors, folder, budget);
    let objects = objects(&root, &accessors, &mut images, &worlds)?;
    if objects.is_empty() {
        return Err("its scene has no mesh; export the stone with its triangles".to_owned());
    }
    let center = center(&objects);
    Ok(GltfScene {
        lights: light::lights(&root, &worlds, center)?,
        cameras: camera::cameras(&root, &worlds, center)?,
        objects,
    })
}

fn objects(
    root: &json::Root,
    accessors: &Accessors,
    images: &mut Images,
    worlds: &[Option<DMat4>],
) -> Result<Vec<GltfObject>, String> {
    check_effort(root, worlds)?;
    let mut objects = Vec::new();
    for (index, (node, world)) in root.nodes.iter().zip(worlds).enumerate() {
        let (Some(world), Some(mesh)) = (world, node.mesh) else { continue };
        let mesh = root.meshes.get(mesh.value()).ok_or_else(|| {
            format!("node {index} names mesh {}, which does not exist", mesh.value())
        })?;
        let name = node.name.clone().or_else(|| mesh.name.clone());
        let name = name.unwrap_or_else(|| format!("node {index}"));
        let surfaces = surface::surfaces(root, accessors, mesh)
            .map_err(|fault| format!("node '{name}': {fault}"))?;
        let names = object_names(&name, surfaces.len());
        for (name, surface) in names.zip(surfaces) {
            objects.push(object(root, images, name, *world, surface)?);
        }
    }
    Ok(objects)
}

/// Refuses a scene that draws too much, before any of it is read: a small file can draw the same
/// mesh any number of times.
fn check_effort(root: &json::Root, worlds: &[Option<DMat4>]) -> Result<(), String> {
    let mut effort = 0_u64;
    for (node, _) in root.nodes.iter().zip(worlds).filter(|(_, world)| world.is_some()) {
        let mesh = node.mesh.and_then(|mesh| root.meshes.get(mesh.value()));
        effort = effort.saturating_add(mesh.map_or(0, |mesh| surface::effort(root, mesh)));
        if effort > MAX_EFFORT {
            return Err(format!(
                "its nodes draw more than {MAX_EFFORT} vertices and indices; decimate the meshes"
            ));
        }
    }
    Ok(())
}

/// One name per surface of a node: numbered where there are several.
fn object_names(node: &str, count: usize) -> impl Iterator<Item = String> {
    (1..=count).map(
        move |number| {
            if count == 1 { node.to_owned() } else { format!("{node} ({number})") }
        },
    )
}

fn object(
    root: &json::Root,
    images: &mut Images,
    name: String,
    world: DMat4,
    surface: Surface,
) -> Result<GltfObject, String> {
    let place = |fault: String| format!("node '{name}': {fault}");
    let material = material::material(root, images, surface.material).map_err(place)?;
    let (mut triangles, mut coordinates) = (surface.triangles, surface.coordinates);
    if world.determinant() < 0.0 {
        // A mirror turns counter-clockwise into clockwise.
        for corners in &mut triangles {
            corners.swap(1, 2);
        }
        for corners in &mut coordinates {
            corners.swap(1, 2);
        }
    }
    let positions = surface
        .positions
        .iter()
        .map(|position| world.transform_point3(position.as_dvec3()).as_vec3())
        .collect();
    let mesh = Mesh::with_coordinates(positions, triangles, coordinates)
        .map_err(|fault| place(fault.to_string()))?;
    if matches!(material, Material::Dielectric(_)) {
        mesh.closed().map_err(|fault| {
            place(format!(
                "its material refracts, so its mesh must be closed, but {fault}; merge vertices \
                 by distance, fill holes and recalculate normals, or make its material opaque"
            ))
        })?;
    }
    Ok(GltfObject { name, mesh: Arc::new(mesh), material })
}

/// The middle of everything, where lights at a finite distance are measured from.
fn center(objects: &[GltfObject]) -> DVec3 {
    let (low, high) = objects
        .iter()
        .map(|object| object.mesh.bounds())
        .fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), bounds| {
            (low.min(bounds.0), high.max(bounds.1))
        });
    low.as_dvec3().midpoint(high.as_dvec3())
}
