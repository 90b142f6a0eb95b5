// The ray of the paper: an interval of wavelengths, a direction and a spread vector.

// A ray that carries the wavelengths from `lambda_low_nm` to `lambda_high_nm`.
//
// The directions at the ends of the interval are `direction ∓ spread`; the length of `spread` is
// tan(angular spread / 2) (Thomas 1986, "Implementation").
struct Ray {
    origin: vec3f,
    lambda_low_nm: f32,
    direction: vec3f,
    lambda_high_nm: f32,
    spread: vec3f,
    significance: f32,
    instance: u32,
    facet: u32,
    medium: u32,
    enclosing: u32,
    depth: u32,
    absorber: u32,
    path_mm: f32,
}

// An undispersed ray of weight 1 over the whole spectrum, outside of everything.
fn white(origin: vec3f, direction: vec3f) -> Ray {
    return Ray(
        origin,
        LAMBDA_MIN_NM,
        direction,
        LAMBDA_MAX_NM,
        vec3f(0.0),
        1.0,
        NONE,
        NONE,
        NONE,
        NONE,
        0u,
        NONE,
        0.0,
    );
}

// The part of the traced spectrum that the ray carries, in 0..=1.
fn bandwidth(ray: Ray) -> f32 {
    return (ray.lambda_high_nm - ray.lambda_low_nm) / (LAMBDA_MAX_NM - LAMBDA_MIN_NM);
}

// The nearest surface along a ray.
struct Hit {
    distance: f32,
    instance: u32,
    facet: u32,
    normal: vec3f,
}

// No surface.
const MISS = Hit(FAR, NONE, NONE, vec3f(0.0, 0.0, 1.0));
