//! The spectrum tab of the inspector.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use brilliance_renderer::film::Region;
use brilliance_renderer::light::Lights;
use brilliance_renderer::scene_file::Document;
use brilliance_renderer::session::Reading;
use brilliance_renderer::still::{Still, StillLimits};
use eframe::egui::{Key, Modifiers, OutputCommand, PointerButton, vec2};
use egui_kittest::kittest::Queryable as _;

use crate::window::*;

const PASSES: u32 = 2;

/// A small window with the tab open, and nothing picked. Few passes of a dim effort, so that they
/// are soon done.
fn spectrum_tab() -> AppHarness {
    spectrum_tab_of(Document::default())
}

fn spectrum_tab_of(mut document: Document) -> AppHarness {
    document.still.passes = PASSES;
    document.trace.max_depth = 6;
    let mut harness = sized_harness(vec2(640.0, 420.0), document);
    for key in [Key::F9, Key::I] {
        harness.key_press(key);
        harness.run_steps(3);
    }
    harness.get_by_label("Spectrum").click();
    harness.run_steps(3);
    harness
}

/// Waits until what is picked was read from the finished film.
fn reading(harness: &mut AppHarness) -> Arc<Reading> {
    wait(harness, "a reading of all passes", |app| {
        let size = app.request().map_or([1, 1], |request| request.size);
        let region = app.inspector().watched(size);
        app.session()
            .reading()
            .is_some_and(|it| Some(it.region) == region && it.passes == PASSES && !it.is_draft)
    });
    harness.run_steps(2);
    harness.state().session().reading().expect("it is there")
}

fn picks(harness: &AppHarness) -> u64 {
    harness.state().inspector().pick().map_or(0, |pick| pick.pixels.count())
}

/// Holds a reading to a film of the same request, which the processor makes bit by bit.
fn assert_is_of_film(harness: &AppHarness, reading: &Reading) {
    let request = request(harness);
    let limits = StillLimits::default();
    let still = Still::render(&request, limits, None, &AtomicBool::new(false), |_, _| {});
    let film = still.expect("it renders").film;
    assert_eq!(reading.film_size, request.size);
    assert_eq!(reading.spectrum, film.mean_spectrum(reading.pixels));
    assert!(reading.spectrum.iter().any(|&radiance| radiance > 0.0), "something is lit");
}

#[test]
fn while_nothing_is_picked_the_tab_says_what_to_do() {
    let mut harness = spectrum_tab();
    harness.get_by_label_contains("drag a region");
    assert_eq!(harness.query_by_label("Spectrum of what is picked").map(|_| ()), None);
    let watched = |harness: &AppHarness| harness.state().inspector().watched([640, 400]);
    assert_eq!(watched(&harness), Some(Region::WHOLE));
    harness.get_by_label("Rays").click();
    harness.run_steps(3);
    assert_eq!(watched(&harness), Some(Region::WHOLE), "it stays ready for a spectrum");
    harness.key_press(Key::I);
    harness.run_steps(3);
    assert_eq!(watched(&harness), None);
    assert_eq!(harness.state().session().reading(), None);
}

#[test]
fn a_picked_pixel_and_a_region_are_read_from_the_film_that_is_shown() {
    let mut harness = spectrum_tab();
    let center = picture_centre(&harness);
    click(&mut harness, center);
    let pixel = reading(&mut harness);
    assert_eq!((picks(&harness), pixel.pixels.count()), (1, 1));
    assert_is_of_film(&harness, &pixel);
    harness.get_by_label("Spectrum of what is picked");
    harness.get_by_label_contains("u'v' diagram");
    harness.get_by_label_contains(&format!("{PASSES} passes"));

    let passes = harness.state().session().progress().statistics.camera_rays;
    drag(&mut harness, PointerButton::Primary, Modifiers::COMMAND, vec2(30.0, -20.0));
    let region = reading(&mut harness);
    assert!(region.pixels.count() > 300, "{:?}", region.pixels);
    assert_eq!(picks(&harness), region.pixels.count());
    assert_is_of_film(&harness, &region);
    let now = harness.state().session().progress().statistics.camera_rays;
    assert_eq!(now, passes, "nothing is traced for it");
}

#[test]
fn a_kept_spectrum_stays_while_another_is_picked_and_both_are_copied() {
    let mut harness = spectrum_tab();
    let center = picture_centre(&harness);
    click(&mut harness, center);
    let kept = reading(&mut harness);
    assert!(harness.query_by_label("Forget").is_none());
    harness.get_by_label("Keep").click();
    harness.run_steps(3);
    click(&mut harness, center + vec2(17.0, 9.0));
    let picked = reading(&mut harness);
    assert_ne!(kept.pixels, picked.pixels);

    harness.get_by_label("Copy as CSV").click();
    harness.step();
    let commands = &harness.output().platform_output.commands;
    let csv = commands.iter().find_map(|command| match command {
        OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    let csv = csv.expect("it is copied");
    let rows: Vec<Vec<f32>> = csv
        .lines()
        .filter(|line| line.starts_with(char::is_numeric))
        .map(|line| line.split(',').map(|number| number.parse().expect("a number")).collect())
        .collect();
    assert_eq!(rows.len(), picked.bins.count());
    assert_eq!(rows[0][0], 380.0);
    for (bin, row) in rows.iter().enumerate() {
        assert_eq!(row[2..], [picked.spectrum[bin], kept.spectrum[bin]]);
    }
    harness.get_by_label("Forget").click();
    harness.run_steps(3);
    assert!(harness.query_by_label("Forget").is_none());
}

#[test]
fn a_pixel_without_light_is_said_to_be_dark() {
    let mut document = Document::default();
    document.scene.lights = Lights::default();
    let mut harness = spectrum_tab_of(document);
    let center = picture_centre(&harness);
    click(&mut harness, center);
    let dark = reading(&mut harness);
    assert!(dark.spectrum.iter().all(|&radiance| radiance == 0.0), "{dark:?}");
    harness.get_by_label_contains("No light");
}
