//! Each control changes what it says it changes.

use std::f32::consts::PI;
use std::path::Path;

use brilliance_renderer::cuts::StandardProportions;
use brilliance_renderer::light::DiscLight;
use brilliance_renderer::material::{Dispersion, Material, find};
use brilliance_renderer::rigs::rigs;
use brilliance_renderer::scene_file::{Document, scenes};
use brilliance_renderer::session::RenderRequest;
use brilliance_renderer::settings::{
    DisplaySettings, Splitting, ToneCurve, TraceSettings, WhitePoint,
};
use eframe::egui::{Event, Key, Modifiers, accesskit::Role, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _, by};

use crate::window::*;

/// Reads the value that a slider turns.
type Value = fn(&RenderRequest) -> f64;

#[test]
fn every_tracing_slider_changes_the_request() {
    let mut harness = harness();
    choose(&mut harness, "Splitting", "Paper (Thomas 1986)");
    let cases: [(&str, f64, f64, Value); 15] = [
        ("Diameter", 8.25, 8.25, |r| f64::from(brilliant(r).diameter_mm)),
        ("Table", 60.0, 0.6, |r| f64::from(brilliant(r).table)),
        ("Crown angle", 32.5, 32.5, |r| f64::from(brilliant(r).crown_angle_degrees)),
        ("Pavilion angle", 42.25, 42.25, |r| f64::from(brilliant(r).pavilion_angle_degrees)),
        ("Star length", 60.0, 0.6, |r| f64::from(brilliant(r).star_length)),
        ("Lower halves", 70.0, 0.7, |r| f64::from(brilliant(r).lower_half_length)),
        ("Girdle", 5.0, 0.05, |r| f64::from(brilliant(r).girdle_thickness)),
        ("Culet", 4.0, 0.04, |r| f64::from(brilliant(r).culet)),
        ("Split count", 9.0, 9.0, |r| f64::from(r.trace.split_count)),
        ("Significance", 1.0, 0.01, |r| f64::from(r.trace.significance_threshold)),
        ("Maximum depth", 12.0, 12.0, |r| f64::from(r.trace.max_depth)),
        ("Spectral bins", 32.0, 32.0, |r| f64::from(r.trace.bins)),
        ("Passes", 100.0, 100.0, |r| f64::from(r.pass_limit)),
        ("Noise target", 5.0, 0.05, |r| f64::from(r.noise.target)),
        ("Ambient", 0.5, 0.5, |r| f64::from(r.scene.lights.hemisphere.as_ref().unwrap().radiance)),
    ];
    for (label, shown, expected, value) in cases {
        let before = request(&harness);
        set(&mut harness, label, shown);
        let after = request(&harness);
        assert_ne!(before, after, "{label} made no request");
        let value = value(&after);
        assert!((value - expected).abs() < 1e-6 * expected, "{label} is {value}, not {expected}");
    }
}

#[test]
fn passes_and_noise_carry_on_with_the_film() {
    let mut harness = harness();
    let before = request(&harness);
    set(&mut harness, "Passes", 100.0);
    set(&mut harness, "Noise target", 3.0);
    harness.get_by_role_and_label(Role::CheckBox, "Adaptive").click();
    harness.run_steps(2);
    let after = request(&harness);
    assert_ne!(before.noise.is_adaptive, after.noise.is_adaptive);
    assert!(before != after && before.makes_same_film(&after));
}

#[test]
fn index_and_dispersion_change_the_material() {
    let mut harness = harness();
    set(&mut harness, "Refractive index", 1.76);
    set(&mut harness, "Dispersion B\u{2013}G", 0.1);
    let request = request(&harness);
    let Material::Dielectric(stone) = &request.scene.objects[0].material else {
        panic!("the stone is no longer clear")
    };
    assert!((stone.dispersion.n_d() - 1.76).abs() < 1e-9);
    assert!((stone.dispersion.dispersion_bg() - 0.1).abs() < 1e-9);
}

#[test]
fn lights_scale_together() {
    let mut harness = harness();
    let before = request(&harness).scene.lights.discs.clone();
    let irradiance = |discs: &[DiscLight]| {
        discs.iter().map(|disc| disc.radiance * disc.solid_angle_steradians()).sum::<f32>()
    };
    set(&mut harness, "Light size", 2.0);
    set(&mut harness, "Brightness", 5.0);
    let after = request(&harness).scene.lights.discs.clone();
    assert!((irradiance(&after) / (5.0 * PI) - 1.0).abs() < 1e-3);
    for (old, new) in before.iter().zip(&after) {
        assert_eq!(old.direction, new.direction);
    }
    let mean_radius =
        after.iter().map(|disc| disc.angular_radius_radians.to_degrees()).sum::<f32>()
            / after.len() as f32;
    assert!((mean_radius - 2.0).abs() < 1e-3, "{mean_radius}");

    set(&mut harness, "Observer shadow", 10.0);
    let shadow = request(&harness).scene.lights.observer_shadow_radians;
    assert!((shadow.to_degrees() - 10.0).abs() < 1e-3);
}

#[test]
fn switches_and_lists_change_the_request() {
    let mut harness = harness();
    choose(&mut harness, "Splitting", "Paper (Thomas 1986)");
    harness.get_by_role_and_label(Role::CheckBox, "Perturb sub-rays").click();
    harness.run_steps(2);
    assert!(!request(&harness).trace.perturb);

    harness.get_by_role_and_label(Role::CheckBox, "Throws light").click();
    harness.run_steps(2);
    assert!(request(&harness).scene.objects[0].throws_light);

    let had_backdrop = request(&harness).scene.lights.backdrop.is_some();
    harness.get_by_role_and_label(Role::CheckBox, "Plain backdrop").click();
    harness.run_steps(2);
    assert_ne!(request(&harness).scene.lights.backdrop.is_some(), had_backdrop);

    for rig in rigs() {
        choose(&mut harness, "Lights", rig.name);
        assert_eq!(request(&harness).scene.lights, (rig.lights)(), "{}", rig.name);
    }

    let sapphire = find("Sapphire").unwrap();
    choose(&mut harness, "Material", &sapphire.name);
    let expected = Material::Dielectric(sapphire.dielectric());
    assert_eq!(request(&harness).scene.objects[0].material, expected);

    choose(&mut harness, "Proportions", StandardProportions::Tolkowsky.name());
    let tolkowsky = StandardProportions::Tolkowsky.of_diameter(6.5);
    assert_eq!(brilliant(&request(&harness)), tolkowsky);
}

/// What belongs to the paper's splitting only is idle by the exact one, and keeps its value.
#[test]
fn the_splitting_can_be_chosen_and_taken_back() {
    let mut harness = harness();
    choose(&mut harness, "Splitting", "Paper (Thomas 1986)");
    let of_paper = request(&harness).trace;
    assert_eq!(of_paper.splitting, Splitting::Paper);
    let is_idle = |harness: &AppHarness| {
        let perturb = harness.get_by_role_and_label(Role::CheckBox, "Perturb sub-rays");
        let [split_count, roulette] = ["Split count", "Roulette"].map(|row| slider(harness, row));
        [perturb, split_count, roulette].map(|node| node.accesskit_node().is_disabled())
    };
    assert_eq!(is_idle(&harness), [false, false, true]);
    rest(&mut harness);

    choose(&mut harness, "Splitting", "Exact");
    let exact = TraceSettings { splitting: Splitting::Exact, ..of_paper.clone() };
    assert_eq!(request(&harness).trace, exact);
    harness.run_steps(2);
    assert_eq!(is_idle(&harness), [true, true, false]);
    rest(&mut harness);
    set(&mut harness, "Roulette", 1.0);
    assert!((request(&harness).trace.roulette_threshold - 0.01).abs() < 1e-8);
    harness.get(by().role(Role::Label).label("Split count").include_labels()).hover();
    harness.run_steps(60);
    harness.get_by_label_contains("Belongs to the paper's splitting");

    for expected in [exact, of_paper] {
        rest(&mut harness);
        harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        harness.run_steps(3);
        assert_eq!(request(&harness).trace, expected);
    }
}

#[test]
fn display_settings_make_no_request() {
    let mut harness = harness();
    let before = request(&harness);
    let requests = harness.state().session().requests_made();

    set(&mut harness, "Exposure", 1.5);
    assert_eq!(harness.state().document().display.exposure_ev, 1.5);
    choose(&mut harness, "Tone curve", "Linear");
    assert_eq!(harness.state().document().display.tone_curve, ToneCurve::Linear);
    choose(&mut harness, "White point", "Colour temperature");
    set(&mut harness, "Temperature", 4000.0);
    assert_eq!(harness.state().document().display.white_point, WhitePoint::Temperature(4000.0));
    harness.get_by_role_and_label(Role::CheckBox, "Gamut mapping").click();
    harness.run_steps(2);
    assert!(!harness.state().document().display.gamut_mapping);

    assert_ne!(harness.state().document().display, DisplaySettings::default());
    assert_eq!(request(&harness), before);
    assert_eq!(harness.state().session().requests_made(), requests);
}

#[test]
fn a_slider_follows_the_mouse_and_a_double_click_resets_it() {
    let mut harness = harness();
    choose(&mut harness, "Splitting", "Paper (Thomas 1986)");
    let default = f64::from(request(&harness).trace.split_count);
    let rect = slider(&harness, "Split count").rect();
    let target = rect.left_center() + vec2(0.75 * rect.width(), 0.0);
    harness.hover_at(rect.center());
    harness.drag_at(rect.center());
    harness.hover_at(target);
    harness.drop_at(target);
    harness.run_steps(3);
    assert!(request(&harness).trace.split_count > 15.0);

    rest(&mut harness);
    double_click(&mut harness, target);
    assert_eq!(f64::from(request(&harness).trace.split_count), default);

    set(&mut harness, "Split count", 3.0);
    rest(&mut harness);
    let label = harness.get(by().role(Role::Label).label("Split count").include_labels()).rect();
    double_click(&mut harness, label.center());
    assert_eq!(f64::from(request(&harness).trace.split_count), default);
}

#[test]
fn values_can_be_typed_with_their_unit() {
    let mut harness = harness();
    let field = harness.get_by_label("Crown angle value").rect().center();
    harness.hover_at(field);
    harness.drag_at(field);
    harness.drop_at(field);
    harness.run_steps(3);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.event(Event::Text("31,5°".to_owned()));
    harness.key_press(Key::Enter);
    harness.run_steps(3);
    assert_eq!(brilliant(&request(&harness)).crown_angle_degrees, 31.5);
}

#[test]
fn a_digit_that_is_typed_with_enter_in_one_frame_is_no_view_key() {
    let mut harness = harness();
    let camera = harness.state().camera();
    let field = harness.get_by_label("Crown angle value").rect().center();
    harness.hover_at(field);
    harness.drag_at(field);
    harness.drop_at(field);
    harness.run_steps(3);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.run_steps(1);
    let press = |key| Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::NONE,
    };
    let typed =
        [press(Key::Num3), Event::Text("31".to_owned()), press(Key::Num1), press(Key::Enter)];
    harness.input_mut().events.extend(typed);
    harness.run_steps(3);
    assert_eq!(brilliant(&request(&harness)).crown_angle_degrees, 31.0);
    assert_eq!(harness.state().camera(), camera);
}

#[test]
fn every_control_has_a_name() {
    let harness = harness();
    assert!(harness.unnamed_widgets().is_empty(), "{:?}", harness.unnamed_widgets());
    let root = harness.root();
    let sliders =
        root.children_recursive().filter(|node| node.accesskit_node().role() == Role::Slider);
    assert!(sliders.count() >= 20);
}

/// A matte body says what is printed on it.
#[test]
fn a_print_is_named_with_its_size() {
    let scene = scenes().iter().find(|scene| scene.name == "Prism and word").unwrap();
    let document = Document::from_toml(scene.text, Path::new("")).unwrap();
    let harness = harness_with(document, None, services());
    for text in ["The word prism", "70 \u{d7} 35 mm"] {
        assert!(harness.query_by_label(text).is_some(), "{text}");
    }
}

fn dispersion(harness: &AppHarness) -> Dispersion {
    match &request(harness).scene.objects[0].material {
        Material::Dielectric(stone) => stone.dispersion.clone(),
        Material::Diffuse(_) => panic!("the stone is no longer clear"),
    }
}

#[test]
fn the_index_curve_is_a_line_a_formula_or_the_measurement() {
    let mut harness = harness();
    let diamond = find("Diamond").unwrap();
    let cauchy = Dispersion::cauchy_from(diamond.figures.n_d(), diamond.figures.dispersion_bg);
    choose(&mut harness, "Material", "Diamond");
    assert_eq!(dispersion(&harness), diamond.dispersion);
    for (name, expected) in [
        ("Straight line (Thomas 1986)", diamond.linear()),
        ("Cauchy", cauchy),
        ("Measured", diamond.dispersion.clone()),
    ] {
        choose(&mut harness, "Index curve", name);
        assert_eq!(dispersion(&harness), expected, "{name}");
        assert_eq!(shown(&harness, "Material"), "Diamond");
    }

    set(&mut harness, "Dispersion B\u{2013}G", 0.0);
    set(&mut harness, "Dispersion B\u{2013}G", 0.1);
    assert_eq!(shown(&harness, "Index curve"), "Measured, changed");
    assert_eq!(shown(&harness, "Material"), "Diamond, changed");
    let (n_d, shape) = (diamond.dispersion.n_d(), &diamond.dispersion);
    let stretched = |lambda_nm| n_d + (shape.n(lambda_nm) - n_d) * 0.1 / shape.dispersion_bg();
    for lambda_nm in [400.0, 550.0, 700.0] {
        let n = dispersion(&harness).n(lambda_nm);
        assert!((n - stretched(lambda_nm)).abs() < 1e-6, "{lambda_nm} nm: {n}");
    }

    choose(&mut harness, "Index curve", "Straight line (Thomas 1986)");
    let Dispersion::Linear { n_d: line_n_d, dispersion_bg } = dispersion(&harness) else {
        panic!("{:?}", dispersion(&harness))
    };
    assert!((line_n_d - n_d).abs() < 1e-9 && (dispersion_bg - 0.1).abs() < 1e-9);

    let unmeasured = find("Benitoite").unwrap();
    assert!(unmeasured.measurement.is_none());
    harness.get_by_role_and_label(Role::ComboBox, "Material").click();
    harness.run_steps(3);
    harness.event(Event::Text("beni".to_owned()));
    harness.run_steps(3);
    harness.get(by().role(Role::Button).label("Benitoite")).click();
    harness.run_steps(3);
    assert_eq!(dispersion(&harness), unmeasured.dispersion);
    harness.get_by_role_and_label(Role::ComboBox, "Index curve").click();
    harness.run_steps(3);
    assert!(harness.query(by().role(Role::Button).label("Measured")).is_none());
}

/// What the list called `label` shows.
fn shown(harness: &AppHarness, label: &str) -> String {
    let list = harness.get_by_role_and_label(Role::ComboBox, label);
    list.accesskit_node().value().unwrap_or_default()
}
