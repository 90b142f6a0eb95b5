// Which part of a fan crosses one facet of a convex solid.

// The part of a fan about its middle, between two positions in it, whose points on the plane of
// `facet` lie within that facet.
//
// The points are `points` over `scale`, in homogeneous coordinates; where `scale` is not above 0 there
// is none. The middle one lies within the facet.
fn clip_to_facet(instance: Instance, points: Nodes, scale: vec3f) -> vec2f {
    let facing = facing_part(scale);
    var inside = vec2f(1.0);
    for (var facet = 0u; facet < instance.count; facet++) {
        let plane = plane_of(instance, facet);
        // How far each point is outside of the plane, times its scale.
        let outside = dot_each(points, plane.xyz) - plane.w * scale;
        if max(outside.x, outside.z) <= FACET_TOLERANCE_MM {
            continue;
        }
        let c = min(outside.y, 0.0);
        let a = 0.5 * (outside.x + outside.z) - c;
        let b = 0.5 * (outside.z - outside.x);
        let shares = vec2f(share_inside(a, -b, c, outside.x), share_inside(a, b, c, outside.z));
        inside = min(inside, shares);
    }
    return vec2f(max(facing.x, -inside.x), min(facing.y, inside.y));
}

// The part of a fan about its middle whose points have a scale.
fn facing_part(scale: vec3f) -> vec2f {
    var facing = vec2f(-1.0, 1.0);
    if scale.x < LEAST_SCALE || scale.z < LEAST_SCALE {
        let crossed = crossings(parabola_through(scale - vec3f(LEAST_SCALE)));
        if scale.x < LEAST_SCALE {
            facing.x = select(min(crossed.x, 0.0), crossed.y, crossed.y < 0.0);
        }
        if scale.z < LEAST_SCALE {
            facing.y = select(max(crossed.y, 0.0), crossed.x, crossed.x > 0.0);
        }
    }
    return facing;
}

// Where a·u² + b·u + c, of which c is not above 0, comes to 0 on its way to its value `end` at u = 1;
// 1 where that is not above 0.
fn share_inside(a: f32, b: f32, c: f32, end: f32) -> f32 {
    if end <= FACET_TOLERANCE_MM {
        return 1.0;
    }
    let root = sqrt(max(b * b - 4.0 * a * c, 0.0));
    // Of the two forms of the root the one in which nothing cancels.
    if b < 0.0 {
        return clamp((root - b) / (2.0 * a), 0.0, 1.0);
    }
    return clamp(-2.0 * c / max(b + root, 1e-30), 0.0, 1.0);
}
