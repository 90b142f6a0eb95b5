//! A rendered prism bends every wavelength by the textbook angle.

use brilliance_renderer::camera::Camera;
use brilliance_renderer::film::Film;
use brilliance_renderer::light::Lights;
use brilliance_renderer::settings::TraceSettings;
use glam::Vec3;

use crate::scenes::{FLINT, clear, exact, flat_disc, object, paper, prism, render, request, scene};

const WIDTH: u32 = 900;
const FOV_DEGREES: f64 = 14.0;

/// Column at which each bin's light arrives on average; `None` where it is not in the picture.
fn centroids(film: &Film) -> Vec<Option<f64>> {
    let bins = film.bins().count();
    (0..bins)
        .map(|bin| {
            let (mut sum, mut moment) = (0.0, 0.0);
            for x in 0..WIDTH {
                let value = f64::from(film.pixel(x, 0)[bin]);
                sum += value;
                moment += value * (f64::from(x) + 0.5);
            }
            (sum > 0.0).then(|| moment / sum)
        })
        .collect()
}

#[test]
fn light_is_bent_by_the_textbook_angle() {
    // Seen from the right face; the light's direction is that of D light at minimum deviation
    // δ = 2·asin(n·sin(A/2)) − A (Born & Wolf, §4.7.2).
    let apex = 60.0_f64.to_radians();
    let n_d = FLINT.n(589.0);
    let deviation = 2.0 * (n_d * (0.5 * apex).sin()).asin() - apex;
    let incidence = 0.5 * (deviation + apex);
    let view = 30.0_f64.to_radians() + std::f64::consts::PI - incidence;
    let towards_light = view + deviation;
    let at = |angle: f64| Vec3::new(angle.cos() as f32, 0.0, angle.sin() as f32);
    let lights =
        Lights { discs: vec![flat_disc(at(towards_light), 0.1, 1.0)], ..Lights::default() };
    let face = at(30.0_f64.to_radians()) * 5.0;
    let camera = Camera {
        position: face - at(view) * 2.0,
        target: face,
        // Angles grow to the left of the picture.
        up: Vec3::Y,
        fov_y_radians: 2.0
            * ((FOV_DEGREES / 2.0).to_radians().tan() / f64::from(WIDTH)).atan() as f32,
    };
    // Only the ray that is refracted twice: images by inner reflections lie elsewhere.
    let of_paper = TraceSettings { significance_threshold: 0.3, ..paper() };
    for (settings, tolerance) in [(of_paper, 0.004), (exact(), 0.004)] {
        let settings = TraceSettings { bins: 50, max_depth: 2, ..settings };
        let prism = object(prism(60.0, 5.0), clear(FLINT));
        let scene = scene(vec![prism], lights.clone());
        let mut request = request(scene, camera, [WIDTH, 1], settings);
        request.pass_limit = 16;
        let film = render(&request, 0).film;
        assert_bent(&film, &camera, [view, towards_light], tolerance);
    }
}

/// Where each bin of the film sees the light, the formula sends it, to `tolerance` degrees.
fn assert_bent(film: &Film, camera: &Camera, [view, towards_light]: [f64; 2], tolerance: f64) {
    let apex = 60.0_f64.to_radians();

    let half_width = (FOV_DEGREES / 2.0).to_radians().tan();
    let mut checked = 0;
    for (bin, column) in centroids(film).into_iter().enumerate() {
        let Some(column) = column else { continue };
        let across = (2.0 * column / f64::from(WIDTH) - 1.0) * half_width;
        let ray_angle = camera_angle(view, across, camera);
        let (low_nm, high_nm) = film.bins().range_nm(bin);
        let n = FLINT.n(f64::from(0.5 * (low_nm + high_nm)));
        let incidence = 30.0_f64.to_radians() + std::f64::consts::PI - ray_angle;
        let inside = (incidence.sin() / n).asin();
        let exit = (n * (apex - inside).sin()).asin();
        let predicted = ray_angle + incidence + exit - apex;
        let error = (predicted - towards_light).to_degrees();
        assert!(error.abs() < tolerance, "bin {bin}: off by {error}°");
        checked += 1;
    }
    assert!(checked > 40, "the spectrum is in the picture: {checked} bins");
}

/// Angle of the camera ray that crosses the image plane at `across`, to the right.
fn camera_angle(view: f64, across: f64, camera: &Camera) -> f64 {
    let frame = camera.frame(WIDTH, 1);
    let direction = frame.forward.as_dvec3() + frame.right.as_dvec3().normalize() * across;
    let angle = direction.z.atan2(direction.x);
    let turn = std::f64::consts::TAU;
    angle + ((view - angle) / turn).round() * turn
}
