//! Asking for a file: the system's dialog, or a typed path where there is none.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use brilliance_renderer::drawing::SheetFormat;
use eframe::egui::{self, Key, RichText, TextEdit, Ui};

use crate::task::{Task, TaskState};
use crate::theme;
use crate::waker::Waker;

/// What a path is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// A scene, a mesh or the scene of a still to open.
    Open,
    /// Where to save the scene.
    SaveScene,
    /// Where to write the still.
    ExportStill,
    /// Where to write a drawing.
    SaveDrawing(SheetFormat),
}

/// A question for a path.
#[derive(Clone, Debug)]
pub struct Question {
    /// What it is for.
    pub purpose: Purpose,
    /// Where to begin: a file to be, or the folder to look in.
    pub suggestion: PathBuf,
}

/// Asks the user and waits for the answer; called on a thread of its own.
pub type AskPath = Arc<dyn Fn(&Question) -> Option<PathBuf> + Send + Sync>;

/// A dialog that answers sooner than this was not seen by anybody: the system has none.
const SOONEST_ANSWER: Duration = Duration::from_millis(700);

/// The question that is open, if any.
pub struct PathDialog {
    ask: AskPath,
    native: Option<Native>,
    typed: Option<Typed>,
}

struct Native {
    question: Question,
    task: Task<Answered>,
}

/// What a dialog of the system gave, and how long that took.
struct Answered {
    path: Option<PathBuf>,
    after: Duration,
}

struct Typed {
    purpose: Purpose,
    text: String,
    /// The file exists and would be replaced.
    replaces: bool,
}

impl Purpose {
    fn title(self) -> &'static str {
        match self {
            Self::Open => "Open a scene, a mesh or the scene of a still",
            Self::SaveScene => "Save the scene",
            Self::ExportStill => "Export the still",
            Self::SaveDrawing(_) => "Save the drawing",
        }
    }

    fn action(self) -> &'static str {
        match self {
            Self::Open => "Open",
            Self::SaveScene | Self::SaveDrawing(_) => "Save",
            Self::ExportStill => "Choose",
        }
    }
}

impl PathDialog {
    /// Asks by `ask`, and by a field in the window where that fails.
    pub fn new(ask: AskPath) -> Self {
        Self { ask, native: None, typed: None }
    }

    /// True while a question is open.
    pub fn is_open(&self) -> bool {
        self.native.is_some() || self.typed.is_some()
    }

    /// Opens a question; [`show`](Self::show) gives the answer in a later frame.
    pub fn open(&mut self, waker: &Waker, question: Question) {
        if self.is_open() {
            return;
        }
        let ask = Arc::clone(&self.ask);
        let asked = question.clone();
        let answer = move || {
            let since = Instant::now();
            let path = ask(&asked);
            Answered { path, after: since.elapsed() }
        };
        match Task::spawn("file dialog", waker, answer) {
            Ok(task) => self.native = Some(Native { question, task }),
            Err(_) => self.typed = Some(Typed::new(&question)),
        }
    }

    /// Shows the question; gives the answer once.
    pub fn show(&mut self, ctx: &egui::Context) -> Option<(Purpose, PathBuf)> {
        if let Some(native) = self.native.take() {
            match native.task.poll() {
                TaskState::Running => self.native = Some(native),
                TaskState::Finished(Answered { path: Some(path), .. }) => {
                    return Some((native.question.purpose, path));
                }
                TaskState::Finished(answered) if answered.after >= SOONEST_ANSWER => {}
                TaskState::Finished(_) | TaskState::Broken => {
                    self.typed = Some(Typed::new(&native.question));
                }
            }
        }
        let typed = self.typed.as_mut()?;
        let modal = theme::dialog(ctx, "typed path").show(ctx, |ui| typed_ui(ui, typed));
        let closed = modal.should_close();
        match modal.inner {
            Answer::Path(path) => {
                let purpose = typed.purpose;
                self.typed = None;
                return Some((purpose, path));
            }
            Answer::Cancelled => self.typed = None,
            Answer::None if closed => self.typed = None,
            Answer::None => {}
        }
        None
    }
}

/// What the buttons of the typed path say.
enum Answer {
    None,
    Path(PathBuf),
    Cancelled,
}

impl Typed {
    fn new(question: &Question) -> Self {
        let mut text = question.suggestion.display().to_string();
        if question.purpose == Purpose::Open && !text.is_empty() {
            text.push(std::path::MAIN_SEPARATOR);
        }
        let mut typed = Self { purpose: question.purpose, text, replaces: false };
        typed.look();
        typed
    }

    fn look(&mut self) {
        self.replaces = self.purpose != Purpose::Open && self.path().is_file();
    }

    fn path(&self) -> PathBuf {
        PathBuf::from(self.text.trim())
    }
}

/// The field with its buttons.
fn typed_ui(ui: &mut Ui, typed: &mut Typed) -> Answer {
    ui.set_width(460.0);
    ui.heading(typed.purpose.title());
    ui.label(
        RichText::new("This system offers no file dialog: type the path.").color(theme::TEXT_WEAK),
    );
    let field = TextEdit::singleline(&mut typed.text)
        .hint_text("/folder/file")
        .desired_width(f32::INFINITY);
    let field = ui.add(field).accessible_name("Path");
    if field.changed() {
        typed.look();
    }
    let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
    if ui.memory(|memory| memory.focused().is_none()) && !entered {
        field.request_focus();
    }
    if typed.replaces {
        ui.label(RichText::new("This file exists and will be replaced.").color(theme::WARNING));
    }
    ui.add_space(8.0);
    let mut answer = Answer::None;
    ui.horizontal(|ui| {
        let ready = !typed.text.trim().is_empty();
        let confirm = ui.add_enabled(ready, theme::main_button(typed.purpose.action()));
        if confirm.clicked() || (entered && ready) {
            answer = Answer::Path(typed.path());
        }
        if ui.add(theme::dialog_button("Cancel")).clicked() {
            answer = Answer::Cancelled;
        }
    });
    answer
}

/// Asks by the desktop's own dialog.
pub fn ask_desktop(question: &Question) -> Option<PathBuf> {
    let mut dialog = rfd::FileDialog::new().set_title(question.purpose.title());
    let folder = match question.purpose {
        Purpose::Open => Some(question.suggestion.as_path()),
        Purpose::SaveScene | Purpose::ExportStill | Purpose::SaveDrawing(_) => {
            question.suggestion.parent()
        }
    };
    if let Some(folder) = folder.filter(|folder| folder.is_dir()) {
        dialog = dialog.set_directory(folder);
    }
    if let Some(name) = question.suggestion.file_name().and_then(|name| name.to_str()) {
        dialog = dialog.set_file_name(name);
    }
    match question.purpose {
        Purpose::Open => dialog
            .set_file_name("")
            .add_filter("Scenes, meshes and stills", &["toml", "gltf", "glb", "png", "exr"])
            .pick_file(),
        Purpose::SaveScene => dialog
            .add_filter("Scene", &["toml"])
            .save_file()
            .map(|path| with_default_extension(path, "toml")),
        Purpose::ExportStill => {
            dialog.add_filter("PNG", &["png"]).add_filter("OpenEXR", &["exr"]).save_file()
        }
        Purpose::SaveDrawing(SheetFormat::Svg) => dialog.add_filter("SVG", &["svg"]).save_file(),
        Purpose::SaveDrawing(SheetFormat::Png) => dialog.add_filter("PNG", &["png"]).save_file(),
    }
}

fn with_default_extension(path: PathBuf, extension: &str) -> PathBuf {
    if Path::new(&path).extension().is_some() { path } else { path.with_extension(extension) }
}
