// Rays and triangle meshes: a binary hierarchy with watertight triangles.

// Nodes that wait. A variable of the function would be set to zeros at each call.
var<private> node_stack: array<u32, NODE_STACK>;

// A ray as node boxes see it.
struct BoxRay {
    origin: vec3f,
    inverse_direction: vec3f,
}

// For a ray from `origin` along `direction`, which may have zero components.
fn new_box_ray(origin: vec3f, direction: vec3f) -> BoxRay {
    // A component of 0 would make infinite what may then be multiplied by 0.
    let is_parallel = abs(direction) < vec3f(PARALLEL);
    return BoxRay(origin, 1.0 / select(direction, vec3f(PARALLEL), is_parallel));
}

// Distance at which the ray enters the node's box, `FAR` for a miss or an entry beyond `limit`.
fn box_entry(ray: BoxRay, node: BvhNode, limit: f32) -> f32 {
    let t0 = (node.min - ray.origin) * ray.inverse_direction;
    let t1 = (node.max - ray.origin) * ray.inverse_direction;
    let near = max(max_element(min(t0, t1)), 0.0);
    let far = min_element(max(t0, t1)) * SLAB_ROUNDING;
    return select(FAR, near, near <= far && near <= limit);
}

// Permutation and shear that lay a ray along +z (Woop, Benthin, Wald 2013).
struct Shear {
    axes: vec3u,
    scale: vec3f,
}

// For a ray along `direction`, which is not zero.
fn new_shear(direction: vec3f) -> Shear {
    let z = max_position(abs(direction));
    var x = (z + 1u) % 3u;
    var y = (z + 2u) % 3u;
    if direction[z] < 0.0 {
        let swapped = x;
        x = y;
        y = swapped;
    }
    let scale = vec3f(direction[x], direction[y], 1.0) / direction[z];
    return Shear(vec3u(x, y, z), scale);
}

// The point relative to the ray's origin, in the sheared frame.
fn shear_point(shear: Shear, point: vec3f) -> vec3f {
    let along = point[shear.axes.z];
    return vec3f(
        point[shear.axes.x] - shear.scale.x * along,
        point[shear.axes.y] - shear.scale.y * along,
        shear.scale.z * along,
    );
}

// Distance to the triangle, `FAR` for a miss. Neighbouring triangles leave no gap: their common
// edge is judged by the same arithmetic.
fn triangle_distance(origin: vec3f, shear: Shear, triangle: PackedTriangle) -> f32 {
    let a = shear_point(shear, triangle.a - origin);
    let b = shear_point(shear, triangle.b - origin);
    let c = shear_point(shear, triangle.c - origin);
    let u = difference_of_products(c.x, b.y, c.y, b.x);
    let v = difference_of_products(a.x, c.y, a.y, c.x);
    let w = difference_of_products(b.x, a.y, b.y, a.x);
    let has_negative = u < 0.0 || v < 0.0 || w < 0.0;
    let has_positive = u > 0.0 || v > 0.0 || w > 0.0;
    let determinant = u + v + w;
    if (has_negative && has_positive) || determinant == 0.0 {
        return FAR;
    }
    let distance = (u * a.z + v * b.z + w * c.z) / determinant;
    return select(FAR, distance, distance >= 0.0);
}

// a·b − c·d, of the right sign: two triangles must see their common edge on opposite sides. The
// plain difference would lose that where the compiler fuses one product with the subtraction, so it
// is corrected by what that product's rounding lost (Kahan); where nothing is fused, by 0.
fn difference_of_products(a: f32, b: f32, c: f32, d: f32) -> f32 {
    let product = c * d;
    return fma(a, b, -product) + fma(-c, d, product);
}

// The nearest triangle of the mesh along the ray, closer than `limit`, met from one of `sides`.
//
// `left_facet` is the facet the ray has just left, which it can't meet again, or `NONE`.
fn meet_mesh(instance: Instance, ray: Ray, left_facet: u32, sides: u32, limit: f32) -> Hit {
    let rows = instance.object_from_world;
    let point = vec4f(ray.origin, 1.0);
    let vector = vec4f(ray.direction, 0.0);
    let origin = vec3f(dot(rows[0], point), dot(rows[1], point), dot(rows[2], point));
    let direction = vec3f(dot(rows[0], vector), dot(rows[1], vector), dot(rows[2], vector));
    let shear = new_shear(direction);
    let box_ray = new_box_ray(origin, direction);

    var hit = MISS;
    hit.distance = limit;
    var count = 0u;
    var current = instance.first;
    if box_entry(box_ray, nodes[current], limit) == FAR {
        return MISS;
    }
    loop {
        let node = nodes[current];
        if node.primitive_count > 0u {
            for (var i = node.first; i < node.first + node.primitive_count; i++) {
                let triangle = triangles[i];
                if triangle.facet == left_facet || !faces(triangle, direction, sides) {
                    continue;
                }
                let distance = triangle_distance(origin, shear, triangle);
                if distance < hit.distance {
                    hit.distance = distance;
                    hit.facet = triangle.facet;
                    hit.normal = normal(triangle);
                }
            }
        } else {
            var near = node.first;
            var far = node.first + 1u;
            var near_entry = box_entry(box_ray, nodes[near], hit.distance);
            var far_entry = box_entry(box_ray, nodes[far], hit.distance);
            if far_entry < near_entry {
                near = node.first + 1u;
                far = node.first;
                let swapped = near_entry;
                near_entry = far_entry;
                far_entry = swapped;
            }
            if near_entry < FAR {
                if far_entry < FAR {
                    node_stack[count] = far;
                    count++;
                }
                current = near;
                continue;
            }
        }
        if count == 0u {
            break;
        }
        count--;
        current = node_stack[count];
    }
    if hit.facet == NONE {
        return MISS;
    }
    // The inverse transpose of the world matrix, up to a scale.
    let normal = rows[0].xyz * hit.normal.x + rows[1].xyz * hit.normal.y + rows[2].xyz * hit.normal.z;
    hit.normal = normalize_or_zero(normal);
    return hit;
}

// Whether the triangle turns one of `sides` towards the ray.
fn faces(triangle: PackedTriangle, direction: vec3f, sides: u32) -> bool {
    let along = dot(normal(triangle), direction);
    switch sides {
        case SIDES_FRONT: {
            return along < 0.0;
        }
        case SIDES_BACK: {
            return along > 0.0;
        }
        default: {
            return true;
        }
    }
}
