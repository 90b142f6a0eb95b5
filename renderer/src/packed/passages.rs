//! Packing of the passages: through which two facets of which body the light of which disc can go
//! straight.
//!
//! A disc's directions and the wavelengths are tried at samples. What lies between the samples is
//! allowed for by widening: a passage too many costs time, one too few would be a dark spot.

use std::f32::consts::TAU;

use glam::Vec3;

use super::bodies::Thrower;
use super::spectra::PackedMaterials;
use super::{PackedDisc, PackedPassage};
use crate::error::RendererError;
use crate::kernel::diffuse::direction_on_disc;
use crate::kernel::interface::{cos_refracted_squared, refract};
use crate::scene::Object;
use crate::solid::Solid;

/// Most passages of a scene. Every point of a matte surface asks them all, at some 10 ns each.
pub const MAX_PASSAGES: usize = 8192;
/// Most facets of a body that throws light: all pairs are tried.
pub const MAX_THROWER_FACETS: usize = 256;

/// Nanometres between the wavelengths that are tried.
const LAMBDA_STEP_NM: usize = 35;
/// Degrees between the rings of directions that are tried on a disc, as long as there are few.
const RING_STEP_DEGREES: f32 = 5.0;
/// Most rings on a disc.
const MAX_RINGS: u32 = 6;
/// Part of the angles between samples that the light between them can be off by.
const BETWEEN_SAMPLES: f32 = 0.6;
/// How much, in radians, the light of one direction can be off between two wavelengths that are tried.
const BETWEEN_WAVELENGTHS: f32 = 0.02;

/// A facet in the world.
#[derive(Clone, Debug)]
pub(super) struct Polygon {
    normal: Vec3,
    corners: Vec<Vec3>,
    /// On its plane, of a sphere about the corners.
    center: Vec3,
    radius: f32,
}

impl Polygon {
    /// The facets of an object in the world, in the order of its planes.
    pub(super) fn of(solid: &Solid, object: &Object) -> Vec<Self> {
        let facets = solid.facets.iter().map(|facet| {
            let corner = |&i: &u32| object.transform.point(solid.vertices[i as usize].as_vec3());
            let corners: Vec<_> = facet.vertices.iter().map(corner).collect();
            let center = corners.iter().sum::<Vec3>() / corners.len() as f32;
            let radius = corners.iter().map(|corner| corner.distance(center)).fold(0.0, f32::max);
            let normal = object.transform.direction(facet.half_space.normal.as_vec3());
            // Room for rounding.
            Self { normal, corners, center, radius: 1.001 * radius }
        });
        facets.collect()
    }

    /// Whether light that runs along `direction`, or up to `margin_mm` beside that, gets from here to
    /// `other`: whether the two overlap, seen along it. That they don't shows across one of their
    /// edges.
    fn shines_on(&self, other: &Self, direction: Vec3, margin_mm: f32) -> bool {
        let reach = self.radius + other.radius + margin_mm;
        if (other.center - self.center).cross(direction).length_squared() > reach * reach {
            return false;
        }
        let is_apart = |edge: Vec3| {
            let across = direction.cross(edge).normalize_or_zero();
            let (from, to) = (self.range(across), other.range(across));
            from[0] > to[1] + margin_mm || to[0] > from[1] + margin_mm
        };
        !self.edges().chain(other.edges()).any(is_apart)
    }

    fn edges(&self) -> impl Iterator<Item = Vec3> {
        let next = self.corners.iter().cycle().skip(1);
        self.corners.iter().zip(next).map(|(a, b)| b - a)
    }

    /// From where to where it reaches along `axis`.
    fn range(&self, axis: Vec3) -> [f32; 2] {
        let places = self.corners.iter().map(|corner| corner.dot(axis));
        places.fold([f32::MAX, f32::MIN], |[low, high], at| [low.min(at), high.max(at)])
    }
}

/// Finds the passages of all discs through all throwers, and enters into the discs which are theirs.
pub(super) fn pack(
    discs: &mut [PackedDisc],
    throwers: &[Thrower],
    materials: &PackedMaterials,
) -> Result<Vec<PackedPassage>, RendererError> {
    for thrower in throwers {
        check_facets(thrower)?;
    }
    let mut passages = Vec::new();
    for disc in discs {
        disc.first_passage = passages.len() as u32;
        for thrower in throwers {
            let indices = materials.indices_of(thrower.material);
            add_passages(&mut passages, disc, thrower, indices)?;
        }
        disc.passage_count = passages.len() as u32 - disc.first_passage;
    }
    Ok(passages)
}

fn check_facets(thrower: &Thrower) -> Result<(), RendererError> {
    let count = thrower.facets.len();
    if count <= MAX_THROWER_FACETS {
        return Ok(());
    }
    Err(RendererError::Invalid(format!(
        "{}: it has {count} facets, and what throws light may have {MAX_THROWER_FACETS}; switch \
         throws_light off, or give it fewer facets",
        thrower.name
    )))
}

/// Light of one wavelength inside a body.
struct Inside {
    direction: Vec3,
    n: f32,
}

fn add_passages(
    passages: &mut Vec<PackedPassage>,
    disc: &PackedDisc,
    thrower: &Thrower,
    indices: &[f32],
) -> Result<(), RendererError> {
    let (towards_light, ring_step) = directions(disc);
    let margin_mm = thrower.size_mm * (BETWEEN_SAMPLES * ring_step + BETWEEN_WAVELENGTHS);
    for (facet_in, entry) in thrower.facets.iter().enumerate() {
        let facing = towards_light.iter().filter(|light| light.dot(entry.normal) > 0.0);
        let light: Vec<_> = facing
            .flat_map(|&light| {
                indices.iter().step_by(LAMBDA_STEP_NM).map(move |&n| {
                    let direction = refract(-light, entry.normal, 1.0 / n);
                    Inside { direction, n }
                })
            })
            .collect();
        let inside: Vec<_> = light.iter().map(|light| light.direction).collect();
        // All of it at once runs along one direction, and drifts at most so far from that in the body.
        let shaft = Cone::around(&inside, -entry.normal, 0.0);
        let drift = if shaft.cos_bound > 0.0 { shaft.sin_bound } else { 1.0 };
        let drift_mm = margin_mm + thrower.size_mm * drift;
        for (facet_out, exit) in thrower.facets.iter().enumerate() {
            if facet_in == facet_out || !entry.shines_on(exit, shaft.direction, drift_mm) {
                continue;
            }
            let arrives = light.iter().any(|light| {
                gets_out(light, exit) && entry.shines_on(exit, light.direction, margin_mm)
            });
            if !arrives {
                continue;
            }
            if passages.len() == MAX_PASSAGES {
                return Err(RendererError::Invalid(format!(
                    "{}: with it there are more than {MAX_PASSAGES} ways for the lamps' light straight \
                     through bodies that throw light; let fewer throw light, or use fewer lamps",
                    thrower.name
                )));
            }
            let cone = Cone::behind(&light, exit, ring_step);
            passages.push(PackedPassage {
                center_out: exit.center,
                radius_out: exit.radius,
                direction: cone.direction,
                cos_bound: cone.cos_bound,
                normal_in: entry.normal,
                sin_bound: cone.sin_bound,
                normal_out: exit.normal,
                instance: thrower.instance,
                center_in: entry.center,
                radius_in: entry.radius,
                facet_in: facet_in as u32,
                facet_out: facet_out as u32,
                padding: [0; 2],
            });
        }
    }
    Ok(())
}

/// Whether the light is refracted at the facet that it reaches.
fn gets_out(light: &Inside, exit: &Polygon) -> bool {
    let cos = light.direction.dot(exit.normal);
    cos > 0.0 && cos_refracted_squared(cos, light.n) > 0.0
}

/// Directions all over the disc, in rings about its middle; the angle in radians between rings.
fn directions(disc: &PackedDisc) -> (Vec<Vec3>, f32) {
    let radius = disc.sin_squared_radius.sqrt().atan2(disc.cos_radius);
    let rings = (radius.to_degrees() / RING_STEP_DEGREES).ceil().clamp(1.0, MAX_RINGS as f32);
    let step = radius / rings;
    let height = 1.0 - disc.cos_radius;
    let mut directions = vec![disc.direction];
    for ring in 1..=rings as u32 {
        // The part of the solid angle within the ring; that of a small disc is that of the plane.
        let within = if height > 1e-4 {
            (1.0 - (step * ring as f32).cos()) / height
        } else {
            (ring as f32 / rings).powi(2)
        };
        let count = 8 * ring;
        directions
            .extend((0..count).map(|i| direction_on_disc(disc, [within, i as f32 / count as f32])));
    }
    (directions, step)
}

/// A cone that holds directions; one that is no narrower than a half-space holds all.
struct Cone {
    direction: Vec3,
    cos_bound: f32,
    sin_bound: f32,
}

impl Cone {
    /// A tenth and `margin_radians` wider than `directions`; about `axis` where they have no middle.
    fn around(directions: &[Vec3], axis: Vec3, margin_radians: f32) -> Self {
        let direction = directions.iter().sum::<Vec3>().normalize_or(axis);
        let angles = directions.iter().map(|other| other.angle_between(direction));
        let bound = 1.1 * angles.fold(0.0, f32::max) + margin_radians;
        let (sin_bound, cos_bound) = if bound < 0.25 * TAU { bound.sin_cos() } else { (0.0, 0.0) };
        Self { direction, cos_bound, sin_bound }
    }

    /// The directions in which a passage's light is seen from behind.
    ///
    /// Where some of the light is totally reflected, the cone reaches down to the facet: in between
    /// there is light that leaves along it.
    fn behind(light: &[Inside], exit: &Polygon, ring_step: f32) -> Self {
        let seen: Vec<_> = light
            .iter()
            .filter(|light| light.direction.dot(exit.normal) > 0.0)
            .map(|light| -refract(light.direction, -exit.normal, light.n))
            .collect();
        Self::around(&seen, exit.normal, 0.1 * ring_step + 0.5 * BETWEEN_WAVELENGTHS)
    }
}
