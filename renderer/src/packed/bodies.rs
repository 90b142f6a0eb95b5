//! Packing of everything with a surface: convex solids as planes, meshes as hierarchies.

use std::collections::HashMap;
use std::sync::Arc;

use glam::{DVec3, Mat3, Vec4};

use super::passages::Polygon;
use super::prints::PrintWords;
use super::{BvhNode, CONVEX, Instance, MESH, PLANE_LANES, PackedTriangle};
use crate::accel::{Bounds, Hierarchy, MAX_DEPTH};
use crate::error::RendererError;
use crate::material::Material;
use crate::mesh::Mesh;
use crate::scene::{Object, Scene, Shape, Transform};
use crate::solid::{HalfSpace, Solid};

#[derive(Default)]
pub(super) struct PackedBodies {
    pub(super) instances: Vec<Instance>,
    pub(super) top_nodes: Vec<BvhNode>,
    pub(super) top_order: Vec<u32>,
    pub(super) planes: Vec<f32>,
    pub(super) nodes: Vec<BvhNode>,
    pub(super) triangles: Vec<PackedTriangle>,
    pub(super) throwers: Vec<Thrower>,
}

/// A clear convex body whose light falls on matte surfaces.
pub(super) struct Thrower {
    pub(super) name: String,
    pub(super) instance: u32,
    pub(super) material: u32,
    pub(super) facets: Vec<Polygon>,
    /// Largest distance of two of its points, in mm.
    pub(super) size_mm: f32,
}

/// Packs the objects; `materials` is the packed material of each.
pub(super) fn pack(
    scene: &Scene,
    materials: &[u32],
    prints: &PrintWords,
) -> Result<PackedBodies, RendererError> {
    let mut bodies = PackedBodies::default();
    let mut bounds = Vec::with_capacity(scene.objects.len());
    // A mesh with an image on it by its coordinates is packed apart: its facets are others.
    let mut mesh_roots = HashMap::new();
    for (object, &material) in scene.objects.iter().zip(materials) {
        check_transform(object)?;
        object
            .check_throwing()
            .map_err(|fault| RendererError::Invalid(format!("{}: {fault}", object.name)))?;
        bounds.push(match &object.shape {
            Shape::Mesh(source) => {
                check_mesh(object, &source.mesh)?;
                let facets = prints.facets(&source.mesh);
                let facets = facets.filter(|_| object.is_printed_by_coordinates());
                let root = *mesh_roots
                    .entry((Arc::as_ptr(&source.mesh), facets.is_some()))
                    .or_insert_with(|| bodies.push_mesh(&source.mesh, facets));
                bodies.push_mesh_instance(root, &source.mesh, object, material)
            }
            Shape::RoundBrilliant(_) | Shape::Polyhedron(_) => {
                bodies.push_convex(&object.solid()?, object, material)
            }
        });
    }
    bodies.mark_clear_interiors(&bounds, scene.ground.as_ref().map(|ground| ground.height));
    let top = Hierarchy::new(&bounds);
    check_depth("the scene", top.depth)?;
    (bodies.top_nodes, bodies.top_order) = (top.nodes, top.order);
    Ok(bodies)
}

fn check_transform(object: &Object) -> Result<(), RendererError> {
    let Transform { translation, rotation, scale } = object.transform;
    if translation.is_finite() && rotation.is_normalized() && scale > 0.0 && scale.is_finite() {
        return Ok(());
    }
    Err(RendererError::Invalid(format!(
        "{}: the transform must be finite, with a unit rotation and a scale above 0",
        object.name
    )))
}

/// A refracting mesh must enclose a volume.
fn check_mesh(object: &Object, mesh: &Mesh) -> Result<(), RendererError> {
    if let (Material::Dielectric(_), Err(fault)) = (&object.material, mesh.closed()) {
        return Err(RendererError::Invalid(format!("{}: {fault}", object.name)));
    }
    check_depth(&object.name, mesh.hierarchy().depth)
}

/// A deeper hierarchy would overflow the tracers' stacks.
fn check_depth(what: &str, depth: usize) -> Result<(), RendererError> {
    if depth <= MAX_DEPTH {
        return Ok(());
    }
    Err(RendererError::Invalid(format!(
        "{what}: its parts are so unevenly placed that {depth} levels of boxes are needed, and \
         {MAX_DEPTH} are allowed; split it into several objects"
    )))
}

impl PackedBodies {
    fn push_convex(&mut self, solid: &Solid, object: &Object, material: u32) -> Bounds {
        let first = self.planes.len() as u32;
        let count = solid.facets.len().next_multiple_of(PLANE_LANES);
        let mut planes = vec![0.0; 4 * count];
        for (i, facet) in solid.facets.iter().enumerate() {
            let (normal, distance) = world_plane(&facet.half_space, object);
            for (component, value) in normal.to_array().into_iter().chain([distance]).enumerate() {
                planes[component * count + i] = value as f32;
            }
        }
        self.planes.extend_from_slice(&planes);
        let bounds = Bounds::of(
            solid.vertices.iter().map(|vertex| object.transform.point(vertex.as_vec3())),
        );
        if object.throws_light {
            self.throwers.push(Thrower {
                name: object.name.clone(),
                instance: self.instances.len() as u32,
                material,
                facets: Polygon::of(solid, object),
                size_mm: (bounds.max - bounds.min).length(),
            });
        }
        self.instances.push(Instance {
            object_from_world: object_from_world(&object.transform),
            kind: CONVEX,
            first,
            count: count as u32,
            material,
            center: bounds.center(),
            interior_is_clear: 0,
        });
        bounds
    }

    /// Appends the mesh's hierarchy, with other facets than its own where there are any, and returns
    /// its root node.
    fn push_mesh(&mut self, mesh: &Mesh, facets: Option<&[u32]>) -> u32 {
        let root = self.nodes.len() as u32;
        let first_triangle = self.triangles.len() as u32;
        let hierarchy = mesh.hierarchy();
        self.nodes.extend(hierarchy.nodes.iter().map(|node| {
            let offset = if node.primitive_count == 0 { root } else { first_triangle };
            BvhNode { first: node.first + offset, ..*node }
        }));
        self.triangles.extend_from_slice(&hierarchy.triangles);
        let triangles = &mut self.triangles[first_triangle as usize..];
        for (triangle, &facet) in triangles.iter_mut().zip(facets.unwrap_or_default()) {
            triangle.facet = facet;
        }
        root
    }

    fn push_mesh_instance(
        &mut self,
        root: u32,
        mesh: &Mesh,
        object: &Object,
        material: u32,
    ) -> Bounds {
        let bounds =
            Bounds::of(mesh.positions.iter().map(|&position| object.transform.point(position)));
        self.instances.push(Instance {
            object_from_world: object_from_world(&object.transform),
            kind: MESH,
            first: root,
            count: 0,
            material,
            center: bounds.center(),
            interior_is_clear: 0,
        });
        bounds
    }

    fn mark_clear_interiors(&mut self, bounds: &[Bounds], ground_height: Option<f32>) {
        for (i, instance) in self.instances.iter_mut().enumerate() {
            let met_by_other =
                bounds.iter().enumerate().any(|(j, other)| j != i && other.overlaps(&bounds[i]));
            let met_by_ground = ground_height.is_some_and(|height| height > bounds[i].min.z);
            instance.interior_is_clear = u32::from(!met_by_other && !met_by_ground);
        }
    }
}

/// The rows of the matrix that takes points of the world into the object's frame.
fn object_from_world(transform: &Transform) -> [Vec4; 3] {
    let Transform { translation, rotation, scale } = *transform;
    let inverse = Mat3::from_quat(rotation.conjugate()) * (1.0 / scale);
    let offset = -(inverse * translation);
    [0, 1, 2].map(|i| inverse.row(i).extend(offset[i]))
}

/// Normal and distance of a facet plane in the world.
fn world_plane(half_space: &HalfSpace, object: &Object) -> (DVec3, f64) {
    let Transform { translation, rotation, scale } = object.transform;
    let normal = rotation.as_dquat() * half_space.normal;
    (normal, half_space.distance * f64::from(scale) + normal.dot(translation.as_dvec3()))
}
