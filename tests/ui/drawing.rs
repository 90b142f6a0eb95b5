//! The line drawing follows the stone, and is saved as it is seen.

use std::sync::Arc;

use brilliance::app::{App, Services};
use brilliance::notice::NoticeKind;
use brilliance_renderer::scene_file::Document;
use eframe::egui::Key;
use egui_kittest::kittest::Queryable as _;

use crate::window::*;

/// Whether there is a drawing with this text.
fn says(app: &App, text: &str) -> bool {
    app.drawing().is_some_and(|sheet| sheet.words().any(|words| words.text == text))
}

#[test]
fn the_drawing_shows_the_stone_as_it_is_edited() {
    let mut harness = harness();
    assert!(harness.state().drawing().is_none());
    harness.key_press(Key::L);
    wait(&mut harness, "the drawing", |app| says(app, "main 40.8°"));
    set(&mut harness, "Pavilion angle", 42.0);
    assert!(harness.state().drawing().is_some(), "the last stays while the next is made");
    wait(&mut harness, "the next drawing", |app| says(app, "main 42°"));
    harness.key_press(Key::L);
    harness.run_steps(2);
    assert!(harness.state().drawing().is_none());
}

#[test]
fn the_prism_diagram_follows_its_sliders() {
    let mut harness = harness();
    harness.get_by_label("Help").click();
    harness.run_steps(3);
    harness.get_by_label_contains("How rays are divided").click();
    harness.run_steps(4);
    let words = |harness: &AppHarness| -> String {
        let sheet = harness.state().prism_diagram().expect("a diagram");
        sheet.words().map(|words| words.text.clone() + "\n").collect()
    };
    assert!(words(&harness).contains("perturb off") && words(&harness).contains("perturb on"));
    set(&mut harness, "Apex", 30.0);
    assert!(words(&harness).contains("Apex 30°"));
    choose(&mut harness, "Perturb", "On");
    assert!(!words(&harness).contains("perturb off") && words(&harness).contains("perturb on"));
    harness.key_press(Key::Escape);
    harness.run_steps(2);
    assert!(harness.state().prism_diagram().is_none());
}

#[test]
fn a_stone_that_can_not_be_cut_says_so_in_its_place() {
    let mut harness = harness();
    harness.key_press(Key::L);
    wait(&mut harness, "the drawing", |app| app.drawing().is_some());
    set(&mut harness, "Table", 90.0);
    set(&mut harness, "Star length", 5.0);
    wait(&mut harness, "the fault", |app| app.drawing().is_none());
    harness.run_steps(2);
    harness.get_by_label("This can't be drawn");
    set(&mut harness, "Star length", 95.0);
    wait(&mut harness, "the drawing", |app| app.drawing().is_some());
}

#[test]
fn the_drawing_is_saved_in_both_formats() {
    let folder = tempfile::tempdir().unwrap();
    // A dialog that leaves the ending to the program.
    let answer = folder.path().join("figure");
    let services = Services { ask_path: Arc::new(move |_| Some(answer.clone())), ..services() };
    let mut harness = harness_with(Document::default(), None, services);
    harness.key_press(Key::L);
    wait(&mut harness, "the drawing", |app| app.drawing().is_some());
    harness.run_steps(2);
    for (button, file) in [("Save SVG…", "figure.svg"), ("Save PNG…", "figure.png")] {
        harness.get_by_label(button).click();
        let path = folder.path().join(file);
        wait(&mut harness, "the file", |_| path.is_file());
        wait(&mut harness, "the notice", |app| {
            app.notices().list().iter().any(|notice| notice.text.contains(file))
        });
        let notices = harness.state().notices().list();
        assert!(notices.iter().all(|n| n.kind == NoticeKind::Confirmation), "{notices:?}");
    }
    let svg = std::fs::read_to_string(folder.path().join("figure.svg")).unwrap();
    assert_eq!(svg, harness.state().drawing().unwrap().to_svg());
    let picture = image::open(folder.path().join("figure.png")).unwrap();
    assert_eq!(picture.width(), 2339);
}
