//! Rays and convex solids: all facet planes in one loop, as many at a time as the processor can.
#![expect(
    clippy::inline_always,
    reason = "vector instructions are only chosen where the code is inlined into their dispatch"
)]

use glam::Vec3;
use pulp::{Arch, Simd, WithSimd};

use crate::kernel::ray::{Hit, Ray, TOUCHING_MM};
use crate::packed::{Instance, NONE, PLANE_LANES, PackedScene};

/// Numbers the planes that are tested at a time.
const LANES: [f32; PLANE_LANES] =
    [0., 1., 2., 3., 4., 5., 6., 7., 8., 9., 10., 11., 12., 13., 14., 15.];

/// 2²³, which stands in the lanes for facet 0: from here on floats are whole numbers, and their lowest
/// bits are the number of the facet, without the cost of a conversion.
const FIRST_FACET: f32 = 8_388_608.0;

/// Stands for the distance to a plane that the ray starts on, or by rounding beyond: one that can be
/// divided by.
const LEAST_GAP: f32 = 1e-30;

/// Where a ray inside the solid leaves it. There is always such a point: rounding can't lose it.
///
/// `left_facet`, the one that the ray has just left, or [`NONE`], is excluded: a ray can't meet a
/// plane twice.
#[inline]
pub fn leave_convex(scene: &PackedScene, instance: &Instance, ray: &Ray, left_facet: u32) -> Hit {
    let planes = Planes::of(scene, instance);
    Arch::new().dispatch(NearestExit { planes, ray, left_facet })
}

/// Where a ray from outside enters the solid. One that starts on its surface enters there.
#[inline]
pub fn enter_convex(scene: &PackedScene, instance: &Instance, ray: &Ray) -> Hit {
    let planes = Planes::of(scene, instance);
    Arch::new().dispatch(FarthestEntry { planes, ray })
}

/// The planes of one solid, component by component.
#[derive(Clone, Copy)]
pub(super) struct Planes<'a> {
    normal: [&'a [f32]; 3],
    distance: &'a [f32],
}

impl<'a> Planes<'a> {
    #[inline]
    pub(super) fn of(scene: &'a PackedScene, instance: &Instance) -> Self {
        let run = |i: u32| {
            let start = (instance.first + i * instance.count) as usize;
            &scene.planes[start..start + instance.count as usize]
        };
        Self { normal: [run(0), run(1), run(2)], distance: run(3) }
    }

    #[inline(always)]
    fn hit(&self, distance: f32, facet: u32) -> Hit {
        let [x, y, z] = self.normal.map(|component| component[facet as usize]);
        Hit { distance, instance: NONE, facet, normal: Vec3::new(x, y, z) }
    }
}

/// A ray spread over the lanes.
#[derive(Clone, Copy)]
struct WideRay<S: Simd> {
    origin: [S::f32s; 3],
    direction: [S::f32s; 3],
}

impl<S: Simd> WideRay<S> {
    #[inline(always)]
    fn new(simd: S, ray: &Ray) -> Self {
        Self {
            origin: ray.origin.to_array().map(|component| simd.splat_f32s(component)),
            direction: ray.direction.to_array().map(|component| simd.splat_f32s(component)),
        }
    }

    /// n·direction, and the distance from the origin to the plane along n.
    #[inline(always)]
    fn project(&self, simd: S, normal: [S::f32s; 3], distance: S::f32s) -> (S::f32s, S::f32s) {
        let [nx, ny, nz] = normal;
        let [dx, dy, dz] = self.direction;
        let towards = simd.mul_add_e_f32s(ny, dy, simd.mul_f32s(nz, dz));
        let towards = simd.mul_add_e_f32s(nx, dx, towards);
        let [ox, oy, oz] = self.origin;
        let gap = simd.negate_mul_add_e_f32s(nz, oz, distance);
        let gap = simd.negate_mul_add_e_f32s(ny, oy, gap);
        (towards, simd.negate_mul_add_e_f32s(nx, ox, gap))
    }
}

/// Calls `visit` with the normals, distances and numbers of the planes, a vector of them at a time.
#[inline(always)]
pub(super) fn for_each_vector<S: Simd>(
    simd: S,
    planes: &Planes<'_>,
    mut visit: impl FnMut([S::f32s; 3], S::f32s, S::f32s),
) {
    let [nx, ny, nz] = planes.normal.map(|component| S::as_simd_f32s(component).0);
    let distances = S::as_simd_f32s(planes.distance).0;
    let mut facets = simd.add_f32s(S::as_simd_f32s(&LANES).0[0], simd.splat_f32s(FIRST_FACET));
    let step = simd.splat_f32s(S::F32_LANES as f32);
    for (((&nx, &ny), &nz), &distance) in nx.iter().zip(ny).zip(nz).zip(distances) {
        visit([nx, ny, nz], distance, facets);
        facets = simd.add_f32s(facets, step);
    }
}

/// The greatest of all lanes, and the facet in the lane that it stands in.
#[inline(always)]
fn greatest<S: Simd>(simd: S, values: S::f32s, facets: S::f32s) -> (f32, u32) {
    let value = simd.reduce_max_f32s(values);
    let is_greatest = simd.equal_f32s(values, simd.splat_f32s(value));
    let infinity = simd.splat_f32s(f32::INFINITY);
    let facet = simd.reduce_min_f32s(simd.select_f32s(is_greatest, facets, infinity));
    (value, facet.to_bits() - FIRST_FACET.to_bits())
}

struct NearestExit<'a> {
    planes: Planes<'a>,
    ray: &'a Ray,
    left_facet: u32,
}

impl WithSimd for NearestExit<'_> {
    type Output = Hit;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Hit {
        let Self { planes, ray, left_facet } = self;
        let ray = WideRay::new(simd, ray);
        let (mut nearness, mut facet) = nearest_exit(simd, &planes, &ray, |_, towards| towards);
        // The facet that a ray has left lies behind it, unless it grazes it from within rounding.
        if facet == left_facet {
            let left_facet = simd.splat_f32s(FIRST_FACET + left_facet as f32);
            let zero = simd.splat_f32s(0.0);
            (nearness, facet) = nearest_exit(simd, &planes, &ray, |facets, towards| {
                simd.select_f32s(simd.equal_f32s(facets, left_facet), zero, towards)
            });
        }
        if nearness > 0.0 { planes.hit(nearness.recip(), facet) } else { Hit::MISS }
    }
}

/// The inverse of the distance to the first plane that the ray crosses outwards, and its facet; 0 where
/// there is none. `exclude` may replace n·direction of some facets by 0, which excludes them.
#[inline(always)]
fn nearest_exit<S: Simd>(
    simd: S,
    planes: &Planes<'_>,
    ray: &WideRay<S>,
    exclude: impl Fn(S::f32s, S::f32s) -> S::f32s,
) -> (f32, u32) {
    let least_gap = simd.splat_f32s(LEAST_GAP);
    // Of what is not crossed outwards the inverse is not above 0.
    let mut nearness = simd.splat_f32s(0.0);
    let mut nearest_facets = simd.splat_f32s(FIRST_FACET);
    for_each_vector(simd, planes, |normal, distance, facets| {
        let (towards, gap) = ray.project(simd, normal, distance);
        let towards = exclude(facets, towards);
        let inverse = simd.div_f32s(towards, simd.max_f32s(gap, least_gap));
        let is_nearer = simd.greater_than_f32s(inverse, nearness);
        nearness = simd.max_f32s(inverse, nearness);
        nearest_facets = simd.select_f32s(is_nearer, facets, nearest_facets);
    });
    greatest(simd, nearness, nearest_facets)
}

struct FarthestEntry<'a> {
    planes: Planes<'a>,
    ray: &'a Ray,
}

impl WithSimd for FarthestEntry<'_> {
    type Output = Hit;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Hit {
        let ray = WideRay::new(simd, self.ray);
        let zero = simd.splat_f32s(0.0);
        let infinity = simd.splat_f32s(f32::INFINITY);
        let minus_infinity = simd.splat_f32s(f32::NEG_INFINITY);
        let mut farthest = minus_infinity;
        let mut farthest_facets = simd.splat_f32s(FIRST_FACET);
        let mut nearest_exit = infinity;
        for_each_vector(simd, &self.planes, |normal, distance, facets| {
            let (towards, gap) = ray.project(simd, normal, distance);
            let crossing = simd.div_f32s(gap, towards);
            let enters = simd.less_than_f32s(towards, zero);
            let entry = simd.select_f32s(enters, crossing, minus_infinity);
            let is_farther = simd.greater_than_f32s(entry, farthest);
            farthest = simd.max_f32s(entry, farthest);
            farthest_facets = simd.select_f32s(is_farther, facets, farthest_facets);
            // A plane that the ray has behind it, or runs along outside of, shuts it out: such an
            // exit is at −∞.
            let leaves = simd.greater_than_f32s(towards, zero);
            let is_beyond = simd.less_than_f32s(gap, zero);
            let parallel = simd.select_f32s(is_beyond, minus_infinity, infinity);
            let outward = simd.select_f32s(leaves, crossing, parallel);
            let exit = simd.select_f32s(enters, infinity, outward);
            nearest_exit = simd.min_f32s(nearest_exit, exit);
        });
        let (entry_distance, facet) = greatest(simd, farthest, farthest_facets);
        let distance = entry_distance.max(0.0);
        let exit_distance = simd.reduce_min_f32s(nearest_exit);
        let is_met = entry_distance >= -TOUCHING_MM && distance < exit_distance;
        if is_met { self.planes.hit(distance, facet) } else { Hit::MISS }
    }
}
