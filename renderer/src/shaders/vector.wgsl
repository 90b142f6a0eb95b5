// What glam gives the Rust twins.

// `v` at length 1, or zero where it has no direction.
fn normalize_or_zero(v: vec3f) -> vec3f {
    let length_squared = dot(v, v);
    if length_squared < SMALLEST_SQUARE {
        return vec3f(0.0);
    }
    return v * inverseSqrt(length_squared);
}

fn length_squared(v: vec3f) -> f32 {
    return dot(v, v);
}

fn max_element(v: vec3f) -> f32 {
    return max(v.x, max(v.y, v.z));
}

fn min_element(v: vec3f) -> f32 {
    return min(v.x, min(v.y, v.z));
}

// The axis of the greatest component.
fn max_position(v: vec3f) -> u32 {
    if v.z > max(v.x, v.y) {
        return 2u;
    }
    return select(0u, 1u, v.y > v.x);
}
