// What becomes of a ray at an interface (the paper's `fork_rays` and `refract`).

// Sends on what the interface at `hit` makes of `ray`, which has been moved to it.
fn fork_rays(ray: Ray, hit: Hit) {
    let at = interface_at(ray, hit);
    var incident = ray;
    if frame.rules.perturb == 0u {
        // Every wavelength arrives from one direction: the mistake of Fig. 3.
        incident.spread = vec3f(0.0);
    }
    let low_nm = ray.lambda_low_nm;
    let high_nm = ray.lambda_high_nm;
    let low_is_reflected = is_totally_reflected(at, fan_at(incident, low_nm), low_nm);
    let high_is_reflected = is_totally_reflected(at, fan_at(incident, high_nm), high_nm);
    var reflected = ray;
    var refracted = incident;
    var refracted_spread = ray.spread;
    if low_is_reflected != high_is_reflected {
        let dividing_nm = find_total_refl_wave(at, incident, low_is_reflected);
        reflected = perturb(incident, low_nm, dividing_nm);
        refracted = perturb(incident, dividing_nm, high_nm);
        if high_is_reflected {
            let below = reflected;
            reflected = refracted;
            refracted = below;
        }
        refracted_spread = refracted.spread;
    }
    if low_is_reflected || high_is_reflected {
        send(reflected_ray(reflected, hit, at));
    }
    if !low_is_reflected || !high_is_reflected {
        split_and_refract(refracted, refracted_spread, hit, at);
    }
}

// The body that the ray would be in beyond the surface at `hit`, or `NONE`.
fn medium_beyond(ray: Ray, hit: Hit) -> u32 {
    return select(hit.instance, ray.enclosing, ray.medium == hit.instance);
}

// The interface with its normal on the ray's side and the media in the ray's order.
fn interface_at(ray: Ray, hit: Hit) -> Interface {
    return Interface(
        select(hit.normal, -hit.normal, ray.medium == hit.instance),
        index_table_of(ray.medium),
        index_table_of(medium_beyond(ray, hit)),
    );
}

// The index table of a body, or `NONE` for air.
fn index_table_of(instance: u32) -> u32 {
    if instance == NONE {
        return NONE;
    }
    return material_of(instance).index_table;
}

// Divides a ray of which nothing is totally reflected into sub-rays that are fine enough for
// the smallest light, and refracts each. `spread` is the one that counts for their number.
fn split_and_refract(ray: Ray, spread: vec3f, hit: Hit, at: Interface) {
    let low_nm = ray.lambda_low_nm;
    let high_nm = ray.lambda_high_nm;
    var low_end = refracted_at(ray, at, low_nm);
    let last_end = refracted_at(ray, at, high_nm);
    let dispersed = spread_angle(spread_between(low_end, last_end));
    let light_spread = frame.sky.light_spread;
    var count =
        subray_count(frame.rules.split_count, spread_angle(spread), dispersed, light_spread);
    if meets_second_absorber(ray, hit) {
        count = max(count, u32(ceil((high_nm - low_nm) / frame.bin_width_nm)));
    }
    var edge_nm = low_nm;
    for (var i = 1u; i <= count; i++) {
        var sub_ray = ray;
        var high_end = last_end;
        if count > 1u {
            let next_nm = low_nm + (high_nm - low_nm) * (f32(i) / f32(count));
            sub_ray = perturb(ray, edge_nm, next_nm);
            edge_nm = next_nm;
        }
        if i < count {
            high_end = refracted_at(ray, at, edge_nm);
        }
        refract_and_reflect(sub_ray, hit, at, spread_between(low_end, high_end));
        low_end = high_end;
    }
}

// Unit direction of the refracted light of `lambda_nm`.
fn refracted_at(ray: Ray, at: Interface, lambda_nm: f32) -> vec3f {
    let eta = relative_index(at, lambda_nm);
    return refract(direction_at(ray, lambda_nm), at.normal, eta);
}

// Sends on the refracted and the reflected part of one sub-ray, weighted by Fresnel's
// coefficients at its central wavelength. `spread` is that of the refracted ray, from its ends.
fn refract_and_reflect(ray: Ray, hit: Hit, at: Interface, spread: vec3f) {
    let central_nm = 0.5 * (ray.lambda_low_nm + ray.lambda_high_nm);
    let eta = relative_index(at, central_nm);
    let cos_i = -dot(ray.direction, at.normal);
    let cos_t_squared = cos_refracted_squared(cos_i, eta);
    var reflectance = 1.0;
    if cos_i > 0.0 && cos_t_squared > 0.0 {
        reflectance = fresnel(cos_i, sqrt(cos_t_squared), eta);
    }
    var reflected = reflected_ray(ray, hit, at);
    reflected.significance *= reflectance;
    send(reflected);
    if reflectance == 1.0 {
        return;
    }
    let medium = medium_beyond(ray, hit);
    var refracted = ray;
    refracted.direction = refract(ray.direction, at.normal, eta);
    refracted.spread = spread;
    refracted.significance *= 1.0 - reflectance;
    refracted.instance = hit.instance;
    refracted.facet = hit.facet;
    refracted.medium = medium;
    refracted.enclosing = select(NONE, ray.medium, medium == hit.instance);
    refracted.depth += 1u;
    send(enter_absorber(refracted));
}

// The whole ray, mirrored.
fn reflected_ray(ray: Ray, hit: Hit, at: Interface) -> Ray {
    var reflected = ray;
    reflected.instance = hit.instance;
    reflected.facet = hit.facet;
    reflected.depth += 1u;
    // At grazing incidence `perturb` may turn a sub-ray away from the surface: it goes on as it is.
    if dot(ray.direction, at.normal) < 0.0 {
        reflected.direction = reflect(ray.direction, at.normal);
        reflected.spread = reflect(ray.spread, at.normal);
    }
    return reflected;
}

// The material that absorbs inside the body `instance`, or `NONE`.
fn absorber_of(instance: u32) -> u32 {
    if instance == NONE {
        return NONE;
    }
    return select(instances[instance].material, NONE, material_of(instance).absorption == NONE);
}

// Whether the ray, having run through one coloured material, would enter another.
fn meets_second_absorber(ray: Ray, hit: Hit) -> bool {
    let next = absorber_of(medium_beyond(ray, hit));
    return ray.absorber != NONE && next != NONE && next != ray.absorber;
}

// The ray with the path through its medium begun if that is coloured. A path through another one is
// paid for first, by its mean over the interval, which for that is at most one bin wide.
fn enter_absorber(ray: Ray) -> Ray {
    let next = absorber_of(ray.medium);
    if next == NONE || next == ray.absorber {
        return ray;
    }
    let kept = mean_transmittance(ray);
    walk.tally.absorbed += ray.significance * bandwidth(ray) * (1.0 - kept);
    var entered = ray;
    entered.significance *= kept;
    entered.absorber = next;
    entered.path_mm = 0.0;
    return entered;
}
