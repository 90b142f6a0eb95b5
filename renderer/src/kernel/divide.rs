//! What becomes of a fan at an interface.

use glam::Vec3A;

use crate::kernel::axis::{axis_position_of, wavelength_at};
use crate::kernel::band::{fan_energy, retire_fan};
use crate::kernel::crossing::{
    Crossing, crossing_of, drawn_to_critical, is_misjudged, reflectances,
};
use crate::kernel::fan::{
    Fan, NEXT_PART, axis_position_in, axis_width, part_of_fan, position_of, seed_of_way,
    segment_count,
};
use crate::kernel::fan_lights::end_at_lights;
use crate::kernel::fan_walk::{fate_of_fan, is_worth_dividing, largest, least_of, send_fan};
use crate::kernel::fork::{absorber_of, interface_at, medium_beyond};
use crate::kernel::interface::Interface;
use crate::kernel::nodes::{
    Nodes, dot_each, high_node, low_node, middle_node, normalize_each, scale_each, shift_each,
};
use crate::kernel::parabola::{crossings, parabola_at, parabola_through};
use crate::kernel::ray::{Hit, Ray};
use crate::kernel::reach::{is_convex_body, is_single};
use crate::kernel::walk::{Fate, TraceRules, Walk};
use crate::packed::{NONE, PackedScene};
use crate::spectrum::LAMBDA_MIN_NM;

/// Width of an interval, as a part of the dispersion axis, below which nothing divides it.
pub const NARROW: f32 = 1e-6;

/// By how much, in radians, directions between the nodes may be off before a refracted fan is divided.
pub const DIRECTION_TOLERANCE: f32 = 4e-5;

/// The same inside a body, over the energy below which nothing is divided: what is off there moves the
/// place where the fan meets the hundredth facet.
pub const INNER_TOLERANCE: f32 = 0.013;

/// The least of that which single precision tells from nothing, in radians.
pub const LEAST_INNER_TOLERANCE: f32 = 2e-7;

/// Energy below which a fan lives by chance, over that of others, where it ends at the lights at once:
/// it costs little.
pub const LEAF_SHARE: f32 = 0.1;

/// Sends on what the interface at `hit` makes of `fan`, which has been moved to it; `ray` is its middle
/// one. Where a part is totally reflected, the fan is divided there.
#[inline]
pub fn divide_fan(walk: &mut Walk<'_, Fan>, fan: &Fan, ray: &Ray, hit: &Hit) {
    let scene = walk.scene;
    let at = interface_at(scene, ray, hit);
    let crossing = crossing_of(scene, &at, fan);
    if largest(crossing.cos_t_squared) <= 0.0 {
        reflect_fan(walk, fan, hit, &at, Vec3A::ONE);
        return;
    }
    if least_of(crossing.cos_t_squared) > 0.0 || !is_worth_dividing(walk.rules, fan) {
        refract_fan(walk, fan, &crossing, ray, hit, &at);
        return;
    }
    let cos_t_squared = parabola_through(crossing.cos_t_squared);
    let [first, second] = crossings(&cos_t_squared);
    let ends = [-1.0, first, second, 1.0];
    let mut seed = fan.seed;
    for i in 0..3 {
        if ends[i + 1] <= ends[i] {
            continue;
        }
        seed = seed_of_way(seed, NEXT_PART);
        let part = Fan { seed, ..part_of_fan(fan, ends[i], ends[i + 1]) };
        if parabola_at(&cos_t_squared, 0.5 * (ends[i] + ends[i + 1])) <= 0.0 {
            reflect_fan(walk, &part, hit, &at, Vec3A::ONE);
        } else {
            refract_fan(walk, &part, &crossing_of(scene, &at, &part), ray, hit, &at);
        }
    }
}

/// Sends on the reflected part, whose weight is multiplied by `factor`.
#[inline]
pub fn reflect_fan(walk: &mut Walk<'_, Fan>, fan: &Fan, hit: &Hit, at: &Interface, factor: Vec3A) {
    let mut reflected = *fan;
    reflected.weight = fan.weight * factor;
    reflected.instance = hit.instance;
    reflected.facet = hit.facet;
    reflected.depth += 1;
    reflected.seed = seed_of_way(fan.seed, 2 * hit.facet);
    let along = dot_each(&fan.direction, at.normal);
    reflected.direction = shift_each(&fan.direction, at.normal, along.min(Vec3A::ZERO) * -2.0);
    send_fan(walk, reflected);
}

/// Sends on the refracted and the reflected part of a fan of which at least one node is refracted. It is
/// divided where its weights or its directions bend too much for three nodes.
#[inline]
pub fn refract_fan(
    walk: &mut Walk<'_, Fan>,
    incident: &Fan,
    incident_crossing: &Crossing,
    ray: &Ray,
    hit: &Hit,
    at: &Interface,
) {
    let scene = walk.scene;
    let drawn = drawn_to_critical(scene, incident, incident_crossing);
    let is_drawn = drawn.is_some();
    let mut whole = drawn.unwrap_or(*incident);
    let divides_by_bins = pays_on_entering(scene, &whole, medium_beyond(ray, hit));
    let mut part = whole;
    let mut crossing = *incident_crossing;
    let mut low = -1.0;
    let mut high: f32 = 1.0;
    if divides_by_bins {
        high = end_of_bin(scene, &whole, low);
        part = part_of_fan(&whole, low, high);
    }
    if is_drawn || divides_by_bins {
        crossing = crossing_of(scene, at, &part);
    }
    loop {
        let reflectance = reflectances(&crossing);
        let refracted = refracted_fan(scene, &part, ray, hit, at, &crossing, reflectance);
        let is_rough = (is_drawn && is_misjudged(walk, at, &part, reflectance))
            || is_bent(&refracted.direction, direction_tolerance(walk.rules, refracted.medium));
        if is_rough && is_worth_dividing(walk.rules, &part) && axis_width(&part) > NARROW {
            high = 0.5 * (low + high);
        } else {
            reflect_fan(walk, &part, hit, at, reflectance);
            send_refracted(walk, refracted);
            if high >= 1.0 {
                return;
            }
            whole.seed = seed_of_way(whole.seed, NEXT_PART);
            // Next to the critical wavelength parts are narrow; away from it each may be twice as wide.
            let step = 2.0 * (high - low);
            low = high;
            high = (low + step).min(1.0);
            if divides_by_bins {
                high = high.min(end_of_bin(scene, &whole, low));
            }
        }
        part = part_of_fan(&whole, low, high);
        crossing = crossing_of(scene, at, &part);
    }
}

/// The fan beyond the interface.
#[inline]
pub fn refracted_fan(
    scene: &PackedScene,
    fan: &Fan,
    ray: &Ray,
    hit: &Hit,
    at: &Interface,
    crossing: &Crossing,
    reflectance: Vec3A,
) -> Fan {
    let medium = medium_beyond(ray, hit);
    let cos_t = crossing.cos_t_squared.max(Vec3A::ZERO).sqrt();
    let along = scale_each(&fan.direction, crossing.eta);
    let mut refracted = *fan;
    refracted.direction =
        normalize_each(&shift_each(&along, at.normal, crossing.eta * crossing.cos_i - cos_t));
    refracted.weight = fan.weight * (Vec3A::ONE - reflectance);
    refracted.instance = hit.instance;
    refracted.facet = hit.facet;
    refracted.medium = medium;
    refracted.enclosing = if medium == hit.instance { ray.medium } else { NONE };
    refracted.depth += 1;
    refracted.seed = seed_of_way(fan.seed, 2 * hit.facet + 1);
    let next = absorber_of(scene, medium);
    if fan.absorber == NONE && next != NONE {
        refracted.absorber = next;
        refracted.path_mm = Vec3A::ZERO;
    }
    refracted
}

/// Sends on a refracted fan. A path through another coloured material is paid for first, by its mean
/// over the interval, which for that is at most one bin wide. What leaves the only body of a scene is
/// at the lights.
#[inline]
pub fn send_refracted(walk: &mut Walk<'_, Fan>, mut fan: Fan) {
    let scene = walk.scene;
    if pays_on_entering(scene, &fan, fan.medium) {
        let energy = fan_energy(scene, &fan);
        let kept = retire_fan(walk, &fan);
        fan.weight *= (kept / energy.max(1e-12)).clamp(0.0, 1.0);
        fan.absorber = absorber_of(scene, fan.medium);
        fan.path_mm = Vec3A::ZERO;
    }
    if walk.keeps_all || !can_only_meet_lights(scene, &fan) {
        send_fan(walk, fan);
        return;
    }
    let threshold = LEAF_SHARE * walk.rules.significance_threshold;
    if fate_of_fan(walk, &mut fan, threshold) == Fate::Kept {
        walk.tally.segments += segment_count(&fan);
        walk.tally.depth = walk.tally.depth.max(fan.depth);
        end_at_lights(walk, &fan);
    }
}

/// Whether the fan has left the only body of the scene, which is convex.
#[inline]
pub fn can_only_meet_lights(scene: &PackedScene, fan: &Fan) -> bool {
    fan.medium == NONE && is_single(scene) && is_convex_body(scene, fan.instance)
}

/// Whether the fan, having run through one coloured material, enters another.
#[inline]
pub fn pays_on_entering(scene: &PackedScene, fan: &Fan, medium: u32) -> bool {
    let next = absorber_of(scene, medium);
    fan.absorber != NONE && next != NONE && next != fan.absorber
}

/// The position in the fan at which the bin ends that `position` lies in.
#[inline]
pub fn end_of_bin(scene: &PackedScene, fan: &Fan, position: f32) -> f32 {
    let width_nm = scene.bins.width_nm();
    let lambda_nm = wavelength_at(scene, axis_position_in(fan, position));
    let bin = ((lambda_nm - LAMBDA_MIN_NM) / width_nm + 1e-3).floor();
    let end = axis_position_of(scene, LAMBDA_MIN_NM + (bin + 1.0) * width_nm);
    // Rounding must not put it where the position is already.
    if end < fan.axis.z { position_of(fan, end).max(position + 1e-3) } else { 1.0 }
}

/// By how much, in radians, directions in a medium may be off between the nodes.
#[inline]
pub fn direction_tolerance(rules: &TraceRules, medium: u32) -> f32 {
    if medium == NONE {
        return DIRECTION_TOLERANCE;
    }
    (INNER_TOLERANCE * rules.cut_threshold).clamp(LEAST_INNER_TOLERANCE, DIRECTION_TOLERANCE)
}

/// Whether directions bend too much between the nodes for a parabola to follow them: what three
/// nodes can't tell is about the square of their bend over their difference.
#[inline]
pub fn is_bent(directions: &Nodes, tolerance: f32) -> bool {
    let (low, high) = (low_node(directions), high_node(directions));
    let bend = middle_node(directions) - (low + high) * 0.5;
    let bend_squared = bend.length_squared();
    let limit = tolerance * tolerance * (high - low).length_squared();
    bend_squared * bend_squared > limit
}
