//! Rays that should not be: nothing hangs, nothing turns into NaN.

use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::settings::TraceSettings;
use glam::Vec3;

use crate::scenes::{flat_disc, furnace, trace_ray};

const POISON: [f32; 9] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    f32::NAN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::MIN_POSITIVE / 8.0,
    1e30,
];

#[test]
fn poisoned_origins_and_directions_leave_finite_pixels() {
    let mut scene = furnace();
    scene.lights.discs = vec![flat_disc(Vec3::new(0.1, 0.2, 0.9), 0.3, 10.0)];
    let settings = TraceSettings { max_depth: 16, ..TraceSettings::default() };
    for a in POISON {
        for b in POISON {
            for (origin, direction) in [
                (Vec3::new(a, b, 5.0), Vec3::NEG_Z),
                (Vec3::new(0.3, 0.1, 5.0), Vec3::new(a, b, -1.0)),
                (Vec3::new(a, 0.0, 9.0), Vec3::new(0.0, b, -1.0)),
                (Vec3::new(0.1, 0.2, a), Vec3::new(0.0, 0.0, b)),
            ] {
                let (pixel, _) = trace_ray(&scene, &settings, &Ray::white(origin, direction));
                assert!(pixel.iter().all(|bin| bin.is_finite()), "{origin} {direction}: {pixel:?}");
            }
        }
    }
}

#[test]
fn grazing_and_axis_parallel_rays_are_accounted_for() {
    let scene = furnace();
    let settings = TraceSettings::default();
    for i in 0..400 {
        // Along the girdle, the table and through the symmetry planes.
        let offset = 4.0 * (i as f32 / 200.0 - 1.0);
        for (origin, direction) in [
            (Vec3::new(-9.0, offset, 0.0), Vec3::X),
            (Vec3::new(offset, 0.0, 9.0), Vec3::NEG_Z),
            (Vec3::new(-9.0, 0.0, offset), Vec3::X),
        ] {
            let (pixel, tally) = trace_ray(&scene, &settings, &Ray::white(origin, direction));
            let kept = 1.0 - tally.pruned - tally.cut_off;
            assert_eq!(tally.lost, 0.0);
            for bin in &pixel {
                assert!(bin.is_finite() && *bin <= 1.001, "{origin} {direction} {bin}");
            }
            let mean = pixel.iter().sum::<f32>() / pixel.len() as f32;
            assert!((mean - kept).abs() < 1e-3, "{origin} {direction}: {mean} {kept}");
        }
    }
}
