//! Deposits on the bins.

use brilliance_renderer::kernel::deposit::deposit;
use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::packed::NONE;

use crate::probe::{Case, Probe, Table, Tolerance, World, throw};

#[test]
fn deposits() {
    table().check();
}

/// A bin's overlap is a difference of numbers up to the number of bins.
const RADIANCE: Tolerance = Tolerance::relative(1e-5).or(1e-5);

pub(super) fn table() -> Table {
    Table {
        worlds: vec![World::full()],
        probes: vec![Probe {
            name: "deposit",
            wgsl: "begin_walk();
    deposit(take_ray(), take_u32(), take_u32(), take_f32());
    deposit(take_ray(), take_u32(), take_u32(), take_f32());
    put_walk();",
            rust: |world, take, put| {
                world.walk(take, put, |walk, take, _| {
                    for _ in 0..2 {
                        let (ray, radiance) = (take.ray(), take.u32());
                        deposit(walk, &ray, radiance, take.u32(), take.f32());
                    }
                });
            },
            cases: deposits_in_twos,
            tolerance: RADIANCE,
        }],
    }
}

fn deposits_in_twos(world: &World) -> Vec<Case> {
    let rows = world.scene.spectra.len() / world.scene.bins.count();
    throw(600, |dice| {
        let mut case = Case::new().u32(0).u32(0);
        for _ in 0..2 {
            let absorber = dice.pick(&world.absorbers());
            let absorber = dice.pick(&[NONE, absorber]);
            let ray = Ray { absorber, path_mm: dice.magnitude(1e-3, 20.0), ..dice.ray() };
            let [radiance, reflectance] = [0; 2].map(|_| dice.below(rows) as u32);
            case = case
                .ray(&ray)
                .u32(radiance)
                .u32(dice.pick(&[NONE, reflectance]))
                .f32(dice.between(0.0, 2.0));
        }
        case
    })
}
