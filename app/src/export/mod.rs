//! The export window: a still at any size, written to a file.

mod job;

use std::path::{Path, PathBuf};

use brilliance_renderer::error::RendererError;
use brilliance_renderer::scene_file::StillSettings;
use brilliance_renderer::still::StillFormat;
use eframe::egui::{self, Button, DragValue, ProgressBar, RichText, TextEdit, Ui, Window};

use job::RunningJob;
pub use job::{RenderStill, StillJob, StillReport, render_and_write};

use crate::notice::Notices;
use crate::panels::MAX_PASSES;
use crate::row::{SliderRow, choice, combo, labelled, readout, switch};
use crate::status::duration;
use crate::task::TaskState;
use crate::theme;

/// Longest side of a still, in pixels.
const LARGEST_SIDE: u32 = *StillSettings::SIDE.end();
/// Largest film of a still, in bytes.
const LARGEST_FILM: u64 = 8 << 30;

const SIZES: [(&str, [u32; 2]); 6] = [
    ("1280 × 800", [1280, 800]),
    ("1920 × 1080, Full HD", [1920, 1080]),
    ("2560 × 1440", [2560, 1440]),
    ("3840 × 2160, 4K", [3840, 2160]),
    ("1024 × 1024, square", [1024, 1024]),
    ("2048 × 2048, square", [2048, 2048]),
];

/// File formats, without the spectral switch.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Format {
    Png8,
    Png16,
    Exr,
}

const FORMATS: [(Format, &str); 3] = [
    (Format::Png8, "PNG, 8 bit"),
    (Format::Png16, "PNG, 16 bit"),
    (Format::Exr, "OpenEXR, linear"),
];

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
    path: String,
    /// The file exists and would be replaced.
    replaces: bool,
    format: Format,
    spectral: bool,
    still: StillSettings,
    /// Width over height while the proportions are locked.
    locked_aspect: Option<f64>,
    running: Option<RunningJob>,
}

impl ExportWindow {
    /// A closed window; `render` does the work.
    pub fn new(render: RenderStill) -> Self {
        Self {
            render,
            open: false,
            path: String::new(),
            replaces: false,
            format: Format::Png8,
            spectral: false,
            still: StillSettings::default(),
            locked_aspect: None,
            running: None,
        }
    }

    /// Opens the window for a document whose still is `still`; `suggestion` is the file to be,
    /// without ending.
    pub fn open(&mut self, still: StillSettings, suggestion: &Path) {
        if !self.open && self.running.is_none() {
            self.still = still;
            self.locked_aspect = None;
            self.set_path(&suggestion.with_extension(self.extension()));
        }
        self.open = true;
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
        self.path = path.display().to_string();
        self.follow_path();
    }

    /// Starts `job`.
    pub fn start(&mut self, job: StillJob, ctx: &egui::Context, notices: &mut Notices) {
        match RunningJob::start(job, &self.render, ctx) {
            Ok(running) => self.running = Some(running),
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
                let cost = duration(report.tracing_seconds);
                let text = format!("{path}\n{} passes, {cost} of tracing", report.passes);
                notices.confirm("Still exported", text);
            }
            TaskState::Finished(Err(RendererError::Cancelled)) => {
                notices.confirm("Export cancelled", "Nothing was written.");
            }
            TaskState::Finished(Err(fault)) => notices.error(
                "Export failed",
                format!("{path} was not written: {fault}. Choose another folder or size."),
            ),
            TaskState::Broken => notices.error(
                "Export failed",
                format!("{path} was not written: the renderer stopped. Try a smaller size."),
            ),
        }
        self.running = None;
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
            .pivot(egui::Align2::CENTER_CENTER)
            .default_pos(ctx.content_rect().center())
            .show(ctx, |ui| {
                ui.set_width(420.0);
                let idle = self.running.is_none();
                let browse = ui.add_enabled_ui(idle, |ui| self.settings_ui(ui, window_size)).inner;
                ui.add_space(4.0);
                ui.separator();
                browse.or_else(|| self.footer_ui(ui, bins))
            });
        self.open = open;
        shown.and_then(|window| window.inner).flatten()
    }

    fn settings_ui(&mut self, ui: &mut Ui, window_size: [u32; 2]) -> Option<ExportAction> {
        let browse = self.path_ui(ui);
        let tooltip = "PNG is ready to show; OpenEXR keeps the light as it is, for other programs.";
        if choice(ui, "Format", tooltip, &mut self.format, &FORMATS) {
            let path = Path::new(self.path.trim()).with_extension(self.extension());
            self.set_path(&path);
        }
        if self.format == Format::Exr {
            let tooltip = "Adds one channel for each spectral bin of the film.";
            switch(ui, "Spectral layers", tooltip, &mut self.spectral);
        }
        self.size_ui(ui, window_size);
        SliderRow::new(
            "Passes",
            "Rays per pixel: more make edges smoother and take longer.",
            1.0..=f64::from(MAX_PASSES),
            StillSettings::default().passes,
        )
        .logarithmic()
        .show_u32(ui, &mut self.still.passes);
        browse
    }

    fn path_ui(&mut self, ui: &mut Ui) -> Option<ExportAction> {
        let tooltip = "Where the still is written; the ending chooses the format.";
        let browse = labelled(ui, "File", tooltip, |ui, label| {
            let browse_width = 74.0;
            let width = ui.available_width() - browse_width - ui.spacing().item_spacing.x;
            let field = TextEdit::singleline(&mut self.path).desired_width(width);
            if ui.add_sized([width, 22.0], field).labelled_by(label.id).changed() {
                self.follow_path();
            }
            ui.add_sized([browse_width, 22.0], Button::new("Browse\u{2026}")).clicked()
        });
        if self.replaces {
            let text = RichText::new("This file exists and will be replaced.").small();
            ui.label(text.color(theme::WARNING));
        }
        browse.then(|| ExportAction::Browse(PathBuf::from(self.path.trim())))
    }

    fn size_ui(&mut self, ui: &mut Ui, window_size: [u32; 2]) {
        let tooltip = "Common sizes, and that of the window.";
        labelled(ui, "Size", tooltip, |ui, label| {
            let preset = SIZES.iter().find(|(_, size)| *size == self.still.size);
            let shown = preset.map_or("Custom", |(name, _)| name);
            let mut chosen = None;
            combo(ui, "size", shown, |ui| {
                if ui.selectable_label(false, "As the window").clicked() {
                    chosen = Some(window_size);
                }
                for (name, size) in SIZES {
                    if ui.selectable_label(name == shown, name).clicked() {
                        chosen = Some(size);
                    }
                }
            })
            .labelled_by(label.id);
            if let Some(size) = chosen {
                self.still.size = size;
                self.locked_aspect = self.locked_aspect.map(|_| aspect(size));
            }
        });
        let old = self.still.size;
        for (side, name, tooltip) in
            [(0, "Width", "Width in pixels."), (1, "Height", "Height in pixels.")]
        {
            labelled(ui, name, tooltip, |ui, label| {
                let value = DragValue::new(&mut self.still.size[side])
                    .range(1..=LARGEST_SIDE)
                    .speed(4)
                    .update_while_editing(false)
                    .suffix(" px");
                ui.add_sized([96.0, 22.0], value).labelled_by(label.id);
            });
        }
        self.keep_aspect(old);
        let mut locked = self.locked_aspect.is_some();
        if switch(ui, "Lock proportions", "Width and height change together.", &mut locked) {
            self.locked_aspect = locked.then(|| aspect(self.still.size));
        }
    }

    /// With locked proportions, lets one side follow the other.
    fn keep_aspect(&mut self, old: [u32; 2]) {
        let Some(aspect) = self.locked_aspect else { return };
        let [width, height] = self.still.size.map(f64::from);
        let side = |pixels: f64| (pixels.round() as u32).clamp(1, LARGEST_SIDE);
        if self.still.size[0] != old[0] {
            self.still.size[1] = side(width / aspect);
        } else if self.still.size[1] != old[1] {
            self.still.size[0] = side(height * aspect);
        }
    }

    fn footer_ui(&mut self, ui: &mut Ui, bins: u32) -> Option<ExportAction> {
        if let Some(running) = &self.running {
            running_ui(ui, running);
            return None;
        }
        let film = film_bytes(self.still.size, bins);
        let text = format!("{:.0} MB", film as f64 / 1e6);
        readout(ui, "Memory", "What the spectral film of this still needs.", &text);
        let fault = if self.path.trim().is_empty() {
            Some("Type a file name, or browse for a folder.".to_owned())
        } else if film > LARGEST_FILM {
            Some(format!(
                "A film of {text} is too large: choose a smaller size or fewer spectral bins."
            ))
        } else {
            None
        };
        if let Some(fault) = &fault {
            ui.label(RichText::new(fault).color(theme::WARNING));
        }
        let export = Button::new(RichText::new("Export").color(theme::TEXT_STRONG))
            .fill(theme::ACCENT_DIM)
            .min_size(egui::vec2(96.0, 26.0));
        ui.add_enabled(fault.is_none(), export).clicked().then(|| {
            ExportAction::Start(StillOrder {
                path: PathBuf::from(self.path.trim()),
                format: self.still_format(),
                still: self.still,
            })
        })
    }

    fn still_format(&self) -> StillFormat {
        match self.format {
            Format::Png8 => StillFormat::Png8,
            Format::Png16 => StillFormat::Png16,
            Format::Exr => StillFormat::Exr { spectral: self.spectral },
        }
    }

    fn extension(&self) -> &'static str {
        if self.format == Format::Exr { "exr" } else { "png" }
    }

    /// Takes the format from the ending of the path.
    fn follow_path(&mut self) {
        let path = PathBuf::from(self.path.trim());
        self.replaces = path.is_file();
        let Some(extension) = path.extension() else { return };
        if extension.eq_ignore_ascii_case("exr") {
            self.format = Format::Exr;
        } else if extension.eq_ignore_ascii_case("png") && self.format == Format::Exr {
            self.format = Format::Png8;
        }
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
        let cancel = ui.add_enabled(!running.is_cancelled(), Button::new("Cancel"));
        if cancel.clicked() {
            running.cancel();
        }
        ui.label(RichText::new(format!("Pass {done} of {all}{left}")).color(theme::TEXT_WEAK));
    });
}

fn aspect([width, height]: [u32; 2]) -> f64 {
    f64::from(width) / f64::from(height.max(1))
}

fn film_bytes([width, height]: [u32; 2], bins: u32) -> u64 {
    u64::from(width) * u64::from(height) * u64::from(bins) * 4
}
