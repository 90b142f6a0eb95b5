//! Opening, saving and leaving, none of which makes the window wait.

use std::path::{Path, PathBuf};

use brilliance_renderer::error::RendererError;
use brilliance_renderer::scene_file::{Document, ShippedScene, scenes};
use eframe::egui::{self, Align2, FontId, Id, LayerId, Order, ViewportCommand};

use super::App;
use crate::editor::Editor;
use crate::notice::{Notices, naming};
use crate::opening::Reading;
use crate::path_dialog::{Purpose, Question};
use crate::question::{Decision, Loss};
use crate::task::{Task, TaskState};
use crate::theme;
use crate::waker::Waker;

const NOT_OPENED: &str = "Not opened";
const NOT_SAVED: &str = "Not saved";

/// What would lose unsaved changes.
#[derive(Debug)]
enum Intent {
    Quit,
    /// To show a document that has been read.
    Show(Box<Editor>),
}

/// Where a document comes from.
#[derive(Clone, Debug, PartialEq)]
enum Source {
    File(PathBuf),
    Shipped(ShippedScene),
}

impl Source {
    fn name(&self) -> String {
        match self {
            Self::File(path) => path.display().to_string(),
            Self::Shipped(scene) => scene.name.to_owned(),
        }
    }

    /// Reads it; may take seconds.
    fn open(self) -> Result<Editor, RendererError> {
        match self {
            Self::File(path) => {
                Document::open(&path).map(|document| Editor::new(document, Some(&path)))
            }
            Self::Shipped(scene) => Document::from_toml(scene.text, Path::new(""))
                .map(|document| Editor::named(document, scene.name)),
        }
    }
}

struct Saving {
    path: PathBuf,
    document: Document,
    task: Task<Result<(), RendererError>>,
}

/// What is going on with files.
#[derive(Default)]
pub(super) struct Files {
    opening: Option<(String, Task<Result<Editor, RendererError>>)>,
    saving: Option<Saving>,
    /// Waits for the answer about unsaved changes.
    asked: Option<Intent>,
    /// Goes on once the scene is saved.
    after_saving: Option<Intent>,
    /// The changes may be lost.
    may_quit: bool,
}

impl Files {
    /// True while the question about unsaved changes is open.
    pub(super) fn is_asking(&self) -> bool {
        self.asked.is_some()
    }

    /// Takes over a file that is being read since before there was a window.
    pub(super) fn await_reading(&mut self, reading: Reading, waker: &Waker, notices: &mut Notices) {
        let path = reading.path().to_owned();
        let name = path.display().to_string();
        let finish =
            move || reading.finish().map(|document| Editor::new(document, Some(path.as_path())));
        match Task::spawn("await opening", waker, finish) {
            Ok(task) => self.opening = Some((name, task)),
            Err(fault) => notices.error(NOT_OPENED, no_thread(&name, &fault)),
        }
    }

    /// The file that is being read.
    pub(super) fn opening_name(&self) -> Option<&str> {
        self.opening.as_ref().map(|(name, _)| name.as_str())
    }
}

impl App {
    /// Opens a scene or a mesh; asks about unsaved changes once it is read.
    pub fn open_file(&mut self, path: PathBuf) {
        self.read(Source::File(path));
    }

    /// Opens the shipped scene of this index.
    pub(super) fn open_scene(&mut self, index: usize) {
        if let Some(scene) = scenes().get(index) {
            self.read(Source::Shipped(*scene));
        }
    }

    pub(super) fn ask_open(&mut self) {
        let suggestion = self.editor.folder().map_or_else(current_folder, Path::to_owned);
        self.paths.open(self.live.waker(), Question { purpose: Purpose::Open, suggestion });
    }

    pub(super) fn ask_save(&mut self) {
        let suggestion = self.suggested_path("toml");
        let question = Question { purpose: Purpose::SaveScene, suggestion };
        self.paths.open(self.live.waker(), question);
    }

    /// Saves to the document's own file, or asks for one.
    pub(super) fn save(&mut self) {
        match self.editor.file().map(Path::to_owned) {
            Some(path) => self.save_to(path),
            None => self.ask_save(),
        }
    }

    /// A file beside the document's own, with another ending.
    pub(super) fn suggested_path(&self, extension: &str) -> PathBuf {
        let folder = self.editor.folder().map_or_else(current_folder, Path::to_owned);
        folder.join(format!("{}.{extension}", self.editor.stem()))
    }

    /// Writes what is not saved beside other temporary files, for when the program has to end
    /// without asking. None if everything is saved.
    ///
    /// # Errors
    /// The file can't be written.
    pub fn rescue(&self) -> Option<Result<PathBuf, RendererError>> {
        let file = format!("{} {}.toml", self.editor.stem(), std::process::id());
        let path = std::env::temp_dir().join(file);
        let edited = self.editor.edited();
        edited.then(|| self.document_to_save().save(&path).map(|()| path))
    }

    /// Takes the answer of a path dialog.
    pub(super) fn take_path(&mut self, purpose: Purpose, path: PathBuf) {
        match purpose {
            Purpose::Open => self.open_file(path),
            Purpose::SaveScene => self.save_to(path),
            Purpose::ExportStill => self.export.set_path(&path),
            Purpose::SaveDrawing(_) => {
                self.sheets.write(&path, self.live.waker(), &mut self.notices);
            }
        }
    }

    /// Takes the answer about unsaved changes.
    pub(super) fn decide(&mut self, decision: Decision, ctx: &egui::Context) {
        let Some(intent) = self.files.asked.take() else { return };
        match decision {
            Decision::Save => {
                self.files.after_saving = Some(intent);
                self.save();
            }
            Decision::Discard => self.carry_out(intent, ctx),
            Decision::Cancel => {}
        }
    }

    /// Takes files that are dropped on the window and results of the threads.
    pub(super) fn poll_files(&mut self, ctx: &egui::Context) {
        let dropped =
            ctx.input(|input| input.raw.dropped_files.first().map(|file| file.path().to_owned()));
        if let Some(path) = dropped {
            self.open_file(path);
        }
        self.poll_opening(ctx);
        self.poll_saving(ctx);
        // The user chose no file to save to: the plan that waited for it is off.
        if !self.paths.is_open() && self.files.saving.is_none() {
            self.files.after_saving = None;
        }
    }

    /// What the intent that is asked about would lose.
    pub(super) fn loss(&self) -> Loss<'_> {
        let quits = matches!(self.files.asked, Some(Intent::Quit));
        Loss {
            changed: self.editor.edited().then(|| self.editor.name()),
            export: quits && self.export.is_running(),
        }
    }

    /// Holds the window open while changes are unsaved or a still is rendered.
    pub(super) fn guard_close(&mut self, ctx: &egui::Context) {
        let closing = ctx.input(|input| input.viewport().close_requested());
        if closing && !self.files.may_quit && (self.editor.edited() || self.export.is_running()) {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            self.files.asked = Some(Intent::Quit);
        }
    }

    fn intend(&mut self, intent: Intent, ctx: &egui::Context) {
        if self.editor.edited() {
            self.files.asked = Some(intent);
        } else {
            self.carry_out(intent, ctx);
        }
    }

    fn carry_out(&mut self, intent: Intent, ctx: &egui::Context) {
        match intent {
            Intent::Quit => {
                self.files.may_quit = true;
                ctx.send_viewport_cmd(ViewportCommand::Close);
            }
            Intent::Show(editor) => self.replace(*editor),
        }
    }

    fn read(&mut self, source: Source) {
        let name = source.name();
        match Task::spawn("open", self.live.waker(), move || source.open()) {
            Ok(task) => self.files.opening = Some((name, task)),
            Err(fault) => self.notices.error(NOT_OPENED, no_thread(&name, &fault)),
        }
    }

    fn save_to(&mut self, path: PathBuf) {
        let document = self.document_to_save();
        let (copy, target) = (document.clone(), path.clone());
        match Task::spawn("save", self.live.waker(), move || copy.save(&target)) {
            Ok(task) => self.files.saving = Some(Saving { path, document, task }),
            Err(fault) => {
                self.notices.error(NOT_SAVED, no_thread(&path.display().to_string(), &fault));
            }
        }
    }

    fn poll_opening(&mut self, ctx: &egui::Context) {
        let Some((name, task)) = self.files.opening.take() else { return };
        match task.poll() {
            TaskState::Running => self.files.opening = Some((name, task)),
            TaskState::Finished(Ok(editor)) => {
                self.notices.withdraw(NOT_OPENED);
                self.intend(Intent::Show(Box::new(editor)), ctx);
            }
            TaskState::Finished(Err(fault)) => {
                self.notices.error(NOT_OPENED, naming(&name, &fault.to_string()));
            }
            TaskState::Broken => {
                let fault = "the program failed while reading it; please report this file";
                self.notices.error(NOT_OPENED, naming(&name, fault));
            }
        }
    }

    fn poll_saving(&mut self, ctx: &egui::Context) {
        let Some(saving) = self.files.saving.take() else { return };
        let name = saving.path.display().to_string();
        match saving.task.poll() {
            TaskState::Running => self.files.saving = Some(saving),
            TaskState::Finished(Ok(())) => {
                self.notices.withdraw(NOT_SAVED);
                self.notices.confirm("Scene saved", name);
                self.finish_saving(saving.document, saving.path);
                if let Some(intent) = self.files.after_saving.take() {
                    self.carry_out(intent, ctx);
                }
            }
            TaskState::Finished(Err(fault)) => {
                self.notices.error(NOT_SAVED, naming(&name, &fault.to_string()));
                self.files.after_saving = None;
            }
            TaskState::Broken => {
                let fault = "the program failed while writing it; please report this scene";
                self.notices.error(NOT_SAVED, naming(&name, fault));
                self.files.after_saving = None;
            }
        }
    }

    /// The saved camera becomes the document's, so that the camera alone is no change.
    fn finish_saving(&mut self, saved: Document, path: PathBuf) {
        self.editor.document.scene.camera = saved.scene.camera;
        self.editor.mark_saved(saved, path);
    }
}

fn no_thread(name: &str, fault: &std::io::Error) -> String {
    format!("{name}: the system gives no thread ({fault}). Close other programs and try again.")
}

fn current_folder() -> PathBuf {
    std::env::current_dir().unwrap_or_default()
}

/// Says that a file can be dropped, or that one is being read.
pub(super) fn drop_target_ui(ctx: &egui::Context, opening: Option<&str>) {
    let hovering = ctx.input(|input| !input.raw.hovered_files.is_empty());
    let text = match (hovering, opening) {
        (true, _) => "Drop to open".to_owned(),
        (false, Some(name)) => {
            let name = Path::new(name).file_name().map_or(name.into(), |n| n.to_string_lossy());
            format!("Opening {name}\u{2026}")
        }
        (false, None) => return,
    };
    let painter = ctx.layer_painter(LayerId::new(Order::Foreground, Id::unique("drop target")));
    let room = ctx.content_rect();
    painter.rect_filled(room, 0.0, egui::Color32::from_black_alpha(150));
    let font = FontId::proportional(18.0);
    painter.text(room.center(), Align2::CENTER_CENTER, text, font, theme::TEXT_STRONG);
}
