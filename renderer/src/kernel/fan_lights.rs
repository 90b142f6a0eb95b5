//! What a fan sees that meets nothing: each light is cut out of its interval.

use crate::kernel::band::{deposit_band, retire_fan};
use crate::kernel::fan::{Fan, is_dispersed};
use crate::kernel::fan_walk::largest;
use crate::kernel::lights::{Cone, disc_cone};
use crate::kernel::nodes::{
    basis_at, blend, dot_each, high_node, low_node, middle_node, slope_basis_at,
};
use crate::kernel::parabola::{crossings, parabola_at, parabola_through};
use crate::kernel::walk::Walk;
use crate::packed::NONE;

/// Steps towards the position in a fan that is nearest to the middle of a light.
pub const APPROACH_STEPS: u32 = 3;

/// What directions between the nodes may gain in distance by being brought to length 1, as a factor.
pub const LEEWAY: f32 = 1.1;

/// By how much a cosine between the nodes may be larger than the parabola through those at them, since
/// directions there are brought to length 1.
pub const FAR_OFF_MARGIN: f32 = 1e-3;

/// Steps, at most, in search of the edge of a light.
pub const EDGE_STEPS: u32 = 10;

/// Step, as a position in the fan, after which the edge is found.
pub const EDGE_FOUND: f32 = 1e-5;

/// Ends a fan that meets nothing: what it sees is deposited, what it carries is booked.
#[inline]
pub fn end_at_lights(walk: &mut Walk<'_, Fan>, fan: &Fan) {
    fan_light(walk, fan);
    let energy = retire_fan(walk, fan);
    walk.tally.returned += energy;
}

/// Deposits what the fan sees where it meets no surface.
#[inline]
pub fn fan_light(walk: &mut Walk<'_, Fan>, fan: &Fan) {
    let scene = walk.scene;
    let sky = &scene.sky;
    if fan.depth == 0 && sky.backdrop != NONE {
        deposit_band(walk, fan, -1.0, 1.0, sky.backdrop);
        return;
    }
    let middle = middle_node(&fan.direction);
    let spread = largest_spread(fan);
    for disc in &scene.discs {
        let cone = disc_cone(disc);
        if middle.dot(cone.center) + spread < cone.cos_radius || is_fan_far_off(fan, &cone) {
            continue;
        }
        let [low, high] = part_in_cone(fan, &cone);
        if low < high {
            deposit_band(walk, fan, low, high, disc.spectrum);
        }
    }
    if sky.environment == NONE && sky.hemisphere == NONE {
        return;
    }
    let mut shadow = [1.0, 1.0];
    if sky.sin_squared_observer_shadow > 0.0 {
        let head = Cone {
            center: walk.rules.observer,
            cos_radius: sky.cos_observer_shadow,
            sin_squared_radius: sky.sin_squared_observer_shadow,
        };
        if !is_fan_far_off(fan, &head) {
            shadow = part_in_cone(fan, &head);
        }
    }
    if sky.environment != NONE {
        deposit_beside(walk, fan, [-1.0, 1.0], shadow, sky.environment);
    }
    if sky.hemisphere != NONE {
        let height = parabola_through(fan.direction.z);
        let [first, second] = crossings(&height);
        let ends = [-1.0, first, second, 1.0];
        for i in 0..3 {
            if parabola_at(&height, 0.5 * (ends[i] + ends[i + 1])) > 0.0 {
                deposit_beside(walk, fan, [ends[i], ends[i + 1]], shadow, sky.hemisphere);
            }
        }
    }
}

/// Deposits over a part of the fan without what of it lies in `shadow`.
#[inline]
pub fn deposit_beside(
    walk: &mut Walk<'_, Fan>,
    fan: &Fan,
    part: [f32; 2],
    shadow: [f32; 2],
    radiance_row: u32,
) {
    let before = part[1].min(shadow[0]);
    let behind = part[0].max(shadow[1]);
    for [low, high] in [[part[0], before], [behind, part[1]]] {
        if low < high {
            deposit_band(walk, fan, low, high, radiance_row);
        }
    }
}

/// How far directions of the fan are from the middle one, at most: between the nodes a parabola strays
/// no further than at them.
#[inline]
pub fn largest_spread(fan: &Fan) -> f32 {
    let middle = middle_node(&fan.direction);
    let to_low = (low_node(&fan.direction) - middle).length_squared();
    let to_high = (high_node(&fan.direction) - middle).length_squared();
    LEEWAY * to_low.max(to_high).sqrt()
}

/// Whether the fan is sure to miss the cone: between the nodes the cosine is no larger than a
/// parabola's vertex can be.
#[inline]
pub fn is_fan_far_off(fan: &Fan, cone: &Cone) -> bool {
    let along = dot_each(&fan.direction, cone.center);
    let bend = 0.5 * (along.x + along.z) - along.y;
    largest(along) + 0.25 * bend.abs() + FAR_OFF_MARGIN < cone.cos_radius
}

/// How far, at a position in the fan, its direction is inside of the cone: above 0 inside, and
/// about proportional to the distance from the edge.
#[inline]
pub fn depth_in_cone(fan: &Fan, cone: &Cone, position: f32) -> f32 {
    let direction = blend(&fan.direction, basis_at(position));
    let off_center = direction.cross(cone.center);
    if direction.dot(cone.center) <= 0.0 {
        return -direction.length_squared();
    }
    cone.sin_squared_radius * direction.length_squared() - off_center.length_squared()
}

/// How fast that changes with the position.
#[inline]
pub fn depth_slope_in_cone(fan: &Fan, cone: &Cone, position: f32) -> f32 {
    let direction = blend(&fan.direction, basis_at(position));
    let slope = blend(&fan.direction, slope_basis_at(position));
    let along = cone.sin_squared_radius * direction.dot(slope);
    2.0 * (along - direction.cross(cone.center).dot(slope.cross(cone.center)))
}

/// The part of the fan that lies within the cone, from its nearest approach to both sides; one of no
/// width where there is none.
#[inline]
pub fn part_in_cone(fan: &Fan, cone: &Cone) -> [f32; 2] {
    if !is_dispersed(fan) {
        let is_inside = depth_in_cone(fan, cone, 0.0) >= 0.0;
        return if is_inside { [-1.0, 1.0] } else { [1.0, 1.0] };
    }
    let nearest = nearest_approach(fan, cone);
    if depth_in_cone(fan, cone, nearest) <= 0.0 {
        return [1.0, 1.0];
    }
    [edge_of_cone(fan, cone, nearest, -1.0), edge_of_cone(fan, cone, nearest, 1.0)]
}

/// The position in the fan whose direction is nearest to the middle of the cone.
#[inline]
pub fn nearest_approach(fan: &Fan, cone: &Cone) -> f32 {
    let along = parabola_through(dot_each(&fan.direction, cone.center));
    let mut position = if along.b < 0.0 { -1.0 } else { 1.0 };
    if along.a < 0.0 {
        position = (-along.b / along.a).clamp(-1.0, 1.0);
    }
    for _ in 0..APPROACH_STEPS {
        let direction = blend(&fan.direction, basis_at(position));
        let slope = blend(&fan.direction, slope_basis_at(position));
        // Both as they lie across the cone's axis.
        let off_center = direction - cone.center * direction.dot(cone.center);
        let drift = slope - cone.center * slope.dot(cone.center);
        let step = off_center.dot(drift) / drift.length_squared().max(1e-20);
        position = (position - step).clamp(-1.0, 1.0);
    }
    position
}

/// The position between `inside`, which is within the cone, and `end` at which the fan leaves it.
#[inline]
pub fn edge_of_cone(fan: &Fan, cone: &Cone, inside: f32, end: f32) -> f32 {
    let depth_outside = depth_in_cone(fan, cone, end);
    if depth_outside >= 0.0 {
        return end;
    }
    let mut near = inside;
    let mut far = end;
    // As if the depth fell from its height like a parabola; then by Newton's steps, or by halves where
    // they lead astray.
    let depth_inside = depth_in_cone(fan, cone, inside);
    let part = (depth_inside / (depth_inside - depth_outside)).max(0.0).sqrt();
    let mut position = near + (far - near) * part;
    for _ in 0..EDGE_STEPS {
        let depth = depth_in_cone(fan, cone, position);
        if depth >= 0.0 {
            near = position;
        } else {
            far = position;
        }
        let mut next = 0.5 * (near + far);
        let newton = position - depth / depth_slope_in_cone(fan, cone, position);
        if (newton - near) * (newton - far) <= 0.0 {
            next = newton;
        }
        let step = (next - position).abs();
        position = next;
        if step < EDGE_FOUND {
            break;
        }
    }
    position
}
