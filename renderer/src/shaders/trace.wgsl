// Following rays through the tree of a camera ray's descendants (the paper's `ray_solid`).

// Takes the next ray that waits to the next surface, or to the lights.
fn follow() {
    var ray = pop();
    walk.tally.segments += 1u;
    walk.tally.depth = max(walk.tally.depth, ray.depth);
    let hit = next_surface(&ray);
    if hit.instance != NONE {
        ray.origin += ray.direction * hit.distance;
        if runs_in_absorber(ray.absorber, ray.medium) {
            ray.path_mm += hit.distance;
        }
        if !meets_opaque(hit) {
            fork_rays(ray, hit);
            return;
        }
        shade_diffuse(ray, hit);
    } else if ray.medium == NONE {
        ray_light(ray);
    }
    let energy = retire(ray);
    if is_lost(ray, hit) {
        walk.tally.lost += energy;
    } else {
        walk.tally.returned += energy;
    }
}

// The next surface along a ray. One that a mesh seems not to let out tries once more, and is left
// slightly further inside.
fn next_surface(ray: ptr<function, Ray>) -> Hit {
    var hit = MISS;
    for (var attempt = 0u; attempt < 2u; attempt++) {
        if attempt > 0u {
            *ray = nudge_inwards(*ray);
        }
        hit = find_intersection(*ray);
        if !is_lost(*ray, hit) {
            break;
        }
    }
    return hit;
}

// Whether the ray is inside of a body that it does not meet from there.
fn is_lost(ray: Ray, hit: Hit) -> bool {
    return hit.instance == NONE && ray.medium != NONE;
}

// Whether the body `medium` that a ray runs in is of the material `absorber` whose path it counts.
fn runs_in_absorber(absorber: u32, medium: u32) -> bool {
    return absorber != NONE && medium != NONE && instances[medium].material == absorber;
}

// Whether the ray ends at `hit`.
fn meets_opaque(hit: Hit) -> bool {
    return hit.instance == GROUND || is_opaque(material_of(hit.instance));
}
