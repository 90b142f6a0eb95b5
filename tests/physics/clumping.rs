//! Fig. 3 of the paper: without perturbed directions the rays behind a prism clump.

use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::light::Lights;
use brilliance_renderer::settings::TraceSettings;
use glam::Vec3;

use crate::scenes::{FLINT, clear, flat_disc, object, prism, scene, trace_ray};

/// Light received from a narrow disc at each of many directions across the prism's spectrum.
fn received(perturb: bool) -> Vec<f64> {
    let settings = TraceSettings { split_count: 0.35, perturb, ..TraceSettings::default() };
    let incidence = 60.0_f32.to_radians();
    let inward = Vec3::new(-1.0, 0.0, 0.0);
    let tilt = 30.0_f32.to_radians();
    let normal = Vec3::new(tilt.cos(), 0.0, tilt.sin());
    let along = Vec3::new(-normal.z, 0.0, normal.x);
    let direction = (-normal * incidence.cos() + along * incidence.sin()).normalize_or_zero();
    assert!(direction.dot(inward) > 0.0);
    let ray = Ray::white(normal * 5.0 - direction * 20.0, direction);
    let (low, high) = (exit_angle(380.0), exit_angle(730.0));
    (0..120)
        .map(|i| {
            let angle = low + (high - low) * (i as f64 + 0.5) / 120.0;
            let towards = Vec3::new(angle.cos() as f32, 0.0, angle.sin() as f32);
            let lights = Lights { discs: vec![flat_disc(towards, 0.06, 1.0)], ..Lights::default() };
            let scene = scene(vec![object(prism(60.0, 5.0), clear(FLINT))], lights);
            let (pixel, _) = trace_ray(&scene, &settings, &ray);
            pixel.iter().map(|&bin| f64::from(bin)).sum()
        })
        .collect()
}

/// Direction, as an angle from +x towards +z, in which light of `lambda_nm` leaves the prism: the
/// textbook formula (Born & Wolf, §4.7.2) for an apex of 60° and 60° of incidence.
fn exit_angle(lambda_nm: f64) -> f64 {
    let n = FLINT.n(lambda_nm);
    let (apex, incidence) = (60.0_f64.to_radians(), 60.0_f64.to_radians());
    let inside = (incidence.sin() / n).asin();
    let exit = (n * (apex - inside).sin()).asin();
    let deviation = incidence + exit - apex;
    // It arrives against the normal of the right face, which stands at 30°, turned by the incidence.
    let arrival = 30.0_f64.to_radians() + std::f64::consts::PI - incidence;
    arrival + deviation
}

/// Standard deviation over mean.
fn variation(values: &[f64]) -> f64 {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let variance = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>();
    (variance / values.len() as f64).sqrt() / mean
}

#[test]
fn exit_directions_clump_only_without_perturb() {
    let (with, without) = (received(true), received(false));
    let dark = |values: &[f64]| values.iter().filter(|&&value| value == 0.0).count();
    assert_eq!(dark(&with[2..118]), 0, "the perturbed spectrum has no gap: {with:?}");
    assert!(dark(&without) > 20, "the unperturbed one has: {without:?}");
    assert!(variation(&with[2..118]) < 0.35, "{}", variation(&with[2..118]));
    assert!(variation(&without) > 2.0 * variation(&with), "{}", variation(&without));
}
