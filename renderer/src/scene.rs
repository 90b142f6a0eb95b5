//! The scene: objects with their materials, the ground, the lights and the camera.
//!
//! A scene is a plain value. It is compared to decide whether a picture must start again, and
//! turned into a [`PackedScene`](crate::packed::PackedScene) before it is traced.
//! One unit of length is one millimetre; +z is up.

use std::path::PathBuf;
use std::sync::Arc;

use glam::{Quat, Vec3};

use crate::camera::Camera;
use crate::cuts::RoundBrilliant;
use crate::error::RendererError;
use crate::light::Lights;
use crate::material::{Diffuse, Layout, Material};
use crate::mesh::Mesh;
use crate::solid::{HalfSpace, Solid};
use crate::spectrum::Spectrum;

/// Everything that can be seen.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// Stones and opaque meshes.
    pub objects: Vec<Object>,
    /// A checkered plane under them.
    pub ground: Option<Ground>,
    /// What shines.
    pub lights: Lights,
    /// Where the picture is taken from when the scene is opened.
    pub camera: Camera,
}

/// One body in the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// What the user calls it.
    pub name: String,
    /// Its surface, in its own frame.
    pub shape: Shape,
    /// Where it stands.
    pub transform: Transform,
    /// What it is made of.
    pub material: Material,
    /// Whether matte surfaces see the light of the discs straight through it, and not only its
    /// shadow; for clear convex bodies alone.
    pub throws_light: bool,
}

impl Object {
    /// Whether something is printed on it by the texture coordinates of its mesh.
    pub(crate) fn is_printed_by_coordinates(&self) -> bool {
        let Material::Diffuse(Diffuse { print: Some(print), .. }) = &self.material else {
            return false;
        };
        print.layout == Layout::Coordinates
    }

    /// The convex solid that it is, in its own frame.
    ///
    /// # Errors
    /// It is a mesh, or its proportions or half-spaces enclose no volume; the text names the object.
    pub(crate) fn solid(&self) -> Result<Solid, RendererError> {
        let named = |fault: String| RendererError::Invalid(format!("{}: {fault}", self.name));
        let solid = match &self.shape {
            Shape::Mesh(_) => {
                return Err(named("a mesh is not known to be convex; choose a cut".into()));
            }
            Shape::RoundBrilliant(cut) => {
                cut.half_spaces().and_then(|half_spaces| Solid::from_half_spaces(&half_spaces))
            }
            Shape::Polyhedron(half_spaces) => Solid::from_half_spaces(half_spaces),
        };
        solid.map_err(|fault| named(fault.to_string()))
    }

    /// Refuses an object that shall throw light and can't: only through what is clear and known to be
    /// convex can light be followed straight.
    pub(crate) fn check_throwing(&self) -> Result<(), &'static str> {
        match (&self.shape, &self.material) {
            _ if !self.throws_light => Ok(()),
            (Shape::Mesh(_), _) => {
                Err("a mesh can't throw light, only a round_brilliant or a polyhedron; switch \
                 throws_light off")
            }
            (_, Material::Diffuse(_)) => {
                Err("what is matte can't throw light; make it clear, or switch throws_light off")
            }
            _ => Ok(()),
        }
    }
}

/// The surface of an object.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// The parametric standard round brilliant.
    RoundBrilliant(RoundBrilliant),
    /// A convex solid given by its half-spaces.
    Polyhedron(Vec<HalfSpace>),
    /// A triangle mesh from a glTF file.
    Mesh(MeshSource),
}

/// A mesh and the file it came from.
#[derive(Clone, Debug)]
pub struct MeshSource {
    /// The glTF or GLB file.
    pub path: PathBuf,
    /// Which of the file's meshes, counted over its nodes in file order.
    pub index: usize,
    /// The triangles, with the file's node transform applied.
    pub mesh: Arc<Mesh>,
}

impl PartialEq for MeshSource {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.mesh, &other.mesh)
    }
}

/// A similarity: scale, then rotation, then translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// Translation in millimetres.
    pub translation: Vec3,
    /// Unit quaternion.
    pub rotation: Quat,
    /// Uniform scale, positive.
    pub scale: f32,
}

impl Default for Transform {
    fn default() -> Self {
        Self { translation: Vec3::ZERO, rotation: Quat::IDENTITY, scale: 1.0 }
    }
}

impl Transform {
    /// The point `p` of the object's frame in the world.
    pub fn point(&self, p: Vec3) -> Vec3 {
        self.rotation * (p * self.scale) + self.translation
    }

    /// The direction `d` of the object's frame in the world, length kept.
    pub fn direction(&self, d: Vec3) -> Vec3 {
        self.rotation * d
    }
}

/// An infinite horizontal plane with a checker of two reflectances, diffuse.
#[derive(Clone, Debug, PartialEq)]
pub struct Ground {
    /// z of the plane in millimetres.
    pub height: f32,
    /// Side of one square in millimetres.
    pub square: f32,
    /// Reflectances of the two kinds of square, each in 0..=1.
    pub reflectance: [Spectrum; 2],
}
