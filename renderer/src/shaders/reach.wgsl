// How far about its middle a fan meets one and the same surface.

// The part of the fan about its middle, between two positions in it, whose rays meet the surface
// that the middle one meets at `hit`, or as it nothing.
fn reach(fan: Fan, middle: Ray, hit: Hit) -> vec2f {
    var reached = vec2f(-1.0, 1.0);
    if !is_dispersed(fan) || !is_worth_dividing(fan) {
        return reached;
    }
    let is_convex = is_convex_body(hit.instance);
    if is_convex {
        reached = clip_fan(fan, middle, hit);
    }
    if !is_convex || !is_unobstructed(middle) {
        for (var i = 0u; i < 2u; i++) {
            reached[i] = reach_towards(fan, hit, reached[i]);
        }
    }
    return reached;
}

// Whether the instance is a convex body.
fn is_convex_body(instance: u32) -> bool {
    return instance < frame.instance_count && instances[instance].kind == CONVEX;
}

// Whether only the body that the ray runs in, or the only one, can be met: no other surface can
// stand in front of its facets.
fn is_unobstructed(ray: Ray) -> bool {
    if ray.medium != NONE {
        return instances[ray.medium].interior_is_clear == 1u;
    }
    return is_single();
}

// Whether the scene has one body and no ground.
fn is_single() -> bool {
    return frame.instance_count == 1u && frame.ground.reflectance[0] == NONE;
}

// The part of the fan whose rays cross the plane of the facet at `hit` within the facet.
fn clip_fan(fan: Fan, middle: Ray, hit: Hit) -> vec2f {
    // A point in homogeneous coordinates, which is smooth also where a ray turns away from the plane:
    // the point itself is `points` over `scale`.
    let plane_distance = dot(middle.origin + middle.direction * hit.distance, hit.normal);
    let side = select(-1.0, 1.0, middle.medium == hit.instance);
    let scale = dot_each(fan.direction, hit.normal) * side;
    let gap = (vec3f(plane_distance) - dot_each(fan.origin, hit.normal)) * side;
    let points = advance_each(scale_each(fan.origin, scale), fan.direction, gap);
    return clip_to_facet(instances[hit.instance], points, scale);
}

// The position nearest to `end`, coming from the middle, whose ray meets the same surface as the
// middle one.
fn reach_towards(fan: Fan, hit: Hit, end: f32) -> f32 {
    var same = 0.0;
    var other = end;
    var tried = end;
    for (var i = 0u; i <= REACH_BISECTIONS; i++) {
        if meets_same(fan, hit, tried) {
            same = tried;
        } else {
            other = tried;
        }
        if same == end {
            break;
        }
        tried = 0.5 * (same + other);
    }
    return same;
}

// Whether the ray at a position in the fan meets the facet at `hit`.
fn meets_same(fan: Fan, hit: Hit, position: f32) -> bool {
    walk.tally.segments += 1u;
    let found = find_intersection(ray_in_fan(fan, position));
    return found.instance == hit.instance && found.facet == hit.facet;
}

// Moves the fan to the plane of the surface at `hit`, `height` from the origin along its normal. Where
// a ray of its ends does not come to the plane, which is so only in a fan that was not worth
// dividing, all take the middle one's place.
fn arrive(fan: ptr<function, Fan>, hit: Hit, height: f32) {
    let along = dot_each((*fan).direction, hit.normal);
    let sense = select(1.0, -1.0, along.y < 0.0);
    let towards = along * sense;
    let gap = (vec3f(height) - dot_each((*fan).origin, hit.normal)) * sense;
    var distance = gap / max(towards, vec3f(1e-12));
    if least_of(towards) < GRAZING || least_of(distance) < -DRIFT_MM {
        *fan = gathered(*fan);
        distance = vec3f(distance.y);
    }
    (*fan).origin = advance_each((*fan).origin, (*fan).direction, distance);
    if runs_in_absorber((*fan).absorber, (*fan).medium) {
        (*fan).path_mm += distance;
    }
}
