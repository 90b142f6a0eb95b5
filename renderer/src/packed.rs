//! What the tracers read: the scene flattened into plain arrays.
//!
//! Every struct is `repr(C)` and free of padding so that a GPU can be handed the same bytes.

mod axis;
mod bodies;
mod passages;
mod prints;
mod spectra;
mod unwrapped;

pub use passages::{MAX_PASSAGES, MAX_THROWER_FACETS};

use bytemuck::{Pod, Zeroable};
use glam::{Vec3, Vec4};

use crate::error::RendererError;
use crate::scene::Scene;
use crate::spectrum::Bins;

/// Most planes that any processor tests at a time; a solid's planes are filled up to a multiple.
pub const PLANE_LANES: usize = 16;
/// Entries of an index table: one per nm from 380 to 730.
pub const INDEX_TABLE_LEN: usize = 351;
/// Positions on the dispersion axis that tables give values at, evenly from 0 to 1.
pub const AXIS_LEN: usize = 513;
/// The index of nothing: no instance, no facet, no material.
pub const NONE: u32 = u32::MAX;

/// A node of a bounding volume hierarchy; two children side by side, or a run of primitives.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct BvhNode {
    /// Lower corner of the box.
    pub min: Vec3,
    /// Primitives of a leaf; 0 for an inner node.
    pub primitive_count: u32,
    /// Upper corner of the box.
    pub max: Vec3,
    /// First child or first primitive.
    pub first: u32,
}

/// A triangle in the frame of its mesh.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct PackedTriangle {
    /// First corner.
    pub a: Vec3,
    /// The flat facet that the triangle is part of.
    pub facet: u32,
    /// Second corner.
    pub b: Vec3,
    /// x of the outward unit normal.
    pub normal_x: f32,
    /// Third corner.
    pub c: Vec3,
    /// y of the outward unit normal.
    pub normal_y: f32,
    /// z of the outward unit normal.
    pub normal_z: f32,
    /// Fills the struct to 64 bytes.
    pub padding: [u32; 3],
}

impl PackedTriangle {
    /// The outward unit normal.
    pub fn normal(&self) -> Vec3 {
        Vec3::new(self.normal_x, self.normal_y, self.normal_z)
    }
}

/// [`Instance::kind`] of a convex solid: `count` planes in world space, at `first` in
/// [`PackedScene::planes`].
pub const CONVEX: u32 = 0;
/// [`Instance::kind`] of a mesh: `first` is the root node of its hierarchy.
pub const MESH: u32 = 1;

/// One body of the scene.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Instance {
    /// Rows of the matrix that takes world points into the frame of the body.
    pub object_from_world: [Vec4; 3],
    /// [`CONVEX`] or [`MESH`].
    pub kind: u32,
    /// First number of the planes, or root node.
    pub first: u32,
    /// Number of planes, those that fill up included.
    pub count: u32,
    /// Index into the materials.
    pub material: u32,
    /// A point inside the body's bounds, towards which a lost ray is nudged.
    pub center: Vec3,
    /// 1 where nothing else reaches into the body's bounds, so that a ray inside meets only it.
    pub interior_is_clear: u32,
}

/// What is printed on a matte material; words are those of [`PackedScene::words`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct PackedPrint {
    /// Printed on is where `front · n + front_offset` is above 0, n the outward unit normal in the
    /// body's frame.
    pub front: Vec3,
    /// See `front`.
    pub front_offset: f32,
    /// Linear sRGB that each texel is multiplied by.
    pub tint: Vec3,
    /// Row of the reflectance of red; those of green and blue follow.
    pub primaries: u32,
    /// Width and height in texels.
    pub size: [u32; 2],
    /// What is beyond the image, across and along: an [`Outside`](crate::material::Outside).
    pub outside: [u32; 2],
    /// First texel, or [`NONE`] where nothing is printed: row by row from the top, each red, green
    /// and blue in sRGB codes of 8 bits, red in the lowest.
    pub texels: u32,
    /// First of the 256 linear values of the sRGB codes.
    pub levels: u32,
    /// First word of the projection of facet 0: x, y and z in the body's frame, and 1, times the
    /// first four numbers are the texture coordinate u, times the next four v.
    pub projection: u32,
    /// Words from the projection of one facet to that of the next; 0 where all have the same.
    pub projection_stride: u32,
}

/// Optical properties; spectra are rows of [`PackedScene::spectra`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct PackedMaterial {
    /// First number of the index table, or [`NONE`] for an opaque diffuse material.
    pub index_table: u32,
    /// Row of the absorption coefficient per mm, or [`NONE`].
    pub absorption: u32,
    /// Row of the reflectance, or [`NONE`].
    pub reflectance: u32,
    /// Least absorption coefficient of any bin, per mm.
    pub least_absorption: f32,
    /// What is printed on it.
    pub print: PackedPrint,
}

impl PackedMaterial {
    /// Whether no light enters the material.
    #[inline]
    pub fn is_opaque(&self) -> bool {
        self.index_table == NONE
    }
}

/// A distant disc.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct PackedDisc {
    /// Unit vector towards the light.
    pub direction: Vec3,
    /// Cosine of the angular radius.
    pub cos_radius: f32,
    /// Squared sine of the angular radius.
    pub sin_squared_radius: f32,
    /// Solid angle in steradians.
    pub solid_angle: f32,
    /// Row of the radiance.
    pub spectrum: u32,
    /// First of the passages that the light takes through clear bodies.
    pub first_passage: u32,
    /// Number of these passages.
    pub passage_count: u32,
    /// Fills the struct to 48 bytes.
    pub padding: [u32; 3],
}

/// Two facets of a clear convex body that light of one disc goes straight through, in at one and out
/// at the other.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct PackedPassage {
    /// Middle of the facet that the light leaves through.
    pub center_out: Vec3,
    /// Radius about that middle of a sphere that holds the facet.
    pub radius_out: f32,
    /// Unit vector along the middle of the directions in which the light is seen from behind.
    pub direction: Vec3,
    /// Cosine of the half-angle of the cone about `direction` that holds them all.
    pub cos_bound: f32,
    /// Outward unit normal of the facet that the light enters through.
    pub normal_in: Vec3,
    /// Sine of the half-angle of that cone; where it is wider than 90°, both are 0.
    pub sin_bound: f32,
    /// Outward unit normal of the facet that the light leaves through.
    pub normal_out: Vec3,
    /// The body.
    pub instance: u32,
    /// Middle of the facet that the light enters through.
    pub center_in: Vec3,
    /// Radius about that middle of a sphere that holds the facet.
    pub radius_in: f32,
    /// The facet that the light enters through.
    pub facet_in: u32,
    /// The facet that the light leaves through.
    pub facet_out: u32,
    /// Fills the struct to 96 bytes.
    pub padding: [u32; 2],
}

/// The checkered plane.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct PackedGround {
    /// z of the plane.
    pub height: f32,
    /// Side of a square.
    pub square: f32,
    /// Rows of the two reflectances; [`NONE`] where there is no ground.
    pub reflectance: [u32; 2],
}

/// The lights that have no place, and what the tracer must know of all lights.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct PackedSky {
    /// Row of the hemisphere's radiance, or [`NONE`].
    pub hemisphere: u32,
    /// Row of the environment's radiance, or [`NONE`].
    pub environment: u32,
    /// Row of the backdrop's radiance, or [`NONE`].
    pub backdrop: u32,
    /// Angular diameter of the smallest disc in radians; π where there is none.
    pub light_spread: f32,
    /// Cosine of the half-angle of the observer's shadow.
    pub cos_observer_shadow: f32,
    /// Squared sine of the half-angle of the observer's shadow; 0 where there is none.
    pub sin_squared_observer_shadow: f32,
    /// Fills the struct to 32 bytes.
    pub padding: [u32; 2],
}

/// A scene ready for tracing.
#[derive(Clone, Debug)]
pub struct PackedScene {
    /// The film's division of the spectrum, which the rows of `spectra` follow.
    pub bins: Bins,
    /// Bodies.
    pub instances: Vec<Instance>,
    /// Hierarchy over the bodies; node 0 is the root, empty where there are none.
    pub top_nodes: Vec<BvhNode>,
    /// First the instance index per leaf slot of `top_nodes`, then what prints consist of: texels,
    /// linear values and, as the bits of f32, projections. They share an array because a graphics
    /// device takes only so many.
    pub words: Vec<u32>,
    /// Facet planes of all convex solids. Each solid has four runs of numbers, one per plane: x, y
    /// and z of the outward unit normals, and the distances from the origin of the world. Planes
    /// that fill up have normal 0 and are never met.
    pub planes: Vec<f32>,
    /// Hierarchies of all meshes.
    pub nodes: Vec<BvhNode>,
    /// Triangles of all meshes, in leaf order.
    pub triangles: Vec<PackedTriangle>,
    /// Materials.
    pub materials: Vec<PackedMaterial>,
    /// First rows of mean values per bin: radiances, reflectances, absorption coefficients. Then, per
    /// dielectric, n(λ) at every nm, [`INDEX_TABLE_LEN`] values, and along the dispersion axis,
    /// [`AXIS_LEN`] values. Last the axis. They share an array as `words` do.
    pub spectra: Vec<f32>,
    /// First number of the dispersion axis in `spectra`: wavelengths in nm at [`AXIS_LEN`] positions,
    /// positions at every nm, and the means over each bin's wavelengths of the position and of its
    /// square. The axis runs from 0 at 380 nm to 1 at 730 nm in proportion to the index of the most
    /// dispersive material.
    pub axis: u32,
    /// Disc lights.
    pub discs: Vec<PackedDisc>,
    /// Passages of the discs' light, disc by disc.
    pub passages: Vec<PackedPassage>,
    /// Lights without a place.
    pub sky: PackedSky,
    /// The ground.
    pub ground: PackedGround,
}

impl PackedScene {
    /// Flattens `scene` for a film of `bins`.
    ///
    /// # Errors
    /// An object that is no closed body, one that shall throw light and can't, or a value that is out
    /// of its range; the text names the object or light.
    pub fn new(scene: &Scene, bins: Bins) -> Result<Self, RendererError> {
        let mut spectra = spectra::SpectrumRows::new(bins);
        let mut prints = prints::PrintWords::new(scene.objects.len());
        let materials = spectra::pack_materials(scene, &mut spectra, &mut prints)?;
        let bodies = bodies::pack(scene, &materials.of_object, &prints)?;
        let mut discs = spectra::pack_discs(&scene.lights, &mut spectra)?;
        let passages = passages::pack(&mut discs, &bodies.throwers, &materials)?;
        let sky = spectra::pack_sky(&scene.lights, &mut spectra)?;
        let ground = spectra::pack_ground(scene.ground.as_ref(), &mut spectra)?;
        let axis = axis::Axis::of(&materials);
        let (materials, mut spectra) = materials.behind(spectra.into_values(), &axis);
        let axis_start = spectra.len() as u32;
        spectra.extend(axis.tables(bins));
        Ok(Self {
            bins,
            instances: bodies.instances,
            top_nodes: bodies.top_nodes,
            words: prints.behind(bodies.top_order),
            planes: bodies.planes,
            nodes: bodies.nodes,
            triangles: bodies.triangles,
            materials,
            spectra,
            axis: axis_start,
            discs,
            passages,
            sky,
            ground,
        })
    }

    /// The material of a body.
    #[inline]
    pub fn material_of(&self, instance: u32) -> &PackedMaterial {
        &self.materials[self.instances[instance as usize].material as usize]
    }

    /// One row of a projection: the four numbers from a word on.
    #[inline]
    pub fn projection_row(&self, first: u32) -> Vec4 {
        let number = |i: u32| f32::from_bits(self.words[(first + i) as usize]);
        Vec4::new(number(0), number(1), number(2), number(3))
    }

    /// The means of row `row` over all bins.
    #[inline]
    pub fn spectrum_row(&self, row: u32) -> &[f32] {
        let start = row as usize * self.bins.count();
        &self.spectra[start..start + self.bins.count()]
    }

    /// The mean of row `row` over `bin`.
    #[inline]
    pub fn spectrum_value(&self, row: u32, bin: u32) -> f32 {
        self.spectra[row as usize * self.bins.count() + bin as usize]
    }
}
