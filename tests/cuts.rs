//! The round brilliant against independently computed stones, and over its whole range.

#![expect(clippy::unwrap_used, reason = "a test ends where it fails, in its helpers too")]

use brilliance_renderer::cuts::{RoundBrilliant, StandardProportions};
use brilliance_renderer::mesh::Mesh;
use brilliance_renderer::solid::Solid;
use serde_json::Value;

const REFERENCE: &str = include_str!("reference/round_brilliant_reference.json");

const SETS: [(StandardProportions, &str); 5] = [
    (StandardProportions::Tolkowsky, "tolkowsky1919"),
    (StandardProportions::ModernIdeal, "modern_ideal"),
    (StandardProportions::GiaChart, "gia_default"),
    (StandardProportions::Scandinavian, "eurocut_scandinavian"),
    (StandardProportions::PracticalFineCut, "practical_fine"),
];

fn solid(cut: &RoundBrilliant) -> Solid {
    Solid::from_half_spaces(&cut.half_spaces().unwrap()).unwrap()
}

fn assert_close(name: &str, value: f64, expected: f64, relative: f64) {
    assert!((value / expected - 1.0).abs() < relative, "{name}: {value}, expected {expected}");
}

#[test]
fn angles_and_heights_match_the_reference() {
    let reference: Value = serde_json::from_str(REFERENCE).unwrap();
    for (set, key) in SETS {
        let expected = |field: &str| reference[key][field].as_f64().unwrap();
        let measures = set.of_diameter(6.5).measures().unwrap();
        for (field, value) in [
            ("star_angle", measures.star_angle_degrees),
            ("upper_half_angle", measures.upper_half_angle_degrees),
            ("lower_half_angle", measures.lower_half_angle_degrees),
            ("crown_height_pct", measures.crown_height * 100.0),
            ("pav_depth_pct", measures.pavilion_depth * 100.0),
            ("total_depth_pct", measures.total_depth * 100.0),
        ] {
            assert_close(&format!("{key} {field}"), value, expected(field), 1e-9);
        }
    }
}

#[test]
fn solids_match_the_reference() {
    let reference: Value = serde_json::from_str(REFERENCE).unwrap();
    for (set, key) in SETS {
        let expected = |field: &str| reference[key][field].as_f64().unwrap();
        // The reference stones have a girdle radius of 1.
        let solid = solid(&set.of_diameter(2.0));
        assert_eq!(solid.vertices.len() as f64, expected("verts"), "{key}");
        assert_eq!(solid.facets.len() as f64, expected("facets_used"), "{key}");
        assert!(solid.dropped.is_empty(), "{key}: {:?}", solid.dropped);
        assert_close(key, solid.volume(), expected("volume"), 1e-7);
        let size = solid.extents();
        let width = size.x.min(size.y);
        assert_close(key, size.z / width, expected("H_over_W"), 1e-7);
        assert_close(key, solid.volume() / width.powi(3), expected("vol_over_W3"), 1e-7);
        let table = solid.facets.iter().find(|f| f.half_space.name == "table").unwrap();
        let corner = solid.vertices[table.vertices[0] as usize];
        assert_close(key, corner.truncate().length(), expected("table_corner_radius"), 1e-7);
    }
}

#[test]
fn facets_are_named_and_counted() {
    let solid = solid(&RoundBrilliant::default());
    let count = |kind: &str| {
        solid
            .facets
            .iter()
            .filter(|f| f.half_space.name.trim_end_matches(char::is_numeric).trim_end() == kind)
            .count()
    };
    let kinds = ["table", "star", "bezel", "upper half", "girdle", "lower half", "main"];
    assert_eq!(kinds.map(count), [1, 8, 8, 16, 16, 16, 8]);
    let first_main = solid.facets.iter().find(|f| f.half_space.name == "main 1").unwrap();
    let normal = first_main.half_space.normal;
    assert!(normal.x.abs() < 1e-12 && normal.y > 0.0 && normal.z < 0.0, "{normal}");
}

#[test]
fn a_culet_is_the_58th_facet() {
    for culet in [0.005, 0.02, 0.1] {
        let cut = RoundBrilliant { culet, ..RoundBrilliant::default() };
        let solid = solid(&cut);
        let polished =
            solid.facets.iter().filter(|f| !f.half_space.name.starts_with("girdle")).count();
        assert_eq!(polished, 58);
        let face = solid.facets.iter().find(|f| f.half_space.name == "culet").unwrap();
        assert_eq!(face.vertices.len(), 8);
        let corner = solid.vertices[face.vertices[0] as usize];
        assert_close("culet", corner.truncate().length(), 3.25 * f64::from(culet), 1e-6);
        let depth = cut.measures().unwrap().total_depth * 6.5;
        assert_close("depth", solid.extents().z, depth, 1e-9);
    }
}

#[test]
fn the_default_is_the_practical_fine_cut_of_one_carat() {
    let cut = RoundBrilliant::default();
    assert_eq!(cut, StandardProportions::PracticalFineCut.of_diameter(6.5));
    // Diamond weighs 3.52 g/cm³ and a carat is 0.2 g.
    let carats = solid(&cut).volume() * 3.52e-3 / 0.2;
    assert!((carats - 1.0).abs() < 0.05, "{carats}");
}

#[test]
fn named_sets_are_complete() {
    assert_eq!(StandardProportions::ALL.len(), SETS.len());
    for set in StandardProportions::ALL {
        assert!(SETS.iter().any(|(known, _)| *known == set));
        assert!(!set.name().is_empty() && !set.source().is_empty());
    }
}

#[test]
fn values_out_of_range_are_named() {
    let base = RoundBrilliant::default();
    for (cut, name) in [
        (RoundBrilliant { diameter_mm: 0.0, ..base }, "diameter"),
        (RoundBrilliant { table: 1.2, ..base }, "table"),
        (RoundBrilliant { crown_angle_degrees: f32::NAN, ..base }, "crown angle"),
        (RoundBrilliant { pavilion_angle_degrees: 90.0, ..base }, "pavilion angle"),
        (RoundBrilliant { star_length: -0.5, ..base }, "star length"),
        (RoundBrilliant { lower_half_length: f32::INFINITY, ..base }, "lower half length"),
        (RoundBrilliant { girdle_thickness: 0.0, ..base }, "girdle thickness"),
        (RoundBrilliant { culet: 0.9, ..base }, "culet"),
    ] {
        let text = cut.half_spaces().unwrap_err().to_string();
        assert!(text.contains(&format!("the {name} is")) && text.contains("choose"), "{text}");
        assert!(cut.measures().is_err());
    }
}

#[test]
fn stars_too_short_for_the_table_get_advice_that_works() {
    let cut = RoundBrilliant { table: 0.8, star_length: 0.4, ..RoundBrilliant::default() };
    let text = cut.half_spaces().unwrap_err().to_string();
    let advice = text.split("star length of ").nth(1).unwrap().split(' ').next().unwrap();
    let star_length: f32 = advice.parse().unwrap();
    let better = RoundBrilliant { star_length, ..cut };
    assert_eq!(solid(&better).facets.len(), 73);
    let shorter = RoundBrilliant { star_length: star_length - 0.02, ..cut };
    assert!(shorter.half_spaces().is_err());
}

#[test]
fn every_corner_of_the_sliders_closes_or_says_why() {
    let mut state = 1_u64;
    let mut random = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1 << 24) as f32
    };
    // A third of the values are the very ends of their ranges.
    let mut pick = |range: std::ops::RangeInclusive<f32>| {
        let (low, high) = range.into_inner();
        (low + (high - low) * (random() * 1.5 - 0.25)).clamp(low, high)
    };
    let (mut closed, mut refused) = (0, 0);
    for _ in 0..4000 {
        let cut = RoundBrilliant {
            diameter_mm: pick(RoundBrilliant::DIAMETER_MM),
            table: pick(RoundBrilliant::TABLE),
            crown_angle_degrees: pick(RoundBrilliant::CROWN_ANGLE_DEGREES),
            pavilion_angle_degrees: pick(RoundBrilliant::PAVILION_ANGLE_DEGREES),
            star_length: pick(RoundBrilliant::STAR_LENGTH),
            lower_half_length: pick(RoundBrilliant::LOWER_HALF_LENGTH),
            girdle_thickness: pick(RoundBrilliant::GIRDLE_THICKNESS),
            culet: pick(RoundBrilliant::CULET),
        };
        match cut.half_spaces() {
            Ok(half_spaces) => {
                closed += 1;
                let solid = Solid::from_half_spaces(&half_spaces)
                    .unwrap_or_else(|fault| panic!("{cut:?}: {fault}"));
                assert!(solid.dropped.is_empty(), "{cut:?}: {:?}", solid.dropped);
                let mesh = Mesh::from_solid(&solid).unwrap();
                mesh.closed().unwrap_or_else(|fault| panic!("{cut:?}: {fault}"));
                assert_close("mesh volume", mesh.volume(), solid.volume(), 1e-4);
            }
            Err(fault) => {
                refused += 1;
                assert!(fault.to_string().contains("star length"), "{fault}");
            }
        }
    }
    assert!(closed > 2000 && refused > 100, "{closed} closed, {refused} refused");
}
