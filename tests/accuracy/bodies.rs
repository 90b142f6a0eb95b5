//! Rays and bodies in double precision, every plane and every triangle asked.

use brilliance_renderer::material::{Dispersion, Material};
use brilliance_renderer::scene::{Object, Shape, Transform};
use glam::{DQuat, DVec3};

/// What is nearer than this, in mm, to where a ray starts outside of a body is where it starts.
const START_MM: f64 = 1e-9;

/// Where a ray meets a surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Meeting {
    pub(crate) distance: f64,
    /// Outward unit normal of the body.
    pub(crate) normal: DVec3,
    /// Number of the plane or triangle.
    pub(crate) facet: usize,
}

/// A clear body in the world.
pub(crate) struct Body {
    surface: Surface,
    pub(crate) dispersion: Dispersion,
}

enum Surface {
    Convex(Vec<Plane>),
    Mesh(Vec<Triangle>),
}

/// The points x with `normal · x ≤ distance`.
struct Plane {
    normal: DVec3,
    distance: f64,
}

struct Triangle {
    corner: DVec3,
    edges: [DVec3; 2],
    normal: DVec3,
}

impl Body {
    pub(crate) fn new(object: &Object) -> Self {
        let Material::Dielectric(dielectric) = &object.material else {
            panic!("{}: only what is clear is a body here", object.name);
        };
        assert_eq!(dielectric.absorption_per_mm, None, "{}: nothing is coloured", object.name);
        let surface = Surface::new(&object.shape, &object.transform);
        Self { surface, dispersion: dielectric.dispersion.clone() }
    }

    /// Where a ray inside leaves the body.
    pub(crate) fn leave(&self, origin: DVec3, direction: DVec3) -> Option<Meeting> {
        match &self.surface {
            Surface::Convex(planes) => leave_convex(planes, origin, direction),
            Surface::Mesh(triangles) => nearest(triangles, origin, direction, 1.0),
        }
    }

    /// Where a ray outside enters the body.
    pub(crate) fn enter(&self, origin: DVec3, direction: DVec3) -> Option<Meeting> {
        match &self.surface {
            Surface::Convex(planes) => enter_convex(planes, origin, direction),
            Surface::Mesh(triangles) => nearest(triangles, origin, direction, -1.0),
        }
    }
}

impl Surface {
    fn new(shape: &Shape, transform: &Transform) -> Self {
        let [x, y, z, w] = transform.rotation.to_array().map(f64::from);
        let rotation = DQuat::from_xyzw(x, y, z, w).normalize();
        let (scale, shift) = (f64::from(transform.scale), transform.translation.as_dvec3());
        let half_spaces = match shape {
            Shape::RoundBrilliant(cut) => cut.half_spaces().expect("the cut closes"),
            Shape::Polyhedron(half_spaces) => half_spaces.clone(),
            Shape::Mesh(source) => {
                let mesh = &source.mesh;
                let position =
                    |i: u32| rotation * (mesh.positions[i as usize].as_dvec3() * scale) + shift;
                let triangles = mesh.triangles.iter().map(|corners| corners.map(position));
                return Self::Mesh(triangles.map(Triangle::new).collect());
            }
        };
        let planes = half_spaces.iter().map(|half_space| {
            let normal = rotation * half_space.normal.normalize();
            let distance = scale * half_space.distance / half_space.normal.length();
            Plane { normal, distance: distance + normal.dot(shift) }
        });
        Self::Convex(planes.collect())
    }
}

impl Triangle {
    fn new([a, b, c]: [DVec3; 3]) -> Self {
        let edges = [b - a, c - a];
        Self { corner: a, edges, normal: edges[0].cross(edges[1]).normalize() }
    }

    /// Möller and Trumbore 1997.
    fn distance(&self, origin: DVec3, direction: DVec3) -> Option<f64> {
        let [u_edge, v_edge] = self.edges;
        let across = direction.cross(v_edge);
        let determinant = u_edge.dot(across);
        let from_corner = origin - self.corner;
        let u = from_corner.dot(across) / determinant;
        let around = from_corner.cross(u_edge);
        let v = direction.dot(around) / determinant;
        let distance = v_edge.dot(around) / determinant;
        (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 0.0).then_some(distance)
    }
}

/// The nearest plane that the ray crosses outwards.
fn leave_convex(planes: &[Plane], origin: DVec3, direction: DVec3) -> Option<Meeting> {
    // Distances are compared as fractions: one division is enough.
    let (mut gap, mut towards, mut facet) = (1.0, 0.0, 0);
    for (i, plane) in planes.iter().enumerate() {
        let plane_towards = plane.normal.dot(direction);
        let plane_gap = plane.distance - plane.normal.dot(origin);
        if plane_towards > 0.0 && plane_gap * towards < gap * plane_towards {
            (gap, towards, facet) = (plane_gap, plane_towards, i);
        }
    }
    let distance = (gap / towards).max(0.0);
    (towards > 0.0).then(|| Meeting { distance, normal: planes[facet].normal, facet })
}

/// The farthest plane that the ray crosses inwards, if that is before any that it crosses outwards.
fn enter_convex(planes: &[Plane], origin: DVec3, direction: DVec3) -> Option<Meeting> {
    let mut entry = None;
    let (mut entry_distance, mut exit_distance) = (START_MM, f64::INFINITY);
    for (facet, plane) in planes.iter().enumerate() {
        let towards = plane.normal.dot(direction);
        let gap = plane.distance - plane.normal.dot(origin);
        let distance = gap / towards;
        if towards < 0.0 && distance > entry_distance {
            entry_distance = distance;
            entry = Some(Meeting { distance, normal: plane.normal, facet });
        } else if towards > 0.0 {
            exit_distance = exit_distance.min(distance);
        } else if towards == 0.0 && gap < 0.0 {
            return None;
        }
    }
    entry.filter(|entry| entry.distance < exit_distance)
}

/// The nearest triangle whose normal points along the ray, for a `side` of 1, or against it, for −1.
/// A triangle that the ray has just left is never among them.
fn nearest(triangles: &[Triangle], origin: DVec3, direction: DVec3, side: f64) -> Option<Meeting> {
    triangles
        .iter()
        .enumerate()
        .filter(|(_, triangle)| side * triangle.normal.dot(direction) > 0.0)
        .filter_map(|(facet, triangle)| {
            let distance = triangle.distance(origin, direction)?;
            Some(Meeting { distance, normal: triangle.normal, facet })
        })
        .min_by(|a, b| a.distance.total_cmp(&b.distance))
}
