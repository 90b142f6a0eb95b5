// What becomes of a fan at an interface.

// Sends on what the interface at `hit` makes of `fan`, which has been moved to it; `ray` is its middle
// one. Where a part is totally reflected, the fan is divided there.
fn divide_fan(fan: Fan, ray: Ray, hit: Hit) {
    let at = interface_at(ray, hit);
    let at_nodes = crossing_of(at, fan).cos_t_squared;
    let cos_t_squared = parabola_through(at_nodes);
    let is_reflected = largest(at_nodes) <= 0.0;
    let divides = !is_reflected && least_of(at_nodes) <= 0.0 && is_worth_dividing(fan);
    // One loop for all cases: compilers write out each call.
    var ends = vec4f(-1.0, 1.0, 1.0, 1.0);
    var seed = fan.seed;
    if divides {
        ends = vec4f(-1.0, crossings(cos_t_squared), 1.0);
    }
    for (var i = 0u; i < 3u; i++) {
        if ends[i + 1u] <= ends[i] {
            continue;
        }
        var part = fan;
        if divides {
            seed = seed_of_way(seed, NEXT_PART);
            part = part_of_fan(fan, ends[i], ends[i + 1u]);
            part.seed = seed;
        }
        let middle = parabola_at(cos_t_squared, 0.5 * (ends[i] + ends[i + 1u]));
        if is_reflected || (divides && middle <= 0.0) {
            reflect_fan(part, hit, at, vec3f(1.0));
        } else {
            refract_fan(part, ray, hit, at);
        }
    }
}

// Sends on the reflected part, whose weight is multiplied by `factor`.
fn reflect_fan(fan: Fan, hit: Hit, at: Interface, factor: vec3f) {
    var reflected = fan;
    reflected.weight = fan.weight * factor;
    reflected.instance = hit.instance;
    reflected.facet = hit.facet;
    reflected.depth += 1u;
    reflected.seed = seed_of_way(fan.seed, 2u * hit.facet);
    let along = dot_each(fan.direction, at.normal);
    reflected.direction = shift_each(fan.direction, at.normal, min(along, vec3f(0.0)) * -2.0);
    send_fan(reflected);
}

// Sends on the refracted and the reflected part of a fan of which at least one node is refracted. It is
// divided where its weights or its directions bend too much for three nodes.
fn refract_fan(incident: Fan, ray: Ray, hit: Hit, at: Interface) {
    var drawn = drawn_to_critical(incident, crossing_of(at, incident));
    let divides_by_bins = pays_on_entering(drawn.fan, medium_beyond(ray, hit));
    var part = drawn.fan;
    var low = -1.0;
    var high = 1.0;
    if divides_by_bins {
        high = end_of_bin(drawn.fan, low);
        part = part_of_fan(drawn.fan, low, high);
    }
    loop {
        let crossing = crossing_of(at, part);
        let reflectance = reflectances(crossing);
        let refracted = refracted_fan(part, ray, hit, at, crossing, reflectance);
        let is_rough = (drawn.is_elsewhere && is_misjudged(at, part, reflectance))
            || is_bent(refracted.direction, direction_tolerance(refracted.medium));
        if is_rough && is_worth_dividing(part) && axis_width(part) > NARROW {
            high = 0.5 * (low + high);
        } else {
            reflect_fan(part, hit, at, reflectance);
            send_refracted(refracted);
            if high >= 1.0 {
                return;
            }
            drawn.fan.seed = seed_of_way(drawn.fan.seed, NEXT_PART);
            // Next to the critical wavelength parts are narrow; away from it each may be twice as wide.
            let step = 2.0 * (high - low);
            low = high;
            high = min(low + step, 1.0);
            if divides_by_bins {
                high = min(high, end_of_bin(drawn.fan, low));
            }
        }
        part = part_of_fan(drawn.fan, low, high);
    }
}

// The fan beyond the interface.
fn refracted_fan(
    fan: Fan,
    ray: Ray,
    hit: Hit,
    at: Interface,
    crossing: Crossing,
    reflectance: vec3f,
) -> Fan {
    let medium = medium_beyond(ray, hit);
    let cos_t = sqrt(max(crossing.cos_t_squared, vec3f(0.0)));
    let along = scale_each(fan.direction, crossing.eta);
    var refracted = fan;
    refracted.direction =
        normalize_each(shift_each(along, at.normal, crossing.eta * crossing.cos_i - cos_t));
    refracted.weight = fan.weight * (1.0 - reflectance);
    refracted.instance = hit.instance;
    refracted.facet = hit.facet;
    refracted.medium = medium;
    refracted.enclosing = select(NONE, ray.medium, medium == hit.instance);
    refracted.depth += 1u;
    refracted.seed = seed_of_way(fan.seed, 2u * hit.facet + 1u);
    let next = absorber_of(medium);
    if fan.absorber == NONE && next != NONE {
        refracted.absorber = next;
        refracted.path_mm = vec3f(0.0);
    }
    return refracted;
}

// Sends on a refracted fan. A path through another coloured material is paid for first, by its mean
// over the interval, which for that is at most one bin wide. What leaves the only body of a scene is
// at the lights.
fn send_refracted(refracted: Fan) {
    var fan = refracted;
    if pays_on_entering(fan, fan.medium) {
        let energy = fan_energy(fan);
        let kept = retire_fan(fan);
        fan.weight *= clamp(kept / max(energy, 1e-12), 0.0, 1.0);
        fan.absorber = absorber_of(fan.medium);
        fan.path_mm = vec3f(0.0);
    }
    var threshold = frame.rules.significance_threshold;
    if can_only_meet_lights(fan) {
        threshold *= LEAF_SHARE;
    }
    // It waits even for the lights: compilers write out each call.
    if fate_of_fan(&fan, threshold) == FATE_KEPT {
        push_fan(fan);
    }
}

// Whether the fan has left the only body of the scene, which is convex.
fn can_only_meet_lights(fan: Fan) -> bool {
    return fan.medium == NONE && is_single() && is_convex_body(fan.instance);
}

// Whether the fan, having run through one coloured material, enters another.
fn pays_on_entering(fan: Fan, medium: u32) -> bool {
    let next = absorber_of(medium);
    return fan.absorber != NONE && next != NONE && next != fan.absorber;
}

// The position in the fan at which the bin ends that `position` lies in.
fn end_of_bin(fan: Fan, position: f32) -> f32 {
    let lambda_nm = wavelength_at(axis_position_in(fan, position));
    let bin = floor((lambda_nm - LAMBDA_MIN_NM) / frame.bin_width_nm + 1e-3);
    let end = axis_position_of(LAMBDA_MIN_NM + (bin + 1.0) * frame.bin_width_nm);
    if end < fan.axis.z {
        // Rounding must not put it where the position is already.
        return max(position_of(fan, end), position + 1e-3);
    }
    return 1.0;
}

// By how much, in radians, directions in a medium may be off between the nodes.
fn direction_tolerance(medium: u32) -> f32 {
    if medium == NONE {
        return DIRECTION_TOLERANCE;
    }
    let tolerance = INNER_TOLERANCE * frame.rules.cut_threshold;
    return clamp(tolerance, LEAST_INNER_TOLERANCE, DIRECTION_TOLERANCE);
}

// Whether directions bend too much between the nodes for a parabola to follow them: what three
// nodes can't tell is about the square of their bend over their difference.
fn is_bent(directions: Nodes, tolerance: f32) -> bool {
    let low = low_node(directions);
    let high = high_node(directions);
    let bend = middle_node(directions) - (low + high) * 0.5;
    let bend_squared = length_squared(bend);
    let limit = tolerance * tolerance * length_squared(high - low);
    return bend_squared * bend_squared > limit;
}
