//! A window without a window system, and the hands that use it.

use std::path::Path;
use std::sync::Arc;

use brilliance::app::{App, Services};
use brilliance::live::Live;
use brilliance::opening::Opening;
use brilliance_renderer::cuts::RoundBrilliant;
use brilliance_renderer::error::RendererError;
use brilliance_renderer::scene::Shape;
use brilliance_renderer::scene_file::Document;
use brilliance_renderer::session::RenderRequest;
use brilliance_renderer::tracer::Backend;
use eframe::egui::{self, Event, Modifiers, PointerButton, Pos2, accesskit::Role, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{Queryable as _, by};

pub(crate) type AppHarness = Harness<'static, App>;

pub(crate) fn services() -> Services {
    Services {
        ask_path: Arc::new(|_| None),
        render_still: Arc::new(|_, _, _| Err(RendererError::Cancelled)),
        ..Services::default()
    }
}

/// The app in the window that is being created.
pub(crate) fn app(
    creation: &eframe::CreationContext<'_>,
    opening: Opening,
    services: Services,
) -> App {
    let live = Live::new(Backend::Auto).expect("threads");
    let mut app = App::new(opening, live, services);
    app.enter(&creation.egui_ctx);
    app
}

pub(crate) fn harness_with(
    document: Document,
    file: Option<&Path>,
    services: Services,
) -> AppHarness {
    let opening = Opening::Read { document: Box::new(document), file: file.map(Path::to_owned) };
    build(vec2(1400.0, 1300.0), opening, services)
}

/// A document in a window of another size.
pub(crate) fn sized_harness(size: egui::Vec2, document: Document) -> AppHarness {
    build(size, Opening::Read { document: Box::new(document), file: None }, services())
}

fn build(size: egui::Vec2, opening: Opening, services: Services) -> AppHarness {
    let mut harness = Harness::builder()
        .with_size(size)
        .with_step_dt(1.0 / 60.0)
        .with_max_steps(30)
        .build_eframe(move |creation| app(creation, opening, services));
    harness.run_steps(4);
    harness
}

pub(crate) fn harness() -> AppHarness {
    harness_with(Document::default(), None, services())
}

pub(crate) fn request(harness: &AppHarness) -> RenderRequest {
    harness.state().request().expect("a first frame").clone()
}

pub(crate) fn brilliant(request: &RenderRequest) -> RoundBrilliant {
    match &request.scene.objects[0].shape {
        Shape::RoundBrilliant(cut) => *cut,
        shape => panic!("not a brilliant: {shape:?}"),
    }
}

pub(crate) fn slider<'h>(harness: &'h AppHarness, label: &'h str) -> egui_kittest::Node<'h> {
    harness.get_by_role_and_label(Role::Slider, label)
}

/// Sets a slider as a screen reader would, in the unit it shows.
pub(crate) fn set(harness: &mut AppHarness, label: &str, value: f64) {
    slider(harness, label).set_value_accesskit(value);
    harness.run_steps(2);
}

/// Opens the list called `label` and clicks on `item`.
pub(crate) fn choose(harness: &mut AppHarness, label: &str, item: &str) {
    harness.get_by_role_and_label(Role::ComboBox, label).click();
    harness.run_steps(3);
    harness.get(by().role(Role::Button).label(item)).click();
    harness.run_steps(3);
}

pub(crate) fn click(harness: &mut AppHarness, at: Pos2) {
    clicks(harness, at, 1);
}

pub(crate) fn double_click(harness: &mut AppHarness, at: Pos2) {
    clicks(harness, at, 2);
}

/// Clicks at one place; each event is a frame of its own.
fn clicks(harness: &mut AppHarness, at: Pos2, count: u32) {
    harness.hover_at(at);
    for _ in 0..count {
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
pub(crate) fn rest(harness: &mut AppHarness) {
    harness.run_steps(60);
}

pub(crate) fn drag(
    harness: &mut AppHarness,
    button: PointerButton,
    modifiers: Modifiers,
    by: egui::Vec2,
) {
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

pub(crate) fn picture_centre(harness: &AppHarness) -> Pos2 {
    harness.get_by_label_contains("Picture of the stone").rect().center()
}

/// Runs frames until `done`, for what happens on other threads.
pub(crate) fn wait(harness: &mut AppHarness, what: &str, done: impl Fn(&App) -> bool) {
    for _ in 0..400 {
        harness.step();
        if done(harness.state()) {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    panic!("{what} did not happen");
}
