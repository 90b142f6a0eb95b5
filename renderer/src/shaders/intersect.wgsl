// The nearest surface along a ray, over all bodies and the ground.

// Top-level nodes that wait. A variable of the function would be set to zeros at each call.
var<private> top_stack: array<u32, TOP_STACK>;

// The nearest surface along `ray`; `MISS` where there is none.
//
// A ray inside a body meets that body's own surface before any that touches it.
fn find_intersection(ray: Ray) -> Hit {
    var own = MISS;
    if ray.medium != NONE {
        own = meet_instance(ray, ray.medium, FAR);
        if instances[ray.medium].interior_is_clear == 1u {
            return own;
        }
    }
    let ground = meet_ground(ray);
    var nearest = own;
    var limit = own.distance - TOUCHING_MM;
    if ground.distance < limit {
        nearest = ground;
        limit = ground.distance;
    }
    let other = meet_bodies(ray, limit, false);
    if other.instance == NONE {
        return nearest;
    }
    return other;
}

// Whether anything stands in the way of `ray`.
fn is_occluded(ray: Ray) -> bool {
    return meet_ground(ray).instance != NONE || meet_bodies(ray, FAR, true).instance != NONE;
}

// The ray inside a body, from slightly further inside and met by every facet.
fn nudge_inwards(ray: Ray) -> Ray {
    let center = instances[ray.medium].center;
    var nudged = ray;
    nudged.origin += (center - ray.origin) * NUDGE;
    nudged.facet = NONE;
    return nudged;
}

// The nearest body, or with `any` the first that is found.
fn meet_bodies(ray: Ray, limit: f32, any: bool) -> Hit {
    if frame.top_node_count == 0u {
        return MISS;
    }
    var nearest = MISS;
    nearest.distance = limit;
    let box_ray = new_box_ray(ray.origin, ray.direction);
    top_stack[0] = 0u;
    var count = 1u;
    while count > 0u {
        count--;
        let node = top_nodes[top_stack[count]];
        if box_entry(box_ray, node, nearest.distance) == FAR {
            continue;
        }
        if node.primitive_count == 0u {
            top_stack[count] = node.first + 1u;
            top_stack[count + 1u] = node.first;
            count += 2u;
            continue;
        }
        for (var slot = node.first; slot < node.first + node.primitive_count; slot++) {
            let hit = meet_instance(ray, words[slot], nearest.distance);
            if hit.distance < nearest.distance {
                nearest = hit;
                if any {
                    return nearest;
                }
            }
        }
    }
    return nearest;
}

// Where the ray meets one body, from the side that the ray is on.
fn meet_instance(ray: Ray, index: u32, limit: f32) -> Hit {
    let instance = instances[index];
    let has_left_it = ray.instance == index;
    let is_inside = ray.medium == index;
    if ray.enclosing == index && !is_inside {
        // The ray is in a body inside this one, and must leave that first.
        return MISS;
    }
    let left_facet = select(NONE, ray.facet, has_left_it);
    var hit = MISS;
    if instance.kind == CONVEX {
        // What leaves a convex solid does not come back.
        if is_inside {
            hit = leave_convex(instance, ray, left_facet);
        } else if !has_left_it {
            hit = enter_convex(instance, ray);
        }
    } else {
        hit = meet_mesh(instance, ray, left_facet, sides(instance, is_inside), limit);
    }
    if hit.facet != NONE {
        hit.instance = index;
    }
    return hit;
}

// The sides from which a body is met.
fn sides(instance: Instance, is_inside: bool) -> u32 {
    if is_opaque(materials[instance.material]) {
        return SIDES_BOTH;
    }
    return select(SIDES_FRONT, SIDES_BACK, is_inside);
}

// Where the ray meets the ground; a ray that has just left it never does.
fn meet_ground(ray: Ray) -> Hit {
    if frame.ground.reflectance[0] == NONE || ray.instance == GROUND {
        return MISS;
    }
    let height = frame.ground.height - ray.origin.z;
    // What leaves a body that rests on the ground starts on it, or a rounding error below.
    let is_touching = ray.direction.z < 0.0 && abs(height) < TOUCHING_MM;
    // So does what goes up inside it.
    let is_resting = ray.medium != NONE && ray.direction.z > 0.0 && height < TOUCHING_MM;
    let is_ahead = height * ray.direction.z > 0.0 && !is_resting;
    if !is_touching && !is_ahead {
        return MISS;
    }
    let distance = max(height / ray.direction.z, 0.0);
    return Hit(distance, GROUND, 0u, vec3f(0.0, 0.0, 1.0));
}
