//! The kernel's functions on both sides, module by module.

mod absorption;
mod axis;
mod band;
mod camera;
mod convex;
mod crossing;
mod deposit;
mod diffuse;
mod divide;
mod facet;
mod fan;
mod fan_lights;
mod fan_matte;
mod fan_trace;
mod fan_walk;
mod fork;
mod interface;
mod intersect;
mod lights;
mod mesh;
mod nodes;
mod packed;
mod parabola;
mod passage;
mod print;
mod ray;
mod reach;
mod rng;
mod spread;
mod trace;
mod vector;
mod walk;

use brilliance_renderer::shaders::KERNEL;

/// The probes themselves can fail.
#[test]
fn a_slip_in_a_shader_is_found() {
    let table = spread::table();
    assert_eq!(table.faults(KERNEL), [""; 0]);
    for (from, to) in
        [("2.0 * atan", "2.01 * atan"), ("high - low", "low - high"), ("1u + u32", "u32")]
    {
        let mut slipped = KERNEL.to_vec();
        let module = slipped.iter_mut().find(|module| module.name == "spread").expect("a module");
        let source = module.source.replacen(from, to, 1);
        assert_ne!(source, module.source, "{from}");
        module.source = Box::leak(source.into_boxed_str());
        assert!(!table.faults(&slipped).is_empty(), "{from}");
    }
}
