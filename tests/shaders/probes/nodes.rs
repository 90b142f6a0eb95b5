//! Values at the nodes of a fan and between them.

use brilliance_renderer::kernel::nodes::{
    advance_each, basis_at, basis_of, blend, blend_nodes, dot_each, equal_nodes, high_node,
    length_squared_each, low_node, middle_node, nodes_of, normalize_each, scale_each, shift_each,
    slope_basis_at,
};
use glam::Vec3A;

use crate::probe::{Case, EXACT, Probe, ROUNDING, Table, World, throw};

#[test]
fn nodes() {
    table().check();
}

/// Sums of three products of up to 10.
const REACH: f32 = 3.0;

pub(super) fn table() -> Table {
    let probes = [vectors(), arithmetic(), between()];
    Table { worlds: vec![World::empty()], probes: probes.into_iter().flatten().collect() }
}

fn vectors() -> Vec<Probe> {
    vec![
        Probe {
            name: "equal_nodes",
            wgsl: "put_nodes(equal_nodes(take_vec3()));",
            rust: |_, take, put| put.nodes(&equal_nodes(take.vec3())),
            cases: |_| throw(100, |dice| Case::new().vec3(dice.point(REACH))),
            tolerance: EXACT,
        },
        Probe {
            name: "nodes_of",
            wgsl: "put_nodes(nodes_of(take_vec3(), take_vec3(), take_vec3()));",
            rust: |_, take, put| put.nodes(&nodes_of(take.vec3(), take.vec3(), take.vec3())),
            cases: |_| throw(100, |dice| Case::new().nodes(&dice.nodes(REACH))),
            tolerance: EXACT,
        },
        Probe {
            name: "low_node",
            wgsl: "put_vec3(low_node(take_nodes()));",
            rust: |_, take, put| put.vec3(low_node(&take.nodes())),
            cases: |_| throw(100, |dice| Case::new().nodes(&dice.nodes(REACH))),
            tolerance: EXACT,
        },
        Probe {
            name: "middle_node",
            wgsl: "put_vec3(middle_node(take_nodes()));",
            rust: |_, take, put| put.vec3(middle_node(&take.nodes())),
            cases: |_| throw(100, |dice| Case::new().nodes(&dice.nodes(REACH))),
            tolerance: EXACT,
        },
        Probe {
            name: "high_node",
            wgsl: "put_vec3(high_node(take_nodes()));",
            rust: |_, take, put| put.vec3(high_node(&take.nodes())),
            cases: |_| throw(100, |dice| Case::new().nodes(&dice.nodes(REACH))),
            tolerance: EXACT,
        },
    ]
}

fn arithmetic() -> Vec<Probe> {
    vec![
        Probe {
            name: "dot_each",
            wgsl: "put_vec3(dot_each(take_nodes(), take_vec3()));",
            rust: |_, take, put| put.each(dot_each(&take.nodes(), take.vec3())),
            cases: |_| {
                throw(200, |dice| Case::new().nodes(&dice.nodes(REACH)).vec3(dice.point(REACH)))
            },
            tolerance: ROUNDING.or(1e-5),
        },
        Probe {
            name: "length_squared_each",
            wgsl: "put_vec3(length_squared_each(take_nodes()));",
            rust: |_, take, put| put.each(length_squared_each(&take.nodes())),
            cases: |_| throw(200, |dice| Case::new().nodes(&dice.nodes(REACH))),
            tolerance: ROUNDING,
        },
        Probe {
            name: "scale_each",
            wgsl: "put_nodes(scale_each(take_nodes(), take_vec3()));",
            rust: |_, take, put| put.nodes(&scale_each(&take.nodes(), take.each())),
            cases: |_| {
                throw(200, |dice| Case::new().nodes(&dice.nodes(REACH)).each(dice.each(-2.0, 2.0)))
            },
            tolerance: ROUNDING,
        },
        Probe {
            name: "advance_each",
            wgsl: "put_nodes(advance_each(take_nodes(), take_nodes(), take_vec3()));",
            rust: |_, take, put| {
                let (start, along) = (take.nodes(), take.nodes());
                put.nodes(&advance_each(&start, &along, take.each()));
            },
            cases: |_| {
                throw(200, |dice| {
                    let (start, along) = (dice.nodes(REACH), dice.nodes(REACH));
                    Case::new().nodes(&start).nodes(&along).each(dice.each(-2.0, 2.0))
                })
            },
            tolerance: ROUNDING.or(1e-5),
        },
        Probe {
            name: "shift_each",
            wgsl: "put_nodes(shift_each(take_nodes(), take_vec3(), take_vec3()));",
            rust: |_, take, put| {
                put.nodes(&shift_each(&take.nodes(), take.vec3(), take.each()));
            },
            cases: |_| {
                throw(200, |dice| {
                    let case = Case::new().nodes(&dice.nodes(REACH)).vec3(dice.point(REACH));
                    case.each(dice.each(-2.0, 2.0))
                })
            },
            tolerance: ROUNDING.or(1e-5),
        },
        Probe {
            name: "normalize_each",
            wgsl: "put_nodes(normalize_each(take_nodes()));",
            rust: |_, take, put| put.nodes(&normalize_each(&take.nodes())),
            cases: |_| {
                throw(200, |dice| {
                    let length = Vec3A::splat(dice.magnitude(1e-3, 1e3));
                    let [low, middle, high] =
                        [dice.direction(), dice.direction(), dice.direction()];
                    Case::new().nodes(&scale_each(&nodes_of(low, middle, high), length))
                })
            },
            tolerance: ROUNDING,
        },
    ]
}

fn between() -> Vec<Probe> {
    vec![
        Probe {
            name: "basis_at",
            wgsl: "put_vec3(basis_at(take_f32()));",
            rust: |_, take, put| put.each(basis_at(take.f32())),
            cases: |_| throw(200, |dice| Case::new().f32(dice.position())),
            tolerance: ROUNDING,
        },
        Probe {
            name: "slope_basis_at",
            wgsl: "put_vec3(slope_basis_at(take_f32()));",
            rust: |_, take, put| put.each(slope_basis_at(take.f32())),
            cases: |_| throw(200, |dice| Case::new().f32(dice.position())),
            tolerance: ROUNDING,
        },
        Probe {
            name: "basis_of",
            wgsl: "put_vec3(basis_of(take_vec3()) * take_vec3());",
            rust: |_, take, put| put.each(basis_of(take.each()) * take.each()),
            cases: |_| {
                throw(200, |dice| {
                    Case::new().each(dice.each(-1.0, 1.0)).each(dice.each(-REACH, REACH))
                })
            },
            tolerance: ROUNDING.or(1e-5),
        },
        Probe {
            name: "blend",
            wgsl: "put_vec3(blend(take_nodes(), take_vec3()));",
            rust: |_, take, put| put.vec3(blend(&take.nodes(), take.each())),
            cases: |_| {
                throw(200, |dice| {
                    Case::new().nodes(&dice.nodes(REACH)).each(basis_at(dice.position()))
                })
            },
            tolerance: ROUNDING.or(1e-5),
        },
        Probe {
            name: "blend_nodes",
            wgsl: "let nodes = take_nodes();
    put_nodes(blend_nodes(nodes, basis_of(take_vec3())));",
            rust: |_, take, put| {
                let nodes = take.nodes();
                put.nodes(&blend_nodes(&nodes, basis_of(take.each())));
            },
            cases: |_| {
                throw(200, |dice| Case::new().nodes(&dice.nodes(REACH)).each(dice.each(-1.0, 1.0)))
            },
            tolerance: ROUNDING.or(1e-5),
        },
    ]
}
