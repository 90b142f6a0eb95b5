// Values at the three wavelengths that a fan of rays is traced at, and between them.
//
// A position in the fan runs from −1 at its shortest wavelength over 0 at the middle node to 1 at the
// longest. Between the nodes a value is the quadratic function through the three.

// Vectors at the three nodes, component by component.
struct Nodes {
    x: vec3f,
    y: vec3f,
    z: vec3f,
}

// The same vector at all nodes.
fn equal_nodes(vector: vec3f) -> Nodes {
    return Nodes(vec3f(vector.x), vec3f(vector.y), vec3f(vector.z));
}

// The vectors at the low, the middle and the high node.
fn nodes_of(low: vec3f, middle: vec3f, high: vec3f) -> Nodes {
    return Nodes(
        vec3f(low.x, middle.x, high.x),
        vec3f(low.y, middle.y, high.y),
        vec3f(low.z, middle.z, high.z),
    );
}

// The vector at the low node.
fn low_node(nodes: Nodes) -> vec3f {
    return vec3f(nodes.x.x, nodes.y.x, nodes.z.x);
}

// The vector at the middle node.
fn middle_node(nodes: Nodes) -> vec3f {
    return vec3f(nodes.x.y, nodes.y.y, nodes.z.y);
}

// The vector at the high node.
fn high_node(nodes: Nodes) -> vec3f {
    return vec3f(nodes.x.z, nodes.y.z, nodes.z.z);
}

// The scalar product of each vector with `vector`.
fn dot_each(nodes: Nodes, vector: vec3f) -> vec3f {
    return nodes.x * vector.x + nodes.y * vector.y + nodes.z * vector.z;
}

// The squared length of each vector.
fn length_squared_each(nodes: Nodes) -> vec3f {
    return nodes.x * nodes.x + nodes.y * nodes.y + nodes.z * nodes.z;
}

// Each vector times its own factor.
fn scale_each(nodes: Nodes, factor: vec3f) -> Nodes {
    return Nodes(nodes.x * factor, nodes.y * factor, nodes.z * factor);
}

// `start` and, times its own factor, `along` at each node.
fn advance_each(start: Nodes, along: Nodes, factor: vec3f) -> Nodes {
    return Nodes(
        start.x + along.x * factor,
        start.y + along.y * factor,
        start.z + along.z * factor,
    );
}

// Each vector and, times its own factor, `vector`.
fn shift_each(nodes: Nodes, vector: vec3f, factor: vec3f) -> Nodes {
    return Nodes(
        nodes.x + factor * vector.x,
        nodes.y + factor * vector.y,
        nodes.z + factor * vector.z,
    );
}

// Each vector brought to length 1; none of them is 0.
fn normalize_each(nodes: Nodes) -> Nodes {
    return scale_each(nodes, inverseSqrt(length_squared_each(nodes)));
}

// How much each node counts at `position`.
fn basis_at(position: f32) -> vec3f {
    let half = 0.5 * position;
    return vec3f(half * (position - 1.0), 1.0 - position * position, half * (position + 1.0));
}

// How much each node counts in the change of a value with the position.
fn slope_basis_at(position: f32) -> vec3f {
    return vec3f(position - 0.5, -2.0 * position, position + 0.5);
}

// What makes the values at three positions of those at the nodes.
fn basis_of(positions: vec3f) -> mat3x3f {
    let half = positions * 0.5;
    return mat3x3f(
        half * (positions - 1.0),
        1.0 - positions * positions,
        half * (positions + 1.0),
    );
}

// The vector that `basis` makes of the nodes.
fn blend(nodes: Nodes, basis: vec3f) -> vec3f {
    return vec3f(dot(nodes.x, basis), dot(nodes.y, basis), dot(nodes.z, basis));
}

// The vectors that `basis` makes of the nodes.
fn blend_nodes(nodes: Nodes, basis: mat3x3f) -> Nodes {
    return Nodes(basis * nodes.x, basis * nodes.y, basis * nodes.z);
}
