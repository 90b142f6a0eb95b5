//! Drawings on their way to files.

use std::path::{Path, PathBuf};

use brilliance_renderer::drawing::{Sheet, SheetFormat};
use brilliance_renderer::error::RendererError;
use eframe::egui::Ui;

use crate::notice::{Notices, naming};
use crate::task::{Task, TaskState};
use crate::theme;
use crate::waker::Waker;

const NOT_SAVED: &str = "Drawing not saved";

/// A drawing to be saved, as it was when the user asked.
#[derive(Clone, Debug, PartialEq)]
pub struct SaveSheet {
    /// The drawing.
    pub sheet: Sheet,
    /// How it is written.
    pub format: SheetFormat,
}

/// The drawing that waits for a path, and the one that is written.
#[derive(Default)]
pub struct SheetFiles {
    asked: Option<SaveSheet>,
    writing: Option<(PathBuf, Task<Result<(), RendererError>>)>,
}

impl SaveSheet {
    /// Shows the two buttons under a drawing; gives what was asked for.
    pub fn buttons_ui(ui: &mut Ui, sheet: &Sheet) -> Option<Self> {
        let formats =
            [("Save SVG\u{2026}", SheetFormat::Svg), ("Save PNG\u{2026}", SheetFormat::Png)];
        let mut order = None;
        for (text, format) in formats {
            if ui.add(theme::dialog_button(text)).clicked() {
                order = Some(Self { sheet: sheet.clone(), format });
            }
        }
        order
    }
}

/// The usual ending of files in this format.
pub fn extension(format: SheetFormat) -> &'static str {
    match format {
        SheetFormat::Svg => "svg",
        SheetFormat::Png => "png",
    }
}

impl SheetFiles {
    /// Keeps `order` until there is a path for it.
    pub fn await_path(&mut self, order: SaveSheet) {
        self.asked = Some(order);
    }

    /// Writes the drawing that waits to `path`, whose ending may be missing or name the other format.
    pub fn write(&mut self, path: &Path, waker: &Waker, notices: &mut Notices) {
        let Some(SaveSheet { sheet, format }) = self.asked.take() else { return };
        let mut name = path.as_os_str().to_owned();
        if SheetFormat::of(path).is_err() {
            name.push(".");
            name.push(extension(format));
        }
        let path = PathBuf::from(name);
        let target = path.clone();
        let save = move || sheet.save(&target, sheet.size_at(Sheet::DPI));
        match Task::spawn("save drawing", waker, save) {
            Ok(task) => self.writing = Some((path, task)),
            Err(fault) => notices.error(
                NOT_SAVED,
                format!("The system gives no thread: {fault}. Close other programs and try again."),
            ),
        }
    }

    /// Looks whether the drawing has been written and says so.
    pub fn poll(&mut self, notices: &mut Notices) {
        let Some((path, task)) = self.writing.take() else { return };
        let name = path.display().to_string();
        match task.poll() {
            TaskState::Running => self.writing = Some((path, task)),
            TaskState::Finished(Ok(())) => {
                notices.withdraw(NOT_SAVED);
                notices.confirm("Drawing saved", name);
            }
            TaskState::Finished(Err(fault)) => {
                notices.error(NOT_SAVED, naming(&name, &fault.to_string()));
            }
            TaskState::Broken => {
                let fault = "the program failed while writing it; please report this drawing";
                notices.error(NOT_SAVED, naming(&name, fault));
            }
        }
    }
}
