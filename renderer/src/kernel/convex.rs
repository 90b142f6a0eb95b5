//! Rays and convex solids: all facet planes in one loop, as many at a time as the processor can.
#![expect(
    clippy::inline_always,
    reason = "vector instructions are only chosen where the code is inlined into their dispatch"
)]

use glam::{Vec3, Vec3A};
use pulp::{Arch, Simd, WithSimd};

use crate::kernel::nodes::{Nodes, high_node, low_node, middle_node};
use crate::kernel::parabola::{crossings, parabola_through};
use crate::kernel::ray::{Hit, Ray, TOUCHING_MM};
use crate::packed::{Instance, NONE, PLANE_LANES, PackedScene};

/// Numbers the planes that are tested at a time.
const LANES: [f32; PLANE_LANES] =
    [0., 1., 2., 3., 4., 5., 6., 7., 8., 9., 10., 11., 12., 13., 14., 15.];

/// How far outside of a facet, in mm, a point counts as within it.
pub const FACET_TOLERANCE_MM: f32 = 2e-5;

/// Scale of a point on a facet's plane, the cosine to its normal, from which on it counts.
pub const LEAST_SCALE: f32 = 1e-4;

/// The facet number of no facet.
const NO_FACET: f32 = -1.0;

/// Where a ray inside the solid leaves it. There is always such a point: rounding can't lose it.
///
/// `left_facet`, the one that the ray has just left, or [`NONE`], is excluded: a ray can't meet a
/// plane twice.
#[inline]
pub fn leave_convex(scene: &PackedScene, instance: &Instance, ray: &Ray, left_facet: u32) -> Hit {
    let planes = Planes::of(scene, instance);
    let left_facet = if left_facet == NONE { NO_FACET } else { left_facet as f32 };
    let crossing = Arch::new().dispatch(NearestExit { planes, ray, left_facet });
    if crossing.facet < 0.0 {
        return Hit::MISS;
    }
    planes.hit(crossing.distance.max(0.0), crossing.facet)
}

/// Where a ray from outside enters the solid. One that starts on its surface enters there.
#[inline]
pub fn enter_convex(scene: &PackedScene, instance: &Instance, ray: &Ray) -> Hit {
    let planes = Planes::of(scene, instance);
    let (entry, exit_distance) = Arch::new().dispatch(FarthestEntry { planes, ray });
    let distance = entry.distance.max(0.0);
    if entry.facet < 0.0 || entry.distance < -TOUCHING_MM || distance >= exit_distance {
        return Hit::MISS;
    }
    planes.hit(distance, entry.facet)
}

/// The part of a fan about its middle, between two positions in it, whose points on the plane of
/// `facet` lie within that facet.
///
/// The points are `points` over `scale`, in homogeneous coordinates; where `scale` is not above 0 there
/// is none. The middle one lies within the facet.
#[inline]
pub fn clip_to_facet(
    scene: &PackedScene,
    instance: &Instance,
    points: &Nodes,
    scale: Vec3A,
) -> [f32; 2] {
    let planes = Planes::of(scene, instance);
    let [low, high] = facing_part(scale);
    if Arch::new().dispatch(FarthestOutside { planes, points, scale }) <= FACET_TOLERANCE_MM {
        return [low, high];
    }
    let [inside_low, inside_high] = Arch::new().dispatch(InsideShares { planes, points, scale });
    [low.max(-inside_low), high.min(inside_high)]
}

/// The part of a fan about its middle whose points have a scale.
#[inline]
pub fn facing_part(scale: Vec3A) -> [f32; 2] {
    let mut facing = [-1.0, 1.0];
    if scale.x < LEAST_SCALE || scale.z < LEAST_SCALE {
        let [first, second] = crossings(&parabola_through(scale - Vec3A::splat(LEAST_SCALE)));
        if scale.x < LEAST_SCALE {
            facing[0] = if second < 0.0 { second } else { first.min(0.0) };
        }
        if scale.z < LEAST_SCALE {
            facing[1] = if first > 0.0 { first } else { second.max(0.0) };
        }
    }
    facing
}

/// A plane that a ray crosses.
#[derive(Clone, Copy)]
struct Crossing {
    distance: f32,
    facet: f32,
}

/// The planes of one solid, component by component.
#[derive(Clone, Copy)]
struct Planes<'a> {
    normal: [&'a [f32]; 3],
    distance: &'a [f32],
}

impl<'a> Planes<'a> {
    #[inline]
    fn of(scene: &'a PackedScene, instance: &Instance) -> Self {
        let run = |i: u32| {
            let start = (instance.first + i * instance.count) as usize;
            &scene.planes[start..start + instance.count as usize]
        };
        Self { normal: [run(0), run(1), run(2)], distance: run(3) }
    }

    #[inline]
    fn hit(&self, distance: f32, facet: f32) -> Hit {
        let facet = facet as usize;
        let [x, y, z] = self.normal.map(|component| component[facet]);
        Hit { distance, instance: NONE, facet: facet as u32, normal: Vec3::new(x, y, z) }
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
        let towards = dot(simd, normal, self.direction);
        (towards, simd.sub_f32s(distance, dot(simd, normal, self.origin)))
    }
}

#[inline(always)]
fn dot<S: Simd>(simd: S, a: [S::f32s; 3], b: [S::f32s; 3]) -> S::f32s {
    let yz = simd.mul_add_e_f32s(a[1], b[1], simd.mul_f32s(a[2], b[2]));
    simd.mul_add_e_f32s(a[0], b[0], yz)
}

/// Calls `visit` with the normals, distances and numbers of the planes, a vector of them at a time.
#[inline(always)]
fn for_each_vector<S: Simd>(
    simd: S,
    planes: &Planes<'_>,
    mut visit: impl FnMut([S::f32s; 3], S::f32s, S::f32s),
) {
    let [nx, ny, nz] = planes.normal.map(|component| S::as_simd_f32s(component).0);
    let distances = S::as_simd_f32s(planes.distance).0;
    let mut facets = S::as_simd_f32s(&LANES).0[0];
    let step = simd.splat_f32s(S::F32_LANES as f32);
    for (((&nx, &ny), &nz), &distance) in nx.iter().zip(ny).zip(nz).zip(distances) {
        visit([nx, ny, nz], distance, facets);
        facets = simd.add_f32s(facets, step);
    }
}

/// The lane with the least value: that value, and what stands in the lane of `facets`.
#[inline(always)]
fn least<S: Simd>(simd: S, distances: S::f32s, facets: S::f32s) -> Crossing {
    let distance = simd.reduce_min_f32s(distances);
    let is_least = simd.equal_f32s(distances, simd.splat_f32s(distance));
    let infinity = simd.splat_f32s(f32::INFINITY);
    let facet = simd.reduce_min_f32s(simd.select_f32s(is_least, facets, infinity));
    Crossing { distance, facet: if distance < f32::INFINITY { facet } else { NO_FACET } }
}

struct NearestExit<'a> {
    planes: Planes<'a>,
    ray: &'a Ray,
    left_facet: f32,
}

impl WithSimd for NearestExit<'_> {
    type Output = Crossing;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Crossing {
        let ray = WideRay::new(simd, self.ray);
        let left_facet = simd.splat_f32s(self.left_facet);
        let zero = simd.splat_f32s(0.0);
        let infinity = simd.splat_f32s(f32::INFINITY);
        let mut nearest = infinity;
        let mut nearest_facets = infinity;
        for_each_vector(simd, &self.planes, |normal, distance, facets| {
            let (towards, gap) = ray.project(simd, normal, distance);
            let is_left = simd.equal_f32s(facets, left_facet);
            let towards = simd.select_f32s(is_left, zero, towards);
            let crossing = simd.select_f32s(
                simd.greater_than_f32s(towards, zero),
                simd.div_f32s(gap, towards),
                infinity,
            );
            let is_nearer = simd.less_than_f32s(crossing, nearest);
            nearest = simd.select_f32s(is_nearer, crossing, nearest);
            nearest_facets = simd.select_f32s(is_nearer, facets, nearest_facets);
        });
        least(simd, nearest, nearest_facets)
    }
}

/// Three points spread over the lanes, and what they are divided by.
struct WidePoints<S: Simd> {
    points: [[S::f32s; 3]; 3],
    scale: [S::f32s; 3],
}

impl<S: Simd> WidePoints<S> {
    #[inline(always)]
    fn new(simd: S, points: &Nodes, scale: Vec3A) -> Self {
        let splat = |vector: Vec3| vector.to_array().map(|component| simd.splat_f32s(component));
        Self {
            points: [low_node(points), middle_node(points), high_node(points)].map(splat),
            scale: scale.to_array().map(|component| simd.splat_f32s(component)),
        }
    }

    /// How far a point is outside of the planes, times its scale.
    #[inline(always)]
    fn outside(&self, simd: S, node: usize, normal: [S::f32s; 3], distance: S::f32s) -> S::f32s {
        let along = dot(simd, normal, self.points[node]);
        simd.sub_f32s(along, simd.mul_f32s(distance, self.scale[node]))
    }
}

struct FarthestOutside<'a> {
    planes: Planes<'a>,
    points: &'a Nodes,
    scale: Vec3A,
}

impl WithSimd for FarthestOutside<'_> {
    /// How far the end points are outside of any plane.
    type Output = f32;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> f32 {
        let points = WidePoints::new(simd, self.points, self.scale);
        let mut farthest = simd.splat_f32s(0.0);
        for_each_vector(simd, &self.planes, |normal, distance, _| {
            let low = points.outside(simd, 0, normal, distance);
            let high = points.outside(simd, 2, normal, distance);
            farthest = simd.max_f32s(farthest, simd.max_f32s(low, high));
        });
        simd.reduce_max_f32s(farthest)
    }
}

struct InsideShares<'a> {
    planes: Planes<'a>,
    points: &'a Nodes,
    scale: Vec3A,
}

impl WithSimd for InsideShares<'_> {
    /// How far towards each end the points stay inside of all planes, in 0..=1.
    type Output = [f32; 2];

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> [f32; 2] {
        let points = WidePoints::new(simd, self.points, self.scale);
        let zero = simd.splat_f32s(0.0);
        let one = simd.splat_f32s(1.0);
        let half = simd.splat_f32s(0.5);
        let tolerance = simd.splat_f32s(FACET_TOLERANCE_MM);
        let (mut low_share, mut high_share) = (one, one);
        for_each_vector(simd, &self.planes, |normal, distance, _| {
            let [low, middle, high] = [0, 1, 2].map(|i| points.outside(simd, i, normal, distance));
            let c = simd.min_f32s(middle, zero);
            let mean = simd.mul_f32s(half, simd.add_f32s(low, high));
            let a = simd.sub_f32s(mean, c);
            let b = simd.mul_f32s(half, simd.sub_f32s(high, low));
            let share = |b, end| {
                let share = crossing_share(simd, a, b, c);
                simd.select_f32s(simd.greater_than_f32s(end, tolerance), share, one)
            };
            low_share = simd.min_f32s(low_share, share(simd.neg_f32s(b), low));
            high_share = simd.min_f32s(high_share, share(b, high));
        });
        [simd.reduce_min_f32s(low_share), simd.reduce_min_f32s(high_share)]
    }
}

/// The root in 0..=1 of a·u² + b·u + c, of which c is not above 0 and a + b + c is.
#[inline(always)]
fn crossing_share<S: Simd>(simd: S, a: S::f32s, b: S::f32s, c: S::f32s) -> S::f32s {
    let zero = simd.splat_f32s(0.0);
    let two = simd.splat_f32s(2.0);
    let four_ac = simd.mul_f32s(simd.splat_f32s(4.0), simd.mul_f32s(a, c));
    let square = simd.max_f32s(simd.sub_f32s(simd.mul_f32s(b, b), four_ac), zero);
    let root = simd.sqrt_f32s(square);
    let falls = simd.less_than_f32s(b, zero);
    let numerator =
        simd.select_f32s(falls, simd.sub_f32s(root, b), simd.mul_f32s(simd.neg_f32s(two), c));
    let denominator = simd.select_f32s(falls, simd.mul_f32s(two, a), simd.add_f32s(b, root));
    let share = simd.div_f32s(numerator, denominator);
    simd.min_f32s(simd.max_f32s(share, zero), simd.splat_f32s(1.0))
}

struct FarthestEntry<'a> {
    planes: Planes<'a>,
    ray: &'a Ray,
}

impl WithSimd for FarthestEntry<'_> {
    /// The last plane that the ray crosses inwards, and the distance of the first outwards.
    type Output = (Crossing, f32);

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> (Crossing, f32) {
        let ray = WideRay::new(simd, self.ray);
        let zero = simd.splat_f32s(0.0);
        let infinity = simd.splat_f32s(f32::INFINITY);
        let minus_infinity = simd.splat_f32s(f32::NEG_INFINITY);
        // Entry distances are negated, so that the farthest is the least.
        let mut farthest = infinity;
        let mut farthest_facets = infinity;
        let mut nearest_exit = infinity;
        for_each_vector(simd, &self.planes, |normal, distance, facets| {
            let (towards, gap) = ray.project(simd, normal, distance);
            let crossing = simd.div_f32s(gap, towards);
            let enters = simd.less_than_f32s(towards, zero);
            let entry = simd.select_f32s(enters, simd.neg_f32s(crossing), infinity);
            let is_farther = simd.less_than_f32s(entry, farthest);
            farthest = simd.select_f32s(is_farther, entry, farthest);
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
        let entry = least(simd, farthest, farthest_facets);
        let entry = Crossing { distance: -entry.distance, ..entry };
        (entry, simd.reduce_min_f32s(nearest_exit))
    }
}
