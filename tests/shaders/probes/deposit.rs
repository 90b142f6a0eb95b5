//! Deposits on the bins.

use brilliance_renderer::kernel::deposit::{Reflectance, deposit, print_value};
use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::packed::NONE;

use crate::probe::{Case, Dice, Probe, Table, Tolerance, World, throw};

#[test]
fn deposits() {
    table().check();
}

/// A bin's overlap is a difference of numbers up to the number of bins.
const RADIANCE: Tolerance = Tolerance::relative(1e-5).or(1e-5);

pub(super) fn table() -> Table {
    Table {
        worlds: vec![World::full()],
        probes: vec![
            Probe {
                name: "print_value",
                wgsl: "put_f32(print_value(take_reflectance(), take_u32()));",
                rust: |world, take, put| {
                    let reflectance = take.reflectance();
                    put.f32(print_value(&world.scene, &reflectance, take.u32()));
                },
                cases: |world| {
                    let bins = world.scene.bins.count();
                    let rows = world.rows();
                    throw(200, |dice| {
                        let printed = Reflectance {
                            primaries: dice.below(rows - 2) as u32,
                            ..reflectance(dice, rows)
                        };
                        Case::new().reflectance(&printed).u32(dice.below(bins) as u32)
                    })
                },
                tolerance: RADIANCE,
            },
            Probe {
                name: "deposit",
                wgsl: "begin_walk();
    deposit(take_ray(), take_u32(), take_reflectance(), take_f32());
    deposit(take_ray(), take_u32(), take_reflectance(), take_f32());
    put_walk();",
                rust: |world, take, put| {
                    world.walk(take, put, |walk, take, _| {
                        for _ in 0..2 {
                            let (ray, radiance) = (take.ray(), take.u32());
                            deposit(walk, &ray, radiance, &take.reflectance(), take.f32());
                        }
                    });
                },
                cases: deposits_in_twos,
                tolerance: RADIANCE,
            },
        ],
    }
}

/// Of any of the rows, or of none.
fn reflectance(dice: &mut Dice, rows: usize) -> Reflectance {
    let (row, primaries) = (dice.below(rows) as u32, dice.below(rows - 2) as u32);
    Reflectance {
        row: dice.pick(&[NONE, row]),
        primaries: dice.pick(&[NONE, primaries]),
        weights: dice.point(0.5) + 0.5,
    }
}

fn deposits_in_twos(world: &World) -> Vec<Case> {
    let rows = world.rows();
    throw(600, |dice| {
        let mut case = Case::new().u32(0).u32(0);
        for _ in 0..2 {
            let absorber = dice.pick(&world.absorbers());
            let absorber = dice.pick(&[NONE, absorber]);
            let ray = Ray { absorber, path_mm: dice.magnitude(1e-3, 20.0), ..dice.ray() };
            let radiance = dice.below(rows) as u32;
            let reflectance = reflectance(dice, rows);
            case =
                case.ray(&ray).u32(radiance).reflectance(&reflectance).f32(dice.between(0.0, 2.0));
        }
        case
    })
}
