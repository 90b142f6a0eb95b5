//! Objects in a scene file: shape, place and material.

use std::path::Path;

use glam::{DVec3, Quat, Vec3};
use serde::{Deserialize, Serialize};

use super::angle;
use super::brilliant::BrilliantEntry;
use super::check::{exactly_one, positive};
use super::fault::{Fault, Under};
use super::material::MaterialEntry;
use super::mesh_file::{MeshEntry, MeshFiles};
use super::print::ImageFiles;
use crate::material::Material;
use crate::scene::{Object, Shape, Transform};
use crate::solid::{HalfSpace, Solid};

/// Most that the length of a quaternion may differ from 1.
const QUATERNION_TOLERANCE: f32 = 1e-3;
/// Normals this near to length 1 are kept as they are.
const UNIT_TOLERANCE: f64 = 1e-12;

/// An object as written: one of the three shapes, a material, and a place.
#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ObjectEntry {
    name: Option<String>,
    translation_mm: Option<[f32; 3]>,
    scale: Option<f32>,
    rotation: Option<RotationEntry>,
    round_brilliant: Option<BrilliantEntry>,
    polyhedron: Option<PolyhedronEntry>,
    mesh: Option<MeshEntry>,
    /// A mesh without it keeps the material of its own file.
    material: Option<MaterialEntry>,
    throws_light: Option<bool>,
}

/// A turn about an axis, or the unit quaternion x, y, z, w where no short turn gives its bits.
#[derive(Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct RotationEntry {
    axis: Option<[f64; 3]>,
    degrees: Option<f64>,
    quaternion: Option<[f32; 4]>,
}

#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct PolyhedronEntry {
    half_spaces: Vec<HalfSpaceEntry>,
}

/// The points x with normal · x ≤ distance, the normal brought to length 1 first.
#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct HalfSpaceEntry {
    name: Option<String>,
    normal: [f64; 3],
    distance_mm: f64,
}

impl ObjectEntry {
    /// `index` counts the objects of the file; `meshes` and `images` read files once each.
    pub(super) fn read(
        self,
        index: usize,
        meshes: &mut MeshFiles,
        images: &mut ImageFiles,
    ) -> Result<Object, Fault> {
        exactly_one(&[
            ("round_brilliant", self.round_brilliant.is_some()),
            ("polyhedron", self.polyhedron.is_some()),
            ("mesh", self.mesh.is_some()),
        ])?;
        let transform = Transform {
            translation: self.translation_mm.map_or(Vec3::ZERO, Vec3::from_array),
            rotation: self
                .rotation
                .map_or(Ok(Quat::IDENTITY), RotationEntry::read)
                .under("rotation")?,
            scale: positive("scale", self.scale.unwrap_or(1.0))?,
        };
        let (shape, own_material) = match (self.round_brilliant, self.polyhedron, self.mesh) {
            (Some(entry), _, _) => {
                (Shape::RoundBrilliant(entry.read().under("round_brilliant")?), None)
            }
            (_, Some(entry), _) => (Shape::Polyhedron(entry.read().under("polyhedron")?), None),
            (_, _, Some(entry)) => {
                let (source, material) = meshes.read(&entry, &mut images.budget).under("mesh")?;
                (Shape::Mesh(source), Some(material))
            }
            (None, None, None) => return Err(Fault::new("the object has no shape")),
        };
        let material = self.material.map(|material| material.read(images));
        let material = material.transpose().under("material")?;
        let material = material
            .or(own_material)
            .ok_or_else(|| Fault::at("material", "this key is missing"))?;
        refuse_open_stone(&shape, &material)?;
        let object = Object {
            name: self.name.unwrap_or_else(|| format!("Object {}", index + 1)),
            shape,
            transform,
            material,
            throws_light: self.throws_light.unwrap_or(false),
        };
        object.check_throwing().map_err(|fault| Fault::at("throws_light", fault))?;
        Ok(object)
    }

    /// Paths are written relative to `base`.
    pub(super) fn write(object: &Object, base: &Path) -> Self {
        let Object { name, shape, transform, material, throws_light } = object;
        let Transform { translation, rotation, scale } = transform;
        let mut entry = Self {
            name: Some(name.clone()),
            translation_mm: (*translation != Vec3::ZERO).then(|| translation.to_array()),
            scale: (*scale != 1.0).then_some(*scale),
            rotation: (*rotation != Quat::IDENTITY).then(|| RotationEntry::write(*rotation)),
            round_brilliant: None,
            polyhedron: None,
            mesh: None,
            // What only the mesh's own file can say is left to it.
            material: (!object.is_printed_by_coordinates())
                .then(|| MaterialEntry::write(material, base)),
            throws_light: throws_light.then_some(true),
        };
        match shape {
            Shape::RoundBrilliant(cut) => entry.round_brilliant = Some(BrilliantEntry::write(cut)),
            Shape::Polyhedron(half_spaces) => {
                let half_spaces = half_spaces.iter().map(HalfSpaceEntry::write).collect();
                entry.polyhedron = Some(PolyhedronEntry { half_spaces });
            }
            Shape::Mesh(source) => entry.mesh = Some(MeshEntry::write(source, base)),
        }
        entry
    }
}

/// Light that enters a clear mesh must find its way out: the mesh must be closed.
fn refuse_open_stone(shape: &Shape, material: &Material) -> Result<(), Fault> {
    match (shape, material) {
        (Shape::Mesh(source), Material::Dielectric(_)) => source.mesh.closed().map_err(|fault| {
            Fault::at(
                "mesh",
                format!("a clear stone must be closed, but {fault}; close it, or make it diffuse"),
            )
        }),
        _ => Ok(()),
    }
}

impl RotationEntry {
    fn read(self) -> Result<Quat, Fault> {
        exactly_one(&[
            ("axis", self.axis.is_some() || self.degrees.is_some()),
            ("quaternion", self.quaternion.is_some()),
        ])?;
        if let Some(quaternion) = self.quaternion {
            let quaternion = Quat::from_array(quaternion);
            if (quaternion.length() - 1.0).abs() <= QUATERNION_TOLERANCE {
                return Ok(quaternion);
            }
            return Err(Fault::at(
                "quaternion",
                format!("its length is {}, it must be 1", quaternion.length()),
            ));
        }
        let axis = self.axis.ok_or_else(|| Fault::at("axis", "this key is missing"))?;
        let degrees = self.degrees.ok_or_else(|| Fault::at("degrees", "this key is missing"))?;
        angle::rotation(axis, degrees).ok_or_else(|| {
            Fault::at("axis", format!("found {axis:?}; it must point somewhere, such as [0, 0, 1]"))
        })
    }

    fn write(rotation: Quat) -> Self {
        match angle::axis_degrees(rotation) {
            Some((axis, degrees)) => {
                Self { axis: Some(axis), degrees: Some(degrees), quaternion: None }
            }
            None => Self { quaternion: Some(rotation.to_array()), ..Self::default() },
        }
    }
}

impl PolyhedronEntry {
    fn read(self) -> Result<Vec<HalfSpace>, Fault> {
        let half_spaces = self
            .half_spaces
            .into_iter()
            .enumerate()
            .map(|(index, entry)| entry.read(index).under(index))
            .collect::<Result<Vec<_>, _>>()
            .under("half_spaces")?;
        Solid::from_half_spaces(&half_spaces)
            .map_err(|error| Fault::at("half_spaces", error.to_string()))?;
        Ok(half_spaces)
    }
}

impl HalfSpaceEntry {
    fn read(self, index: usize) -> Result<HalfSpace, Fault> {
        let given = DVec3::from_array(self.normal);
        let is_unit = (given.length() - 1.0).abs() <= UNIT_TOLERANCE;
        let normal = if is_unit { Some(given) } else { given.try_normalize() };
        Ok(HalfSpace {
            normal: normal.ok_or_else(|| {
                Fault::at("normal", "it must point out of the solid, such as [0, 0, 1]")
            })?,
            distance: self.distance_mm,
            name: self.name.unwrap_or_else(|| format!("facet {}", index + 1)),
        })
    }

    fn write(half_space: &HalfSpace) -> Self {
        let HalfSpace { normal, distance, name } = half_space;
        Self { name: Some(name.clone()), normal: normal.to_array(), distance_mm: *distance }
    }
}
