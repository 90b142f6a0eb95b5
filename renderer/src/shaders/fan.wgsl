// The fan: an interval of wavelengths traced at three of them, its ends and its middle.
//
// All that is said of Thomas's spread vector in `spread` stops at a fan without width and a straight
// line of directions. Here each of the three has its own start, its own direction and its own weight,
// and between them all is quadratic along the dispersion axis.

// Rays of an interval of wavelengths, at three of them.
struct Fan {
    origin: Nodes,
    direction: Nodes,
    weight: vec3f,
    low: f32,
    path_mm: vec3f,
    high: f32,
    instance: u32,
    facet: u32,
    medium: u32,
    enclosing: u32,
    depth: u32,
    absorber: u32,
}

// The whole spectrum along one ray, with weight 1.
fn white_fan(origin: vec3f, direction: vec3f) -> Fan {
    return Fan(
        equal_nodes(origin),
        equal_nodes(direction),
        vec3f(1.0),
        0.0,
        vec3f(0.0),
        1.0,
        NONE,
        NONE,
        NONE,
        NONE,
        0u,
        NONE,
    );
}

// Positions of the three wavelengths on the axis.
fn axis_positions(fan: Fan) -> vec3f {
    return vec3f(fan.low, 0.5 * (fan.low + fan.high), fan.high);
}

// Position on the axis of a position in the fan.
fn axis_position_in(fan: Fan, position: f32) -> f32 {
    return 0.5 * ((fan.low + fan.high) + (fan.high - fan.low) * position);
}

// Whether the rays of different wavelengths are different rays.
fn is_dispersed(fan: Fan) -> bool {
    return fan.direction.x.x != fan.direction.x.z
        || fan.direction.y.x != fan.direction.y.z
        || fan.direction.z.x != fan.direction.z.z;
}

// Rays that are traced for a fan: one while all wavelengths take the same way.
fn segment_count(fan: Fan) -> u32 {
    return select(1u, 3u, is_dispersed(fan));
}

// The part of the fan between two positions in it.
fn part_of_fan(fan: Fan, low: f32, high: f32) -> Fan {
    let basis = basis_between(low, high);
    var part = fan;
    part.origin = blend_nodes(fan.origin, basis);
    part.direction = normalize_each(blend_nodes(fan.direction, basis));
    part.weight = max(basis * fan.weight, vec3f(0.0));
    part.path_mm = basis * fan.path_mm;
    part.low = axis_position_in(fan, low);
    part.high = axis_position_in(fan, high);
    return part;
}

// The fan with the rays of all wavelengths on the middle one.
fn gathered(fan: Fan) -> Fan {
    var together = fan;
    together.origin = equal_nodes(middle_node(fan.origin));
    together.direction = equal_nodes(middle_node(fan.direction));
    together.path_mm = vec3f(fan.path_mm.y);
    return together;
}

// The ray of one wavelength of the fan, without the light that it carries.
fn ray_in_fan(fan: Fan, position: f32) -> Ray {
    let basis = basis_at(position);
    let direction = normalize_or_zero(blend(fan.direction, basis));
    var ray = white(blend(fan.origin, basis), direction);
    ray.instance = fan.instance;
    ray.facet = fan.facet;
    ray.medium = fan.medium;
    ray.enclosing = fan.enclosing;
    ray.depth = fan.depth;
    return ray;
}
