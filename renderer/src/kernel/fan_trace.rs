//! Following fans of rays through the tree of a camera ray's descendants.

use crate::kernel::band::retire_fan;
use crate::kernel::divide::{NARROW, divide_fan};
use crate::kernel::fan::{
    Fan, NEXT_PART, axis_position_in, part_of_fan, ray_in_fan, seed_of_way, segment_count,
    white_fan,
};
use crate::kernel::fan_lights::end_at_lights;
use crate::kernel::fan_matte::shade_fan;
use crate::kernel::fan_walk::{largest, send_fan};
use crate::kernel::ray::Ray;
use crate::kernel::reach::{arrive, reach};
use crate::kernel::trace::{is_lost, meets_opaque, next_surface};
use crate::kernel::walk::Walk;
use crate::packed::NONE;

/// Energy of the part of a fan that meets another surface up to which it goes with the rest, over that
/// from which on fans are divided.
pub const REST_SHARE: f32 = 0.3;

/// Follows `camera_ray` and all that comes of it to the end, as fans.
#[inline]
pub fn trace_fans(walk: &mut Walk<'_, Fan>, camera_ray: &Ray) {
    send_fan(walk, white_fan(camera_ray.origin, camera_ray.direction, walk.seed));
    while walk.has_rays() {
        follow_fan(walk);
    }
}

/// Takes the next fan that waits to the next surface, or to the lights. Only the part about its middle
/// goes there; what meets other surfaces waits again.
#[inline]
pub fn follow_fan(walk: &mut Walk<'_, Fan>) {
    let scene = walk.scene;
    let mut fan = walk.pop();
    walk.tally.segments += segment_count(&fan);
    walk.tally.depth = walk.tally.depth.max(fan.depth);
    let mut middle = ray_in_fan(&fan, 0.0);
    let hit = next_surface(scene, &mut middle);
    let reached = reach(walk, &fan, &middle, &hit);
    send_rest(walk, &mut fan, reached);
    if is_lost(&middle, &hit) {
        let energy = retire_fan(walk, &fan);
        walk.tally.lost += energy;
    } else if hit.instance == NONE {
        end_at_lights(walk, &fan);
    } else {
        let height = (middle.origin + middle.direction * hit.distance).dot(hit.normal);
        arrive(scene, &mut fan, &hit, height);
        if meets_opaque(scene, &hit) {
            shade_fan(walk, &fan, &hit);
        } else {
            divide_fan(walk, &fan, &middle, &hit);
        }
    }
}

/// Sends what is outside of the reached part of the fan back to wait, and leaves that part.
#[inline]
pub fn send_rest(walk: &mut Walk<'_, Fan>, fan: &mut Fan, reached: [f32; 2]) {
    let [mut low, mut high] = reached;
    let least_energy = REST_SHARE * walk.rules.cut_threshold;
    let least_width = (least_energy / largest(fan.weight).max(1e-12)).max(NARROW);
    if axis_position_in(fan, low) - fan.axis.x <= least_width {
        low = -1.0;
    }
    if fan.axis.z - axis_position_in(fan, high) <= least_width {
        high = 1.0;
    }
    if low == -1.0 && high == 1.0 {
        return;
    }
    let mut seed = fan.seed;
    for [from, to] in [[high, 1.0], [-1.0, low]] {
        seed = seed_of_way(seed, NEXT_PART);
        if from < to {
            send_fan(walk, Fan { seed, ..part_of_fan(fan, from, to) });
        }
    }
    *fan = part_of_fan(fan, low, high);
}
