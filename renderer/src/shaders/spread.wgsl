// The angular spread of a ray and its division among sub-rays.

// Direction of `ray` at `lambda_nm` within its interval, of a length of about 1.
fn fan_at(ray: Ray, lambda_nm: f32) -> vec3f {
    return ray.direction + ray.spread * interval_position(ray, lambda_nm);
}

// Unit direction of `ray` at `lambda_nm` within its interval (the paper's `perturb(ray, λ, λ)`).
fn direction_at(ray: Ray, lambda_nm: f32) -> vec3f {
    return normalize_or_zero(fan_at(ray, lambda_nm));
}

// The part of `ray` between two wavelengths of its interval, with the direction and spread of
// that part (Thomas 1986, `perturb`; Fig. 4).
fn perturb(ray: Ray, low_nm: f32, high_nm: f32) -> Ray {
    let low = fan_at(ray, low_nm);
    let high = fan_at(ray, high_nm);
    var part = ray;
    part.lambda_low_nm = low_nm;
    part.lambda_high_nm = high_nm;
    part.direction = normalize_or_zero((low + high) * 0.5);
    part.spread = (high - low) * 0.5;
    return part;
}

// Position of `lambda_nm` in the interval, from −1 at the low end to 1 at the high end.
fn interval_position(ray: Ray, lambda_nm: f32) -> f32 {
    let width_nm = ray.lambda_high_nm - ray.lambda_low_nm;
    if width_nm > 0.0 {
        return 2.0 * (lambda_nm - ray.lambda_low_nm) / width_nm - 1.0;
    }
    return 0.0;
}

// The spread vector between two unit directions: half their difference, of length
// tan(angle / 2).
fn spread_between(low: vec3f, high: vec3f) -> vec3f {
    // |low + high| is 2·cos(angle/2); opposite directions do not come out of one interface.
    return (high - low) / max(length(high + low), 1e-6);
}

// Angle in radians that a spread vector stands for.
fn spread_angle(spread: vec3f) -> f32 {
    return 2.0 * atan(length(spread));
}

// Number of sub-rays that makes `split_count` of them hit a light of angular extent
// `light_spread`: 1 + K·(spread + dispersed spread)/light spread, all angles in radians.
fn subray_count(split_count: f32, ray_spread: f32, dispersed: f32, light_spread: f32) -> u32 {
    let extra = split_count * (ray_spread + dispersed) / light_spread;
    return 1u + u32(clamp(extra, 0.0, f32(MAX_SUBRAYS - 1u)));
}
