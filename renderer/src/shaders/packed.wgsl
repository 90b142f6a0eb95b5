// What the tracers read: the scene as plain arrays, and what a dispatch is told beside it.

struct BvhNode {
    min: vec3f,
    primitive_count: u32,
    max: vec3f,
    first: u32,
}

struct PackedTriangle {
    a: vec3f,
    facet: u32,
    b: vec3f,
    normal_x: f32,
    c: vec3f,
    normal_y: f32,
    normal_z: f32,
}

struct Instance {
    object_from_world: array<vec4f, 3>,
    kind: u32,
    first: u32,
    count: u32,
    material: u32,
    center: vec3f,
    interior_is_clear: u32,
}

struct PackedPrint {
    front: vec3f,
    front_offset: f32,
    tint: vec3f,
    primaries: u32,
    size: vec2u,
    outside: vec2u,
    texels: u32,
    levels: u32,
    projection: u32,
    projection_stride: u32,
}

struct PackedMaterial {
    index_table: u32,
    absorption: u32,
    reflectance: u32,
    least_absorption: f32,
    print: PackedPrint,
}

struct PackedDisc {
    direction: vec3f,
    cos_radius: f32,
    sin_squared_radius: f32,
    solid_angle: f32,
    spectrum: u32,
    first_passage: u32,
    passage_count: u32,
}

struct PackedPassage {
    center_out: vec3f,
    radius_out: f32,
    direction: vec3f,
    cos_bound: f32,
    normal_in: vec3f,
    sin_bound: f32,
    normal_out: vec3f,
    instance: u32,
    center_in: vec3f,
    radius_in: f32,
    facet_in: u32,
    facet_out: u32,
}

struct PackedGround {
    height: f32,
    square: f32,
    reflectance: vec2u,
}

struct PackedSky {
    hemisphere: u32,
    environment: u32,
    backdrop: u32,
    light_spread: f32,
    cos_observer_shadow: f32,
    sin_squared_observer_shadow: f32,
    padding: vec2u,
}

struct TraceRules {
    observer: vec3f,
    split_count: f32,
    significance_threshold: f32,
    max_depth: u32,
    perturb: u32,
    cut_threshold: f32,
}

// One dispatch: the camera, the rules, the lights without a place, and the work to be done.
struct Frame {
    position: vec3f,
    width: u32,
    forward: vec3f,
    height: u32,
    right: vec3f,
    first_row: u32,
    up: vec3f,
    pixel_count: u32,
    rules: TraceRules,
    sky: PackedSky,
    ground: PackedGround,
    first_pass: u32,
    item_count: u32,
    budget: u32,
    bin_count: u32,
    bin_width_nm: f32,
    disc_count: u32,
    top_node_count: u32,
    first_walker: u32,
    instance_count: u32,
    axis: u32,
    padding: vec2u,
}

@group(0) @binding(0) var<storage, read> instances: array<Instance>;
@group(0) @binding(1) var<storage, read> top_nodes: array<BvhNode>;
@group(0) @binding(2) var<storage, read> words: array<u32>;
@group(0) @binding(3) var<storage, read> planes: array<f32>;
@group(0) @binding(4) var<storage, read> nodes: array<BvhNode>;
@group(0) @binding(5) var<storage, read> triangles: array<PackedTriangle>;
@group(0) @binding(6) var<storage, read> materials: array<PackedMaterial>;
@group(0) @binding(7) var<storage, read> spectra: array<f32>;
@group(0) @binding(8) var<storage, read> discs: array<PackedDisc>;
@group(0) @binding(9) var<storage, read> passages: array<PackedPassage>;
// No uniform: Mesa's software device compiles a kernel anew for each content of one.
@group(1) @binding(0) var<storage, read> frame: Frame;

// The outward unit normal.
fn normal(triangle: PackedTriangle) -> vec3f {
    return vec3f(triangle.normal_x, triangle.normal_y, triangle.normal_z);
}

// Whether no light enters the material.
fn is_opaque(material: PackedMaterial) -> bool {
    return material.index_table == NONE;
}

// The material of a body.
fn material_of(instance: u32) -> PackedMaterial {
    return materials[instances[instance].material];
}

// One row of a projection: the four numbers from a word on.
fn projection_row(first: u32) -> vec4f {
    return bitcast<vec4f>(
        vec4u(words[first], words[first + 1u], words[first + 2u], words[first + 3u]),
    );
}

// The mean of row `row` over `bin`.
fn spectrum_value(row: u32, bin: u32) -> f32 {
    return spectra[row * frame.bin_count + bin];
}
