//! A plane-parallel slab shows no colour and no blur of what is far behind it.

use brilliance_renderer::camera::Camera;
use brilliance_renderer::light::Lights;
use brilliance_renderer::material::Dispersion;
use brilliance_renderer::scene::Scene;
use brilliance_renderer::settings::TraceSettings;
use glam::{DVec3, Quat, Vec3};

use crate::scenes::{block, clear, exact, flat_disc, object, paper, render, request, scene};

const GLASS: Dispersion = Dispersion::Linear { n_d: 1.9, dispersion_bg: 0.08 };
const TILT_DEGREES: f32 = 35.0;

fn lights() -> Lights {
    Lights { discs: vec![flat_disc(Vec3::NEG_Z, 1.0, 1.0)], ..Lights::default() }
}

fn with_slab() -> Scene {
    let mut slab = object(block(DVec3::new(200.0, 200.0, 1.0)), clear(GLASS));
    slab.transform.rotation = Quat::from_rotation_x(TILT_DEGREES.to_radians());
    scene(vec![slab], lights())
}

/// Transmittance of a lossless slab with all its internal reflections: (1 − R)/(1 + R)
/// (Hecht, *Optics*, §9.6, incoherent sum).
fn transmittance(lambda_nm: f64) -> f64 {
    let n = GLASS.n(lambda_nm);
    let incidence = f64::from(TILT_DEGREES).to_radians();
    let refracted = (incidence.sin() / n).asin();
    let sine = (incidence - refracted).sin() / (incidence + refracted).sin();
    let tangent = (incidence - refracted).tan() / (incidence + refracted).tan();
    let reflectance = 0.5 * (sine * sine + tangent * tangent);
    (1.0 - reflectance) / (1.0 + reflectance)
}

#[test]
fn a_disc_behind_a_slab_keeps_its_shape_and_its_colour() {
    let camera = Camera {
        position: Vec3::Z * 50.0,
        up: Vec3::Y,
        fov_y_radians: 4.0_f32.to_radians(),
        ..Camera::default()
    };
    for settings in [TraceSettings { significance_threshold: 1e-6, ..paper() }, exact()] {
        a_disc_keeps_its_shape(&camera, &TraceSettings { max_depth: 64, ..settings });
    }
}

fn a_disc_keeps_its_shape(camera: &Camera, settings: &TraceSettings) {
    let size = [48, 48];
    let through = render(&request(with_slab(), *camera, size, settings.clone()), 0).film;
    let bare =
        render(&request(scene(Vec::new(), lights()), *camera, size, settings.clone()), 0).film;
    let (mut lit, mut blurred) = (0, 0);
    for y in 0..size[1] {
        for x in 0..size[0] {
            let (seen, plain) = (through.pixel(x, y), bare.pixel(x, y));
            for bin in 0..seen.len() {
                let (low_nm, high_nm) = through.bins().range_nm(bin);
                let expected =
                    f64::from(plain[bin]) * transmittance(f64::from(0.5 * (low_nm + high_nm)));
                let error = (f64::from(seen[bin]) - expected).abs();
                // The tilt of single pixels against the axis changes R by a little.
                blurred += usize::from(error > 5e-3);
            }
            lit += usize::from(plain[0] > 0.0);
        }
    }
    assert!(lit > 300, "the disc is in the picture: {lit} pixels");
    assert_eq!(blurred, 0, "values off the bare disc's times the transmittance");
}
