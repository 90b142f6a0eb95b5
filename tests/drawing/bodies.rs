//! Bodies to draw.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use brilliance_renderer::cuts::RoundBrilliant;
use brilliance_renderer::mesh::Mesh;
use brilliance_renderer::scene::{MeshSource, Object, Shape};
use brilliance_renderer::scene_file::{Document, scenes};
use brilliance_renderer::solid::HalfSpace;
use glam::{DVec3, Vec3};

pub(crate) fn object(shape: Shape) -> Object {
    Object { shape, ..Document::default().scene.objects[0].clone() }
}

pub(crate) fn brilliant(cut: RoundBrilliant) -> Object {
    object(Shape::RoundBrilliant(cut))
}

pub(crate) fn mesh(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Object {
    let mesh = Arc::new(Mesh::new(positions, triangles).unwrap());
    object(Shape::Mesh(MeshSource { path: PathBuf::from("folder/stone.glb"), index: 0, mesh }))
}

/// Tiers of `sides` facets each: angle from the girdle plane (negative on the pavilion) and the
/// distance of their planes.
pub(crate) fn tiers(sides: u32, tiers: &[(f64, f64)], table: f64) -> Object {
    let mut planes =
        vec![HalfSpace { normal: DVec3::Z, distance: table, name: "table".to_owned() }];
    for (tier, &(angle, distance)) in tiers.iter().enumerate() {
        for side in 0..sides {
            let azimuth = std::f64::consts::TAU * f64::from(side) / f64::from(sides);
            let (sin, cos) = angle.abs().to_radians().sin_cos();
            let normal = DVec3::new(sin * azimuth.sin(), sin * azimuth.cos(), cos * angle.signum());
            planes.push(HalfSpace { normal, distance, name: format!("T{tier} {side}") });
        }
    }
    object(Shape::Polyhedron(planes))
}

/// A torus of `around` × `across` flat facets, each of four corners: that of a wedge of a ring.
pub(crate) fn torus(around: u32, across: u32) -> Object {
    let turn =
        |k: u32, count: u32| (std::f32::consts::TAU * (k % count) as f32 / count as f32).sin_cos();
    let corner = |i: u32, j: u32| {
        let ((sin, cos), (up, out)) = (turn(i, around), turn(j, across));
        let radius = 3.0 + 1.2 * out;
        Vec3::new(radius * cos, radius * sin, 1.2 * up)
    };
    let at = |i: u32, j: u32| (i % around) * across + j % across;
    let places = (0..around).flat_map(|i| (0..across).map(move |j| (i, j)));
    let positions = places.clone().map(|(i, j)| corner(i, j)).collect();
    let triangles = places
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    mesh(positions, triangles)
}

/// A step cut of three tiers above and three below a girdle.
pub(crate) fn step_cut() -> Object {
    tiers(
        8,
        &[
            (25.0, 1.6),
            (35.0, 2.05),
            (45.0, 2.45),
            (90.0, 3.0),
            (-60.0, 2.75),
            (-50.0, 2.6),
            (-40.0, 2.3),
        ],
        1.4,
    )
}

/// A beam along y whose section is a C that opens to the right; the lower arm is the longer one.
///
/// Seen from above, the upper arm covers x from 0 to 3 and the lower arm shows from 3 to 4.
pub(crate) fn c_beam() -> Object {
    let section = [
        [0.0, 0.0],
        [4.0, 0.0],
        [4.0, 1.0],
        [1.0, 1.0],
        [1.0, 2.0],
        [3.0, 2.0],
        [3.0, 3.0],
        [0.0, 3.0],
    ];
    // Seen from −y, with the section counter-clockwise: spine, lower arm and upper arm.
    let caps = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 7], [4, 5, 6], [4, 6, 7]];
    let count = section.len() as u32;
    let positions =
        [-1.0, 1.0].into_iter().flat_map(|y| section.map(|[x, z]| Vec3::new(x, y, z))).collect();
    let mut triangles: Vec<[u32; 3]> = caps.into();
    triangles.extend(caps.map(|[a, b, c]| [a + count, c + count, b + count]));
    for k in 0..count {
        let next = (k + 1) % count;
        triangles.push([k, k + count, next + count]);
        triangles.push([k, next + count, next]);
    }
    mesh(positions, triangles)
}

/// The objects of the scenes that ship.
pub(crate) fn shipped() -> Vec<Object> {
    let documents = scenes().iter().map(|scene| Document::from_toml(scene.text, Path::new("")));
    documents.flat_map(|document| document.unwrap().scene.objects).collect()
}

pub(crate) fn octahedron() -> Object {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../assets/gems/spinel_octahedron.glb");
    Document::open(&file).unwrap().scene.objects[0].clone()
}
