// Rays and convex solids: all facet planes in one loop.

// Where a ray inside the solid leaves it. There is always such a point: rounding can't lose it.
//
// `left_facet`, the one that the ray has just left, or `NONE`, is excluded: a ray can't meet a
// plane twice.
fn leave_convex(instance: Instance, ray: Ray, left_facet: u32) -> Hit {
    var nearest = FAR;
    var nearest_facet = NONE;
    for (var facet = 0u; facet < instance.count; facet++) {
        let plane = plane_of(instance, facet);
        let towards = dot(plane.xyz, ray.direction);
        if facet == left_facet || towards <= 0.0 {
            continue;
        }
        let crossing = (plane.w - dot(plane.xyz, ray.origin)) / towards;
        if crossing < nearest {
            nearest = crossing;
            nearest_facet = facet;
        }
    }
    if nearest_facet == NONE {
        return MISS;
    }
    return plane_hit(instance, max(nearest, 0.0), nearest_facet);
}

// Where a ray from outside enters the solid. One that starts on its surface enters there.
fn enter_convex(instance: Instance, ray: Ray) -> Hit {
    var farthest = -FAR;
    var farthest_facet = NONE;
    var nearest_exit = FAR;
    for (var facet = 0u; facet < instance.count; facet++) {
        let plane = plane_of(instance, facet);
        let towards = dot(plane.xyz, ray.direction);
        let gap = plane.w - dot(plane.xyz, ray.origin);
        if towards < 0.0 {
            let crossing = gap / towards;
            if crossing > farthest {
                farthest = crossing;
                farthest_facet = facet;
            }
        } else if towards > 0.0 {
            nearest_exit = min(nearest_exit, gap / towards);
        } else if gap < 0.0 {
            // A plane that the ray runs along outside of shuts it out.
            nearest_exit = -FAR;
        }
    }
    let distance = max(farthest, 0.0);
    if farthest_facet == NONE || farthest < -TOUCHING_MM || distance >= nearest_exit {
        return MISS;
    }
    return plane_hit(instance, distance, farthest_facet);
}

// Outward unit normal of a facet, and its distance from the origin of the world.
fn plane_of(instance: Instance, facet: u32) -> vec4f {
    let start = instance.first + facet;
    return vec4f(
        planes[start],
        planes[start + instance.count],
        planes[start + 2u * instance.count],
        planes[start + 3u * instance.count],
    );
}

fn plane_hit(instance: Instance, distance: f32, facet: u32) -> Hit {
    return Hit(distance, NONE, facet, plane_of(instance, facet).xyz);
}
