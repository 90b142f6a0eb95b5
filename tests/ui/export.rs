//! Stills are what the export window says.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use brilliance::app::Services;
use brilliance::export::{StillJob, StillReport};
use brilliance::notice::NoticeKind;
use brilliance_renderer::error::RendererError;
use brilliance_renderer::scene_file::{Document, StillSettings};
use brilliance_renderer::still::StillFormat;
use brilliance_renderer::tracer::TracerName;
use eframe::App as _;
use eframe::egui::{Key, Modifiers, ViewportEvent, ViewportId};
use egui_kittest::kittest::Queryable as _;

use crate::window::*;

#[test]
fn export_renders_what_the_window_says() {
    let jobs: Arc<Mutex<Vec<StillJob>>> = Arc::default();
    let seen = Arc::clone(&jobs);
    let render = move |job: &StillJob, _: &AtomicBool, progress: &mut dyn FnMut(u32)| {
        progress(job.request.pass_limit);
        seen.lock().unwrap().push(job.clone());
        Ok(StillReport {
            passes: job.request.pass_limit,
            tracing_seconds: 1.5,
            tracer: TracerName::Cpu { threads: 2 },
            warning: Some("the device caught fire".to_owned()),
        })
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
    for said in [job.path.to_str().unwrap(), "CPU, 2 threads", "the device caught fire"] {
        assert!(notice.text.contains(said), "no {said:?} in {}", notice.text);
    }
    assert_ne!(request(&harness).size, job.request.size, "the viewport keeps its own size");
}

#[test]
fn an_exported_still_is_a_readable_png_of_the_asked_size() {
    let folder = tempfile::tempdir().unwrap();
    let still = StillSettings { size: [48, 32], passes: 2, ..StillSettings::default() };
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

#[test]
fn leaving_while_a_still_is_rendered_is_asked_about() {
    let render = |_: &StillJob, cancel: &AtomicBool, _: &mut dyn FnMut(u32)| {
        while !cancel.load(Ordering::Relaxed) {
            std::thread::sleep(Duration::from_millis(2));
        }
        Err(RendererError::Cancelled)
    };
    let services = Services { render_still: Arc::new(render), ..services() };
    let mut harness = harness_with(Document::default(), None, services);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::E);
    harness.run_steps(3);
    harness.get_by_label("Export").click();
    harness.run_steps(3);

    let window = harness.input_mut().viewports.entry(ViewportId::ROOT).or_default();
    window.events.push(ViewportEvent::Close);
    harness.run_steps(3);
    harness.get_by_label("Stop the export?");
    harness.get_by_label("Stop and quit").click();
    wait(&mut harness, "the end of the question", |app| !app.asks_about_changes());
    harness.state_mut().on_exit();
    wait(&mut harness, "the cancellation", |app| !app.notices().list().is_empty());
    assert_eq!(harness.state().notices().list()[0].title, "Export cancelled");
}
