//! Diffuse surfaces under discs and sky.

use std::f32::consts::PI;

use brilliance_renderer::camera::Camera;
use brilliance_renderer::light::Lights;
use brilliance_renderer::material::{Diffuse, Material};
use brilliance_renderer::scene::{Ground, Scene};
use brilliance_renderer::settings::TraceSettings;
use brilliance_renderer::spectrum::Spectrum;
use glam::{DVec3, Vec3};

use crate::scenes::{block, flat_disc, flat_sky, mean, object, render, request, scene};

fn floor(square: f32) -> Ground {
    Ground { height: 0.0, square, reflectance: [Spectrum::Flat(0.8), Spectrum::Flat(0.2)] }
}

fn lit(lights: Lights, square: f32) -> Scene {
    Scene { ground: Some(floor(square)), lights, ..Scene::default() }
}

fn from_above(target: Vec3) -> Camera {
    Camera {
        position: target + Vec3::Z * 100.0,
        target,
        up: Vec3::Y,
        fov_y_radians: 0.5_f32.to_radians(),
    }
}

fn seen(scene: Scene, target: Vec3, passes: u32) -> f64 {
    let mut request = request(scene, from_above(target), [8, 8], TraceSettings::default());
    request.pass_limit = passes;
    mean(&render(&request, 0).film.means())
}

#[test]
fn a_disc_lights_a_matte_floor_by_its_solid_angle_and_cosine() {
    let angle = 40.0_f32.to_radians();
    let disc = flat_disc(Vec3::new(angle.sin(), 0.0, angle.cos()), 2.0, 50.0);
    let expected = 0.8 / PI * 50.0 * disc.solid_angle_steradians() * angle.cos();
    let lights = Lights { discs: vec![disc], ..Lights::default() };
    let found = seen(lit(lights, 1000.0), Vec3::new(500.0, 500.0, 0.0), 16);
    assert!((found / f64::from(expected) - 1.0).abs() < 2e-3, "{found} {expected}");
}

#[test]
fn a_full_sky_makes_a_floor_as_bright_as_its_reflectance() {
    let lights = Lights { hemisphere: Some(flat_sky(2.0)), ..Lights::default() };
    let found = seen(lit(lights, 1000.0), Vec3::new(500.0, 500.0, 0.0), 1);
    assert!((found - 1.6).abs() < 1e-5, "{found}");
}

#[test]
fn the_checker_alternates_in_both_directions_and_across_zero() {
    let lights = Lights { hemisphere: Some(flat_sky(1.0)), ..Lights::default() };
    for (x, y, expected) in [
        (1.0, 1.0, 0.8),
        (3.0, 1.0, 0.2),
        (1.0, 3.0, 0.2),
        (3.0, 3.0, 0.8),
        (-1.0, 1.0, 0.2),
        (-1.0, -1.0, 0.8),
    ] {
        let found = seen(lit(lights.clone(), 2.0), Vec3::new(x, y, 0.0), 1);
        assert!((found - expected).abs() < 1e-5, "({x}, {y}): {found}");
    }
}

#[test]
fn an_opaque_body_throws_a_shadow() {
    let matte = Material::Diffuse(Diffuse { reflectance: Spectrum::Flat(0.5) });
    let mut blocker = object(block(DVec3::splat(5.0)), matte);
    blocker.transform.translation = Vec3::new(40.0, 0.0, 40.0);
    let disc = flat_disc(Vec3::new(1.0, 0.0, 1.0), 1.0, 100.0);
    let mut scene = scene(vec![blocker], Lights { discs: vec![disc], ..Lights::default() });
    scene.ground = Some(floor(1000.0));
    assert_eq!(seen(scene.clone(), Vec3::ZERO, 4), 0.0, "in the umbra");
    assert!(seen(scene, Vec3::new(0.0, 30.0, 0.0), 4) > 0.0, "beside it");
}
