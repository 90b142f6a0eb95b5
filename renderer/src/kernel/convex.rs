//! Rays and convex solids: all planes, eight at a time, in one loop.

use glam::Vec3;
use wide::f32x8;

use crate::kernel::ray::{Hit, Ray};
use crate::packed::{Instance, NONE, PLANES_PER_BLOCK, PackedScene, PlaneBlock};

/// A solid whose surface lies this little behind the start of a ray touches the one that the ray
/// has left, in mm: rounding must not carry the ray past the surface.
const TOUCHING_MM: f32 = 1e-4;

/// Numbers the planes of a block.
const LANES: [f32; PLANES_PER_BLOCK] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];

/// Where a ray inside the solid leaves it. There is always such a point: rounding can't lose it.
///
/// The facet that the ray has left is excluded: a ray can't meet a plane twice.
#[inline]
pub fn exit(scene: &PackedScene, instance: &Instance, ray: &Ray) -> Hit {
    let origin = ray.origin.to_array().map(f32x8::splat);
    let direction = ray.direction.to_array().map(f32x8::splat);
    let left_facet = f32x8::splat(if ray.facet == NONE { -1.0 } else { ray.facet as f32 });
    let mut nearest = f32x8::splat(f32::INFINITY);
    let mut nearest_facet = f32x8::splat(-1.0);
    let mut facet = f32x8::from(LANES);
    for block in blocks(scene, instance) {
        let (towards, gap) = project(block, &origin, &direction);
        let distance = gap / towards;
        let is_nearer =
            towards.simd_gt(f32x8::ZERO) & distance.simd_lt(nearest) & !facet.simd_eq(left_facet);
        nearest = is_nearer.select(distance, nearest);
        nearest_facet = is_nearer.select(facet, nearest_facet);
        facet += f32x8::splat(PLANES_PER_BLOCK as f32);
    }
    let (distance, facet) = least(nearest, nearest_facet);
    hit(scene, instance, ray, distance.max(0.0), facet)
}

/// Where a ray from outside enters the solid.
#[inline]
pub fn entry(scene: &PackedScene, instance: &Instance, ray: &Ray) -> Hit {
    let origin = ray.origin.to_array().map(f32x8::splat);
    let direction = ray.direction.to_array().map(f32x8::splat);
    let mut nearest_exit = f32x8::splat(f32::INFINITY);
    let mut farthest_entry = f32x8::splat(f32::NEG_INFINITY);
    let mut entry_facet = f32x8::splat(-1.0);
    let mut facet = f32x8::from(LANES);
    for block in blocks(scene, instance) {
        let (towards, gap) = project(block, &origin, &direction);
        let distance = gap / towards;
        let is_farther = towards.simd_lt(f32x8::ZERO) & distance.simd_gt(farthest_entry);
        farthest_entry = is_farther.select(distance, farthest_entry);
        entry_facet = is_farther.select(facet, entry_facet);
        // A plane that the ray runs along or away behind of shuts it out: its exit is at −∞.
        let is_beyond = !towards.simd_lt(f32x8::ZERO) & gap.simd_lt(f32x8::ZERO);
        let exit = is_beyond.select(
            f32x8::splat(f32::NEG_INFINITY),
            towards.simd_gt(f32x8::ZERO).select(distance, f32x8::splat(f32::INFINITY)),
        );
        nearest_exit = nearest_exit.fast_min(exit);
        facet += f32x8::splat(PLANES_PER_BLOCK as f32);
    }
    let (negated, facet) = least(-farthest_entry, entry_facet);
    let (exit_distance, _) = least(nearest_exit, entry_facet);
    let distance = -negated;
    if distance > -TOUCHING_MM && distance.max(0.0) < exit_distance {
        hit(scene, instance, ray, distance.max(0.0), facet)
    } else {
        Hit::MISS
    }
}

#[inline]
fn blocks<'a>(scene: &'a PackedScene, instance: &Instance) -> &'a [PlaneBlock] {
    &scene.planes[instance.first as usize..(instance.first + instance.count) as usize]
}

/// For eight planes: n·direction, and the distance from the origin to the plane along n.
#[inline(always)]
#[expect(clippy::inline_always, reason = "the plane loop is the tracer's innermost")]
fn project(block: &PlaneBlock, origin: &[f32x8; 3], direction: &[f32x8; 3]) -> (f32x8, f32x8) {
    let (nx, ny, nz) = (f32x8::from(block.nx), f32x8::from(block.ny), f32x8::from(block.nz));
    let towards = nx * direction[0] + ny * direction[1] + nz * direction[2];
    let height = nx * origin[0] + ny * origin[1] + nz * origin[2];
    (towards, f32x8::from(block.distance) - height)
}

/// The least of eight values and the number that stands in its lane.
#[inline]
fn least(values: f32x8, numbers: f32x8) -> (f32, f32) {
    let (values, numbers) = (values.to_array(), numbers.to_array());
    let mut best = 0;
    for lane in 1..PLANES_PER_BLOCK {
        if values[lane] < values[best] {
            best = lane;
        }
    }
    (values[best], numbers[best])
}

#[inline]
fn hit(scene: &PackedScene, instance: &Instance, ray: &Ray, distance: f32, facet: f32) -> Hit {
    if facet < 0.0 {
        return Hit::MISS;
    }
    let facet = facet as usize;
    let block = &blocks(scene, instance)[facet / PLANES_PER_BLOCK];
    let lane = facet % PLANES_PER_BLOCK;
    Hit {
        distance,
        instance: ray.instance,
        facet: facet as u32,
        normal: Vec3::new(block.nx[lane], block.ny[lane], block.nz[lane]),
    }
}
