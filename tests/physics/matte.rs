//! Diffuse surfaces under discs and sky.

use std::f32::consts::PI;

use brilliance_renderer::camera::Camera;
use brilliance_renderer::light::Lights;
use brilliance_renderer::material::{Diffuse, Dispersion, Material};
use brilliance_renderer::scene::{Ground, Scene};
use brilliance_renderer::settings::TraceSettings;
use brilliance_renderer::spectrum::Spectrum;
use glam::{DVec3, Vec3};

use crate::scenes::{
    block, clear, exact, flat_disc, flat_sky, mean, object, paper, render, request, scene,
};

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
    let matte = Material::Diffuse(Diffuse { reflectance: Spectrum::Flat(0.5), print: None });
    let mut blocker = object(block(DVec3::splat(5.0)), matte);
    blocker.transform.translation = Vec3::new(40.0, 0.0, 40.0);
    let disc = flat_disc(Vec3::new(1.0, 0.0, 1.0), 1.0, 100.0);
    let mut scene = scene(vec![blocker], Lights { discs: vec![disc], ..Lights::default() });
    scene.ground = Some(floor(1000.0));
    assert_eq!(seen(scene.clone(), Vec3::ZERO, 4), 0.0, "in the umbra");
    assert!(seen(scene, Vec3::new(0.0, 30.0, 0.0), 4) > 0.0, "beside it");
}

#[test]
fn a_block_on_the_ground_shows_the_ground_and_nothing_under_it() {
    for height in [0.0_f32, 0.3, -1.7, 11.1] {
        let glass = Dispersion::Linear { n_d: 1.5, dispersion_bg: 0.0 };
        let mut block = object(block(DVec3::splat(2.0)), clear(glass));
        block.transform.translation = Vec3::new(0.1, 0.2, height + 2.0);
        let lights = Lights { environment: Some(flat_sky(1.0)), ..Lights::default() };
        let mut scene = scene(vec![block], lights);
        scene.ground = Some(Ground {
            height,
            square: 5.0,
            reflectance: [Spectrum::Flat(0.0), Spectrum::Flat(0.0)],
        });
        let camera = from_above(Vec3::new(0.1, 0.2, height));
        for settings in [paper(), exact()] {
            let film = render(&request(scene.clone(), camera, [48, 48], settings), 0).film;
            let brightest = (0..48 * 48).map(|i| film.pixel(i % 48, i / 48)[0]).fold(0.0, f32::max);
            // Looking down through the top the ground is black: only the top's reflection is left.
            assert!(brightest < 0.1, "ground at {height}: {brightest}");
        }
    }
}

#[test]
fn two_touching_slabs_show_no_speckle() {
    let glass = Dispersion::Linear { n_d: 1.5, dispersion_bg: 0.0 };
    let slab = |z: f32| {
        let mut slab = object(block(DVec3::new(20.0, 20.0, 1.0)), clear(glass.clone()));
        slab.transform.translation.z = z;
        slab
    };
    let lights = Lights { discs: vec![flat_disc(Vec3::NEG_Z, 20.0, 1.0)], ..Lights::default() };
    let scene = scene(vec![slab(0.3), slab(2.3)], lights);
    for settings in [paper(), exact()] {
        let request = request(scene.clone(), from_above(Vec3::ZERO), [32, 32], settings);
        let film = render(&request, 0).film;
        let values: Vec<_> = (0..32 * 32).map(|i| film.pixel(i % 32, i / 32)[0]).collect();
        let (least, most) =
            values.iter().fold((f32::MAX, f32::MIN), |(a, b), &value| (a.min(value), b.max(value)));
        // Four surfaces of R = 0.04 with all their reflections: (1 − R)/(1 + 3R) = 0.857.
        assert!(least > 0.85 && most < 0.86, "{least} to {most}");
    }
}

#[test]
fn equal_pixels_grow_alike_with_the_passes() {
    // The edge of a square cuts each pixel, and a wall shadows the light that the pixel is lit by.
    let spread = |passes: u32| {
        let matte = Material::Diffuse(Diffuse { reflectance: Spectrum::Flat(0.0), print: None });
        let mut wall = object(block(DVec3::new(1.0, 500.0, 500.0)), matte);
        wall.transform.translation = Vec3::new(30.0, 0.0, 0.0);
        let lights = Lights { hemisphere: Some(flat_sky(1.0)), ..Lights::default() };
        let mut scene = scene(vec![wall], lights);
        scene.ground = Some(Ground {
            height: 0.0,
            square: 500.0,
            reflectance: [Spectrum::Flat(1.0), Spectrum::Flat(0.0)],
        });
        let camera = Camera {
            position: Vec3::new(0.0, 250.0, 5000.0),
            target: Vec3::new(0.0, 250.0, 0.0),
            up: Vec3::Y,
            fov_y_radians: 0.02,
        };
        let mut request = request(scene, camera, [1, 64], TraceSettings::default());
        request.pass_limit = passes;
        let film = render(&request, 0).film;
        let values: Vec<f64> = (0..64).map(|y| f64::from(film.pixel(0, y)[0])).collect();
        let mean = values.iter().sum::<f64>() / 64.0;
        (values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / 64.0).sqrt() / mean
    };
    let (few, many) = (spread(64), spread(1024));
    assert!(few < 0.2 && many < 0.25 * few, "{few} after 64 passes, {many} after 1024");
}
