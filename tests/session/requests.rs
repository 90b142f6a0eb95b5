//! On the processor: which request is served, and what is shown of it.

use std::sync::{Arc, Mutex};

use brilliance_renderer::develop::{HeatMap, Pixels, Shown};
use brilliance_renderer::session::{Activity, Picture};
use brilliance_renderer::settings::{DisplaySettings, ToneCurve, TraceSettings};

use crate::watched::{Watched, request};

/// The pixels of a picture made by the processor.
fn rgba8(picture: &Picture) -> &[u8] {
    match &picture.pixels {
        Pixels::Rgba8(rgba8) => rgba8,
        Pixels::Texture(_) => panic!("the processor makes no textures"),
    }
}

#[test]
fn a_request_is_traced_to_its_pass_limit_and_shown() {
    let mut watched = Watched::new();
    watched.session.request(request([48, 32], 3));
    let (picture, progress) = watched.wait_for_done([48, 32]);
    assert_eq!((progress.passes, progress.pass_limit), (3, 3));
    assert_eq!(progress.statistics.camera_rays, 3 * 48 * 32);
    assert_eq!(rgba8(&picture).len(), 48 * 32 * 4);
    let shades: std::collections::BTreeSet<_> = rgba8(&picture).chunks(4).collect();
    assert!(shades.len() > 50, "a diamond has more than {} colours", shades.len());
}

#[test]
fn an_equal_request_is_no_new_one() {
    let mut watched = Watched::new();
    watched.session.request(request([16, 16], 1));
    watched.session.request(request([16, 16], 1));
    assert_eq!(watched.session.requests_made(), 1);
    watched.session.request(request([16, 16], 2));
    assert_eq!(watched.session.requests_made(), 2);
}

#[test]
fn more_passes_carry_on_with_the_film() {
    let mut watched = Watched::new();
    watched.session.request(request([24, 24], 2));
    watched.wait_for_done([24, 24]);
    watched.session.request(request([24, 24], 5));
    watched.wait(|session| session.progress().pass_limit == 5);
    watched.wait(|session| session.progress().activity == Activity::Done);
    let progress = watched.session.progress();
    assert_eq!(progress.passes, 5);
    // Begun anew, draft or not, it would have cost at least as many again.
    assert_eq!(progress.statistics.camera_rays, 5 * 24 * 24);
    watched.session.request(request([24, 24], 3));
    watched.wait(|session| session.progress().pass_limit == 3);
    assert_eq!(watched.session.progress().passes, 5, "what is traced stays");
}

#[test]
fn there_and_back_again_is_traced_to_the_end() {
    let mut watched = Watched::new();
    watched.session.request(request([300, 200], 4));
    watched.wait(|session| session.progress().activity == Activity::Accumulating);
    // The first cuts a pass of the film short; the second wants that film again.
    watched.session.request(request([301, 200], 4));
    watched.session.request(request([300, 200], 4));
    let (_, progress) = watched.wait_for_done([300, 200]);
    assert_eq!(progress.passes, 4);
    assert_eq!(progress.statistics.camera_rays, 4 * 300 * 200);
}

#[test]
fn the_newest_request_wins_over_work_that_would_take_hours() {
    let mut watched = Watched::new();
    watched.session.request(request([4000, 4000], 1_000_000));
    watched.wait(|session| session.progress().activity == Activity::Preview);
    for i in 0..20 {
        watched.session.request(request([900 + i, 900], 100_000));
    }
    watched.session.request(request([40, 40], 2));
    let (_, progress) = watched.wait_for_done([40, 40]);
    assert_eq!(progress.passes, 2);
}

#[test]
fn previews_come_before_full_resolution() {
    let mut watched = Watched::new();
    let sizes = Arc::new(Mutex::new(Vec::new()));
    let mut cheap = request([1600, 1000], 1);
    cheap.trace = TraceSettings { significance_threshold: 0.3, ..cheap.trace.draft() };
    watched.session.request(cheap);
    let seen = Arc::clone(&sizes);
    watched.wait(move |session| {
        let mut sizes = seen.lock().expect("one thread");
        let progress = session.progress();
        if sizes.last() != Some(&progress.size) {
            sizes.push(progress.size);
        }
        progress.activity == Activity::Done
    });
    let sizes = sizes.lock().expect("one thread");
    let widths: Vec<_> = sizes.iter().map(|size| size[0]).filter(|&width| width > 0).collect();
    assert!(widths.len() > 1 && widths[0] < 1600, "{widths:?}");
    assert!(widths.is_sorted(), "{widths:?}");
}

#[test]
fn display_settings_change_the_picture_without_tracing() {
    let mut watched = Watched::new();
    watched.session.request(request([20, 20], 1));
    let (before, progress) = watched.wait_for_done([20, 20]);
    watched.session.display(DisplaySettings {
        exposure_ev: 2.0,
        tone_curve: ToneCurve::Linear,
        ..DisplaySettings::default()
    });
    watched.wait(|session| session.picture().is_some_and(|p| p.serial > before.serial));
    let after = watched.session.picture().expect("it is there");
    assert_ne!(rgba8(&before), rgba8(&after));
    assert_eq!(watched.session.progress(), progress, "nothing was traced");
    assert_eq!(watched.session.requests_made(), 1);
}

#[test]
fn heat_maps_are_shown_without_tracing_and_last_beyond_the_next_request() {
    let mut watched = Watched::new();
    watched.session.request(request([20, 20], 1));
    let (color, progress) = watched.wait_for_done([20, 20]);
    assert_eq!(color.shown, Shown::Color);
    let mut pictures = vec![color];
    for shown in HeatMap::ALL.map(Shown::Heat) {
        watched.session.show(shown);
        assert_eq!(watched.session.shown(), shown);
        watched.wait(|session| session.picture().is_some_and(|picture| picture.shown == shown));
        let picture = watched.session.picture().expect("it is there");
        assert!(pictures.iter().all(|other| rgba8(other) != rgba8(&picture)), "{shown:?}");
        pictures.push(picture);
        assert_eq!(watched.session.progress(), progress, "nothing was traced");
    }
    // Heat maps have scales of their own.
    let last = pictures.pop().expect("four pictures");
    watched.session.display(DisplaySettings { exposure_ev: 5.0, ..DisplaySettings::default() });
    watched.wait(|session| session.picture().is_some_and(|p| p.serial > last.serial));
    assert_eq!(watched.session.picture().map(|p| rgba8(&p) == rgba8(&last)), Some(true));
    assert_eq!(watched.session.requests_made(), 1);

    watched.session.request(request([24, 20], 1));
    let (picture, _) = watched.wait_for_done([24, 20]);
    assert_eq!(picture.shown, Shown::Heat(HeatMap::Pruned));
}

#[test]
fn a_scene_that_is_no_solid_fails_in_words_and_the_next_one_is_traced() {
    let mut watched = Watched::new();
    let mut impossible = request([16, 16], 1);
    let mut scene = (*impossible.scene).clone();
    scene.objects[0].transform.scale = 0.0;
    impossible.scene = Arc::new(scene);
    watched.session.request(impossible);
    watched.wait(|session| session.progress().activity == Activity::Failed);
    let error = watched.session.progress().error.expect("a reason");
    assert!(error.contains("scale"), "{error}");
    watched.session.request(request([16, 16], 1));
    watched.wait_for_done([16, 16]);
    assert_eq!(watched.session.progress().error, None);
}
