//! The fan: an interval of wavelengths traced at three of them, its ends and its middle.
//!
//! All that is said of Thomas's spread vector in [`spread`](crate::kernel::spread) stops at a fan
//! without width and a straight line of directions. Here each of the three has its own start, its own
//! direction and its own weight, and between them all is quadratic in the position in the fan. So is the
//! place on the dispersion axis: where the light changes fast next to the critical wavelength, the
//! middle node lies nearer to it.

use glam::{Vec3, Vec3A};

use crate::kernel::nodes::{
    Nodes, basis_at, basis_of, blend, blend_nodes, equal_nodes, middle_node, normalize_each,
};
use crate::kernel::parabola::{parabola_through, position_where};
use crate::kernel::ray::Ray;
use crate::kernel::rng::hash;
use crate::packed::NONE;

/// The way on of the next part of a fan that is divided; those of what is reflected and refracted are
/// numbered by facets.
pub const NEXT_PART: u32 = u32::MAX;

/// Rays of an interval of wavelengths, at three of them.
#[derive(Clone, Copy, Debug)]
pub struct Fan {
    /// Where the rays start, in mm.
    pub origin: Nodes,
    /// Their unit directions.
    pub direction: Nodes,
    /// Products of the Fresnel factors so far: what their radiance counts in the pixel.
    pub weight: Vec3A,
    /// Lengths run inside `absorber`, not yet applied to the weights.
    pub path_mm: Vec3A,
    /// Positions on the dispersion axis.
    pub axis: Vec3A,
    /// The instance whose surface the rays have left, or [`NONE`].
    pub instance: u32,
    /// The facet of `instance` that the rays have left.
    pub facet: u32,
    /// The body that the rays run in, or [`NONE`] for air.
    pub medium: u32,
    /// The body that `medium` lies in, or [`NONE`]; deeper nesting is not kept.
    pub enclosing: u32,
    /// Interfaces met so far.
    pub depth: u32,
    /// The absorbing material that `path_mm` was run through, or [`NONE`].
    pub absorber: u32,
    /// A random word, the same in every pass for what has come the same way.
    pub seed: u32,
}

/// The whole spectrum along one ray, with weight 1.
#[inline]
pub fn white_fan(origin: Vec3, direction: Vec3, seed: u32) -> Fan {
    Fan {
        origin: equal_nodes(origin),
        direction: equal_nodes(direction),
        weight: Vec3A::ONE,
        path_mm: Vec3A::ZERO,
        axis: Vec3A::new(0.0, 0.5, 1.0),
        instance: NONE,
        facet: NONE,
        medium: NONE,
        enclosing: NONE,
        depth: 0,
        absorber: NONE,
        seed,
    }
}

/// The random word of what comes of a fan that has the word `seed` on one of its ways on.
#[inline]
pub fn seed_of_way(seed: u32, way: u32) -> u32 {
    hash(seed.wrapping_add(way))
}

/// Part of the dispersion axis between the ends of the fan.
#[inline]
pub fn axis_width(fan: &Fan) -> f32 {
    fan.axis.z - fan.axis.x
}

/// Position on the axis of a position in the fan.
#[inline]
pub fn axis_position_in(fan: &Fan, position: f32) -> f32 {
    basis_at(position).dot(fan.axis)
}

/// The position in the fan of a position on the axis.
#[inline]
pub fn position_of(fan: &Fan, axis_position: f32) -> f32 {
    position_where(&parabola_through(fan.axis), axis_position)
}

/// Whether the rays of different wavelengths are different rays.
#[inline]
pub fn is_dispersed(fan: &Fan) -> bool {
    fan.direction.x.x != fan.direction.x.z
        || fan.direction.y.x != fan.direction.y.z
        || fan.direction.z.x != fan.direction.z.z
}

/// Rays that are traced for a fan: one while all wavelengths take the same way.
#[inline]
pub fn segment_count(fan: &Fan) -> u32 {
    if is_dispersed(fan) { 3 } else { 1 }
}

/// The part of the fan between two positions in it.
#[inline]
pub fn part_of_fan(fan: &Fan, low: f32, high: f32) -> Fan {
    fan_through(fan, Vec3A::new(low, 0.5 * (low + high), high))
}

/// The part of the fan between two positions in it, with its middle node at a third between them.
#[inline]
pub fn fan_through(fan: &Fan, positions: Vec3A) -> Fan {
    let basis = basis_of(positions);
    let mut part = *fan;
    part.origin = blend_nodes(&fan.origin, basis);
    part.direction = normalize_each(&blend_nodes(&fan.direction, basis));
    part.weight = basis * fan.weight;
    part.path_mm = basis * fan.path_mm;
    part.axis = basis * fan.axis;
    part
}

/// The fan with the rays of all wavelengths on the middle one.
#[inline]
pub fn gathered(fan: &Fan) -> Fan {
    let mut together = *fan;
    together.origin = equal_nodes(middle_node(&fan.origin));
    together.direction = equal_nodes(middle_node(&fan.direction));
    together.path_mm = Vec3A::splat(fan.path_mm.y);
    together
}

/// The ray of one wavelength of the fan, without the light that it carries.
#[inline]
pub fn ray_in_fan(fan: &Fan, position: f32) -> Ray {
    let basis = basis_at(position);
    let direction = blend(&fan.direction, basis).normalize_or_zero();
    let mut ray = Ray::white(blend(&fan.origin, basis), direction);
    ray.instance = fan.instance;
    ray.facet = fan.facet;
    ray.medium = fan.medium;
    ray.enclosing = fan.enclosing;
    ray.depth = fan.depth;
    ray
}
