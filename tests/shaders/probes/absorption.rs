//! Bins and transmittances.

use brilliance_renderer::kernel::absorption::{
    BinRange, bin_overlap, bin_range, mean_transmittance, transmittance, transmittance_bound,
};
use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::packed::NONE;

use crate::probe::{Case, Dice, Probe, ROUNDING, Table, Tolerance, World, throw};

#[test]
fn absorption() {
    table().check();
}

/// WGSL lets e^x be off by 3 + 2|x| ulp.
const EXPONENTIAL: Tolerance = Tolerance::relative(1e-5).or(1e-9);

pub(super) fn table() -> Table {
    Table {
        worlds: vec![World::full()],
        probes: vec![
            Probe {
                name: "bin_range",
                wgsl: "let range = bin_range(take_f32(), take_f32());
    put_f32(range.low);
    put_f32(range.high);
    put_u32(range.first);
    put_u32(range.last);",
                rust: |world, take, put| {
                    let BinRange { low, high, first, last } =
                        bin_range(&world.scene, take.f32(), take.f32());
                    put.f32(low);
                    put.f32(high);
                    put.u32(first);
                    put.u32(last);
                },
                cases: |_| {
                    throw(800, |dice| {
                        let [low_nm, high_nm] = dice.interval_nm();
                        Case::new().f32(low_nm).f32(high_nm)
                    })
                },
                tolerance: ROUNDING,
            },
            Probe {
                name: "bin_overlap",
                wgsl: "let range = bin_range(take_f32(), take_f32());
    for (var bin = 0u; bin < frame.bin_count; bin++) {
        put_f32(bin_overlap(range, bin));
    }",
                rust: |world, take, put| {
                    let range = bin_range(&world.scene, take.f32(), take.f32());
                    for bin in 0..world.scene.bins.count() as u32 {
                        put.f32(bin_overlap(&range, bin));
                    }
                },
                cases: intervals_at_edges,
                tolerance: ROUNDING.or(2e-6),
            },
            Probe {
                name: "transmittance",
                wgsl: "put_f32(transmittance(take_ray(), take_u32()));",
                rust: |world, take, put| {
                    put.f32(transmittance(&world.scene, &take.ray(), take.u32()));
                },
                cases: |world| {
                    throw(400, |dice| {
                        let absorber = dice.pick(&world.absorbers());
                        let bin = dice.below(world.scene.bins.count());
                        Case::new().ray(&absorbed_ray(dice, absorber)).u32(bin as u32)
                    })
                },
                tolerance: EXPONENTIAL,
            },
            Probe {
                name: "mean_transmittance",
                wgsl: "put_f32(mean_transmittance(take_ray()));",
                rust: |world, take, put| {
                    put.f32(mean_transmittance(&world.scene, &take.ray()));
                },
                cases: absorbed_rays,
                tolerance: EXPONENTIAL,
            },
            Probe {
                name: "transmittance_bound",
                wgsl: "put_f32(transmittance_bound(take_ray()));",
                rust: |world, take, put| {
                    put.f32(transmittance_bound(&world.scene, &take.ray()));
                },
                cases: absorbed_rays,
                tolerance: EXPONENTIAL,
            },
        ],
    }
}

/// Intervals that begin and end anywhere or on the edge of a bin, and some without width.
fn intervals_at_edges(world: &World) -> Vec<Case> {
    let bins = world.scene.bins;
    throw(800, |dice| {
        let [low_nm, high_nm] = dice.interval_nm();
        let (edge_nm, _) = bins.range_nm(dice.below(bins.count()));
        let low_nm = dice.pick(&[low_nm, edge_nm]);
        let high_nm = dice.pick(&[high_nm, low_nm, edge_nm]).max(low_nm);
        Case::new().f32(low_nm).f32(high_nm)
    })
}

/// A ray with a path of up to 100 mm, or none, behind it in `absorber`.
fn absorbed_ray(dice: &mut Dice, absorber: u32) -> Ray {
    let path_mm = dice.magnitude(1e-4, 100.0);
    Ray { absorber, path_mm: dice.pick(&[0.0, path_mm, path_mm]), ..dice.ray() }
}

fn absorbed_rays(world: &World) -> Vec<Case> {
    throw(600, |dice| {
        let absorber = dice.pick(&world.absorbers());
        let absorber = dice.pick(&[absorber, absorber, NONE]);
        let ray = absorbed_ray(dice, absorber);
        // Of intervals too narrow to be weighed by their overlaps only none at all are sure.
        let is_narrow = ray.lambda_high_nm - ray.lambda_low_nm < 0.5;
        let lambda_high_nm = if is_narrow { ray.lambda_low_nm } else { ray.lambda_high_nm };
        Case::new().ray(&Ray { lambda_high_nm, ..ray })
    })
}
