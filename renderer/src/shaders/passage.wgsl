// Light that goes straight through a clear convex body onto matte surfaces: in through one facet,
// out through another, without a reflection inside.
//
// Lamps are distant and facets flat, so that behind such a pair of facets light of one wavelength
// has one direction, wherever it came through. A matte surface can therefore look for it.

// Light of one wavelength on its way through a passage.
struct Beam {
    // Unit direction inside the body.
    inside: vec3f,
    // Unit direction behind the body.
    behind: vec3f,
    // Irradiance across the beam behind the body by that before it, absorption left out; 0 where
    // the light does not get through.
    gain: f32,
}

// Deposits what reaches the surface at `hit` through clear bodies of the light that shines from
// `towards_light`, a point on the disc number `light`.
//
// `normal` is the surface's unit normal on the side that `ray` came from. Each bin of the ray's
// interval is asked for at one wavelength, which changes from pass to pass.
fn shine_through(
    ray: Ray,
    hit: Hit,
    normal: vec3f,
    light: u32,
    towards_light: vec3f,
    reflectance: Reflectance,
) {
    let disc = discs[light];
    let bins = bin_range(ray.lambda_low_nm, ray.lambda_high_nm);
    let position = wavelength_sample(walk.pass_index);
    let end = disc.first_passage + disc.passage_count;
    for (var number = disc.first_passage; number < end; number++) {
        let passage = passages[number];
        if is_out_of_reach(passage, ray.origin) {
            continue;
        }
        for (var bin = bins.first; bin <= bins.last; bin++) {
            var band = ray;
            let bin_low_nm = LAMBDA_MIN_NM + f32(bin) * frame.bin_width_nm;
            band.lambda_low_nm = max(bin_low_nm, ray.lambda_low_nm);
            band.lambda_high_nm = min(bin_low_nm + frame.bin_width_nm, ray.lambda_high_nm);
            let width_nm = band.lambda_high_nm - band.lambda_low_nm;
            let beam = bend(passage, towards_light, band.lambda_low_nm + width_nm * position);
            let cos_incidence = -dot(beam.behind, normal);
            if width_nm <= 0.0 || beam.gain <= 0.0 || cos_incidence <= 0.0 {
                continue;
            }
            let kept = follow_back(band, hit, passage, beam, towards_light, bin);
            if kept > 0.0 {
                let scale = FRAC_1_PI * disc.solid_angle * cos_incidence * beam.gain * kept;
                deposit(band, disc.spectrum, reflectance, scale);
            }
        }
    }
}

// Whether no light that comes through the passage can fall on `point`: the way back to the facet
// that it leaves is in a cone about the passage's direction, and that cone misses the facet.
fn is_out_of_reach(passage: PackedPassage, point: vec3f) -> bool {
    let way = passage.center - point;
    let along = dot(way, passage.direction);
    let across = length(cross(way, passage.direction));
    return across * passage.cos_bound - along * passage.sin_bound > passage.radius;
}

// What the passage makes of light of `lambda_nm` that comes from the unit direction
// `towards_light`.
fn bend(passage: PackedPassage, towards_light: vec3f, lambda_nm: f32) -> Beam {
    let medium = material_of(passage.instance).index_table;
    let n = index_of_refraction(medium, lambda_nm);
    let inside = refract(-towards_light, passage.normal_in, 1.0 / n);
    let behind = refract(inside, -passage.normal_out, n);
    let cos_in = dot(towards_light, passage.normal_in);
    let cos_out = dot(inside, passage.normal_out);
    var gain = 0.0;
    if cos_in > 0.0 && cos_out > 0.0 && cos_refracted_squared(cos_out, n) > 0.0 {
        gain = facet_gain(cos_in, 1.0 / n) * facet_gain(cos_out, n);
    }
    return Beam(inside, behind, gain);
}

// By what an interface multiplies the irradiance across a beam: (1 − R)·cos θᵢ/cos θₜ, where R is
// Fresnel's reflectance and the cosines say how the beam's cross-section changes.
//
// `cos_i`, of the angle of incidence, is above 0; `eta` is n₁/n₂ and short of total reflection.
// Written with the transmission coefficients (Born & Wolf, §1.5.2), nothing cancels and nothing is
// divided by the cosine of a grazing angle.
fn facet_gain(cos_i: f32, eta: f32) -> f32 {
    let cos_t = sqrt(max(cos_refracted_squared(cos_i, eta), 0.0));
    let parallel = cos_i / (cos_i + eta * cos_t);
    let perpendicular = cos_i / (eta * cos_i + cos_t);
    return 2.0 * eta * (parallel * parallel + perpendicular * perpendicular);
}

// Goes back along the beam from the surface at `hit` to the light: how much, in 0..=1, the body
// lets through in `bin`; 0 where the beam does not come this way.
fn follow_back(
    ray: Ray,
    hit: Hit,
    passage: PackedPassage,
    beam: Beam,
    towards_light: vec3f,
    bin: u32,
) -> f32 {
    let way = passage.center - ray.origin;
    if dot(way, beam.behind) > passage.radius
        || length(cross(way, beam.behind)) > passage.radius {
        return 0.0;
    }
    var back = white(ray.origin, -beam.behind);
    back.instance = hit.instance;
    back.facet = hit.facet;
    walk.tally.segments += 1u;
    let way_out = find_intersection(back);
    if way_out.instance != passage.instance || way_out.facet != passage.facet_out {
        return 0.0;
    }
    back.origin += back.direction * way_out.distance;
    back.direction = -beam.inside;
    back.instance = passage.instance;
    back.facet = passage.facet_out;
    back.medium = passage.instance;
    walk.tally.segments += 1u;
    let way_in = find_intersection(back);
    if way_in.instance != passage.instance || way_in.facet != passage.facet_in {
        return 0.0;
    }
    let material = instances[passage.instance].material;
    var kept = 1.0;
    if materials[material].absorption != NONE {
        back.absorber = material;
        back.path_mm = way_in.distance;
        kept = transmittance(back, bin);
    }
    back.origin += back.direction * way_in.distance;
    back.direction = towards_light;
    back.facet = passage.facet_in;
    back.medium = NONE;
    walk.tally.segments += 1u;
    if is_occluded(back) {
        return 0.0;
    }
    return kept;
}
