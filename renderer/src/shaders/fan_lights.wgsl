// What a fan sees that meets nothing: each light is cut out of its interval.

// Ends a fan that meets nothing: what it sees is deposited, what it carries is booked.
fn end_at_lights(fan: Fan) {
    fan_light(fan);
    walk.tally.returned += retire_fan(fan);
}

// Deposits what the fan sees where it meets no surface.
fn fan_light(fan: Fan) {
    let sky = frame.sky;
    if fan.depth == 0u && sky.backdrop != NONE {
        deposit_band(fan, -1.0, 1.0, sky.backdrop);
        return;
    }
    let middle = middle_node(fan.direction);
    let spread = largest_spread(fan);
    for (var i = 0u; i < frame.disc_count; i++) {
        let disc = discs[i];
        let cone = disc_cone(disc);
        if dot(middle, cone.center) + spread < cone.cos_radius || is_fan_far_off(fan, cone) {
            continue;
        }
        let part = part_in_cone(fan, cone);
        if part.x < part.y {
            deposit_band(fan, part.x, part.y, disc.spectrum);
        }
    }
    if sky.environment == NONE && sky.hemisphere == NONE {
        return;
    }
    var shadow = vec2f(1.0);
    if sky.sin_squared_observer_shadow > 0.0 {
        let head = Cone(
            frame.rules.observer,
            sky.cos_observer_shadow,
            sky.sin_squared_observer_shadow,
        );
        if !is_fan_far_off(fan, head) {
            shadow = part_in_cone(fan, head);
        }
    }
    if sky.environment != NONE {
        deposit_beside(fan, vec2f(-1.0, 1.0), shadow, sky.environment);
    }
    if sky.hemisphere != NONE {
        let height = parabola_through(fan.direction.z);
        let crossed = crossings(height);
        let ends = vec4f(-1.0, crossed, 1.0);
        for (var i = 0u; i < 3u; i++) {
            if parabola_at(height, 0.5 * (ends[i] + ends[i + 1u])) > 0.0 {
                deposit_beside(fan, vec2f(ends[i], ends[i + 1u]), shadow, sky.hemisphere);
            }
        }
    }
}

// Deposits over a part of the fan without what of it lies in `shadow`.
fn deposit_beside(fan: Fan, part: vec2f, shadow: vec2f, radiance_row: u32) {
    let before = min(part.y, shadow.x);
    let behind = max(part.x, shadow.y);
    let beside = vec4f(part.x, before, behind, part.y);
    for (var i = 0u; i < 4u; i += 2u) {
        if beside[i] < beside[i + 1u] {
            deposit_band(fan, beside[i], beside[i + 1u], radiance_row);
        }
    }
}

// How far directions of the fan are from the middle one, at most: between the nodes a parabola strays
// no further than at them.
fn largest_spread(fan: Fan) -> f32 {
    let middle = middle_node(fan.direction);
    let to_low = length_squared(low_node(fan.direction) - middle);
    let to_high = length_squared(high_node(fan.direction) - middle);
    return LEEWAY * sqrt(max(to_low, to_high));
}

// Whether the fan is sure to miss the cone: between the nodes the cosine is no larger than a
// parabola's vertex can be.
fn is_fan_far_off(fan: Fan, cone: Cone) -> bool {
    let along = dot_each(fan.direction, cone.center);
    let bend = 0.5 * (along.x + along.z) - along.y;
    return largest(along) + 0.25 * abs(bend) + FAR_OFF_MARGIN < cone.cos_radius;
}

// How far, at a position in the fan, its direction is inside of the cone: above 0 inside, and
// about proportional to the distance from the edge.
fn depth_in_cone(fan: Fan, cone: Cone, position: f32) -> f32 {
    let direction = blend(fan.direction, basis_at(position));
    let off_center = cross(direction, cone.center);
    if dot(direction, cone.center) <= 0.0 {
        return -length_squared(direction);
    }
    return cone.sin_squared_radius * length_squared(direction) - length_squared(off_center);
}

// How fast that changes with the position.
fn depth_slope_in_cone(fan: Fan, cone: Cone, position: f32) -> f32 {
    let direction = blend(fan.direction, basis_at(position));
    let slope = blend(fan.direction, slope_basis_at(position));
    let along = cone.sin_squared_radius * dot(direction, slope);
    return 2.0 * (along - dot(cross(direction, cone.center), cross(slope, cone.center)));
}

// The part of the fan that lies within the cone, from its nearest approach to both sides; one of no
// width where there is none.
fn part_in_cone(fan: Fan, cone: Cone) -> vec2f {
    if !is_dispersed(fan) {
        return select(vec2f(1.0), vec2f(-1.0, 1.0), depth_in_cone(fan, cone, 0.0) >= 0.0);
    }
    let nearest = nearest_approach(fan, cone);
    if depth_in_cone(fan, cone, nearest) <= 0.0 {
        return vec2f(1.0);
    }
    return vec2f(
        edge_of_cone(fan, cone, nearest, -1.0),
        edge_of_cone(fan, cone, nearest, 1.0),
    );
}

// The position in the fan whose direction is nearest to the middle of the cone.
fn nearest_approach(fan: Fan, cone: Cone) -> f32 {
    let along = parabola_through(dot_each(fan.direction, cone.center));
    var position = select(1.0, -1.0, along.b < 0.0);
    if along.a < 0.0 {
        position = clamp(-along.b / along.a, -1.0, 1.0);
    }
    for (var i = 0u; i < APPROACH_STEPS; i++) {
        let direction = blend(fan.direction, basis_at(position));
        let slope = blend(fan.direction, slope_basis_at(position));
        // Both as they lie across the cone's axis.
        let off_center = direction - cone.center * dot(direction, cone.center);
        let drift = slope - cone.center * dot(slope, cone.center);
        let step = dot(off_center, drift) / max(length_squared(drift), 1e-20);
        position = clamp(position - step, -1.0, 1.0);
    }
    return position;
}

// The position between `inside`, which is within the cone, and `end` at which the fan leaves it.
fn edge_of_cone(fan: Fan, cone: Cone, inside: f32, end: f32) -> f32 {
    let depth_outside = depth_in_cone(fan, cone, end);
    if depth_outside >= 0.0 {
        return end;
    }
    var near = inside;
    var far = end;
    // As if the depth fell from its height like a parabola; then by Newton's steps, or by halves where
    // they lead astray.
    let depth_inside = depth_in_cone(fan, cone, inside);
    let part = sqrt(max(depth_inside / (depth_inside - depth_outside), 0.0));
    var position = near + (far - near) * part;
    for (var i = 0u; i < EDGE_STEPS; i++) {
        let depth = depth_in_cone(fan, cone, position);
        if depth >= 0.0 {
            near = position;
        } else {
            far = position;
        }
        var next = 0.5 * (near + far);
        let slope = depth_slope_in_cone(fan, cone, position);
        // WGSL leaves open what comes of a division by 0.
        if slope != 0.0 {
            let newton = position - depth / slope;
            next = select(next, newton, (newton - near) * (newton - far) <= 0.0);
        }
        let step = abs(next - position);
        position = next;
        if step < EDGE_FOUND {
            break;
        }
    }
    return position;
}
