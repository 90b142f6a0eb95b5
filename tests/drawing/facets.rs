//! Classes, angles and sizes are those of the cut.

use brilliance_renderer::cuts::{RoundBrilliant, StandardProportions};
use brilliance_renderer::drawing::{BodyMeasures, FacetClass, FacetedBody, Zone, facet_diagram};
use glam::Vec3;

use crate::bodies::*;

fn cuts() -> Vec<RoundBrilliant> {
    let mut cuts: Vec<_> =
        StandardProportions::ALL.into_iter().map(|set| set.of_diameter(6.5)).collect();
    cuts.push(RoundBrilliant { culet: 0.05, ..RoundBrilliant::default() });
    cuts
}

/// Fig. 6 of the paper: 57 facets, of which one is the octagonal table, 16 are kites, and the other
/// 40 are triangles; here with 16 flats of the girdle.
#[test]
fn the_classes_of_a_brilliant_are_those_of_figure_6() {
    for cut in cuts() {
        let measures = cut.measures().unwrap();
        let mut expected = vec![
            ("table", Zone::Crown, 1, 0.0),
            ("star", Zone::Crown, 8, measures.star_angle_degrees),
            ("bezel", Zone::Crown, 8, f64::from(cut.crown_angle_degrees)),
            ("upper half", Zone::Crown, 16, measures.upper_half_angle_degrees),
            ("girdle", Zone::Girdle, 16, 90.0),
            ("lower half", Zone::Pavilion, 16, measures.lower_half_angle_degrees),
            ("main", Zone::Pavilion, 8, f64::from(cut.pavilion_angle_degrees)),
        ];
        if cut.culet > 0.0 {
            expected.push(("culet", Zone::Pavilion, 1, 0.0));
        }
        let classes = FacetClass::all(&FacetedBody::of(&brilliant(cut)).unwrap());
        assert_eq!(classes.len(), expected.len());
        for (class, (name, zone, count, angle)) in classes.iter().zip(expected) {
            assert_eq!((class.name.as_str(), class.zone), (name, zone));
            assert_eq!(class.facets.len(), count, "{name}");
            assert!((class.angle_degrees - angle).abs() < 1e-5, "{name}: {}", class.angle_degrees);
        }
        let polished = classes.iter().filter(|class| class.zone != Zone::Girdle);
        let polished: usize = polished.map(|class| class.facets.len()).sum();
        assert_eq!(polished, if cut.culet > 0.0 { 58 } else { 57 });
    }
}

#[test]
fn every_class_of_a_brilliant_stands_on_its_drawing_with_its_angle() {
    for cut in cuts() {
        let object = brilliant(cut);
        let sheet = facet_diagram(&object).unwrap();
        let texts: Vec<&str> = sheet.words().map(|words| words.text.as_str()).collect();
        for class in FacetClass::all(&FacetedBody::of(&object).unwrap()) {
            let angle = class.angle_text();
            let label = format!("{} {angle}", class.name);
            let on_one_line = texts.contains(&label.as_str());
            let on_two = texts.windows(2).any(|pair| pair == [class.name.as_str(), &angle]);
            assert!(on_one_line || on_two, "no {label} in {texts:?}");
        }
    }
}

#[test]
fn sizes_are_those_of_the_construction() {
    for cut in cuts() {
        let body = FacetedBody::of(&brilliant(cut)).unwrap();
        let sizes = BodyMeasures::of(&body, &FacetClass::all(&body));
        let (measures, diameter) = (cut.measures().unwrap(), f64::from(cut.diameter_mm));
        for (measured, expected) in [
            (sizes.width, 1.0),
            (sizes.length, 1.0),
            (sizes.depth, measures.total_depth),
            (sizes.crown_height().unwrap(), measures.crown_height),
            (sizes.pavilion_depth().unwrap(), measures.pavilion_depth),
            (sizes.table_size().unwrap(), f64::from(cut.table)),
        ] {
            let off = (measured / diameter - expected).abs();
            assert!(off < 1e-6, "{measured} mm are not {expected} of {diameter}");
        }
    }
}

/// The shipped spinel is an octahedron with bevelled edges: its faces stand at arccos(1/√3) =
/// 54.74° to the girdle plane.
#[test]
fn a_mesh_without_names_is_classed_by_zone_and_angle() {
    let body = FacetedBody::of(&octahedron()).unwrap();
    assert!(body.is_convex);
    let classes = FacetClass::all(&body);
    let magic = (1.0 / 3.0_f64.sqrt()).acos().to_degrees();
    for zone in [Zone::Crown, Zone::Pavilion] {
        let faces: Vec<_> = classes
            .iter()
            .filter(|class| class.zone == zone && (class.angle_degrees - magic).abs() < 0.01)
            .collect();
        let [faces] = faces[..] else { panic!("{} classes of faces", faces.len()) };
        assert_eq!(faces.facets.len(), 4);
        assert_eq!(faces.angle_text(), "54.74°");
    }
}

/// Scale is part of a stone's size, where it stands and how it is turned is not.
#[test]
fn a_stone_is_drawn_at_its_size_and_unturned() {
    let mut object = brilliant(RoundBrilliant::default());
    let before = BodyMeasures::of(&FacetedBody::of(&object).unwrap(), &[]);
    object.transform.scale = 2.0;
    object.transform.translation = Vec3::new(5.0, 6.0, 7.0);
    object.transform.rotation = glam::Quat::from_rotation_x(1.0);
    let after = BodyMeasures::of(&FacetedBody::of(&object).unwrap(), &[]);
    assert!((after.width - 2.0 * before.width).abs() < 1e-9);
    assert!((after.z[1] - 2.0 * before.z[1]).abs() < 1e-9);
}

#[test]
fn what_can_not_be_drawn_is_refused_by_name_with_the_remedy() {
    let open = mesh(vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z], vec![[0, 2, 1], [0, 1, 3]]);
    let bad_cut = brilliant(RoundBrilliant { table: 2.0, ..RoundBrilliant::default() });
    for (object, word) in [(open, "close it"), (bad_cut, "choose"), (wavy(), "smooth surfaces")] {
        let fault = facet_diagram(&object).unwrap_err().to_string();
        assert!(fault.starts_with(&object.name) && fault.contains(word), "{fault}");
    }
}

/// A sphere of more triangles than a drawing may have facets.
fn wavy() -> brilliance_renderer::scene::Object {
    let (rows, columns) = (60_u32, 90_u32);
    let mut positions = vec![Vec3::Z, Vec3::NEG_Z];
    for row in 1..rows {
        let (ring, z) = (std::f32::consts::PI * row as f32 / rows as f32).sin_cos();
        for column in 0..columns {
            let around = std::f32::consts::TAU * column as f32 / columns as f32;
            positions.push(Vec3::new(ring * around.cos(), ring * around.sin(), z));
        }
    }
    let at = |row: u32, column: u32| 2 + (row - 1) * columns + column % columns;
    let mut triangles = Vec::new();
    for column in 0..columns {
        triangles.push([0, at(1, column), at(1, column + 1)]);
        triangles.push([1, at(rows - 1, column + 1), at(rows - 1, column)]);
        for row in 1..rows - 1 {
            let [a, b] = [at(row, column), at(row, column + 1)];
            let [c, d] = [at(row + 1, column), at(row + 1, column + 1)];
            triangles.extend([[a, c, b], [b, c, d]]);
        }
    }
    mesh(positions, triangles)
}
