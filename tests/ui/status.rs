//! What the status line says of the picture.

use brilliance_renderer::scene_file::Document;
use brilliance_renderer::session::Activity;
use eframe::egui::vec2;
use egui_kittest::kittest::Queryable as _;

use crate::window::*;

/// A small window whose picture is soon done, with nothing in it but the sky.
fn window_of(passes: u32, noise_target: f32) -> AppHarness {
    let mut document = Document::default();
    document.scene.objects.clear();
    document.still.passes = passes;
    document.still.noise.target = noise_target;
    let mut harness = sized_harness(vec2(640.0, 420.0), document);
    wait(&mut harness, "the end of the picture", |app| {
        app.session().progress().activity == Activity::Done
    });
    harness.run_steps(2);
    harness
}

#[test]
fn it_says_why_the_picture_is_finished() {
    let harness = window_of(10, 0.0);
    assert_eq!(harness.state().session().progress().passes, 10);
    harness.get_by_label("Finished: all passes");
    harness.get_by_label("noise");

    let harness = window_of(10, 0.02);
    assert!(harness.state().session().progress().passes < 10);
    harness.get_by_label("Finished: noise target");
    harness.get_by_label("noise");

    let harness = window_of(3, 0.02);
    harness.get_by_label("Finished: all passes");
    assert!(harness.query_by_label("noise").is_none(), "nothing is known after so few passes");
}

#[test]
fn a_lower_target_carries_on_with_a_picture_that_was_good_enough() {
    let mut harness = window_of(10, 0.02);
    let before = request(&harness);
    set(&mut harness, "Noise target", 0.0);
    wait(&mut harness, "all passes", |app| {
        let progress = app.session().progress();
        progress.passes == 10 && progress.activity == Activity::Done
    });
    harness.run_steps(2);
    assert!(before.makes_same_film(&request(&harness)));
    harness.get_by_label("Finished: all passes");
}
