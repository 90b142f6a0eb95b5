// What a ray sees that meets nothing: discs, hemisphere, environment, the observer's shadow.

// A cone of directions: a light's disc or the observer's shadow.
struct Cone {
    center: vec3f,
    cos_radius: f32,
    sin_squared_radius: f32,
}

// Whether the ray's fan, of half-width `spread_length`, is sure to miss the cone: the cosine
// changes at most as fast as the direction itself.
fn is_far_off(ray: Ray, spread_length: f32, cone: Cone) -> bool {
    return dot(ray.direction, cone.center) + spread_length < cone.cos_radius;
}

// The part of the ray's fan, in 0..=1, that lies within the cone (the paper's `overlap_amount`).
//
// The fan is the directions `direction + u·spread`, u in −1..=1. It is inside where
// |(direction + u·spread) × center|² ≤ sin²·|direction + u·spread|², a quadratic in u, and on the
// side of the center.
fn overlap_amount(ray: Ray, cone: Cone) -> f32 {
    let along = dot(ray.direction, cone.center);
    let spread_squared = length_squared(ray.spread);
    let off_center = cross(ray.direction, cone.center);
    let c = length_squared(off_center) - cone.sin_squared_radius;
    if spread_squared < 1e-14 {
        return select(0.0, 1.0, c <= 0.0 && along >= 0.0);
    }
    let sideways = cross(ray.spread, cone.center);
    let a = length_squared(sideways) - cone.sin_squared_radius * spread_squared;
    let b = dot(off_center, sideways) - cone.sin_squared_radius * dot(ray.direction, ray.spread);
    let drift = dot(ray.spread, cone.center);
    // The fan is cut where it crosses the edge; each part is inside or outside as its middle is.
    let cuts = vec4f(-1.0, crossings(Parabola(a, b, c)), 1.0);
    var inside = 0.0;
    for (var i = 0u; i < 3u; i++) {
        let u = 0.5 * (cuts[i] + cuts[i + 1u]);
        if a * u * u + 2.0 * b * u + c <= 0.0 && along + u * drift >= 0.0 {
            inside += cuts[i + 1u] - cuts[i];
        }
    }
    return 0.5 * inside;
}

// The part of the ray's fan, in 0..=1, that points into the upper half space.
fn overlap_hemisphere(ray: Ray) -> f32 {
    let slope = ray.spread.z;
    if abs(slope) < 1e-12 {
        return select(0.0, 1.0, ray.direction.z > 0.0);
    }
    let above_low_end = 0.5 * (1.0 + ray.direction.z / abs(slope));
    return clamp(above_low_end, 0.0, 1.0);
}

// The directions of a disc light.
fn disc_cone(disc: PackedDisc) -> Cone {
    return Cone(disc.direction, disc.cos_radius, disc.sin_squared_radius);
}

// Deposits what the ray sees where it meets no surface (the paper's `ray_light`).
fn ray_light(ray: Ray) {
    let sky = frame.sky;
    if ray.depth == 0u && sky.backdrop != NONE {
        deposit(ray, sky.backdrop, WHOLE, 1.0);
        return;
    }
    let spread_length = length(ray.spread);
    for (var i = 0u; i < frame.disc_count; i++) {
        let disc = discs[i];
        let cone = disc_cone(disc);
        if is_far_off(ray, spread_length, cone) {
            continue;
        }
        let amount = overlap_amount(ray, cone);
        if amount > 0.0 {
            deposit(ray, disc.spectrum, WHOLE, amount);
        }
    }
    var visible = 1.0;
    if sky.sin_squared_observer_shadow > 0.0 {
        let head = Cone(
            frame.rules.observer,
            sky.cos_observer_shadow,
            sky.sin_squared_observer_shadow,
        );
        if !is_far_off(ray, spread_length, head) {
            visible -= overlap_amount(ray, head);
        }
    }
    if sky.environment != NONE && visible > 0.0 {
        deposit(ray, sky.environment, WHOLE, visible);
    }
    if sky.hemisphere != NONE && visible > 0.0 {
        let amount = overlap_hemisphere(ray);
        if amount > 0.0 {
            deposit(ray, sky.hemisphere, WHOLE, visible * amount);
        }
    }
}
