//! Which part of a fan crosses one facet of a convex solid.
#![expect(
    clippy::inline_always,
    reason = "vector instructions are only chosen where the code is inlined into their dispatch"
)]

use glam::{Vec3, Vec3A};
use pulp::{Arch, Simd, WithSimd};

use crate::kernel::convex::{Planes, for_each_vector};
use crate::kernel::nodes::{Nodes, high_node, low_node, middle_node};
use crate::kernel::parabola::{crossings, parabola_through};
use crate::packed::{Instance, PackedScene};

/// How far outside of a facet, in mm, a point counts as within it.
pub const FACET_TOLERANCE_MM: f32 = 2e-5;

/// Scale of a point on a facet's plane, the cosine to its normal, from which on it counts.
pub const LEAST_SCALE: f32 = 1e-4;

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
        let [nx, ny, nz] = normal;
        let [px, py, pz] = self.points[node];
        let outside = simd.mul_f32s(nx, px);
        let outside = simd.mul_add_e_f32s(ny, py, outside);
        let outside = simd.mul_add_e_f32s(nz, pz, outside);
        simd.negate_mul_add_e_f32s(distance, self.scale[node], outside)
    }

    /// The shares, from the middle towards the low and the high point, that are inside of these planes
    /// too.
    #[inline(always)]
    fn narrow(
        &self,
        simd: S,
        [low_share, high_share]: [S::f32s; 2],
        normal: [S::f32s; 3],
        distance: S::f32s,
    ) -> [S::f32s; 2] {
        let low = self.outside(simd, 0, normal, distance);
        let high = self.outside(simd, 2, normal, distance);
        if simd.reduce_max_f32s(simd.max_f32s(low, high)) <= FACET_TOLERANCE_MM {
            return [low_share, high_share];
        }
        let middle = self.outside(simd, 1, normal, distance);
        let half = simd.splat_f32s(0.5);
        let c = simd.min_f32s(middle, simd.splat_f32s(0.0));
        let a = simd.sub_f32s(simd.mul_f32s(half, simd.add_f32s(low, high)), c);
        let b = simd.mul_f32s(half, simd.sub_f32s(high, low));
        [
            simd.min_f32s(low_share, share_inside(simd, a, simd.neg_f32s(b), c, low)),
            simd.min_f32s(high_share, share_inside(simd, a, b, c, high)),
        ]
    }
}

/// Where a·u² + b·u + c, of which c is not above 0, comes to 0 on its way to its value `end` at u = 1;
/// 1 where that is not above 0.
#[inline(always)]
fn share_inside<S: Simd>(simd: S, a: S::f32s, b: S::f32s, c: S::f32s, end: S::f32s) -> S::f32s {
    let zero = simd.splat_f32s(0.0);
    let one = simd.splat_f32s(1.0);
    let four_ac = simd.mul_f32s(simd.splat_f32s(4.0), simd.mul_f32s(a, c));
    let square = simd.max_f32s(simd.sub_f32s(simd.mul_f32s(b, b), four_ac), zero);
    let root = simd.sqrt_f32s(square);
    // Of the two forms of the root the one in which nothing cancels.
    let falls = simd.less_than_f32s(b, zero);
    let minus_two_c = simd.mul_f32s(simd.splat_f32s(-2.0), c);
    let numerator = simd.select_f32s(falls, simd.sub_f32s(root, b), minus_two_c);
    let twice_a = simd.add_f32s(a, a);
    let rising = simd.max_f32s(simd.add_f32s(b, root), simd.splat_f32s(1e-30));
    let denominator = simd.select_f32s(falls, twice_a, rising);
    let share = simd.div_f32s(numerator, denominator);
    let share = simd.min_f32s(simd.max_f32s(share, zero), one);
    let is_outside = simd.greater_than_f32s(end, simd.splat_f32s(FACET_TOLERANCE_MM));
    simd.select_f32s(is_outside, share, one)
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
        let one = simd.splat_f32s(1.0);
        let mut shares = [one, one];
        for_each_vector(simd, &self.planes, |normal, distance, _| {
            shares = points.narrow(simd, shares, normal, distance);
        });
        shares.map(|share| simd.reduce_min_f32s(share))
    }
}
