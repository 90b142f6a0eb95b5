//! Plane loop and triangle hierarchy must agree, and lose no ray.

use std::path::PathBuf;
use std::sync::Arc;

use brilliance_renderer::cuts::RoundBrilliant;
use brilliance_renderer::kernel::intersect::find_intersection;
use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::kernel::rng::{hash, unit_float};
use brilliance_renderer::light::Lights;
use brilliance_renderer::mesh::Mesh;
use brilliance_renderer::packed::{NONE, PackedScene};
use brilliance_renderer::scene::{MeshSource, Object, Scene, Shape, Transform};
use brilliance_renderer::settings::TraceSettings;
use brilliance_renderer::solid::Solid;
use brilliance_renderer::spectrum::Bins;
use glam::{Quat, Vec3};

use crate::scenes::{
    DIAMOND, brilliant, clear, close_camera, exact, flat_sky, furnace, mean, paper, render,
    request, scene,
};

/// The brilliant as a triangle mesh, somewhere else, turned and scaled.
fn meshed(transform: Transform) -> Object {
    let half_spaces = RoundBrilliant::default().half_spaces().expect("the default cut is a solid");
    let solid = Solid::from_half_spaces(&half_spaces).expect("the default cut closes");
    let mesh = Mesh::from_solid(&solid).expect("a solid is a mesh");
    let source = MeshSource { path: PathBuf::new(), index: 0, mesh: Arc::new(mesh) };
    Object { transform, ..crate::scenes::object(Shape::Mesh(source), clear(DIAMOND)) }
}

fn turned() -> Transform {
    Transform {
        translation: Vec3::new(3.0, -2.0, 1.0),
        rotation: Quat::from_axis_angle(Vec3::new(0.6, 0.0, 0.8), 0.7),
        scale: 1.7,
    }
}

fn packed(object: Object) -> PackedScene {
    let scene: Scene = scene(vec![object], Lights::default());
    PackedScene::new(&scene, Bins::new(16)).expect("packs")
}

#[test]
fn planes_and_triangles_agree_from_outside() {
    let planes = packed(Object { transform: turned(), ..brilliant(DIAMOND) });
    let triangles = packed(meshed(turned()));
    let mut state = 0_u32;
    let mut random = || {
        state += 1;
        2.0 * unit_float(hash(state)) - 1.0
    };
    let (mut hits, mut edge_cases) = (0, 0);
    for _ in 0..20_000 {
        let origin = Vec3::new(random(), random(), random()) * 30.0;
        let target = turned().translation + Vec3::new(random(), random(), random()) * 6.0;
        let ray = Ray::white(origin, (target - origin).normalize_or_zero());
        let (a, b) = (find_intersection(&planes, &ray), find_intersection(&triangles, &ray));
        if (a.instance == NONE) != (b.instance == NONE) || a.normal.dot(b.normal) < 0.999 {
            // Within rounding of an edge the two may choose different facets.
            edge_cases += 1;
            continue;
        }
        if a.instance != NONE {
            hits += 1;
            assert!((a.distance - b.distance).abs() < 1e-4 * a.distance, "{a:?} {b:?}");
        }
    }
    assert!(hits > 3000 && edge_cases < 10, "{hits} hits, {edge_cases} edge cases");
}

#[test]
fn a_mesh_renders_as_its_solid() {
    for settings in [paper(), exact()] {
        a_mesh_renders_as_its_solid_by(&TraceSettings { max_depth: 24, ..settings });
    }
}

fn a_mesh_renders_as_its_solid_by(trace: &TraceSettings) {
    let lights = Lights { hemisphere: Some(flat_sky(1.0)), ..Lights::default() };
    let picture = |object: Object| {
        render(
            &request(
                scene(vec![object], lights.clone()),
                close_camera(7.0),
                [64, 64],
                trace.clone(),
            ),
            0,
        )
    };
    let (solid, mesh) = (picture(brilliant(DIAMOND)), picture(meshed(Transform::default())));
    let difference: f64 = solid
        .film
        .sums()
        .iter()
        .zip(mesh.film.sums())
        .map(|(a, b)| f64::from((a - b).abs()))
        .sum::<f64>()
        / solid.film.sums().len() as f64;
    // A fork tree turns one ulp into another facet now and then: the mean counts, not the maximum.
    assert!(difference < 2e-3, "{difference}");
    assert!((mean(&solid.film.means()) / mean(&mesh.film.means()) - 1.0).abs() < 1e-3);
}

#[test]
fn no_interior_ray_is_lost_in_a_mesh() {
    let mut furnace = furnace();
    furnace.objects = vec![meshed(Transform::default())];
    for (settings, tolerance) in [(paper(), 1e-5), (TraceSettings::default(), 1e-5)] {
        let request = request(furnace.clone(), close_camera(7.0), [128, 128], settings);
        let ledger = render(&request, 0).statistics.ledger;
        assert!(ledger.lost / ledger.entered < 1e-6, "{ledger:?}");
        assert!(ledger.imbalance().abs() / ledger.entered < tolerance, "{ledger:?}");
    }
}

#[test]
fn many_stones_are_met_wherever_they_stand() {
    let objects: Vec<_> = (0..49)
        .map(|i| {
            let translation = Vec3::new((i % 7) as f32 * 8.0, (i / 7) as f32 * 8.0, 0.0);
            let transform = Transform { translation, ..Transform::default() };
            Object { transform, ..brilliant(DIAMOND) }
        })
        .collect();
    let centers: Vec<_> = objects.iter().map(|object| object.transform.translation).collect();
    let scene = scene(objects, Lights::default());
    let packed = PackedScene::new(&scene, Bins::new(16)).expect("packs");
    for (i, center) in centers.iter().enumerate() {
        let hit = find_intersection(&packed, &Ray::white(*center + Vec3::Z * 20.0, Vec3::NEG_Z));
        assert_eq!(hit.instance, i as u32);
        assert_eq!(hit.normal, Vec3::Z);
    }
}
