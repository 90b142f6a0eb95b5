//! The triangles of a mesh, one surface per material.

use std::collections::HashMap;

use glam::{Vec2, Vec3};
use gltf::json;
use json::mesh::{Mode, Primitive, Semantic};
use json::validation::Checked;

use super::accessor::Accessors;
use super::material;
use super::texture::CoordinateSet;

/// The triangles of a mesh that share a material.
pub(super) struct Surface {
    /// Index of the material in the document; `None` is the default material.
    pub(super) material: Option<usize>,
    pub(super) positions: Vec<Vec3>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// Texture coordinates of the corners of each triangle; none where the material has no texture.
    pub(super) coordinates: Vec<[Vec2; 3]>,
}

/// What it takes to read `mesh` once: its vertices and indices as declared, and one per primitive.
pub(super) fn effort(root: &json::Root, mesh: &json::Mesh) -> u64 {
    let count = |index: json::Index<json::Accessor>| {
        root.accessors.get(index.value()).map_or(0, |accessor| accessor.count.0)
    };
    mesh.primitives
        .iter()
        .flat_map(|primitive| {
            let positions = primitive.attributes.get(&Checked::Valid(Semantic::Positions));
            [Some(1), positions.copied().map(count), primitive.indices.map(count)]
        })
        .flatten()
        .fold(0, u64::saturating_add)
}

/// The surfaces of `mesh` in the order in which their materials first appear.
///
/// Primitives of one material are joined: exporters split a closed mesh wherever they please.
pub(super) fn surfaces(
    root: &json::Root,
    accessors: &Accessors,
    mesh: &json::Mesh,
) -> Result<Vec<Surface>, String> {
    let mut surfaces: Vec<Surface> = Vec::new();
    let mut surface_of: HashMap<Option<usize>, usize> = HashMap::new();
    for (number, primitive) in mesh.primitives.iter().enumerate() {
        let place = |fault: String| format!("primitive {number}: {fault}");
        let (positions, triangles) = geometry(accessors, primitive).map_err(place)?;
        let material = primitive.material.map(|material| material.value());
        let set = material::base_texture(root, material).map(CoordinateSet::of);
        let coordinates = set.map(|set| coordinates(accessors, primitive, set, positions.len()));
        let coordinates = coordinates.transpose().map_err(place)?;
        let at = *surface_of.entry(material).or_insert_with(|| {
            surfaces.push(Surface::of(material));
            surfaces.len() - 1
        });
        let surface = &mut surfaces[at];
        let base = surface.positions.len() as u32;
        surface.positions.extend(positions);
        if let Some(coordinates) = coordinates {
            let of_corners = |corners: &[u32; 3]| corners.map(|v| coordinates[v as usize]);
            surface.coordinates.extend(triangles.iter().map(of_corners));
        }
        surface.triangles.extend(triangles.iter().map(|corners| corners.map(|v| v + base)));
    }
    Ok(surfaces)
}

impl Surface {
    /// Without a triangle yet.
    fn of(material: Option<usize>) -> Self {
        let (positions, triangles, coordinates) = (Vec::new(), Vec::new(), Vec::new());
        Self { material, positions, triangles, coordinates }
    }
}

/// Where in its texture each of a primitive's vertices lies.
fn coordinates(
    accessors: &Accessors,
    primitive: &Primitive,
    set: CoordinateSet,
    vertex_count: usize,
) -> Result<Vec<Vec2>, String> {
    let semantic = Semantic::TexCoords(set.number);
    let accessor = primitive.attributes.get(&Checked::Valid(semantic)).ok_or_else(|| {
        format!(
            "its material has a texture, but it has no TEXCOORD_{}; unwrap the mesh or remove the \
             texture",
            set.number
        )
    })?;
    let coordinates = accessors.coordinates(accessor.value())?;
    if coordinates.len() != vertex_count {
        return Err(format!(
            "it has {vertex_count} vertices, but {} texture coordinates; export again",
            coordinates.len()
        ));
    }
    Ok(coordinates.into_iter().map(|at| set.place(at)).collect())
}

fn geometry(
    accessors: &Accessors,
    primitive: &Primitive,
) -> Result<(Vec<Vec3>, Vec<[u32; 3]>), String> {
    let mode = match primitive.mode {
        Checked::Valid(mode @ (Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan)) => mode,
        Checked::Valid(mode) => {
            return Err(format!("it draws {mode:?}, not triangles; delete or triangulate it"));
        }
        Checked::Invalid => return Err("its drawing mode is unknown; export again".to_owned()),
    };
    let positions = primitive
        .attributes
        .get(&Checked::Valid(Semantic::Positions))
        .ok_or("it has no positions; export again")?;
    let positions = accessors.positions(positions.value())?;
    let indices = match primitive.indices {
        Some(indices) => accessors.indices(indices.value())?,
        None => (0..positions.len() as u32).collect(),
    };
    if let Some(beyond) = indices.iter().find(|v| **v as usize >= positions.len()) {
        return Err(format!(
            "index {beyond} is beyond its {} vertices; export again",
            positions.len()
        ));
    }
    Ok((positions, triangles(&indices, mode)))
}

/// Triangles from a list, a strip or a fan (glTF 2.0 §3.7.2.1); an incomplete last one is dropped.
fn triangles(indices: &[u32], mode: Mode) -> Vec<[u32; 3]> {
    match mode {
        Mode::TriangleStrip => indices
            .windows(3)
            .enumerate()
            .map(|(i, v)| if i % 2 == 0 { [v[0], v[1], v[2]] } else { [v[0], v[2], v[1]] })
            .collect(),
        Mode::TriangleFan => indices
            .get(1..)
            .unwrap_or_default()
            .windows(2)
            .map(|v| [v[0], v[1], indices[0]])
            .collect(),
        _ => indices.as_chunks().0.to_vec(),
    }
}
