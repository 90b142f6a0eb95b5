//! What three wavelengths of fans meet at interfaces.

use brilliance_renderer::kernel::crossing::{
    Crossing, crossing_of, drawn_to_critical, is_misjudged, reflectances,
};
use brilliance_renderer::kernel::fork::interface_at;
use glam::Vec3A;

use super::divide::{CRITICAL, arrivals};
use crate::probe::{Case, EXACT, Probe, Put, ROUNDING, Table, World, throw};

#[test]
fn crossing() {
    table().check();
}

pub(super) fn table() -> Table {
    let probes = [at_nodes(), between_nodes()];
    Table {
        worlds: vec![World::full(), World::curt(), World::single()],
        probes: probes.into_iter().flatten().collect(),
    }
}

fn at_nodes() -> Vec<Probe> {
    vec![
        Probe {
            name: "crossing_of",
            wgsl: "let fan = take_fan();
    let crossing = crossing_of(interface_at(take_ray(), take_hit()), fan);
    put_vec3(crossing.eta);
    put_vec3(crossing.cos_i);
    put_vec3(crossing.cos_t_squared);",
            rust: |world, take, put| {
                let fan = take.fan();
                let at = interface_at(&world.scene, &take.ray(), &take.hit());
                put_crossing(put, &crossing_of(&world.scene, &at, &fan));
            },
            cases: |world| arrivals(world, &Case::new()),
            tolerance: ROUNDING.or(1e-5),
        },
        Probe {
            name: "reflectances",
            wgsl: "put_vec3(reflectances(Crossing(take_vec3(), take_vec3(), take_vec3())));",
            rust: |_, take, put| {
                let (eta, cos_i) = (take.each(), take.each());
                let cos_t_squared = take.each();
                put.each(reflectances(&Crossing { eta, cos_i, cos_t_squared }));
            },
            cases: |_| angles(),
            tolerance: CRITICAL,
        },
    ]
}

fn put_crossing(put: &mut Put, crossing: &Crossing) {
    put.each(crossing.eta);
    put.each(crossing.cos_i);
    put.each(crossing.cos_t_squared);
}

fn between_nodes() -> Vec<Probe> {
    vec![
        Probe {
            name: "is_misjudged",
            wgsl: "let fan = take_fan();
    let at = interface_at(take_ray(), take_hit());
    put_bool(is_misjudged(at, fan, reflectances(crossing_of(at, fan))));",
            rust: |world, take, put| {
                let fan = take.fan();
                let at = interface_at(&world.scene, &take.ray(), &take.hit());
                let reflectance = reflectances(&crossing_of(&world.scene, &at, &fan));
                put.bool(
                    world.begin_fan_walk(0, 0, |walk| is_misjudged(walk, &at, &fan, reflectance)),
                );
            },
            cases: |world| arrivals(world, &Case::new()),
            // Where rounding decides.
            tolerance: EXACT.but(0.02),
        },
        Probe {
            name: "drawn_to_critical",
            wgsl: "let fan = take_fan();
    let crossing = crossing_of(interface_at(take_ray(), take_hit()), fan);
    let drawn = drawn_to_critical(fan, crossing);
    put_fan(drawn.fan);
    put_bool(drawn.is_elsewhere);",
            rust: |world, take, put| {
                let fan = take.fan();
                let at = interface_at(&world.scene, &take.ray(), &take.hit());
                let crossing = crossing_of(&world.scene, &at, &fan);
                let drawn = drawn_to_critical(&world.scene, &fan, &crossing);
                put.fan(&drawn.unwrap_or(fan));
                put.bool(drawn.is_some());
            },
            cases: |world| arrivals(world, &Case::new()),
            tolerance: CRITICAL.but(0.02),
        },
    ]
}

/// Both sides of the critical angle, normal and grazing incidence.
fn angles() -> Vec<Case> {
    throw(800, |dice| {
        let eta = Vec3A::splat(dice.between(0.4, 2.5));
        let any = dice.each(0.0, 1.0);
        let at_critical = (1.0 - (eta.x * eta.x).recip()).max(0.0).sqrt();
        let about = Vec3A::splat(at_critical) + dice.each(-1e-3, 1e-3);
        let cos_i = dice.pick(&[any, any, about, Vec3A::ONE, Vec3A::ZERO, Vec3A::splat(1e-5)]);
        let cos_t_squared = Vec3A::ONE - eta * eta * (Vec3A::ONE - cos_i * cos_i);
        Case::new().each(eta).each(cos_i).each(cos_t_squared)
    })
}
