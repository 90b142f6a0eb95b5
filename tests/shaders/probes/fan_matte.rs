//! Fans that end at matte surfaces.

use brilliance_renderer::kernel::fan_matte::{matte_ray_count, shade_fan};
use brilliance_renderer::kernel::trace::meets_opaque;

use crate::probe::{Case, EXACT, Meeting, Probe, Table, Tolerance, World};

#[test]
fn fan_matte() {
    table().check();
}

pub(super) fn table() -> Table {
    Table {
        worlds: vec![World::full(), World::throwing()],
        probes: vec![
            Probe {
                name: "shade_fan",
                wgsl: "begin_walk();
    shade_fan(take_fan(), take_hit());
    put_fan_walk();",
                rust: |world, take, put| {
                    world.fan_walk(take, put, |walk, take, _| {
                        shade_fan(walk, &take.fan(), &take.hit());
                    });
                },
                cases: |world| {
                    let is_matte = |meeting: &Meeting| meets_opaque(&world.scene, &meeting.hit);
                    let arrivals = world.arrivals(1500).into_iter().filter(is_matte);
                    let case = |(i, Meeting { fan, hit, .. }): (usize, Meeting)| {
                        Case::new().u32(i as u32).u32(i as u32 / 7).fan(&fan).hit(&hit)
                    };
                    arrivals.enumerate().map(case).take(300).collect()
                },
                // Edges of shadows and of squares, where rounding decides.
                tolerance: Tolerance::relative(1e-3).or(1e-3).but(0.03),
            },
            Probe {
                name: "matte_ray_count",
                wgsl: "put_u32(matte_ray_count(take_fan()));",
                rust: |world, take, put| {
                    let fan = take.fan();
                    put.u32(world.begin_fan_walk(0, 0, |walk| matte_ray_count(walk, &fan)));
                },
                cases: |world| {
                    let arrivals = world.arrivals(400).into_iter();
                    arrivals.map(|arrival| Case::new().fan(&arrival.fan)).collect()
                },
                // Where rounding decides.
                tolerance: EXACT.but(0.02),
            },
        ],
    }
}
