//! Dispersion models and the material library against published indices.

use std::collections::BTreeMap;

use brilliance_renderer::material::{Dispersion, SellmeierTerm, find, library};
use serde::Deserialize;

/// Values computed from the same coefficients by an independent program, at the lines
/// B 686.72, C 656.28, D 589.3, F 486.13 and G 430.79 nm.
#[derive(Deserialize)]
struct Reference {
    n_d: f64,
    b_g: f64,
    f_c: f64,
}

fn references() -> BTreeMap<String, Reference> {
    #[derive(Deserialize)]
    struct WithFile {
        file: String,
        #[serde(flatten)]
        reference: Reference,
    }
    let text = include_str!("reference/measured_indices.json");
    let all: BTreeMap<String, WithFile> =
        serde_json::from_str(text).expect("the reference file is JSON");
    assert!(all.values().all(|entry| !entry.file.is_empty()));
    all.into_iter().map(|(name, entry)| (name, entry.reference)).collect()
}

fn assert_close(got: f64, want: f64, tolerance: f64, what: &str) {
    assert!((got - want).abs() <= tolerance, "{what}: {got}, not {want} ± {tolerance}");
}

#[test]
fn measured_curves_match_the_reference_values() {
    let references = references();
    let measured = library().iter().filter(|material| material.measurement.is_some());
    let mut checked = 0;
    for material in measured {
        let reference = &references[&material.name];
        let n = |lambda_nm| material.dispersion.n(lambda_nm);
        // Chrysoberyl's λ² term is written as a far resonance, good to 1e-8.
        assert_close(n(589.3), reference.n_d, 1e-8, &material.name);
        assert_close(n(430.79) - n(686.72), reference.b_g, 1e-8, &material.name);
        assert_close(n(486.13) - n(656.28), reference.f_c, 1e-8, &material.name);
        checked += 1;
    }
    assert_eq!(checked, references.len());
}

#[test]
fn diamond_has_its_published_indices() {
    // What gemmologists quote: B 2.407, D 2.417, G 2.451, of which the .044 is the difference.
    let diamond = &find("diamond").unwrap().dispersion;
    assert_close(diamond.n(686.7), 2.407, 1e-3, "n_B");
    assert_close(diamond.n(589.3), 2.417, 5e-4, "n_D");
    assert_close(diamond.n(430.8), 2.451, 1e-3, "n_G");
    // Critical angle of diamond: 24.4°.
    assert_close((1.0 / diamond.n_d()).asin().to_degrees(), 24.44, 0.02, "critical angle");
}

#[test]
fn glasses_have_the_abbe_numbers_of_their_data_sheets() {
    // SCHOTT data sheets: N-BK7 517642, SF11 785258.
    assert_close(find("N-BK7").unwrap().dispersion.abbe_number(), 64.17, 0.005, "N-BK7");
    assert_close(find("SF11").unwrap().dispersion.abbe_number(), 25.76, 0.005, "SF11");
    assert_close(find("SF11").unwrap().dispersion.n(587.56), 1.784_72, 1e-5, "SF11 n_d");
}

#[test]
fn the_curve_stands_near_the_gemmologists_figures() {
    for material in library() {
        let [low, high] = material.figures.index;
        let n_d = material.dispersion.n_d();
        assert!((low - 0.01..=high + 0.01).contains(&n_d), "{}: {n_d}", material.name);
        let ratio = material.dispersion.dispersion_bg() / material.figures.dispersion_bg;
        assert!((0.85..=1.2).contains(&ratio), "{}: B–G ratio {ratio}", material.name);
    }
}

#[test]
fn names_are_found_whatever_their_case_and_stand_for_one_material() {
    assert_eq!(find(" DIAMOND ").unwrap().name, "Diamond");
    assert_eq!(find("emerald").unwrap().name, "Beryl");
    assert!(find("kryptonite").is_none());
    for material in library() {
        for name in material.names() {
            assert_eq!(find(name).unwrap().name, material.name);
        }
    }
}

#[test]
fn linear_is_the_line_of_the_paper() {
    // Thomas 1986: n falls by δ from 431 to 687 nm, through n_D at 589 nm.
    let line = Dispersion::Linear { n_d: 2.417, dispersion_bg: 0.044 };
    assert_close(line.n(589.0), 2.417, 1e-15, "n_D");
    assert_close(line.n(431.0), 2.417 + 0.044 * 158.0 / 256.0, 1e-15, "n_G");
    assert_close(line.n(687.0), 2.417 - 0.044 * 98.0 / 256.0, 1e-15, "n_B");
}

#[test]
fn cauchy_from_passes_through_its_figures() {
    for (n_d, dispersion_bg) in [(1.5, 0.01), (2.417, 0.044), (2.6, 0.33), (1.3, 0.0)] {
        let curve = Dispersion::cauchy_from(n_d, dispersion_bg);
        assert_close(curve.n_d(), n_d, 1e-14, "n_D");
        assert_close(curve.dispersion_bg(), dispersion_bg, 1e-14, "B–G");
    }
}

#[test]
fn rescaled_curves_pass_through_their_figures_and_keep_their_shape() {
    for material in library() {
        let old = &material.dispersion;
        let new = old.rescaled(1.9, 0.06);
        assert_close(new.n_d(), 1.9, 1e-12, &material.name);
        assert_close(new.dispersion_bg(), 0.06, 1e-12, &material.name);
        let shape = |curve: &Dispersion| (curve.n(500.0) - curve.n_d()) / curve.dispersion_bg();
        assert_close(shape(&new), shape(old), 1e-9, &material.name);
        new.validate().unwrap();
    }
    let same = find("Sapphire").unwrap().dispersion.clone();
    let again = same.rescaled(same.n_d(), same.dispersion_bg());
    for lambda_nm in 380..=730 {
        assert_close(again.n(lambda_nm.into()), same.n(lambda_nm.into()), 1e-12, "unchanged");
    }
}

#[test]
fn tables_are_straight_between_and_beyond_their_values() {
    let table =
        Dispersion::Tabulated { lambda_nm: vec![400.0, 500.0, 700.0], n: vec![1.6, 1.5, 1.4] };
    table.validate().unwrap();
    assert_close(table.n(450.0), 1.55, 1e-14, "between");
    assert_close(table.n(500.0), 1.5, 1e-14, "at");
    assert_close(table.n(380.0), 1.62, 1e-14, "below");
    assert_close(table.n(720.0), 1.39, 1e-14, "above");
}

#[test]
fn impossible_models_are_refused_with_the_reason() {
    let term = |strength, resonance_um2| SellmeierTerm { strength, resonance_um2 };
    let table = |lambda_nm: &[f64], n: &[f64]| Dispersion::Tabulated {
        lambda_nm: lambda_nm.to_vec(),
        n: n.to_vec(),
    };
    let refused = [
        (Dispersion::Linear { n_d: 0.9, dispersion_bg: 0.0 }, "index of refraction"),
        (Dispersion::Linear { n_d: 1.5, dispersion_bg: 9.0 }, "index of refraction"),
        (Dispersion::Linear { n_d: f64::NAN, dispersion_bg: 0.0 }, "index of refraction"),
        (Dispersion::Cauchy { a: f64::INFINITY, b_nm2: 0.0 }, "index of refraction"),
        (Dispersion::Sellmeier { constant: -3.0, terms: vec![] }, "index of refraction"),
        (Dispersion::Sellmeier { constant: 0.0, terms: vec![term(1e-9, 0.25)] }, "resonance"),
        (table(&[400.0], &[1.5]), "at least two"),
        (table(&[400.0, 500.0], &[1.5]), "2 wavelengths but 1 indices"),
        (table(&[500.0, 400.0], &[1.5, 1.5]), "must increase"),
        (table(&[400.0, 400.0], &[1.5, 1.6]), "must increase"),
        (table(&[400.0, f64::NAN], &[1.5, 1.6]), "must increase"),
        // A spike between two whole nanometres.
        (
            table(&[380.0, 500.2, 500.3, 500.4, 730.0], &[1.5, 1.5, 7.0, 1.5, 1.5]),
            "index of refraction is 7",
        ),
    ];
    for (model, reason) in refused {
        let fault = model.validate().unwrap_err();
        assert!(fault.contains(reason), "{model:?}: {fault}");
    }
}
