//! A concave mesh above a matte checker: each ray has many ends, and some enter again.

use std::path::PathBuf;
use std::sync::Arc;

use brilliance_renderer::light::{Lights, SkyLight};
use brilliance_renderer::material::Dispersion;
use brilliance_renderer::mesh::Mesh;
use brilliance_renderer::scene::{Ground, MeshSource, Scene, Shape};
use brilliance_renderer::settings::TraceSettings;
use brilliance_renderer::spectrum::{Bins, Spectrum};
use glam::{Quat, Vec3};

use crate::difference::Difference;
use crate::method::{METHODS, trace};
use crate::reference::Reference;
use crate::scenes::{Case, camera, clear_body};

/// A block of 4 × 4 × 3 mm whose top is a pit, down to 0.4 mm above its middle.
fn dented_block() -> Mesh {
    let corner = |x, y, z| Vec3::new(x, y, z);
    let positions = vec![
        corner(-2.0, -2.0, -1.5),
        corner(2.0, -2.0, -1.5),
        corner(2.0, 2.0, -1.5),
        corner(-2.0, 2.0, -1.5),
        corner(-2.0, -2.0, 1.5),
        corner(2.0, -2.0, 1.5),
        corner(2.0, 2.0, 1.5),
        corner(-2.0, 2.0, 1.5),
        corner(0.2, -0.1, 0.4),
    ];
    let mut triangles = vec![[0, 2, 1], [0, 3, 2]];
    for i in 0..4 {
        let next = (i + 1) % 4;
        triangles.extend([[i, next, next + 4], [i, next + 4, i + 4], [i + 4, next + 4, 8]]);
    }
    Mesh::new(positions, triangles).expect("the block is a mesh")
}

/// The block so high above a checker that it hides almost none of its sky.
fn dented_block_over_checker(dispersion: &Dispersion) -> Case {
    let mesh = dented_block();
    mesh.closed().expect("the block is closed");
    let source = MeshSource { path: PathBuf::new(), index: 0, mesh: Arc::new(mesh) };
    let mut block = clear_body(Shape::Mesh(source), dispersion.clone());
    block.transform.rotation = Quat::from_euler(glam::EulerRot::XYZ, 0.21, 0.13, 0.37);
    let sky = SkyLight { radiance: 1.0, spectrum: Spectrum::Flat(1.0) };
    let reflectance = [0.1, 0.8].map(Spectrum::Flat);
    let scene = Scene {
        objects: vec![block],
        ground: Some(Ground { height: -2000.0, square: 900.0, reflectance }),
        lights: Lights { environment: Some(sky), ..Lights::default() },
        ..Scene::default()
    };
    Case {
        name: format!("dented block over a checker, n_G − n_B {:.3}", dispersion.dispersion_bg()),
        scene,
        camera: camera([-65.0, 51.0], Vec3::ZERO, 5.0),
        size: [48, 48],
    }
}

#[test]
fn a_concave_mesh_over_matte_ground_is_what_brute_force_finds() {
    for dispersion_bg in [0.0, 0.03] {
        let case = dented_block_over_checker(&Dispersion::Linear { n_d: 1.7, dispersion_bg });
        let bins = Bins::new(TraceSettings::default().bins);
        let reference = Reference::new(&case, bins, 1.0);
        for method in &METHODS {
            let settings = method.fine_settings();
            let comparison = method.compare(&case, &reference, &settings, None);
            println!("{}", comparison.row);
            if dispersion_bg == 0.0 {
                let Difference { mean, high, .. } =
                    Difference::of(&trace(&case, &settings), &reference);
                assert!(mean < 0.05 && high < 0.5, "{}: {mean}, {high}", method.name);
            }
        }
    }
}
