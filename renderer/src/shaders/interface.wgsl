// Snell, Fresnel and total reflection at one smooth interface.

// An interface as a ray meets it.
struct Interface {
    normal: vec3f,
    medium_from: u32,
    medium_to: u32,
}

// Index of refraction of a medium at `lambda_nm`; 1 for air.
fn index_of_refraction(medium: u32, lambda_nm: f32) -> f32 {
    if medium == NONE {
        return 1.0;
    }
    let position = clamp(lambda_nm - LAMBDA_MIN_NM, 0.0, f32(INDEX_TABLE_LEN - 1u));
    let i = min(u32(position), INDEX_TABLE_LEN - 2u);
    let start = medium + i;
    let n0 = spectra[start];
    let n1 = spectra[start + 1u];
    return n0 + (n1 - n0) * (position - f32(i));
}

// Relative index n₁/n₂ of the interface at `lambda_nm`.
fn relative_index(at: Interface, lambda_nm: f32) -> f32 {
    return index_of_refraction(at.medium_from, lambda_nm)
        / index_of_refraction(at.medium_to, lambda_nm);
}

// `direction` mirrored at a plane with unit `normal`.
fn reflect(direction: vec3f, normal: vec3f) -> vec3f {
    return direction - normal * (2.0 * dot(direction, normal));
}

// Squared cosine of the angle of refraction by Snell's law; 0 or less beyond the critical angle.
//
// `cos_i` is the cosine of the angle of incidence, `eta` is n₁/n₂.
fn cos_refracted_squared(cos_i: f32, eta: f32) -> f32 {
    return 1.0 - eta * eta * (1.0 - cos_i * cos_i);
}

// Unit direction after refraction; grazing beyond the critical angle.
//
// `normal` is the unit normal on the side of the incident unit `direction`, `eta` is n₁/n₂.
fn refract(direction: vec3f, normal: vec3f, eta: f32) -> vec3f {
    let cos_i = -dot(direction, normal);
    let cos_t = sqrt(max(cos_refracted_squared(cos_i, eta), 0.0));
    return normalize_or_zero(direction * eta + normal * (eta * cos_i - cos_t));
}

// Unpolarised Fresnel reflectance of a smooth dielectric interface.
//
// `cos_i` and `cos_t` are the cosines of the angles of incidence and refraction, in 0..=1;
// `eta` is n₁/n₂. Thomas 1986, "Dispersive refraction", after Born & Wolf, §1.5.2.
fn fresnel(cos_i: f32, cos_t: f32, eta: f32) -> f32 {
    // The paper's formulae with both indices divided by n₂.
    let parallel = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    let perpendicular = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    return clamp(0.5 * (parallel * parallel + perpendicular * perpendicular), 0.0, 1.0);
}

// Whether light of `lambda_nm` that arrives along `direction`, of any length, is totally reflected
// (the paper's `reflectp`): n₁·sin θ ≥ n₂, both sides squared and times the length squared.
fn is_totally_reflected(at: Interface, direction: vec3f, lambda_nm: f32) -> bool {
    let n_from = index_of_refraction(at.medium_from, lambda_nm);
    let n_to = index_of_refraction(at.medium_to, lambda_nm);
    let along_normal = dot(direction, at.normal);
    let length_squared = length_squared(direction);
    let sideways_squared = length_squared - along_normal * along_normal;
    return n_from * n_from * sideways_squared >= n_to * n_to * length_squared;
}

// The wavelength in the ray's interval that divides total reflection from refraction, found by
// binary search; the returned wavelength itself is refracted.
//
// `low_is_reflected` tells that the low end is the totally reflected one.
fn find_total_refl_wave(at: Interface, ray: Ray, low_is_reflected: bool) -> f32 {
    var reflected_nm = select(ray.lambda_high_nm, ray.lambda_low_nm, low_is_reflected);
    var refracted_nm = select(ray.lambda_low_nm, ray.lambda_high_nm, low_is_reflected);
    for (var i = 0u; i < BISECTIONS; i++) {
        let middle_nm = 0.5 * (reflected_nm + refracted_nm);
        if is_totally_reflected(at, fan_at(ray, middle_nm), middle_nm) {
            reflected_nm = middle_nm;
        } else {
            refracted_nm = middle_nm;
        }
    }
    return refracted_nm;
}
