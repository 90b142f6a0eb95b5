// What a probe takes its inputs from and puts its outputs to, word by word.

// How many cases there are, and how many words each has.
struct Probing {
    case_count: u32,
    input_len: u32,
    output_len: u32,
}

@group(2) @binding(0) var<storage, read> probing: Probing;
@group(2) @binding(1) var<storage, read> inputs: array<u32>;
// Each case begins with the number of words that were put.
@group(2) @binding(2) var<storage, read_write> outputs: array<u32>;

var<private> case_index: u32;
var<private> taken: u32;
var<private> written: u32;

fn begin_case(index: u32) -> bool {
    case_index = index;
    return index < probing.case_count;
}

fn end_case() {
    outputs[case_index * (1u + probing.output_len)] = written;
}

fn take_u32() -> u32 {
    let word = inputs[case_index * probing.input_len + taken];
    taken++;
    return word;
}

fn take_f32() -> f32 {
    return bitcast<f32>(take_u32());
}

fn take_vec2() -> vec2f {
    let x = take_f32();
    return vec2f(x, take_f32());
}

fn take_vec3() -> vec3f {
    let x = take_f32();
    let y = take_f32();
    return vec3f(x, y, take_f32());
}

fn take_ray() -> Ray {
    var ray: Ray;
    ray.origin = take_vec3();
    ray.lambda_low_nm = take_f32();
    ray.direction = take_vec3();
    ray.lambda_high_nm = take_f32();
    ray.spread = take_vec3();
    ray.significance = take_f32();
    ray.instance = take_u32();
    ray.facet = take_u32();
    ray.medium = take_u32();
    ray.enclosing = take_u32();
    ray.depth = take_u32();
    ray.absorber = take_u32();
    ray.path_mm = take_f32();
    return ray;
}

fn take_hit() -> Hit {
    var hit: Hit;
    hit.distance = take_f32();
    hit.instance = take_u32();
    hit.facet = take_u32();
    hit.normal = take_vec3();
    return hit;
}

fn take_reflectance() -> Reflectance {
    var reflectance: Reflectance;
    reflectance.row = take_u32();
    reflectance.primaries = take_u32();
    reflectance.weights = take_vec3();
    return reflectance;
}

fn take_interface() -> Interface {
    var at: Interface;
    at.normal = take_vec3();
    at.medium_from = take_u32();
    at.medium_to = take_u32();
    return at;
}

fn take_cone() -> Cone {
    var cone: Cone;
    cone.center = take_vec3();
    cone.cos_radius = take_f32();
    cone.sin_squared_radius = take_f32();
    return cone;
}

fn take_nodes() -> Nodes {
    var nodes: Nodes;
    nodes.x = take_vec3();
    nodes.y = take_vec3();
    nodes.z = take_vec3();
    return nodes;
}

fn take_parabola() -> Parabola {
    var parabola: Parabola;
    parabola.a = take_f32();
    parabola.b = take_f32();
    parabola.c = take_f32();
    return parabola;
}

fn take_fan() -> Fan {
    var fan: Fan;
    fan.origin = take_nodes();
    fan.direction = take_nodes();
    fan.weight = take_vec3();
    fan.path_mm = take_vec3();
    fan.axis = take_vec3();
    fan.instance = take_u32();
    fan.facet = take_u32();
    fan.medium = take_u32();
    fan.enclosing = take_u32();
    fan.depth = take_u32();
    fan.absorber = take_u32();
    fan.seed = take_u32();
    return fan;
}

fn put_u32(word: u32) {
    if written < probing.output_len {
        outputs[case_index * (1u + probing.output_len) + 1u + written] = word;
    }
    written++;
}

fn put_bool(value: bool) {
    put_u32(u32(value));
}

fn put_f32(value: f32) {
    put_u32(bitcast<u32>(value));
}

fn put_vec2(v: vec2f) {
    put_f32(v.x);
    put_f32(v.y);
}

fn put_vec3(v: vec3f) {
    put_f32(v.x);
    put_f32(v.y);
    put_f32(v.z);
}

fn put_vec4(v: vec4f) {
    put_vec3(v.xyz);
    put_f32(v.w);
}

fn put_ray(ray: Ray) {
    put_vec3(ray.origin);
    put_f32(ray.lambda_low_nm);
    put_vec3(ray.direction);
    put_f32(ray.lambda_high_nm);
    put_vec3(ray.spread);
    put_f32(ray.significance);
    put_u32(ray.instance);
    put_u32(ray.facet);
    put_u32(ray.medium);
    put_u32(ray.enclosing);
    put_u32(ray.depth);
    put_u32(ray.absorber);
    put_f32(ray.path_mm);
}

fn put_hit(hit: Hit) {
    put_f32(hit.distance);
    put_u32(hit.instance);
    put_u32(hit.facet);
    put_vec3(hit.normal);
}

fn put_interface(at: Interface) {
    put_vec3(at.normal);
    put_u32(at.medium_from);
    put_u32(at.medium_to);
}

fn put_cone(cone: Cone) {
    put_vec3(cone.center);
    put_f32(cone.cos_radius);
    put_f32(cone.sin_squared_radius);
}

fn put_material(material: PackedMaterial) {
    put_u32(material.index_table);
    put_u32(material.absorption);
    put_u32(material.reflectance);
    put_f32(material.least_absorption);
    let print = material.print;
    put_vec3(print.front);
    put_f32(print.front_offset);
    put_vec3(print.tint);
    put_u32(print.primaries);
    put_u32(print.size.x);
    put_u32(print.size.y);
    put_u32(print.outside.x);
    put_u32(print.outside.y);
    put_u32(print.texels);
    put_u32(print.levels);
    put_u32(print.projection);
    put_u32(print.projection_stride);
}

fn put_reflectance(reflectance: Reflectance) {
    put_u32(reflectance.row);
    put_u32(reflectance.primaries);
    put_vec3(reflectance.weights);
}

fn put_nodes(nodes: Nodes) {
    put_vec3(nodes.x);
    put_vec3(nodes.y);
    put_vec3(nodes.z);
}

fn put_parabola(parabola: Parabola) {
    put_f32(parabola.a);
    put_f32(parabola.b);
    put_f32(parabola.c);
}

fn put_fan(fan: Fan) {
    put_nodes(fan.origin);
    put_nodes(fan.direction);
    put_vec3(fan.weight);
    put_vec3(fan.path_mm);
    put_vec3(fan.axis);
    put_u32(fan.instance);
    put_u32(fan.facet);
    put_u32(fan.medium);
    put_u32(fan.enclosing);
    put_u32(fan.depth);
    put_u32(fan.absorber);
    put_u32(fan.seed);
}

// Each case is a walker of its own.
fn begin_walk() {
    walk.walker = case_index;
    walk.seed = take_u32();
    walk.pass_index = take_u32();
    for (var bin = 0u; bin < frame.bin_count; bin++) {
        radiance[case_index * frame.bin_count + bin] = 0.0;
    }
}

// The books, the radiance, and the rays that wait, the last one first.
fn put_walk() {
    put_books();
    put_u32(walk.stack_count);
    while has_rays() {
        put_ray(pop());
    }
}

// The same of a walk with fans.
fn put_fan_walk() {
    put_books();
    put_u32(walk.stack_count);
    while has_rays() {
        put_fan(pop_fan());
    }
}

// Lets the fans that wait for nothing but the lights see them, as the processor does at once.
fn see_lights() {
    let count = walk.stack_count;
    walk.stack_count = 0u;
    for (var i = 0u; i < count; i++) {
        let fan = fans[walk.walker * FAN_STACK_LEN + i];
        if can_only_meet_lights(fan) {
            walk.tally.segments += segment_count(fan);
            walk.tally.depth = max(walk.tally.depth, fan.depth);
            end_at_lights(fan);
        } else {
            push_fan(fan);
        }
    }
}

fn put_books() {
    put_u32(walk.tally.segments);
    put_u32(walk.tally.depth);
    put_f32(walk.tally.returned);
    put_f32(walk.tally.absorbed);
    put_f32(walk.tally.pruned);
    put_f32(walk.tally.cut_off);
    put_f32(walk.tally.lost);
    for (var bin = 0u; bin < frame.bin_count; bin++) {
        put_f32(radiance[case_index * frame.bin_count + bin]);
    }
}
