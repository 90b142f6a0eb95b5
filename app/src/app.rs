//! The window's content: what is edited, what is asked of the renderer, what is shown.

mod commands;
mod files;
mod graphics;
mod overlays;

use std::sync::Arc;
use std::time::Instant;

use brilliance_renderer::camera::Camera;
use brilliance_renderer::drawing::Sheet;
use brilliance_renderer::scene::Scene;
use brilliance_renderer::scene_file::Document;
use brilliance_renderer::session::{RenderRequest, Session};
use eframe::egui::{self, CentralPanel, Color32, Ui, ViewportCommand};

use crate::bounds::Bounds;
use crate::command::{self, Command};
use crate::drawing::{FacetWindow, PrismWindow, SheetFiles};
use crate::editor::Editor;
use crate::export::{ExportWindow, RenderStill, render_and_write};
use crate::first_picture::FirstPicture;
use crate::help::Help;
use crate::inspector::Inspector;
use crate::live::Live;
use crate::menu;
use crate::notice::Notices;
use crate::opening::Opening;
use crate::orbit::Orbit;
use crate::panels::{self, PanelState};
use crate::path_dialog::{AskPath, PathDialog, ask_desktop};
use crate::status;
use crate::theme;
use crate::viewport;
use files::Files;

/// What the app has from outside of its window; a test brings its own.
pub struct Services {
    /// When the process started.
    pub started: Instant,
    /// Asks the user for a path.
    pub ask_path: AskPath,
    /// Renders and writes a still.
    pub render_still: RenderStill,
}

impl Default for Services {
    /// The desktop's dialogs and the renderer.
    fn default() -> Self {
        Self {
            started: Instant::now(),
            ask_path: Arc::new(ask_desktop),
            render_still: Arc::new(render_and_write),
        }
    }
}

/// The program in its window.
pub struct App {
    editor: Editor,
    /// The document's scene as the session has it.
    scene: Arc<Scene>,
    bounds: Bounds,
    orbit: Orbit,
    live: Live,
    viewport_size: [u32; 2],
    viewport_focused: bool,
    panel: PanelState,
    panel_shown: bool,
    inspector: Inspector,
    notices: Notices,
    files: Files,
    paths: PathDialog,
    export: ExportWindow,
    facets: FacetWindow,
    prism: PrismWindow,
    sheets: SheetFiles,
    help: Option<Help>,
    title: String,
    /// Serial of the last failure of a graphics device that the user was told of.
    failure_told: u64,
    first_picture: FirstPicture,
}

impl App {
    /// What is opened, shown by `live`, which may be tracing it already. It has no window yet.
    pub fn new(opening: Opening, live: Live, services: Services) -> Self {
        let mut notices = Notices::default();
        let mut files = Files::default();
        let editor = match opening {
            Opening::Read { document, file } => Editor::new(*document, file.as_deref()),
            Opening::Reading(reading) => {
                files.await_reading(reading, live.waker(), &mut notices);
                Editor::new(Document::default(), None)
            }
        };
        let scene = Arc::new(editor.document.scene.clone());
        Self {
            failure_told: 0,
            bounds: Bounds::of(&scene),
            orbit: Orbit::from_camera(&scene.camera),
            scene,
            editor,
            live,
            viewport_size: [1, 1],
            viewport_focused: false,
            panel: PanelState::default(),
            panel_shown: true,
            inspector: Inspector::default(),
            notices,
            files,
            first_picture: FirstPicture::new(services.started),
            paths: PathDialog::new(services.ask_path),
            export: ExportWindow::new(services.render_still),
            facets: FacetWindow::default(),
            prism: PrismWindow::default(),
            sheets: SheetFiles::default(),
            help: None,
            title: String::new(),
        }
    }

    /// Moves into the window of `ctx`, from the window before it if there was one: with the panel
    /// scrolled, the menus and the focus as they were.
    pub fn enter(&mut self, ctx: &egui::Context) {
        theme::apply(ctx);
        if let Some(before) = self.live.waker().attach(ctx) {
            let memory = before.memory(Clone::clone);
            ctx.memory_mut(|now| *now = memory);
        }
        // The new window has not been told.
        self.title.clear();
    }

    /// The context of the window that it is in, once there is one.
    pub fn window(&self) -> Option<egui::Context> {
        self.live.waker().window()
    }

    /// The document as it is now.
    pub fn document(&self) -> &Document {
        &self.editor.document
    }

    /// The renderer's session.
    pub fn session(&self) -> &Session {
        self.live.session()
    }

    /// What the session was last asked for.
    pub fn request(&self) -> Option<&RenderRequest> {
        self.live.request()
    }

    /// Where the picture is seen from.
    pub fn camera(&self) -> Camera {
        self.orbit.camera()
    }

    /// The messages that are shown.
    pub fn notices(&self) -> &Notices {
        &self.notices
    }

    /// The line drawing, while it is shown.
    pub fn drawing(&self) -> Option<&Sheet> {
        self.facets.sheet()
    }

    /// The diagram of how rays are divided, while it is shown.
    pub fn prism_diagram(&self) -> Option<&Sheet> {
        self.prism.sheet()
    }

    /// True while the question about unsaved changes is open.
    pub fn asks_about_changes(&self) -> bool {
        self.files.is_asking()
    }

    /// The title of the window.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// What is picked in the picture.
    pub fn inspector(&self) -> &Inspector {
        &self.inspector
    }

    /// The document as it would be saved: with the camera as it is now.
    fn document_to_save(&self) -> Document {
        let mut document = self.editor.document.clone();
        document.scene.camera = self.orbit.camera();
        document
    }

    /// Takes over another document, from where its scene wants to be seen.
    fn replace(&mut self, editor: Editor) {
        self.editor = editor;
        self.panel = PanelState::default();
        self.inspector.clear();
        self.update_scene();
        self.orbit = Orbit::from_camera(&self.scene.camera);
    }

    /// Gives the session a new scene if the document's has changed.
    fn update_scene(&mut self) {
        if *self.scene != self.editor.document.scene {
            self.scene = Arc::new(self.editor.document.scene.clone());
            self.bounds = Bounds::of(&self.scene);
        }
    }

    /// Asks the session for what the document and the camera say.
    fn update_request(&mut self) {
        if self.live.request().is_none() && self.files.opening_name().is_some() {
            // The first picture is that of the file.
            return;
        }
        self.update_scene();
        let document = &self.editor.document;
        self.live.ask(document, &self.scene, self.orbit.camera(), self.viewport_size);
        self.live.watch(self.inspector.watched(self.viewport_size));
    }

    fn menu_ui(&mut self, ui: &mut Ui) {
        let tracers = self.tracers();
        let state = menu::State {
            editor: &self.editor,
            tracers: &tracers,
            shown: self.session().shown(),
            panel_is_open: self.panel_shown,
            inspector_is_open: self.inspector.is_shown(),
        };
        if let Some(command) = menu::show(ui, &state) {
            self.run(command, ui.ctx());
        }
    }

    fn panel_ui(&mut self, ui: &mut Ui) {
        let baseline = self.editor.baseline().clone();
        // What is edited while another document is on its way would be lost.
        let editable = self.files.opening_name().is_none();
        let document = &mut self.editor.document;
        panels::show(ui, editable, document, &baseline, &mut self.panel);
    }

    fn viewport_ui(&mut self, ui: &mut Ui) {
        let (picture, progress) = (self.session().picture(), self.session().progress());
        let shown = CentralPanel::no_frame().show(ui, |ui| {
            let picks = self.inspector.is_shown();
            viewport::show(ui, picture.as_ref(), &progress, &mut self.orbit, &self.bounds, picks)
        });
        if picture.is_some() {
            self.first_picture.painted(ui.ctx());
        }
        self.viewport_size = shown.inner.size;
        self.viewport_focused = shown.inner.response.has_focus();
        let camera = self.orbit.camera();
        let response = &shown.inner.response;
        if let Some(pixels) = shown.inner.picked
            // A click on a ray selects that.
            && !(response.clicked() && self.inspector.select_pointed())
        {
            self.inspector.set_pick(pixels, self.viewport_size, camera);
        }
        let painter = ui.painter_at(response.rect);
        self.inspector.overlay(&painter, response, self.viewport_size, &camera);
        viewport::notes_ui(ui, response.rect, picture.as_ref(), &progress);
        if shown.inner.reset {
            self.run(Command::ResetCamera, ui.ctx());
        }
    }

    fn update_title(&mut self, ctx: &egui::Context) {
        let title = format!("{} \u{2013} Brilliance", self.editor.title());
        if title != self.title {
            ctx.send_viewport_cmd(ViewportCommand::Title(title.clone()));
            self.title = title;
        }
    }
}

impl eframe::App for App {
    fn logic(&mut self, ctx: &egui::Context, _frame: &mut eframe::Frame) {
        self.poll_files(ctx);
        self.export.poll(&mut self.notices);
        self.sheets.poll(&mut self.notices);
        self.poll_graphics();
        self.guard_close(ctx);
    }

    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        self.first_picture.begin_frame();
        let ctx = ui.ctx().clone();
        let was_typing = command::is_typing(&ctx);
        self.menu_ui(ui);
        let session = self.session();
        status::show(ui, &session.progress(), session.shown(), &self.tracers());
        if self.panel_shown {
            self.panel_ui(ui);
        }
        let reading = self.session().reading();
        let display = &self.editor.document.display;
        self.inspector.show(ui, self.viewport_size, reading.as_ref(), display);
        self.viewport_ui(ui);
        self.overlays_ui(&ctx);
        // After the widgets, which take the keys that are meant for them.
        if !self.is_modal() {
            for command in command::pressed(&ctx, self.viewport_focused, was_typing) {
                self.run(command, &ctx);
            }
        }
        let (now, pointer_down) = ctx.input(|input| (input.time, input.pointer.any_down()));
        self.editor.record(now, pointer_down);
        self.update_request();
        let trace = &self.editor.document.trace;
        self.inspector.follow_rays(&self.scene, trace, self.live.waker());
        self.update_title(&ctx);
    }

    fn clear_color(&self, _visuals: &egui::Visuals) -> [f32; 4] {
        Color32::to_normalized_gamma_f32(theme::BACKDROP)
    }

    fn on_exit(&mut self) {
        self.export.cancel();
    }
}
