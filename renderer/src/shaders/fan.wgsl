// The fan: an interval of wavelengths traced at three of them, its ends and its middle.
//
// All that is said of Thomas's spread vector in `spread` stops at a fan without width and a straight
// line of directions. Here each of the three has its own start, its own direction and its own weight,
// and between them all is quadratic in the position in the fan. So is the place on the dispersion axis:
// where the light changes fast next to the critical wavelength, the middle node lies nearer to it.

// Rays of an interval of wavelengths, at three of them.
struct Fan {
    origin: Nodes,
    direction: Nodes,
    weight: vec3f,
    depth: u32,
    path_mm: vec3f,
    absorber: u32,
    axis: vec3f,
    instance: u32,
    facet: u32,
    medium: u32,
    enclosing: u32,
    seed: u32,
}

// The whole spectrum along one ray, with weight 1.
fn white_fan(origin: vec3f, direction: vec3f, seed: u32) -> Fan {
    return Fan(
        equal_nodes(origin),
        equal_nodes(direction),
        vec3f(1.0),
        0u,
        vec3f(0.0),
        NONE,
        vec3f(0.0, 0.5, 1.0),
        NONE,
        NONE,
        NONE,
        NONE,
        seed,
    );
}

// The random word of what comes of a fan that has the word `seed` on one of its ways on.
fn seed_of_way(seed: u32, way: u32) -> u32 {
    return hash(seed + way);
}

// Part of the dispersion axis between the ends of the fan.
fn axis_width(fan: Fan) -> f32 {
    return fan.axis.z - fan.axis.x;
}

// Position on the axis of a position in the fan.
fn axis_position_in(fan: Fan, position: f32) -> f32 {
    return dot(basis_at(position), fan.axis);
}

// The position in the fan of a position on the axis.
fn position_of(fan: Fan, axis_position: f32) -> f32 {
    return position_where(parabola_through(fan.axis), axis_position);
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
    return fan_through(fan, vec3f(low, 0.5 * (low + high), high));
}

// The part of the fan between two positions in it, with its middle node at a third between them.
fn fan_through(fan: Fan, positions: vec3f) -> Fan {
    let basis = basis_of(positions);
    var part = fan;
    part.origin = blend_nodes(fan.origin, basis);
    part.direction = normalize_each(blend_nodes(fan.direction, basis));
    part.weight = basis * fan.weight;
    part.path_mm = basis * fan.path_mm;
    part.axis = basis * fan.axis;
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
