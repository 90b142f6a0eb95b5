//! Convex solids: known bodies, any placement, and every way not to close.

#![expect(clippy::unwrap_used, reason = "a test ends where it fails, in its helpers too")]

use brilliance_renderer::solid::{HalfSpace, Solid};
use glam::{DQuat, DVec3};

fn plane(name: &str, normal: DVec3, distance: f64) -> HalfSpace {
    HalfSpace { normal, distance, name: name.to_owned() }
}

/// The cube of half side 1 about `centre`.
fn cube(center: DVec3) -> Vec<HalfSpace> {
    [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z]
        .into_iter()
        .enumerate()
        .map(|(i, n)| plane(&format!("side {i}"), n, 1.0 + n.dot(center)))
        .collect()
}

/// Planes that touch the sphere of radius `radius` about `centre`, spread evenly (golden spiral).
fn sphere(count: usize, radius: f64, center: DVec3) -> Vec<HalfSpace> {
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    (0..count)
        .map(|i| {
            let z = 1.0 - (2.0 * i as f64 + 1.0) / count as f64;
            let (sin, cos) = (golden * i as f64).sin_cos();
            let r = (1.0 - z * z).sqrt();
            let normal = DVec3::new(r * cos, r * sin, z);
            plane(&format!("facet {i}"), normal, radius + normal.dot(center))
        })
        .collect()
}

fn error(half_spaces: &[HalfSpace]) -> String {
    Solid::from_half_spaces(half_spaces).unwrap_err().to_string()
}

fn assert_outward(solid: &Solid) {
    for facet in &solid.facets {
        assert!(solid.facet_area(facet) > 0.0, "{} is wound inwards", facet.half_space.name);
        for v in &solid.vertices {
            let height = facet.half_space.normal.dot(*v) - facet.half_space.distance;
            assert!(height < 1e-8, "a corner lies {height} outside {}", facet.half_space.name);
        }
    }
}

#[test]
fn cube_is_measured_wherever_it_stands() {
    for center in [DVec3::ZERO, DVec3::new(7.0, -3.0, 5.0)] {
        let solid = Solid::from_half_spaces(&cube(center)).unwrap();
        assert_eq!((solid.vertices.len(), solid.facets.len(), solid.edges().count()), (8, 6, 12));
        assert!((solid.volume() - 8.0).abs() < 1e-10);
        assert!((solid.area() - 24.0).abs() < 1e-10);
        assert!((solid.extents() - DVec3::splat(2.0)).abs().max_element() < 1e-10);
        assert_eq!(solid.triangles().count(), 12);
        assert_outward(&solid);
    }
}

#[test]
fn regular_bodies_have_their_textbook_volumes() {
    let signs = || (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(|b| f64::from(1 - 2 * b)));
    let octahedron: Vec<_> = signs().map(|s| plane("face", DVec3::from(s), 1.0)).collect();
    let solid = Solid::from_half_spaces(&octahedron).unwrap();
    // |x| + |y| + |z| ≤ 1: volume 4/3, area 4√3. Its normals are not of unit length.
    assert_eq!((solid.vertices.len(), solid.facets.len()), (6, 8));
    assert!((solid.volume() - 4.0 / 3.0).abs() < 1e-12);
    assert!((solid.area() - 4.0 * 3.0_f64.sqrt()).abs() < 1e-12);
    assert!(solid.facets.iter().all(|f| (f.half_space.normal.length() - 1.0).abs() < 1e-15));

    let golden = f64::midpoint(1.0, 5.0_f64.sqrt());
    let dodecahedron: Vec<_> = (0..12)
        .map(|i| {
            let (a, b) = (f64::from(1 - 2 * (i & 1)), golden * f64::from(1 - 2 * (i >> 1 & 1)));
            let n = [DVec3::new(0.0, a, b), DVec3::new(b, 0.0, a), DVec3::new(a, b, 0.0)]
                [i as usize / 4];
            plane("face", n.try_normalize().unwrap(), 1.0)
        })
        .collect();
    let solid = Solid::from_half_spaces(&dodecahedron).unwrap();
    assert_eq!((solid.vertices.len(), solid.edges().count()), (20, 30));
    // Volume over inradius³ of the regular dodecahedron: 10·√(130 − 58√5).
    let expected = 10.0 * (130.0 - 58.0 * 5.0_f64.sqrt()).sqrt();
    assert!((solid.volume() / expected - 1.0).abs() < 1e-12, "{}", solid.volume());
}

#[test]
fn many_facets_approach_the_sphere() {
    let planes = sphere(300, 3.0, DVec3::new(20.0, 0.0, -9.0));
    let solid = Solid::from_half_spaces(&planes).unwrap();
    assert_eq!((solid.facets.len(), solid.euler_characteristic()), (300, 2));
    assert!(solid.dropped.is_empty());
    assert_outward(&solid);
    // Every facet touches the sphere, so V = r·A/3 whatever their number.
    assert!((solid.volume() / (3.0 * solid.area() / 3.0) - 1.0).abs() < 1e-12);
    let ball = 36.0 * std::f64::consts::PI;
    assert!(solid.volume() > ball && solid.volume() < 1.02 * ball);
}

#[test]
fn order_and_rotation_change_nothing() {
    let planes = sphere(97, 2.0, DVec3::ZERO);
    let volume = Solid::from_half_spaces(&planes).unwrap().volume();
    let rotation = DQuat::from_euler(glam::EulerRot::XYZ, 0.3, 1.1, -2.0);
    let mut turned: Vec<_> =
        planes.iter().map(|p| plane(&p.name, rotation * p.normal, p.distance)).collect();
    turned.reverse();
    let solid = Solid::from_half_spaces(&turned).unwrap();
    assert!((solid.volume() / volume - 1.0).abs() < 1e-11);
    assert_eq!(solid.facets.len(), 97);
}

#[test]
fn planes_that_bound_nothing_are_dropped_by_name() {
    let mut planes = cube(DVec3::ZERO);
    planes.push(plane("beyond", DVec3::ONE, 9.0));
    planes.insert(0, plane("twin of side 0", DVec3::X, 1.0));
    planes.push(plane("touching a corner", DVec3::ONE, 3.0));
    planes.push(plane("touching an edge", DVec3::new(1.0, 1.0, 0.0), 2.0));
    planes.insert(0, plane("cut away later", DVec3::new(1.0, 0.0, 0.2), 2.0));
    let solid = Solid::from_half_spaces(&planes).unwrap();
    assert_eq!(solid.facets.len(), 6);
    assert_eq!(
        solid.dropped,
        ["cut away later", "side 0", "beyond", "touching a corner", "touching an edge"]
    );
}

#[test]
fn what_does_not_close_is_named() {
    let mut open = cube(DVec3::ZERO);
    open.remove(5);
    let text = error(&open);
    assert!(text.contains("open towards −z"), "{text}");
    assert!(text.contains("side 0") && text.contains("3 more"), "{text}");
    assert!(error(&[]).contains("no facets"));
    let slab = [plane("top", DVec3::Z, 1.0), plane("bottom", DVec3::NEG_Z, 1.0)];
    assert!(error(&slab).contains("+x (right)"));
}

#[test]
fn an_empty_intersection_names_the_facet_that_empties_it() {
    let mut planes = cube(DVec3::ZERO);
    planes.push(plane("far side", DVec3::X, -2.0));
    assert!(error(&planes).contains("facet 'far side' leaves nothing"));
    planes.pop();
    planes.push(plane("flush", DVec3::X, -1.0));
    assert!(error(&planes).contains("facet 'flush' leaves nothing"));
}

#[test]
fn unusable_planes_are_refused() {
    for bad in [
        plane("zero", DVec3::ZERO, 1.0),
        plane("nan", DVec3::new(f64::NAN, 0.0, 1.0), 1.0),
        plane("endless", DVec3::new(f64::INFINITY, 0.0, 0.0), 1.0),
        plane("far", DVec3::X, f64::INFINITY),
        plane("unknown", DVec3::X, f64::NAN),
        plane("tiny", DVec3::new(1e-320, 0.0, 0.0), 1.0),
    ] {
        let name = bad.name.clone();
        let mut planes = cube(DVec3::ZERO);
        planes.push(bad);
        let text = error(&planes);
        assert!(text.contains(&format!("facet '{name}'")), "{name}: {text}");
    }
    let many = vec![plane("facet", DVec3::X, 1.0); Solid::MAX_HALF_SPACES + 1];
    assert!(error(&many).contains("too many"));
}

#[test]
fn random_planes_close_or_say_why() {
    let mut state = 7_u64;
    let mut random = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut closed = 0;
    for round in 0..2000 {
        let count = 4 + round % 60;
        // Coarse values make planes coincide and meet in common points.
        let mut coarse = |steps: f64| ((random() * 2.0 - 1.0) * steps).round() / steps;
        let planes: Vec<_> = (0..count)
            .map(|i| {
                let normal = DVec3::new(coarse(4.0), coarse(4.0), coarse(4.0));
                plane(&format!("facet {i}"), normal, coarse(3.0).abs() + 0.5)
            })
            .filter(|p| p.normal != DVec3::ZERO)
            .collect();
        match Solid::from_half_spaces(&planes) {
            Ok(solid) => {
                closed += 1;
                assert_eq!(solid.euler_characteristic(), 2);
                assert_eq!(solid.facets.len() + solid.dropped.len(), planes.len());
                assert_outward(&solid);
            }
            Err(fault) => assert!(fault.to_string().contains("open towards"), "{fault}"),
        }
    }
    assert!(closed > 1000, "{closed}");
}
