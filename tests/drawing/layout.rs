//! Nothing on a sheet lies on anything else.

use brilliance_renderer::cuts::{RoundBrilliant, StandardProportions};
use brilliance_renderer::drawing::{Rect, Sheet, facet_diagram};
use brilliance_renderer::scene::{Object, Shape};
use glam::DVec2;

use crate::bodies::*;

/// Texts keep clear of each other, of every line and of the paper's rim.
fn assert_readable(sheet: &Sheet, what: &str) {
    let paper = Rect { min: DVec2::ZERO, max: sheet.size_mm }.grown(-4.0);
    let words: Vec<_> = sheet.words().map(|words| (&words.text, words.bounds())).collect();
    assert!(words.len() > 10, "{what}");
    for (index, (text, room)) in words.iter().enumerate() {
        assert!(paper.contains(room), "{what}: {text:?} leaves the paper at {room:?}");
        for (other, other_room) in &words[..index] {
            assert!(!room.overlaps(other_room), "{what}: {text:?} lies on {other:?}");
        }
        for stroke in sheet.strokes() {
            for line in stroke.points.windows(2) {
                let crossed = room.is_crossed_by([line[0], line[1]]);
                assert!(!crossed, "{what}: a line from {} crosses {text:?} at {room:?}", line[0]);
            }
        }
    }
    for stroke in sheet.strokes() {
        for point in &stroke.points {
            assert!(point.is_finite() && paper.grown(2.0).min.cmple(*point).all(), "{what}");
            assert!(paper.grown(2.0).max.cmpge(*point).all(), "{what}: {point}");
        }
    }
}

fn assert_object_readable(object: &Object, what: &str) {
    assert_readable(&facet_diagram(object).unwrap(), what);
}

#[test]
fn brilliants_of_all_proportions_can_be_read() {
    let mut drawn = 0;
    for table in [0.3, 0.56, 0.8] {
        for crown in [8.0, 34.5, 55.0] {
            for pavilion in [15.0, 40.75, 60.0] {
                for (girdle, culet) in [(0.001, 0.0), (0.03, 0.02), (0.2, 0.4)] {
                    for (star, lower) in [(0.5, 0.75), (0.9, 0.1)] {
                        let cut = RoundBrilliant {
                            diameter_mm: 6.5,
                            table,
                            crown_angle_degrees: crown,
                            pavilion_angle_degrees: pavilion,
                            star_length: star,
                            lower_half_length: lower,
                            girdle_thickness: girdle,
                            culet,
                        };
                        if let Ok(sheet) = facet_diagram(&brilliant(cut)) {
                            assert_readable(&sheet, &format!("{cut:?}"));
                            drawn += 1;
                        }
                    }
                }
            }
        }
    }
    assert!(drawn > 100, "{drawn}");
}

#[test]
fn published_proportions_can_be_read() {
    for set in StandardProportions::ALL {
        for diameter in [0.5, 6.5, 100.0] {
            let object = brilliant(set.of_diameter(diameter));
            assert_object_readable(&object, &format!("{} {diameter} mm", set.name()));
        }
    }
}

#[test]
fn other_bodies_can_be_read() {
    assert_object_readable(&step_cut(), "step cut");
    assert_object_readable(&octahedron(), "octahedron");
    assert_object_readable(&c_beam(), "C beam");
    for sides in [3, 5, 12, 64] {
        let stone = tiers(sides, &[(30.0, 2.0), (90.0, 3.0), (-42.0, 2.6)], 1.2);
        assert_object_readable(&stone, &format!("{sides} sides"));
    }
    for object in shipped() {
        assert_object_readable(&object, &object.name);
    }
}

/// More classes than there are places for: the rest is told by number.
#[test]
fn hundreds_of_classes_and_long_names_can_be_read() {
    let many: Vec<(f64, f64)> =
        (1..60).map(|k| (f64::from(k) * 1.5, 3.0 - 0.000_1 * f64::from(k))).collect();
    let below: Vec<(f64, f64)> = many.iter().map(|(angle, distance)| (-angle, *distance)).collect();
    let mut object = tiers(4, &[many, below].concat(), 2.9);
    object.name = "A name that is so long that it can stand nowhere on a sheet of paper".repeat(3);
    let sheet = facet_diagram(&object).unwrap();
    assert_readable(&sheet, "many classes");
    assert!(sheet.words().any(|words| words.text.ends_with(" more")));
}

#[test]
fn long_names_of_facets_can_be_read() {
    let stones = [step_cut(), tiers(8, &[(30.0, 2.0), (90.0, 3.0), (-42.0, 2.6)], 1.2)];
    for mut object in stones {
        let Shape::Polyhedron(planes) = &mut object.shape else { panic!("a polyhedron") };
        for plane in planes {
            plane.name =
                format!("A name as nobody would give to a facet, {}", plane.name.repeat(9));
        }
        let sheet = facet_diagram(&object).unwrap();
        assert_readable(&sheet, "long names");
        assert!(sheet.words().any(|words| words.text.contains("… ")), "one beside the side view");
    }
}

/// The slowest bodies that may be drawn: each facet is tried for a label, behind all others.
#[test]
fn the_largest_hollow_body_can_be_read_and_larger_ones_are_refused() {
    for (around, across) in [(32, 16), (128, 4), (16, 32)] {
        assert_object_readable(&torus(around, across), &format!("torus {around} × {across}"));
    }
    let fault = facet_diagram(&torus(33, 16)).unwrap_err().to_string();
    assert!(fault.contains("528 flat facets") && fault.contains("512"), "{fault}");
    let below: Vec<(f64, f64)> = (10..80).map(|angle| (-f64::from(angle), 3.0)).collect();
    let fault = facet_diagram(&tiers(8, &below, 1.0)).unwrap_err().to_string();
    assert!(fault.contains("facets, and") && fault.contains("fewer facets"), "{fault}");
}

#[test]
fn the_same_stone_gives_the_same_sheet() {
    let draw = || facet_diagram(&step_cut()).unwrap();
    assert_eq!(draw(), draw());
}
