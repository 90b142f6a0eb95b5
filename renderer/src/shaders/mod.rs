//! The tracing kernel in WGSL: each file of [`kernel`](crate::kernel) has its twin here, with the
//! same functions in the same order.
//!
//! What the Rust functions are given as `scene` and `walk` are module-scope variables in WGSL. Its
//! constants are printed from those of Rust, so that each is written once. Tests hold the two sides
//! together: `tests/shaders` compares layouts, names and what the functions give, `tests/parity`
//! whole films.

mod frame;
#[cfg(test)]
pub(crate) mod layout;

use std::f32::consts::{FRAC_1_PI, TAU};
use std::fmt::Write as _;

pub use frame::Frame;

use crate::kernel::mesh::Sides;
use crate::kernel::walk::Fate;
use crate::kernel::{
    band, crossing, divide, facet, fan, fan_lights, fan_matte, fan_trace, fan_walk, interface,
    intersect, mesh, ray, reach, rng, spread, walk,
};
use crate::material::Outside;
use crate::packed;
use crate::spectrum::{LAMBDA_MAX_NM, LAMBDA_MIN_NM};

/// A file of WGSL.
#[derive(Clone, Copy, Debug)]
pub struct ShaderModule {
    /// The name of the file, without its ending.
    pub name: &'static str,
    /// Its text.
    pub source: &'static str,
}

macro_rules! modules {
    ($($name:literal),* $(,)?) => {
        &[$(ShaderModule { name: $name, source: include_str!(concat!($name, ".wgsl")) }),*]
    };
}

/// The kernel; each module uses only what is in those before it.
pub const KERNEL: &[ShaderModule] = modules![
    "vector",
    "packed",
    "ray",
    "rng",
    "camera",
    "spread",
    "interface",
    "mesh",
    "convex",
    "intersect",
    "absorption",
    "walk",
    "deposit",
    "parabola",
    "lights",
    "passage",
    "print",
    "diffuse",
    "fork",
    "trace",
    "nodes",
    "axis",
    "fan",
    "band",
    "fan_walk",
    "facet",
    "reach",
    "fan_lights",
    "fan_matte",
    "crossing",
    "divide",
    "fan_trace",
];

/// What runs the kernel on a graphics device: walkers that follow rays.
pub(crate) const RAY_WALKERS: &[ShaderModule] = modules!["ray_walkers", "walkers"];

/// The same: walkers that follow fans.
pub(crate) const FAN_WALKERS: &[ShaderModule] = modules!["fan_walkers", "walkers"];

/// From the film to CIE XYZ and mean counts.
pub(crate) const EXPOSE: &[ShaderModule] = modules!["finite", "expose"];

/// From the film to the sums of a region.
pub(crate) const REGION: &[ShaderModule] = modules!["finite", "region"];

/// From the film to how bright its pixels are in the mean.
pub(crate) const ROOTS: &[ShaderModule] = modules!["finite", "brightness", "roots"];

/// From the film to its noise.
pub(crate) const NOISE: &[ShaderModule] = modules!["finite", "brightness", "noise"];

/// From CIE XYZ to sRGB codes.
pub(crate) const DEVELOP: &[ShaderModule] =
    modules!["finite", "tone_curve", "gamut", "srgb8", "development"];

/// From mean counts to the sRGB codes of a heat map.
pub(crate) const HEAT: &[ShaderModule] = modules!["heat"];

/// The constants of the kernel, and then `modules`: a whole shader.
pub fn join(modules: &[ShaderModule]) -> String {
    let mut source = kernel_constants();
    append(&mut source, modules);
    source
}

/// Adds `modules` to the text of a shader.
pub(crate) fn append(source: &mut String, modules: &[ShaderModule]) {
    for module in modules {
        source.push('\n');
        source.push_str(module.source);
    }
}

/// A constant as WGSL spells it.
pub(crate) enum Constant {
    U32(u32),
    F32(f32),
    Vec2U([u32; 2]),
}

/// Constants of Rust for a shader to begin with.
pub(crate) fn print<const N: usize>(constants: [(&str, Constant); N]) -> String {
    let mut source = String::new();
    for (name, constant) in constants {
        let written = match constant {
            Constant::U32(value) => writeln!(source, "const {name} = {value}u;"),
            Constant::F32(value) => writeln!(source, "const {name} = {value:?}f;"),
            Constant::Vec2U([x, y]) => writeln!(source, "const {name} = vec2u({x}u, {y}u);"),
        };
        written.expect("a string takes all that is written to it");
    }
    source
}

fn kernel_constants() -> String {
    use Constant::{F32, U32, Vec2U};
    print([
        ("NONE", U32(packed::NONE)),
        ("CONVEX", U32(packed::CONVEX)),
        ("INDEX_TABLE_LEN", U32(packed::INDEX_TABLE_LEN as u32)),
        ("AXIS_LEN", U32(packed::AXIS_LEN as u32)),
        ("LAMBDA_MIN_NM", F32(LAMBDA_MIN_NM)),
        ("LAMBDA_MAX_NM", F32(LAMBDA_MAX_NM)),
        ("SMALLEST_SQUARE", F32(f32::MIN_POSITIVE)),
        ("FRAC_1_PI", F32(FRAC_1_PI)),
        ("TAU", F32(TAU)),
        ("FAR", F32(ray::FAR)),
        ("GROUND", U32(ray::GROUND)),
        ("TOUCHING_MM", F32(ray::TOUCHING_MM)),
        ("LIGHT_STEPS", Vec2U(rng::LIGHT_STEPS)),
        ("WAVELENGTH_STEP", U32(rng::WAVELENGTH_STEP)),
        ("MIDDLE", U32(rng::MIDDLE)),
        ("MAX_SUBRAYS", U32(spread::MAX_SUBRAYS)),
        ("BISECTIONS", U32(interface::BISECTIONS)),
        ("NODE_STACK", U32(mesh::NODE_STACK as u32)),
        ("SLAB_ROUNDING", F32(mesh::SLAB_ROUNDING)),
        ("PARALLEL", F32(mesh::PARALLEL)),
        ("SIDES_FRONT", U32(Sides::Front as u32)),
        ("SIDES_BACK", U32(Sides::Back as u32)),
        ("SIDES_BOTH", U32(Sides::Both as u32)),
        ("TOP_STACK", U32(intersect::TOP_STACK as u32)),
        ("NUDGE", F32(intersect::NUDGE)),
        ("OUTSIDE_BARE", U32(Outside::Bare as u32)),
        ("OUTSIDE_REPEAT", U32(Outside::Repeat as u32)),
        ("OUTSIDE_MIRROR", U32(Outside::Mirror as u32)),
        ("STACK_LEN", U32(walk::STACK_LEN as u32)),
        ("FATE_KEPT", U32(Fate::Kept as u32)),
        ("FATE_TOO_WEAK", U32(Fate::TooWeak as u32)),
        ("FATE_TOO_DEEP", U32(Fate::TooDeep as u32)),
        ("FATE_TOO_MANY", U32(Fate::TooMany as u32)),
        ("FAN_STACK_LEN", U32(fan_walk::FAN_STACK_LEN as u32)),
        ("FACET_TOLERANCE_MM", F32(facet::FACET_TOLERANCE_MM)),
        ("LEAST_SCALE", F32(facet::LEAST_SCALE)),
        ("REACH_BISECTIONS", U32(reach::REACH_BISECTIONS)),
        ("GRAZING", F32(reach::GRAZING)),
        ("DRIFT_MM", F32(reach::DRIFT_MM)),
        ("LEEWAY", F32(fan_lights::LEEWAY)),
        ("FAR_OFF_MARGIN", F32(fan_lights::FAR_OFF_MARGIN)),
        ("APPROACH_STEPS", U32(fan_lights::APPROACH_STEPS)),
        ("EDGE_STEPS", U32(fan_lights::EDGE_STEPS)),
        ("EDGE_FOUND", F32(fan_lights::EDGE_FOUND)),
        ("WEIGHT_TOLERANCE", F32(fan_matte::WEIGHT_TOLERANCE)),
        ("GAUSS_POINT", F32(band::GAUSS_POINT)),
        ("STRAIGHT", F32(band::STRAIGHT)),
        ("NARROW", F32(divide::NARROW)),
        ("DIRECTION_TOLERANCE", F32(divide::DIRECTION_TOLERANCE)),
        ("INNER_TOLERANCE", F32(divide::INNER_TOLERANCE)),
        ("LEAST_INNER_TOLERANCE", F32(divide::LEAST_INNER_TOLERANCE)),
        ("DRAWING_CONTRAST", F32(crossing::DRAWING_CONTRAST)),
        ("FIRST_GRACE", F32(fan_walk::FIRST_GRACE)),
        ("LEAST_KEPT", F32(fan_walk::LEAST_KEPT)),
        ("LEAST_MISJUDGED", F32(crossing::LEAST_MISJUDGED)),
        ("LEAF_SHARE", F32(divide::LEAF_SHARE)),
        ("NEXT_PART", U32(fan::NEXT_PART)),
        ("REST_SHARE", F32(fan_trace::REST_SHARE)),
    ])
}
