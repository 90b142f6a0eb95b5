//! The brute force itself against formulas.

use brilliance_renderer::cuts::RoundBrilliant;
use brilliance_renderer::light::{DiscLight, Lights, SkyLight};
use brilliance_renderer::material::Dispersion;
use brilliance_renderer::scene::{Object, Scene, Shape};
use brilliance_renderer::spectrum::Spectrum;
use glam::{DVec3, Vec3};

use crate::brute_force::{Seen, World};
use crate::scenes::{clear_body, plane};

/// A strongly dispersive flint glass.
const FLINT: Dispersion = Dispersion::Linear { n_d: 1.784, dispersion_bg: 0.055 };

fn world(object: Object, lights: Lights) -> World {
    World::new(&Scene { objects: vec![object], lights, ..Scene::default() }, DVec3::Z)
}

fn disc(direction: DVec3, radius_degrees: f32) -> Lights {
    let disc = DiscLight {
        name: "disc".to_owned(),
        direction: direction.as_vec3().normalize_or_zero(),
        angular_radius_radians: radius_degrees.to_radians(),
        radiance: 1.0,
        spectrum: Spectrum::Flat(1.0),
    };
    Lights { discs: vec![disc], ..Lights::default() }
}

fn environment() -> Lights {
    let sky = SkyLight { radiance: 1.0, spectrum: Spectrum::Flat(1.0) };
    Lights { environment: Some(sky), ..Lights::default() }
}

/// Two faces that lean against each other at `apex_degrees`, far from the other four.
fn prism(apex_degrees: f64) -> Object {
    let tilt = (0.5 * apex_degrees).to_radians();
    let planes = vec![
        plane(DVec3::new(tilt.cos(), 0.0, tilt.sin()), 5.0),
        plane(DVec3::new(-tilt.cos(), 0.0, tilt.sin()), 5.0),
        plane(DVec3::NEG_Z, 5.0),
        plane(DVec3::Y, 100.0),
        plane(DVec3::NEG_Y, 100.0),
    ];
    clear_body(Shape::Polyhedron(planes), FLINT)
}

#[test]
fn a_prism_turns_each_wavelength_by_the_angle_of_minimum_deviation() {
    // δ = 2·asin(n·sin(A/2)) − A where the path is symmetric (Born & Wolf, §4.7.2).
    let apex = 60.0_f64.to_radians();
    for lambda_nm in [400.0, 500.0, 600.0, 700.0] {
        let half_deviation = (FLINT.n(lambda_nm) * (0.5 * apex).sin()).asin() - 0.5 * apex;
        // The ray climbs to the right face, runs level inside and descends from the left one: it is
        // turned towards the base.
        let entering = DVec3::new(-half_deviation.cos(), 0.0, half_deviation.sin());
        let leaving = DVec3::new(-half_deviation.cos(), 0.0, -half_deviation.sin());
        let face = DVec3::new((0.5 * apex).cos(), 0.0, (0.5 * apex).sin()) * 5.0;
        let seen = |direction: DVec3| {
            let world = world(prism(60.0), disc(direction, 0.001));
            world.look(face - entering * 10.0, entering, lambda_nm).shares.0[0]
        };
        assert!(seen(leaving) > 0.6, "{lambda_nm} nm: {}", seen(leaving));
        let turned_by = 0.002_f64.to_radians();
        for angle in [half_deviation - turned_by, half_deviation + turned_by] {
            let beside = DVec3::new(-angle.cos(), 0.0, -angle.sin());
            assert!(seen(beside) < 0.1, "{lambda_nm} nm beside: {}", seen(beside));
        }
    }
}

#[test]
fn a_slab_lets_through_what_all_its_reflections_add_up_to() {
    // (1 − R)/(1 + R) (Hecht, *Optics*, §9.6, incoherent sum), R by Fresnel's sines and tangents.
    let axes = [(DVec3::X, 1e4), (DVec3::Y, 1e4), (DVec3::Z, 1.0)];
    let planes =
        axes.iter().flat_map(|&(axis, distance)| [plane(axis, distance), plane(-axis, distance)]);
    let slab = clear_body(Shape::Polyhedron(planes.collect()), FLINT);
    let incidence = 35.0_f64.to_radians();
    let direction = DVec3::new(incidence.sin(), 0.0, -incidence.cos());
    let world = world(slab, disc(direction, 0.01));
    for lambda_nm in [380.0, 550.0, 730.0] {
        let refracted = (incidence.sin() / FLINT.n(lambda_nm)).asin();
        let sine = (incidence - refracted).sin() / (incidence + refracted).sin();
        let tangent = (incidence - refracted).tan() / (incidence + refracted).tan();
        let reflectance = 0.5 * (sine * sine + tangent * tangent);
        let expected = (1.0 - reflectance) / (1.0 + reflectance);
        let found = world.look(-direction * 30.0, direction, lambda_nm).shares.0[0];
        assert!((found - expected).abs() < 1e-5, "{lambda_nm} nm: {found}, not {expected}");
    }
}

#[test]
fn a_stone_in_a_furnace_is_not_seen() {
    let stone = Shape::RoundBrilliant(RoundBrilliant::default());
    let world = world(clear_body(stone, FLINT), environment());
    for i in 0..400_u32 {
        let [x, y] = [i % 20, i / 20].map(|i| f64::from(i) * 0.3 - 2.9);
        let towards = Vec3::new(0.21, -0.13, -1.0).normalize_or_zero().as_dvec3();
        let Seen { shares, segments, .. } = world.look(DVec3::new(x, y, 10.0), towards, 550.0);
        // No disc, no hemisphere: the environment stands second. Each end is worth up to 1e-6.
        let seen = shares.0[1];
        assert!((seen - 1.0).abs() < 1e-6 * segments as f64, "{x}, {y}: {seen}");
    }
}
