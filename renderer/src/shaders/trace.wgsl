// Following rays through the tree of a camera ray's descendants (the paper's `ray_solid`).

// Follows what waits of a walk until nothing does, or `budget` rays were followed; gives what is
// left of the budget.
fn trace(budget: u32) -> u32 {
    var left = budget;
    while has_rays() && left > 0u {
        follow();
        left--;
    }
    return left;
}

// Takes the next ray that waits to the next surface, or to the lights.
fn follow() {
    var ray = pop();
    walk.tally.segments += 1u;
    var hit = find_intersection(ray);
    if hit.instance == NONE && ray.medium != NONE {
        hit = find_lost_exit(ray);
        if hit.instance == NONE {
            walk.tally.lost += retire(ray);
            return;
        }
    }
    if hit.instance == NONE {
        ray_light(ray);
        walk.tally.returned += retire(ray);
        return;
    }
    ray.origin += ray.direction * hit.distance;
    if runs_in_absorber(ray) {
        ray.path_mm += hit.distance;
    }
    if meets_opaque(hit) {
        shade_diffuse(ray, hit);
        walk.tally.returned += retire(ray);
    } else {
        fork_rays(ray, hit);
    }
}

// Whether the ray's medium is the material whose path it counts.
fn runs_in_absorber(ray: Ray) -> bool {
    return ray.absorber != NONE
        && ray.medium != NONE
        && instances[ray.medium].material == ray.absorber;
}

// Whether the ray ends at `hit`.
fn meets_opaque(hit: Hit) -> bool {
    return hit.instance == GROUND || is_opaque(material_of(hit.instance));
}
