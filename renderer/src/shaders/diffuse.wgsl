// Opaque diffuse surfaces under discs and sky, with shadow rays.

// Deposits the light that the surface at `hit` sends back along `ray`, which ends there.
//
// Each disc counts with its solid angle (Thomas 1986: 2π(1 − √(1 − s²))) and is asked for by one
// shadow ray to a point on it that changes from pass to pass; so, last, is the sky.
fn shade_diffuse(ray: Ray, hit: Hit) {
    let sky = frame.sky;
    let reflectance = reflectance_at(ray, hit);
    let normal = select(hit.normal, -hit.normal, dot(ray.direction, hit.normal) > 0.0);
    let disc_count = frame.disc_count;
    let has_sky = sky.hemisphere != NONE || sky.environment != NONE;
    for (var light = 0u; light < disc_count + u32(has_sky); light++) {
        let is_sky = light == disc_count;
        let at = light_sample(next_seed(), walk.pass_index);
        var direction: vec3f;
        var scale = 1.0;
        if is_sky {
            direction = direction_by_cosine(normal, at);
        } else {
            let disc = discs[light];
            direction = direction_on_disc(disc, at);
            scale = FRAC_1_PI * disc.solid_angle * dot(direction, normal);
            shine_through(ray, hit, normal, light, direction, reflectance);
        }
        if scale <= 0.0 || is_shadowed(ray, hit, direction) {
            continue;
        }
        if !is_sky {
            deposit(ray, discs[light].spectrum, reflectance, scale);
            continue;
        }
        if sky.environment != NONE {
            deposit(ray, sky.environment, reflectance, scale);
        }
        if sky.hemisphere != NONE && direction.z > 0.0 {
            deposit(ray, sky.hemisphere, reflectance, scale);
        }
    }
}

// The reflectance of the surface where the ray ends.
fn reflectance_at(ray: Ray, hit: Hit) -> Reflectance {
    if hit.instance != GROUND {
        let material = material_of(hit.instance);
        if material.print.texels == NONE {
            return bare(material.reflectance);
        }
        return print_reflectance(material, hit, ray.origin);
    }
    let square_x = floor(ray.origin.x / frame.ground.square);
    let square_y = floor(ray.origin.y / frame.ground.square);
    let half = (square_x + square_y) * 0.5;
    let is_odd = half != floor(half);
    return bare(select(frame.ground.reflectance[0], frame.ground.reflectance[1], is_odd));
}

// Whether something stands between the surface and the light in `direction`.
fn is_shadowed(ray: Ray, hit: Hit, direction: vec3f) -> bool {
    walk.tally.segments += 1u;
    var shadow_ray = white(ray.origin, direction);
    shadow_ray.instance = hit.instance;
    shadow_ray.facet = hit.facet;
    return is_occluded(shadow_ray);
}

// Two unit vectors at right angles to the unit vector `normal` and to each other (Duff et al.
// 2017).
fn orthonormal_pair(normal: vec3f) -> array<vec3f, 2> {
    let sign = select(1.0, -1.0, normal.z < 0.0);
    let a = -1.0 / (sign + normal.z);
    let b = normal.x * normal.y * a;
    return array<vec3f, 2>(
        vec3f(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x),
        vec3f(b, sign + normal.y * normal.y * a, -normal.y),
    );
}

// A direction evenly distributed over the disc's solid angle.
fn direction_on_disc(disc: PackedDisc, at: vec2f) -> vec3f {
    // 1 − cos of the radius, without the cancellation of the plain difference.
    let height = disc.sin_squared_radius / (1.0 + disc.cos_radius);
    let fall = at.x * height;
    let sin_fall = sqrt(max(fall * (2.0 - fall), 0.0));
    // Shaders know sine and cosine well from −π to π.
    let azimuth = TAU * (at.y - 0.5);
    let pair = orthonormal_pair(disc.direction);
    return normalize_or_zero(
        pair[0] * (sin_fall * cos(azimuth))
            + pair[1] * (sin_fall * sin(azimuth))
            + disc.direction * (1.0 - fall),
    );
}

// A direction about `normal` with a density proportional to its cosine.
fn direction_by_cosine(normal: vec3f, at: vec2f) -> vec3f {
    let azimuth = TAU * (at.y - 0.5);
    let radius = sqrt(at.x);
    let pair = orthonormal_pair(normal);
    return normalize_or_zero(
        pair[0] * (radius * cos(azimuth))
            + pair[1] * (radius * sin(azimuth))
            + normal * sqrt(max(1.0 - at.x, 0.0)),
    );
}
