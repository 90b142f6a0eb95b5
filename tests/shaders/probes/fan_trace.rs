//! The walk with fans, for one of them.

use brilliance_renderer::kernel::fan::Fan;
use brilliance_renderer::kernel::fan_trace::{follow_fan, send_rest};
use brilliance_renderer::kernel::fan_walk::send_fan;

use crate::probe::{Case, Probe, Table, Tolerance, World, see_lights, throw};

#[test]
fn fan_trace() {
    table().check();
}

pub(super) fn table() -> Table {
    Table {
        worlds: vec![
            World::full(),
            World::curt(),
            World::single(),
            World::sliver(),
            World::empty(),
        ],
        probes: vec![
            Probe {
                name: "follow_fan",
                wgsl: "begin_walk();
    send_fan(take_fan());
    if has_rays() {
        follow_fan();
    }
    see_lights();
    put_fan_walk();",
                rust: |world, take, put| {
                    world.fan_walk(take, put, |walk, take, _| {
                        send_fan(walk, take.fan());
                        if walk.has_rays() {
                            follow_fan(walk);
                        }
                        see_lights(walk);
                    });
                },
                cases: |world| {
                    let case = |(i, fan): (usize, Fan)| {
                        Case::new().u32(i as u32).u32(i as u32 / 7).fan(&fan)
                    };
                    world.fans(800).into_iter().enumerate().map(case).collect()
                },
                // Critical angles, edges of lights, shadows and facets: where rounding decides.
                tolerance: Tolerance::relative(2e-3).or(2e-3).but(0.03),
            },
            Probe {
                name: "send_rest",
                wgsl: "begin_walk();
    var fan = take_fan();
    send_rest(&fan, vec2f(take_f32(), take_f32()));
    put_fan(fan);
    put_fan_walk();",
                rust: |world, take, put| {
                    world.fan_walk(take, put, |walk, take, put| {
                        let mut fan = take.fan();
                        send_rest(walk, &mut fan, take.vec2());
                        put.fan(&fan);
                    });
                },
                cases: |_| {
                    throw(400, |dice| {
                        let (low, high) = (dice.between(-1.0, 0.0), dice.between(0.0, 1.0));
                        let narrow = dice.magnitude(1e-6, 1e-2);
                        let low = dice.pick(&[-1.0, low, low, narrow - 1.0]);
                        let high = dice.pick(&[1.0, high, high, 1.0 - narrow]);
                        Case::new().u32(0).u32(0).fan(&dice.fan()).vec2([low, high])
                    })
                },
                tolerance: Tolerance::relative(1e-4).or(1e-5).but(0.01),
            },
        ],
    }
}
