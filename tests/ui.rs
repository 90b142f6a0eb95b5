//! The window without a window system: each control changes what it says it changes.

use std::f32::consts::PI;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex};

use brilliance::app::{App, Services};
use brilliance::export::{StillJob, StillReport};
use brilliance::live::Live;
use brilliance::notice::NoticeKind;
use brilliance::opening::Opening;
use brilliance_renderer::cuts::{RoundBrilliant, StandardProportions};
use brilliance_renderer::error::RendererError;
use brilliance_renderer::light::DiscLight;
use brilliance_renderer::material::{Material, find};
use brilliance_renderer::rigs::rigs;
use brilliance_renderer::scene::Shape;
use brilliance_renderer::scene_file::{Document, StillSettings, scenes};
use brilliance_renderer::session::RenderRequest;
use brilliance_renderer::settings::{DisplaySettings, ToneCurve, WhitePoint};
use brilliance_renderer::still::StillFormat;
use eframe::egui::{self, accesskit::Role};
use eframe::egui::{
    Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, Pos2, TouchPhase, vec2,
};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable, by};

type AppHarness = Harness<'static, App>;

fn services() -> Services {
    Services {
        ask_path: Arc::new(|_| None),
        render_still: Arc::new(|_, _, _| Err(RendererError::Cancelled)),
        ..Services::default()
    }
}

fn harness_with(document: Document, file: Option<&Path>, services: Services) -> AppHarness {
    let opening = Opening::Read { document: Box::new(document), file: file.map(Path::to_owned) };
    let mut harness = Harness::builder()
        .with_size(vec2(1400.0, 1300.0))
        .with_step_dt(1.0 / 60.0)
        .with_max_steps(30)
        .build_eframe(move |creation| {
            App::new(&creation.egui_ctx, opening, Live::new().expect("threads"), services)
        });
    harness.run_steps(4);
    harness
}

fn harness() -> AppHarness {
    harness_with(Document::default(), None, services())
}

fn request(harness: &AppHarness) -> RenderRequest {
    harness.state().request().expect("a first frame").clone()
}

fn slider<'h>(harness: &'h AppHarness, label: &'h str) -> egui_kittest::Node<'h> {
    harness.get_by_role_and_label(Role::Slider, label)
}

/// Sets a slider as a screen reader would, in the unit it shows.
fn set(harness: &mut AppHarness, label: &str, value: f64) {
    slider(harness, label).set_value_accesskit(value);
    harness.run_steps(2);
}

/// Two clicks at one place; each event is a frame of its own.
fn double_click(harness: &mut AppHarness, at: Pos2) {
    harness.hover_at(at);
    for _ in 0..2 {
        for pressed in [true, false] {
            harness.event(Event::PointerButton {
                pos: at,
                button: PointerButton::Primary,
                pressed,
                modifiers: Modifiers::NONE,
            });
        }
    }
    harness.run_steps(2);
}

/// Lets time pass, so that the next change is a step of its own.
fn rest(harness: &mut AppHarness) {
    harness.run_steps(60);
}

fn drag(harness: &mut AppHarness, button: PointerButton, modifiers: Modifiers, by: egui::Vec2) {
    let from = picture_centre(harness);
    harness.hover_at(from);
    harness.event(Event::ModifiersChanged(modifiers));
    for (pos, pressed) in [(from, Some(true)), (from + 0.5 * by, None), (from + by, None)] {
        match pressed {
            Some(pressed) => {
                harness.event(Event::PointerButton { pos, button, pressed, modifiers });
            }
            None => harness.event(Event::PointerMoved(pos)),
        }
    }
    harness.event(Event::PointerButton { pos: from + by, button, pressed: false, modifiers });
    harness.event(Event::ModifiersChanged(Modifiers::NONE));
    harness.run_steps(2);
}

fn picture_centre(harness: &AppHarness) -> Pos2 {
    harness.get_by_label_contains("Picture of the stone").rect().center()
}

/// Reads the value that a slider turns.
type Value = fn(&RenderRequest) -> f64;

#[test]
fn every_tracing_slider_changes_the_request() {
    let mut harness = harness();
    let cases: [(&str, f64, f64, Value); 14] = [
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

fn brilliant(request: &RenderRequest) -> RoundBrilliant {
    match &request.scene.objects[0].shape {
        Shape::RoundBrilliant(cut) => *cut,
        shape => panic!("not a brilliant: {shape:?}"),
    }
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
    harness.get_by_role_and_label(Role::CheckBox, "Perturb sub-rays").click();
    harness.run_steps(2);
    assert!(!request(&harness).trace.perturb);

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

/// Opens the list called `label` and clicks on `item`.
fn choose(harness: &mut AppHarness, label: &str, item: &str) {
    harness.get_by_role_and_label(Role::ComboBox, label).click();
    harness.run_steps(3);
    harness.get(by().role(Role::Button).label(item)).click();
    harness.run_steps(3);
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
fn the_mouse_turns_moves_and_zooms_the_stone() {
    let mut harness = harness();
    let start = harness.state().camera();
    drag(&mut harness, PointerButton::Primary, Modifiers::NONE, vec2(60.0, 20.0));
    let turned = harness.state().camera();
    assert_ne!(start.position, turned.position);
    assert_eq!(start.target, turned.target);
    assert_eq!(request(&harness).camera, turned);

    drag(&mut harness, PointerButton::Middle, Modifiers::NONE, vec2(30.0, 0.0));
    let moved = harness.state().camera();
    assert_ne!(moved.target, turned.target);
    drag(&mut harness, PointerButton::Primary, Modifiers::SHIFT, vec2(-30.0, 0.0));
    assert!(harness.state().camera().target.abs_diff_eq(turned.target, 1e-3));

    harness.hover_at(picture_centre(&harness));
    harness.event(Event::MouseWheel {
        unit: MouseWheelUnit::Point,
        delta: vec2(0.0, 120.0),
        phase: TouchPhase::Move,
        source: MouseWheelSource::Wheel,
        modifiers: Modifiers::NONE,
    });
    harness.run_steps(20);
    let distance =
        |camera: &brilliance_renderer::camera::Camera| (camera.position - camera.target).length();
    assert!(distance(&harness.state().camera()) < 0.9 * distance(&turned));

    let centre = picture_centre(&harness);
    double_click(&mut harness, centre);
    assert!(harness.state().camera().position.abs_diff_eq(start.position, 1e-4));
    assert!(!harness.state().title().contains('\u{2022}'), "the camera is no edit");
}

#[test]
fn keys_show_the_standard_views_but_not_while_typing() {
    let mut harness = harness();
    let axis = |harness: &AppHarness| {
        let camera = harness.state().camera();
        (camera.position - camera.target).normalize_or_zero()
    };
    for (keys, expected) in [
        ([Key::Num1, Key::F], [0.0, 0.0, 1.0]),
        ([Key::Num3, Key::S], [0.0, -1.0, 0.0]),
        ([Key::Num7, Key::P], [0.0, 0.0, -1.0]),
    ] {
        for key in keys {
            harness.key_press(Key::R);
            harness.key_press(key);
            harness.run_steps(2);
            let axis = axis(&harness);
            assert!(axis.abs_diff_eq(expected.into(), 1e-5), "{key:?}: {axis}");
        }
    }
    harness.key_press(Key::R);
    harness.key_press(Key::ArrowRight);
    harness.run_steps(2);
    let turned = harness.state().camera();
    assert!(turned.position.x < -0.1, "the stone turns to the right: {}", turned.position);

    harness.get_by_role_and_label(Role::ComboBox, "Material").click();
    harness.run_steps(3);
    harness.key_press(Key::S);
    harness.event(Event::Text("s".to_owned()));
    harness.run_steps(2);
    assert_eq!(harness.state().camera(), turned);
}

#[test]
fn edits_are_undone_one_gesture_at_a_time() {
    let mut harness = harness();
    set(&mut harness, "Crown angle", 30.0);
    rest(&mut harness);
    set(&mut harness, "Table", 60.0);
    set(&mut harness, "Table", 62.0);
    assert!(harness.state().title().starts_with('\u{2022}'));

    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run_steps(2);
    let cut = brilliant(&request(&harness));
    assert_eq!(cut.table, RoundBrilliant::default().table);
    assert_eq!(cut.crown_angle_degrees, 30.0);

    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run_steps(2);
    assert_eq!(brilliant(&request(&harness)), RoundBrilliant::default());
    assert!(!harness.state().title().contains('\u{2022}'));

    for _ in 0..2 {
        harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    }
    harness.run_steps(2);
    assert_eq!(brilliant(&request(&harness)).table, 0.62);
}

/// Runs frames until `done`, for what happens on other threads.
fn wait(harness: &mut AppHarness, what: &str, done: impl Fn(&App) -> bool) {
    for _ in 0..400 {
        harness.step();
        if done(harness.state()) {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    panic!("{what} did not happen");
}

#[test]
fn a_file_that_cannot_be_opened_is_named_until_dismissed_and_the_scene_stays() {
    let mut harness = harness();
    let before = request(&harness);
    let path = PathBuf::from("/no/such/folder/heart.toml");
    harness.event(Event::PointerGone);
    harness.step();
    let ctx = harness.ctx.clone();
    harness.state_mut().open_file(path, &ctx);
    wait(&mut harness, "the notice", |app| !app.notices().list().is_empty());
    let notice = harness.state().notices().list()[0].clone();
    assert_eq!(notice.kind, NoticeKind::Error);
    assert!(notice.text.contains("/no/such/folder/heart.toml"), "{}", notice.text);
    assert_eq!(request(&harness), before);

    rest(&mut harness);
    assert_eq!(harness.state().notices().list().len(), 1);
    harness.get_by_label("Dismiss").click();
    harness.run_steps(3);
    assert!(harness.state().notices().list().is_empty());
}

#[test]
fn unsaved_changes_are_asked_about_before_another_scene_is_opened() {
    let mut harness = harness();
    set(&mut harness, "Crown angle", 30.0);
    harness.get_by_label("File").click();
    harness.run_steps(3);
    harness.get_by_label_contains("Open scene").click();
    harness.run_steps(3);
    harness.get_by_label(scenes()[0].name).click();
    harness.run_steps(3);
    harness.get_by_label("Save your changes?");
    harness.get_by_label("Cancel").click();
    harness.run_steps(3);
    assert!(harness.query_by_label("Save your changes?").is_none());
    assert_eq!(brilliant(&request(&harness)).crown_angle_degrees, 30.0);
}

#[test]
fn save_writes_the_scene_file_and_clears_the_mark() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("stone.toml");
    let answer = file.clone();
    let services = Services { ask_path: Arc::new(move |_| Some(answer.clone())), ..services() };
    let mut harness = harness_with(Document::default(), None, services);
    set(&mut harness, "Crown angle", 30.0);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::S);
    wait(&mut harness, "saving", |app| app.title().starts_with("stone.toml"));
    assert_eq!(harness.state().notices().list()[0].kind, NoticeKind::Confirmation);
    assert!(harness.state().notices().list()[0].text.contains("stone.toml"));
}

#[test]
fn without_a_file_dialog_a_path_can_be_typed() {
    let mut harness = harness();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::O);
    wait(&mut harness, "the field", |_| true);
    for _ in 0..100 {
        harness.step();
        if harness.query_by_label("Path").is_some() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    harness.get_by_label("Path").focus();
    harness.run_steps(2);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.event(Event::Text("/no/such/stone.glb".to_owned()));
    harness.run_steps(2);
    harness.key_press(Key::Enter);
    wait(&mut harness, "the notice", |app| !app.notices().list().is_empty());
    assert!(harness.state().notices().list()[0].text.contains("/no/such/stone.glb"));
}

#[test]
fn export_renders_what_the_window_says() {
    let jobs: Arc<Mutex<Vec<StillJob>>> = Arc::default();
    let seen = Arc::clone(&jobs);
    let render = move |job: &StillJob, _: &AtomicBool, progress: &mut dyn FnMut(u32)| {
        progress(job.request.pass_limit);
        seen.lock().unwrap().push(job.clone());
        Ok(StillReport { passes: job.request.pass_limit, tracing_seconds: 1.5 })
    };
    let services = Services { render_still: Arc::new(render), ..services() };
    let mut harness = harness_with(Document::default(), None, services);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::E);
    harness.run_steps(3);
    choose(&mut harness, "Size", "3840 × 2160, 4K");
    choose(&mut harness, "Format", "PNG, 16 bit");
    harness.get_by_label("Export").click();
    wait(&mut harness, "the export", |app| !app.notices().list().is_empty());
    let notice = &harness.state().notices().list()[0];
    assert_eq!(notice.kind, NoticeKind::Confirmation, "{notice:?}");

    let jobs = jobs.lock().unwrap();
    let [job] = jobs.as_slice() else { panic!("{} jobs", jobs.len()) };
    assert_eq!(job.request.size, [3840, 2160]);
    assert_eq!(job.format, StillFormat::Png16);
    assert_eq!(job.request.camera, harness.state().camera());
    assert!(notice.text.contains(&job.path.display().to_string()));
    assert_ne!(request(&harness).size, job.request.size, "the viewport keeps its own size");
}

#[test]
fn the_picture_has_the_physical_pixels_of_the_viewport() {
    let mut harness = Harness::builder()
        .with_size(vec2(1200.0, 900.0))
        .with_pixels_per_point(1.5)
        .build_eframe(move |creation| {
            App::new(&creation.egui_ctx, Opening::default(), Live::new().unwrap(), services())
        });
    harness.run_steps(4);
    let points = harness.get_by_label_contains("Picture of the stone").rect().size();
    let size = request(&harness).size;
    assert_eq!(size, [(points.x * 1.5).round() as u32, (points.y * 1.5).round() as u32]);
    harness.key_press(Key::F9);
    harness.run_steps(3);
    assert!(request(&harness).size[0] > size[0], "the picture fills the room of the hidden panel");
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

#[test]
fn an_exported_still_is_a_readable_png_of_the_asked_size() {
    let folder = tempfile::tempdir().unwrap();
    let still = StillSettings { size: [48, 32], passes: 2 };
    let document = Document { still, ..Document::default() };
    let file = folder.path().join("stone.toml");
    let mut harness = harness_with(document, Some(&file), Services::default());
    harness.key_press_modifiers(Modifiers::COMMAND, Key::E);
    harness.run_steps(3);
    harness.get_by_label("Export").click();
    wait(&mut harness, "the export", |app| !app.notices().list().is_empty());
    let notice = &harness.state().notices().list()[0];
    assert_eq!(notice.kind, NoticeKind::Confirmation, "{notice:?}");

    let picture = image::open(folder.path().join("stone.png")).unwrap().to_rgb8();
    assert_eq!(picture.dimensions(), (48, 32));
    let middle = picture.get_pixel(24, 16);
    assert_ne!(middle, picture.get_pixel(0, 0), "the stone differs from the backdrop");
}
