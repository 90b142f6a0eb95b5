//! Deposits fall into the bins exactly by overlap.

use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::light::{Lights, SkyLight};
use brilliance_renderer::settings::TraceSettings;
use brilliance_renderer::spectrum::{Bins, LAMBDA_MAX_NM, LAMBDA_MIN_NM, Spectrum};
use glam::Vec3;

use crate::scenes::{flat_sky, scene, trace_ray};

/// What a ray of this interval leaves in the bins under an environment.
fn deposited(low_nm: f32, high_nm: f32, bins: u32, sky: SkyLight) -> Vec<f32> {
    let lights = Lights { environment: Some(sky), ..Lights::default() };
    let mut ray = Ray::white(Vec3::ZERO, Vec3::X);
    (ray.lambda_low_nm, ray.lambda_high_nm) = (low_nm, high_nm);
    let settings = TraceSettings { bins, ..TraceSettings::default() };
    trace_ray(&scene(Vec::new(), lights), &settings, &ray).0
}

#[test]
fn an_interval_fills_each_bin_by_their_overlap() {
    let intervals = [
        (380.0, 730.0),
        (400.0, 401.0),
        (401.875, 423.75),
        (500.3, 689.9),
        (720.0, 730.0),
        (380.0, 380.5),
    ];
    for count in [4, 7, 16, 64] {
        for (low_nm, high_nm) in intervals {
            let found = deposited(low_nm, high_nm, count, flat_sky(2.0));
            for (i, value) in found.iter().enumerate() {
                let (from, to) = Bins::new(count).range_nm(i);
                let overlap = (high_nm.min(to) - low_nm.max(from)).max(0.0) / (to - from);
                assert!(
                    (value - 2.0 * overlap).abs() < 1e-4,
                    "{low_nm}–{high_nm}, bin {i} of {count}"
                );
            }
        }
    }
}

#[test]
fn parts_of_an_interval_add_up_to_the_whole() {
    let edges = [LAMBDA_MIN_NM, 391.7, 401.875, 444.4, 611.1, 700.0, LAMBDA_MAX_NM];
    let mut sums = vec![0.0; 16];
    for pair in edges.windows(2) {
        for (sum, part) in sums.iter_mut().zip(deposited(pair[0], pair[1], 16, flat_sky(1.0))) {
            *sum += part;
        }
    }
    for sum in sums {
        assert!((sum - 1.0_f32).abs() < 1e-5, "{sum}");
    }
}

#[test]
fn the_light_of_a_bin_is_the_mean_of_its_spectrum() {
    let spectrum = Spectrum::Tabulated { lambda_nm: vec![380.0, 730.0], value: vec![0.0, 1.0] };
    let found = deposited(380.0, 730.0, 10, SkyLight { radiance: 1.0, spectrum });
    for (i, value) in found.iter().enumerate() {
        assert!((value - (i as f32 + 0.5) / 10.0).abs() < 1e-5, "bin {i}: {value}");
    }
}
