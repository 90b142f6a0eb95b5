//! The export window: a still at any size, written to a file.

mod form;
mod job;

use std::path::{Path, PathBuf};

use brilliance_renderer::error::RendererError;
use brilliance_renderer::film::Film;
use brilliance_renderer::scene_file::StillSettings;
use brilliance_renderer::still::StillFormat;
use eframe::egui::{self, ProgressBar, RichText, Ui, Window};

use form::Form;
use job::RunningJob;
pub use job::{RenderStill, StillJob, StillReport, render_and_write};

use crate::notice::{Notices, naming};
use crate::row::readout;
use crate::status::duration;
use crate::task::TaskState;
use crate::theme;
use crate::waker::Waker;

const FAILED: &str = "Export failed";

/// What the user asked the window for.
#[derive(Clone, Debug, PartialEq)]
pub enum ExportAction {
    /// A dialog to choose the path.
    Browse(PathBuf),
    /// To render a still of this size and number of passes.
    Start(StillOrder),
}

/// A still as the window describes it; the app adds the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct StillOrder {
    /// Where it is written.
    pub path: PathBuf,
    /// How it is written.
    pub format: StillFormat,
    /// Size and passes.
    pub still: StillSettings,
}

/// The export window and the job it started.
pub struct ExportWindow {
    render: RenderStill,
    open: bool,
    form: Form,
    running: Option<RunningJob>,
}

impl ExportWindow {
    /// A closed window; `render` does the work.
    pub fn new(render: RenderStill) -> Self {
        Self { render, open: false, form: Form::default(), running: None }
    }

    /// Opens the window for a document whose still is `still`; `suggestion` is the file to be,
    /// without ending.
    pub fn open(&mut self, still: StillSettings, suggestion: &Path) {
        if !self.open && self.running.is_none() {
            self.form.begin(still, suggestion);
        }
        self.open = true;
    }

    /// Closes the window, while nothing runs; true if it was open.
    pub fn close(&mut self) -> bool {
        let closes = self.open && self.running.is_none();
        self.open &= !closes;
        closes
    }

    /// True while a still is rendered.
    pub fn is_running(&self) -> bool {
        self.running.is_some()
    }

    /// Ends the job, if one runs.
    pub fn cancel(&self) {
        if let Some(running) = &self.running {
            running.cancel();
        }
    }

    /// Takes over a path from a dialog, and the format its ending names.
    pub fn set_path(&mut self, path: &Path) {
        self.form.set_path(path);
    }

    /// Starts `job`.
    pub fn start(&mut self, job: StillJob, waker: &Waker, notices: &mut Notices) {
        match RunningJob::start(job, &self.render, waker) {
            Ok(running) => {
                notices.withdraw(FAILED);
                self.running = Some(running);
            }
            Err(fault) => notices.error(
                "Export not started",
                format!("The system gives no thread: {fault}. Close other programs and try again."),
            ),
        }
    }

    /// Looks whether the job has finished and says so.
    pub fn poll(&mut self, notices: &mut Notices) {
        let Some(running) = &self.running else { return };
        let path = running.path.display();
        match running.poll() {
            TaskState::Running => return,
            TaskState::Finished(Ok(report)) => {
                let StillReport { passes, tracing_seconds, tracer, warning } = report;
                let cost = duration(tracing_seconds);
                let unit = if passes == 1 { "pass" } else { "passes" };
                let mut text = format!("{path}\n{passes} {unit}, {cost} of tracing on {tracer}");
                if let Some(warning) = warning {
                    text.push_str("\nThe graphics device could not: ");
                    text.push_str(&warning);
                }
                notices.confirm("Still exported", text);
            }
            TaskState::Finished(Err(RendererError::Cancelled)) => {
                notices.confirm("Export cancelled", "Nothing was written.");
            }
            TaskState::Finished(Err(fault)) => {
                let path = path.to_string();
                notices.error(FAILED, naming(&path, &fault.to_string()));
            }
            TaskState::Broken => notices.error(
                FAILED,
                format!("{path} was not written: the renderer stopped. Try a smaller size."),
            ),
        }
        self.running = None;
        self.form.look();
    }

    /// Shows the window. `window_size` is the size of the viewport in pixels, `bins` the number
    /// of spectral bins of the film.
    pub fn show(
        &mut self,
        ctx: &egui::Context,
        window_size: [u32; 2],
        bins: u32,
    ) -> Option<ExportAction> {
        let mut open = self.open;
        let shown = Window::new("Export still")
            .open(&mut open)
            .collapsible(false)
            .resizable(false)
            .default_width(420.0)
            // Beside the stone, not on it.
            .default_pos(ctx.content_rect().left_top() + egui::vec2(16.0, 44.0))
            .show(ctx, |ui| {
                ui.set_width(420.0);
                let idle = self.running.is_none();
                let browse = ui.add_enabled_ui(idle, |ui| self.form.show(ui, window_size)).inner;
                ui.add_space(4.0);
                ui.separator();
                if browse {
                    return Some(ExportAction::Browse(self.form.path()));
                }
                self.footer_ui(ui, bins)
            });
        self.open = open;
        shown.and_then(|window| window.inner).flatten()
    }

    fn footer_ui(&mut self, ui: &mut Ui, bins: u32) -> Option<ExportAction> {
        if let Some(running) = &self.running {
            running_ui(ui, running);
            return None;
        }
        let film = Film::bytes(self.form.size(), bins);
        let text = format!("{:.0} MB", film as f64 / 1e6);
        readout(ui, "Memory", "What the spectral film of this still needs.", &text);
        let fault = self.form.fault().map(str::to_owned).or_else(|| {
            (film > Film::MAX_BYTES || !self.form.can_be_opened_again()).then(|| {
                format!("A film of {text} is too large: choose a smaller size or fewer bins.")
            })
        });
        if let Some(fault) = &fault {
            ui.label(RichText::new(fault).color(theme::WARNING));
        }
        let export =
            ui.horizontal(|ui| ui.add_enabled(fault.is_none(), theme::main_button("Export")));
        export.inner.clicked().then(|| ExportAction::Start(self.form.order()))
    }
}

fn running_ui(ui: &mut Ui, running: &RunningJob) {
    let (done, all) = running.passes();
    let fraction = done as f32 / all.max(1) as f32;
    let left = match running.seconds_left() {
        Some(seconds) if !running.is_cancelled() => format!(", {} left", duration(seconds)),
        _ => String::new(),
    };
    ui.add(ProgressBar::new(fraction).desired_height(6.0).fill(theme::ACCENT));
    ui.horizontal(|ui| {
        let cancel = ui.add_enabled(!running.is_cancelled(), theme::dialog_button("Cancel"));
        if cancel.clicked() {
            running.cancel();
        }
        ui.label(RichText::new(format!("Pass {done} of {all}{left}")).color(theme::TEXT_WEAK));
    });
}
