//! The choice of a tracer, and graphics devices that show, fail and go.

use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;

use brilliance::app::App;
use brilliance::live::Live;
use brilliance::notice::NoticeKind;
use brilliance::opening::Opening;
use brilliance::picture_painter::{install, paint_picture};
use brilliance_renderer::develop::{Pixels, Shown};
use brilliance_renderer::gpu::Graphics;
use brilliance_renderer::session::{GraphicsState, Picture, RenderRequest};
use brilliance_renderer::tracer::Backend;
use eframe::egui::{self, Key, Modifiers, Rect, accesskit::Role, pos2, vec2};
use eframe::egui_wgpu::{RenderState, Renderer, RendererOptions};
use egui_kittest::Harness;
use egui_kittest::kittest::{By, NodeT as _, Queryable as _, by};
use egui_kittest::wgpu::{WgpuTestRenderer, create_render_state, default_wgpu_setup};
use wgpu::util::DeviceExt as _;

use crate::window::*;

fn open_tracers(harness: &mut AppHarness) {
    harness.get_by_label("View").click();
    harness.run_steps(3);
    harness.get_by_label("Trace with").click();
    harness.run_steps(3);
}

/// The menu's entry, which goes on with the name of the device.
fn tracer(name: &str) -> By<'_> {
    by().role(Role::RadioButton).label_contains(name)
}

fn choose_tracer(harness: &mut AppHarness, name: &str) {
    open_tracers(harness);
    harness.get(tracer(name)).click();
    harness.run_steps(3);
}

fn render_state(target_format: wgpu::TextureFormat) -> RenderState {
    let state = create_render_state(default_wgpu_setup(), RendererOptions::PREDICTABLE);
    let renderer = Renderer::new(&state.device, target_format, RendererOptions::PREDICTABLE);
    RenderState { target_format, renderer: Arc::new(egui::mutex::RwLock::new(renderer)), ..state }
}

fn graphics(state: &RenderState) -> Graphics {
    Graphics::share(&state.device, &state.queue, state.adapter.get_info())
}

#[test]
fn the_menu_chooses_the_tracer_and_changes_nothing_else() {
    let mut harness = harness();
    let state = render_state(wgpu::TextureFormat::Rgba8Unorm);
    harness.state_mut().offer_graphics(graphics(&state));
    let before = request(&harness);
    assert_eq!(before.backend, Backend::Auto);
    for (name, backend) in [
        ("Processor", Backend::Cpu),
        ("Graphics device", Backend::Gpu),
        ("Automatic", Backend::Auto),
    ] {
        choose_tracer(&mut harness, name);
        assert_eq!(request(&harness), RenderRequest { backend, ..before.clone() }, "{name}");
    }
    assert!(!harness.state().title().contains('\u{2022}'), "the choice is no edit");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    choose_tracer(&mut harness, "Processor");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run_steps(2);
    assert_eq!(request(&harness).backend, Backend::Cpu, "the choice is not undone");
}

#[test]
fn without_a_device_the_menu_offers_none() {
    let mut harness = harness();
    open_tracers(&mut harness);
    let device = harness.get(tracer("Graphics device"));
    assert!(device.accesskit_node().is_disabled());
    harness.get_by_label_contains("In use: CPU");
}

#[test]
fn a_device_that_fails_is_told_of_once_and_can_be_tried_again() {
    let mut harness = harness();
    let state = render_state(wgpu::TextureFormat::Rgba8Unorm);
    harness.state_mut().offer_graphics(graphics(&state));
    state.device.destroy();
    choose_tracer(&mut harness, "Graphics device");
    let failed = |app: &App| matches!(app.session().graphics_state(), GraphicsState::Failed(_));
    wait(&mut harness, "the failure", failed);
    harness.run_steps(3);
    let [notice] = harness.state().notices().list() else {
        panic!("{:?}", harness.state().notices())
    };
    assert_eq!(notice.kind, NoticeKind::Error);
    assert!(notice.text.contains("Try again"), "{}", notice.text);
    wait(&mut harness, "a picture", |app| app.session().picture().is_some());
    assert!(matches!(&harness.state().session().picture().unwrap().pixels, Pixels::Rgba8(_)));

    harness.get_by_label("Dismiss").click();
    rest(&mut harness);
    assert!(harness.state().notices().list().is_empty(), "it was told before");

    open_tracers(&mut harness);
    let device = harness.get(tracer("Graphics device"));
    assert!(device.accesskit_node().is_disabled());
    harness.get_by_label("Try again").click();
    wait(&mut harness, "the second failure", |app| !app.notices().list().is_empty());
    assert_eq!(harness.state().notices().list().len(), 1);
}

/// An app that lives longer than its windows.
struct Lodger(Rc<RefCell<App>>);

impl eframe::App for Lodger {
    fn logic(&mut self, ctx: &egui::Context, frame: &mut eframe::Frame) {
        self.0.borrow_mut().logic(ctx, frame);
    }

    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
        self.0.borrow_mut().ui(ui, frame);
    }
}

fn window_of(app: &Rc<RefCell<App>>) -> Harness<'static, Lodger> {
    let app = Rc::clone(app);
    let mut harness =
        Harness::builder().with_size(vec2(1400.0, 1300.0)).build_eframe(move |made| {
            app.borrow_mut().enter(&made.egui_ctx);
            Lodger(app)
        });
    harness.run_steps(4);
    harness
}

#[test]
fn an_app_moves_to_another_window_with_all_that_was_edited() {
    let live = Live::new(Backend::Auto).expect("threads");
    let app = Rc::new(RefCell::new(App::new(Opening::default(), live, services())));
    let angle = |app: &Rc<RefCell<App>>| {
        brilliant(app.borrow().request().expect("a request")).crown_angle_degrees
    };
    let mut first = window_of(&app);
    let default = angle(&app);
    first.get_by_role_and_label(Role::Slider, "Crown angle").set_value_accesskit(30.0);
    first.run_steps(60);
    first.get_by_label("Display").click();
    first.run_steps(60);
    let is_folded = |window: &Harness<'_, Lodger>| {
        window.query_by_role_and_label(Role::Slider, "Exposure").is_none()
    };
    assert!(is_folded(&first));
    drop(first);
    app.borrow_mut().graphics_lost("it was shut down");

    let mut second = window_of(&app);
    assert_eq!(angle(&app), 30.0);
    assert_eq!(app.borrow().request().map(|request| request.backend), Some(Backend::Cpu));
    assert!(app.borrow().title().starts_with('\u{2022}'));
    assert!(is_folded(&second), "the panel is as it was");
    second.get_by_label_contains("it was shut down");
    app.borrow().window().expect("the second window").request_repaint();
    assert!(second.ctx.has_requested_repaint(), "the second window is the one to wake");
    second.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    second.run_steps(3);
    assert_eq!(angle(&app), default, "the history came along");
}

const PICTURE: [u32; 2] = [5, 4];

/// Codes that differ from each other everywhere.
fn codes() -> Vec<u8> {
    (0..PICTURE[0] * PICTURE[1]).flat_map(|i| [(i * 12) as u8, 255 - i as u8, 7, 255]).collect()
}

/// What the harness sees of a picture that is painted over `side` points per pixel of it.
fn painted(
    format: wgpu::TextureFormat,
    side: f32,
    pixels: impl FnOnce(&RenderState) -> Pixels,
) -> image::RgbaImage {
    let state = render_state(format);
    install(&state);
    let (pixels, shown) = (pixels(&state), Shown::Color);
    let picture = Arc::new(Picture { size: PICTURE, pixels, shown, serial: 1 });
    let size = side * vec2(PICTURE[0] as f32, PICTURE[1] as f32);
    let rect = Rect::from_min_size(pos2(3.0, 2.0), size);
    let mut harness = Harness::builder()
        .with_size(vec2(64.0, 48.0))
        .renderer(WgpuTestRenderer::from_render_state(state))
        .build_ui(move |ui| {
            ui.painter().add(paint_picture(rect, &picture, side != 1.0));
        });
    let image = harness.render().expect("a picture of the window");
    let [width, height] = [size.x as u32, size.y as u32];
    image::imageops::crop_imm(&image, 3, 2, width, height).to_image()
}

fn texture(state: &RenderState) -> Pixels {
    let [width, height] = PICTURE;
    let descriptor = wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba8Unorm,
        usage: wgpu::TextureUsages::TEXTURE_BINDING
            | wgpu::TextureUsages::STORAGE_BINDING
            | wgpu::TextureUsages::COPY_DST,
        view_formats: &[wgpu::TextureFormat::Rgba8UnormSrgb],
    };
    let order = wgpu::util::TextureDataOrder::LayerMajor;
    Pixels::Texture(state.device.create_texture_with_data(
        &state.queue,
        &descriptor,
        order,
        &codes(),
    ))
}

#[test]
fn a_texture_is_shown_as_the_same_pixels_in_memory_are() {
    for format in [wgpu::TextureFormat::Rgba8Unorm, wgpu::TextureFormat::Rgba8UnormSrgb] {
        let exact = painted(format, 1.0, texture);
        assert_eq!(exact.as_raw(), &codes(), "{format:?}: code for code");
        let from_memory = |_: &RenderState| Pixels::Rgba8(codes());
        assert_eq!(exact, painted(format, 1.0, from_memory), "{format:?}");

        let smooth = painted(format, 4.0, texture);
        assert_eq!(smooth, painted(format, 4.0, from_memory), "{format:?}");
        let [left, between, right] = [5, 7, 10].map(|x| smooth.get_pixel(x, 2)[0]);
        assert!(left < between && between < right, "{format:?}: {left} {between} {right}");
    }
}
