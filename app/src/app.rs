//! The window's content: what is edited, what is asked of the renderer, what is shown.

mod files;

use std::path::Path;
use std::sync::Arc;

use brilliance_renderer::camera::Camera;
use brilliance_renderer::error::RendererError;
use brilliance_renderer::scene::Scene;
use brilliance_renderer::scene_file::Document;
use brilliance_renderer::session::{RenderRequest, Session};
use eframe::egui::{self, CentralPanel, Color32, Ui, ViewportCommand};

use crate::bounds::Bounds;
use crate::command::{self, Command};
use crate::editor::Editor;
use crate::export::{
    ExportAction, ExportWindow, RenderStill, StillJob, StillOrder, render_and_write,
};
use crate::help::{self, Help};
use crate::menu;
use crate::notice::Notices;
use crate::orbit::Orbit;
use crate::panels::{self, PanelState};
use crate::path_dialog::{AskPath, PathDialog, Purpose, Question, ask_desktop};
use crate::question;
use crate::status;
use crate::theme;
use crate::viewport::Viewport;
use files::Files;

/// What the app has done outside of its window; a test brings its own.
pub struct Services {
    /// Asks the user for a path.
    pub ask_path: AskPath,
    /// Renders and writes a still.
    pub render_still: RenderStill,
}

impl Default for Services {
    /// The desktop's dialogs and the renderer.
    fn default() -> Self {
        Self { ask_path: Arc::new(ask_desktop), render_still: Arc::new(render_and_write) }
    }
}

/// The program in its window.
pub struct App {
    editor: Editor,
    /// The document's scene as the session has it.
    scene: Arc<Scene>,
    bounds: Bounds,
    orbit: Orbit,
    session: Session,
    request: Option<RenderRequest>,
    viewport: Viewport,
    viewport_size: [u32; 2],
    viewport_focused: bool,
    panel: PanelState,
    panel_shown: bool,
    notices: Notices,
    files: Files,
    paths: PathDialog,
    export: ExportWindow,
    help: Option<Help>,
    title: String,
}

impl App {
    /// Shows `document`, which came from `file`.
    ///
    /// # Errors
    /// The system gives the session no threads.
    pub fn new(
        ctx: &egui::Context,
        document: Document,
        file: Option<&Path>,
    ) -> Result<Self, RendererError> {
        Self::with_services(ctx, document, file, Services::default())
    }

    /// As [`new`](Self::new), with other ways to ask for a path and to render a still.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_services(
        ctx: &egui::Context,
        document: Document,
        file: Option<&Path>,
        services: Services,
    ) -> Result<Self, RendererError> {
        theme::apply(ctx);
        let repaint = ctx.clone();
        let editor = Editor::new(document, file);
        let scene = Arc::new(editor.document.scene.clone());
        Ok(Self {
            bounds: Bounds::of(&scene),
            orbit: Orbit::from_camera(&scene.camera),
            scene,
            editor,
            session: Session::new(move || repaint.request_repaint())?,
            request: None,
            viewport: Viewport::default(),
            viewport_size: [1, 1],
            viewport_focused: false,
            panel: PanelState::default(),
            panel_shown: true,
            notices: Notices::default(),
            files: Files::default(),
            paths: PathDialog::new(services.ask_path),
            export: ExportWindow::new(services.render_still),
            help: None,
            title: String::new(),
        })
    }

    /// The document as it is now.
    pub fn document(&self) -> &Document {
        &self.editor.document
    }

    /// The renderer's session.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// What the session was last asked for.
    pub fn request(&self) -> Option<&RenderRequest> {
        self.request.as_ref()
    }

    /// Where the picture is seen from.
    pub fn camera(&self) -> Camera {
        self.orbit.camera()
    }

    /// The messages that are shown.
    pub fn notices(&self) -> &Notices {
        &self.notices
    }

    /// The title of the window.
    pub fn title(&self) -> &str {
        &self.title
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
        self.update_scene();
        let document = &self.editor.document;
        let request = RenderRequest {
            scene: Arc::clone(&self.scene),
            camera: self.orbit.camera(),
            size: self.viewport_size,
            trace: document.trace.clone(),
            pass_limit: document.still.passes,
        };
        if self.request.as_ref() != Some(&request) {
            self.request = Some(request.clone());
            self.session.request(request);
        }
        self.session.display(document.display.clone());
    }

    fn run(&mut self, command: Command, ctx: &egui::Context) {
        match command {
            Command::Open => self.ask_open(ctx),
            Command::OpenScene(index) => self.open_scene(index, ctx),
            Command::Save => self.save(ctx),
            Command::SaveAs => self.ask_save(ctx),
            Command::ExportStill => {
                let suggestion = self.suggested_path("png");
                self.export.open(self.editor.document.still, &suggestion);
            }
            Command::Quit => ctx.send_viewport_cmd(ViewportCommand::Close),
            Command::Undo => self.editor.undo(),
            Command::Redo => self.editor.redo(),
            Command::Reset => self.editor.reset(),
            Command::Look(view) => self.orbit.look(view, &self.bounds),
            Command::ResetCamera => self.orbit = Orbit::from_camera(&self.scene.camera),
            Command::Turn(delta) => self.orbit.rotate(delta, &self.bounds),
            Command::Zoom(factor) => self.orbit.zoom(factor, [0.0, 0.0], &self.bounds),
            Command::TogglePanel => self.panel_shown = !self.panel_shown,
            Command::ShowKeys => self.help = Some(Help::Keys),
            Command::ShowAbout => self.help = Some(Help::About),
        }
    }

    fn menu_ui(&mut self, ui: &mut Ui) {
        if let Some(command) = menu::show(ui, &self.editor, self.panel_shown) {
            self.run(command, ui.ctx());
        }
    }

    fn viewport_ui(&mut self, ui: &mut Ui) {
        let (picture, progress) = (self.session.picture(), self.session.progress());
        let shown = CentralPanel::no_frame().show(ui, |ui| {
            self.viewport.show(ui, picture.as_ref(), &progress, &mut self.orbit, &self.bounds)
        });
        self.viewport_size = shown.inner.size;
        self.viewport_focused = shown.inner.response.has_focus();
        if shown.inner.reset {
            self.run(Command::ResetCamera, ui.ctx());
        }
    }

    /// Windows, questions and messages above the rest.
    fn overlays_ui(&mut self, ctx: &egui::Context) {
        let action = self.export.show(ctx, self.viewport_size, self.editor.document.trace.bins);
        match action {
            Some(ExportAction::Browse(suggestion)) => {
                self.paths.open(ctx, Question { purpose: Purpose::ExportStill, suggestion });
            }
            Some(ExportAction::Start(order)) => self.start_export(order, ctx),
            None => {}
        }
        if let Some(page) = self.help
            && !help::show(ctx, page)
        {
            self.help = None;
        }
        if self.files.is_asking()
            && let Some(decision) = question::show(ctx, self.editor.stem())
        {
            self.decide(decision, ctx);
        }
        if let Some((purpose, path)) = self.paths.show(ctx) {
            self.take_path(purpose, path, ctx);
        }
        self.notices.show(ctx);
        files::drop_target_ui(ctx, self.files.opening_name());
    }

    fn start_export(&mut self, order: StillOrder, ctx: &egui::Context) {
        let mut document = self.document_to_save();
        document.still = order.still;
        let folder = order.path.parent().unwrap_or(Path::new(""));
        let job = StillJob {
            request: RenderRequest {
                scene: Arc::clone(&self.scene),
                camera: self.orbit.camera(),
                size: order.still.size,
                trace: document.trace.clone(),
                pass_limit: order.still.passes,
            },
            display: document.display.clone(),
            format: order.format,
            scene_toml: document.to_toml(folder),
            path: order.path,
        };
        self.export.start(job, ctx, &mut self.notices);
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
        self.guard_close(ctx);
    }

    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        let ctx = ui.ctx().clone();
        self.menu_ui(ui);
        status::show(ui, &self.session.progress(), self.session.threads());
        if self.panel_shown {
            let baseline = self.editor.baseline().clone();
            panels::show(ui, &mut self.editor.document, &baseline, &mut self.panel);
        }
        self.viewport_ui(ui);
        self.overlays_ui(&ctx);
        // After the widgets, which take the keys that are meant for them.
        if !self.is_modal() {
            for command in command::pressed(&ctx, self.viewport_focused) {
                self.run(command, &ctx);
            }
        }
        let (now, pointer_down) = ctx.input(|input| (input.time, input.pointer.any_down()));
        self.editor.record(now, pointer_down);
        self.update_request();
        self.update_title(&ctx);
    }

    fn clear_color(&self, _visuals: &egui::Visuals) -> [f32; 4] {
        Color32::to_normalized_gamma_f32(theme::BACKDROP)
    }

    fn on_exit(&mut self) {
        self.export.cancel();
    }
}

impl App {
    /// True while a question waits above everything else.
    fn is_modal(&self) -> bool {
        self.help.is_some() || self.files.is_asking() || self.paths.is_open()
    }
}
