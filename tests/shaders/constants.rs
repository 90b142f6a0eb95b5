//! What both sides name has the same value.

use std::collections::BTreeMap;
use std::f32::consts::{FRAC_1_PI, TAU};

use brilliance_renderer::kernel::mesh::Sides;
use brilliance_renderer::kernel::walk::Fate;
use brilliance_renderer::kernel::{
    band, crossing, divide, facet, fan, fan_lights, fan_matte, fan_trace, fan_walk, interface,
    intersect, mesh, ray, reach, rng, spread, walk,
};
use brilliance_renderer::material::Outside;
use brilliance_renderer::packed;
use brilliance_renderer::shaders::join;
use brilliance_renderer::spectrum::{LAMBDA_MAX_NM, LAMBDA_MIN_NM};
use wgpu::naga::{Expression, Handle, Literal, Module};

use crate::wgsl::parse;

/// A constant as both sides know it.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Constant {
    U32(u32),
    F32(f32),
    Vec2U([u32; 2]),
}

fn rust_constants() -> Vec<(&'static str, Constant)> {
    use Constant::{F32, U32, Vec2U};
    vec![
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
    ]
}

/// The value of a constant expression; its bits count.
fn value(module: &Module, handle: Handle<Expression>) -> Constant {
    match &module.global_expressions[handle] {
        Expression::Literal(Literal::U32(value)) => Constant::U32(*value),
        Expression::Literal(Literal::F32(value)) => Constant::F32(*value),
        Expression::Compose { components, .. } => {
            let component = |handle: &Handle<Expression>| value(module, *handle);
            match components.iter().map(component).collect::<Vec<_>>()[..] {
                [Constant::U32(x), Constant::U32(y)] => Constant::Vec2U([x, y]),
                ref other => panic!("{other:?} is not looked for"),
            }
        }
        other => panic!("{other:?} is not looked for"),
    }
}

#[test]
fn constants_are_printed_with_all_their_digits_and_none_is_missing() {
    let module = parse(&join(&[]));
    let printed: BTreeMap<_, _> = module
        .constants
        .iter()
        .map(|(_, constant)| {
            (constant.name.as_deref().unwrap_or(""), value(&module, constant.init))
        })
        .collect();
    let expected: BTreeMap<_, _> = rust_constants().into_iter().collect();
    assert_eq!(printed, expected);
}
