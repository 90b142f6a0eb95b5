//! Snell, Fresnel and total reflection at one interface.

use brilliance_renderer::kernel::interface::{
    Interface, cos_refracted_squared, find_total_refl_wave, fresnel, is_totally_reflected, reflect,
    refract, relative_index,
};
use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::light::Lights;
use brilliance_renderer::packed::{NONE, PackedScene};
use brilliance_renderer::spectrum::Bins;
use glam::Vec3;

use crate::scenes::{DIAMOND, brilliant, scene};

/// Reflectance at `angle` radians of incidence from index `n1` to `n2`.
fn reflectance(angle: f32, n1: f32, n2: f32) -> f32 {
    let eta = n1 / n2;
    let cos_t = cos_refracted_squared(angle.cos(), eta).max(0.0).sqrt();
    fresnel(angle.cos(), cos_t, eta)
}

fn direction(angle: f32) -> Vec3 {
    Vec3::new(angle.sin(), 0.0, -angle.cos())
}

#[test]
fn normal_incidence_on_glass_reflects_four_percent() {
    assert!((reflectance(0.0, 1.0, 1.5) - 0.04).abs() < 1e-6);
    // Diamond: ((2.417 − 1)/(2.417 + 1))² = 17.2 %.
    assert!((reflectance(0.0, 1.0, 2.417) - 0.17197).abs() < 1e-5);
    assert!((reflectance(0.0, 2.417, 1.0) - 0.17197).abs() < 1e-5);
}

#[test]
fn at_brewsters_angle_only_perpendicular_light_is_reflected() {
    // tan θ_B = n: 56.31° for 1.5; there R = R⊥/2 with R⊥ = ((n² − 1)/(n² + 1))² (Born & Wolf, §1.5.3).
    let brewster = 1.5_f32.atan();
    assert!((brewster.to_degrees() - 56.31).abs() < 0.005);
    let perpendicular = ((2.25_f32 - 1.0) / (2.25 + 1.0)).powi(2);
    assert!((reflectance(brewster, 1.0, 1.5) - 0.5 * perpendicular).abs() < 1e-6);
}

#[test]
fn reflectance_matches_the_trigonometric_fresnel_formulae() {
    // R = ½[sin²(i−t)/sin²(i+t) + tan²(i−t)/tan²(i+t)] (Born & Wolf, eqs. 1.5.21a).
    for n in [1.333_f64, 1.544, 2.417, 2.9] {
        for degrees in (1..90).step_by(4) {
            let i = f64::from(degrees).to_radians();
            let t = (i.sin() / n).asin();
            let expected = 0.5
                * (((i - t).sin() / (i + t).sin()).powi(2)
                    + ((i - t).tan() / (i + t).tan()).powi(2));
            let found = f64::from(reflectance(i as f32, 1.0, n as f32));
            assert!((found - expected).abs() < 2e-5, "n {n}, {degrees}°: {found} {expected}");
        }
    }
}

#[test]
fn reflectance_is_one_at_grazing_and_at_the_critical_angle() {
    assert!(reflectance(89.999_f32.to_radians(), 1.0, 2.417) > 0.999);
    let critical = (1.0_f32 / 2.417).asin();
    // Diamond's critical angle is 24.4° (Webster, Gems).
    assert!((critical.to_degrees() - 24.4).abs() < 0.05);
    assert!(reflectance(critical, 2.417, 1.0) > 0.99);
    assert!(cos_refracted_squared((critical + 1e-3).cos(), 2.417) < 0.0);
    assert!(cos_refracted_squared((critical - 1e-3).cos(), 2.417) > 0.0);
}

#[test]
fn refraction_obeys_snell_and_stays_in_the_plane_of_incidence() {
    for n in [1.1_f32, 1.5, 2.417, 3.0] {
        for degrees in 0..90 {
            let incident = direction((degrees as f32).to_radians());
            let refracted = refract(incident, Vec3::Z, 1.0 / n);
            assert!((refracted.x * n - incident.x).abs() < 2e-6, "{n} {degrees}");
            assert!(refracted.y.abs() < 1e-7 && refracted.z < 0.0);
            assert!((refracted.length() - 1.0).abs() < 1e-6);
            let back = refract(-refracted, Vec3::NEG_Z, n);
            assert!((back + incident).length() < 1e-3, "reversible: {n} {degrees} {back}");
        }
    }
}

#[test]
fn reflection_keeps_the_angle() {
    let incident = Vec3::new(0.3, -0.5, -0.8).normalize_or_zero();
    let mirrored = reflect(incident, Vec3::Z);
    assert!((mirrored - Vec3::new(incident.x, incident.y, -incident.z)).length() < 1e-7);
}

#[test]
fn the_total_reflection_wavelength_is_the_root_of_the_critical_condition() {
    let packed =
        PackedScene::new(&scene(vec![brilliant(DIAMOND)], Lights::default()), Bins::new(16))
            .expect("packs");
    let interface = Interface { normal: Vec3::Z, medium_from: 0, medium_to: NONE };
    for target_nm in [385.0_f32, 431.0, 500.0, 589.0, 687.0, 725.0] {
        // At sin θ = 1/n(λ) exactly λ is critical; shorter waves, of higher index, are reflected.
        let n = DIAMOND.n(f64::from(target_nm));
        let angle = (1.0 / n).asin() as f32;
        let ray = Ray::white(Vec3::ZERO, direction(angle));
        assert!(is_totally_reflected(&packed, &interface, ray.direction, 380.0));
        assert!(!is_totally_reflected(&packed, &interface, ray.direction, 730.0));
        let found_nm = find_total_refl_wave(&packed, &interface, &ray, true);
        // One ulp of cos θ moves the wavelength by about a nanometre: dn/dλ is 1.7e-4 per nm.
        assert!((found_nm - target_nm).abs() < 1.0, "{target_nm} {found_nm}");
        assert!(!is_totally_reflected(&packed, &interface, ray.direction, found_nm));
        let cos_squared =
            cos_refracted_squared(angle.cos(), relative_index(&packed, &interface, found_nm));
        assert!((0.0..1e-4).contains(&cos_squared), "{cos_squared}");
    }
}
