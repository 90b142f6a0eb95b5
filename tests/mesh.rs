//! Triangle meshes: welding, closedness, orientation and flat facets.

mod shapes;

use brilliance_renderer::cuts::RoundBrilliant;
use brilliance_renderer::mesh::{Mesh, MeshFault};
use brilliance_renderer::solid::Solid;
use glam::Vec3;
use shapes::sphere;

/// A cube of side 2 with four vertices of its own on each face, as exporters write it.
fn split_cube() -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for axis in 0..3 {
        for sign in [-1.0_f32, 1.0] {
            let start = positions.len() as u32;
            for (u, v) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                let mut p = [0.0; 3];
                p[axis] = sign;
                p[(axis + 1) % 3] = u;
                p[(axis + 2) % 3] = v;
                positions.push(Vec3::from(p));
            }
            let quad = if sign > 0.0 { [0, 1, 2, 3] } else { [0, 3, 2, 1] };
            let [a, b, c, d] = quad.map(|i: u32| start + i);
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    (positions, triangles)
}

#[test]
fn split_vertices_are_welded_into_a_closed_mesh_with_flat_facets() {
    let (positions, triangles) = split_cube();
    let mesh = Mesh::new(positions, triangles).unwrap();
    assert_eq!((mesh.positions.len(), mesh.triangles.len()), (8, 12));
    assert_eq!(mesh.closed(), Ok(()));
    assert_eq!(mesh.volume(), 8.0);
    assert_eq!(mesh.facet, [0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5]);
    assert_eq!(mesh.bounds(), (Vec3::NEG_ONE, Vec3::ONE));
}

#[test]
fn minus_zero_is_zero_and_unused_vertices_go() {
    let positions =
        vec![Vec3::X, Vec3::ZERO, Vec3::new(-0.0, 0.0, -0.0), Vec3::Y, Vec3::Z, Vec3::splat(99.0)];
    let mesh = Mesh::new(positions, vec![[1, 3, 0], [2, 0, 4], [1, 4, 3], [0, 3, 4]]).unwrap();
    assert_eq!(mesh.positions, [Vec3::X, Vec3::ZERO, Vec3::Y, Vec3::Z]);
    assert_eq!(mesh.closed(), Ok(()));
    assert_eq!(mesh.bounds().1, Vec3::ONE);
}

#[test]
fn an_inside_out_mesh_is_turned() {
    let (positions, mut triangles) = split_cube();
    for corners in &mut triangles {
        corners.reverse();
    }
    let mesh = Mesh::new(positions, triangles).unwrap();
    assert_eq!(mesh.closed(), Ok(()));
    assert_eq!(mesh.volume(), 8.0);
}

#[test]
fn triangles_with_equal_corners_are_dropped_but_slivers_close_gaps() {
    let (positions, mut triangles) = split_cube();
    let mut with_stray = positions.clone();
    with_stray.push(Vec3::splat(9.0));
    triangles.push([0, 0, 24]);
    let mesh = Mesh::new(with_stray, triangles.clone()).unwrap();
    assert_eq!((mesh.positions.len(), mesh.triangles.len()), (8, 12));

    // The edge from corner 0 to corner 1 gets a point in its middle on one side and a triangle
    // without area that joins it to the other side.
    triangles.pop();
    let [a, b, c] = triangles[0];
    let middle = positions.len() as u32;
    let mut with_middle = positions.clone();
    with_middle.push((positions[a as usize] + positions[b as usize]) / 2.0);
    triangles[0] = [a, middle, c];
    triangles.extend([[middle, b, c], [a, b, middle]]);
    let mesh = Mesh::new(with_middle, triangles).unwrap();
    assert_eq!(mesh.closed(), Ok(()));
    assert_eq!(mesh.volume(), 8.0);
    assert_eq!(mesh.facet.iter().max(), Some(&5));
}

#[test]
fn a_hole_is_located() {
    let (positions, mut triangles) = split_cube();
    triangles.remove(4);
    let fault = Mesh::new(positions, triangles).unwrap().closed().unwrap_err();
    assert!(matches!(fault, MeshFault::Edges { open: 3, crowded: 0, miswound: 0, .. }), "{fault}");
    let text = fault.to_string();
    assert!(text.starts_with("3 edges are open") && text.contains("[-1, "), "{text}");
}

#[test]
fn a_fin_and_a_flipped_triangle_are_told_apart() {
    let (mut positions, mut triangles) = split_cube();
    let tip = positions.len() as u32;
    positions.push(Vec3::splat(5.0));
    let [a, b, _] = triangles[0];
    triangles.push([a, b, tip]);
    let fault = Mesh::new(positions.clone(), triangles.clone()).unwrap().closed().unwrap_err();
    assert!(matches!(fault, MeshFault::Edges { open: 2, crowded: 1, miswound: 0, .. }), "{fault}");

    triangles.pop();
    triangles[3].swap(0, 1);
    let fault = Mesh::new(positions, triangles).unwrap().closed().unwrap_err();
    assert!(matches!(fault, MeshFault::Edges { open: 0, crowded: 0, miswound: 3, .. }), "{fault}");
    assert!(fault.to_string().contains("opposite sides"));
}

#[test]
fn a_folded_sheet_is_flat() {
    let positions = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
    let mesh = Mesh::new(positions, vec![[0, 1, 2], [0, 2, 1]]).unwrap();
    assert_eq!(mesh.closed(), Err(MeshFault::Flat));
}

#[test]
fn bad_input_is_named() {
    let text = |positions: Vec<Vec3>, triangles: Vec<[u32; 3]>| {
        Mesh::new(positions, triangles).unwrap_err().to_string()
    };
    let corners = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
    assert!(text(corners.clone(), vec![[0, 1, 3]]).contains("triangle 0"));
    assert!(text(corners.clone(), vec![]).contains("no triangle"));
    assert!(text(corners.clone(), vec![[1, 1, 2]]).contains("no triangle"));
    for bad in [f32::NAN, f32::INFINITY] {
        let mut positions = corners.clone();
        positions[1].y = bad;
        assert!(text(positions, vec![[0, 1, 2]]).contains("vertex 1"));
    }
}

#[test]
fn a_solid_keeps_its_facets() {
    let solid = Solid::from_half_spaces(&RoundBrilliant::default().half_spaces().unwrap()).unwrap();
    let direct = Mesh::from_solid(&solid).unwrap();
    assert_eq!(direct.closed(), Ok(()));
    assert_eq!(direct.facet.iter().max(), Some(&72));
    // Found again from the triangles alone.
    let found = Mesh::new(direct.positions.clone(), direct.triangles.clone()).unwrap();
    assert_eq!(found.facet, direct.facet);
}

#[test]
fn a_smooth_surface_has_no_flat_facets() {
    let (positions, triangles) = sphere(64, 128);
    let mesh = Mesh::new(positions, triangles).unwrap();
    assert_eq!(mesh.closed(), Ok(()));
    let mut sizes = std::collections::HashMap::new();
    for facet in &mesh.facet {
        *sizes.entry(facet).or_insert(0) += 1;
    }
    // The two triangles of a quad lie in one plane; rings of quads do not.
    assert_eq!(sizes.values().max(), Some(&2));
    assert!(mesh.volume() > 0.0);
}

#[test]
fn a_fine_flat_facet_stays_whole_far_from_the_origin() {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    let side = 40_u32;
    let right = Vec3::new(0.6, 0.8, 0.0);
    let up = Vec3::new(-0.48, 0.36, 0.8);
    for i in 0..side {
        for j in 0..side {
            let at = right * (i as f32 / 13.0) + up * (j as f32 / 17.0);
            positions.push(at + Vec3::new(30.0, -7.0, 12.0));
            if i > 0 && j > 0 {
                let [a, b, c, d] =
                    [(1, 1), (0, 1), (0, 0), (1, 0)].map(|(di, dj)| (i - di) * side + (j - dj));
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
    }
    let mesh = Mesh::new(positions, triangles).unwrap();
    assert!(mesh.facet.iter().all(|facet| *facet == 0));
    assert!(mesh.closed().is_err());
}

#[test]
fn a_million_triangles_are_no_trouble() {
    let (positions, triangles) = sphere(501, 1000);
    assert_eq!(triangles.len(), 1_000_000);
    let started = std::time::Instant::now();
    let mesh = Mesh::new(positions, triangles).unwrap();
    println!("a million triangles in {:.3} s", started.elapsed().as_secs_f64());
    assert_eq!(mesh.closed(), Ok(()));
    assert_eq!(mesh.triangles.len(), 1_000_000);
}
