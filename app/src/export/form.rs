//! The form of the export window: which file, how large, how many passes.

use std::path::{Path, PathBuf};

use brilliance_renderer::scene_file::StillSettings;
use brilliance_renderer::still::StillFormat;
use eframe::egui::{Button, DragValue, RichText, TextEdit, Ui};

use super::StillOrder;
use crate::panels::{MAX_PASSES, noise_ui};
use crate::row::{SliderRow, choice, combo, labelled, switch};
use crate::theme;

/// Longest side of a still, in pixels.
const LARGEST_SIDE: u32 = *StillSettings::SIDE.end();
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

/// A still as it is being described.
pub(super) struct Form {
    path: String,
    /// The file exists and would be replaced.
    replaces: bool,
    format: Format,
    spectral: bool,
    still: StillSettings,
    /// Width over height while the proportions are locked.
    locked_aspect: Option<f64>,
}

impl Default for Form {
    fn default() -> Self {
        Self {
            path: String::new(),
            replaces: false,
            format: Format::Png8,
            spectral: false,
            still: StillSettings::default(),
            locked_aspect: None,
        }
    }
}

impl Form {
    /// Begins anew with the size and the effort of `still`; the format is that of the last time.
    pub(super) fn begin(&mut self, still: StillSettings, suggestion: &Path) {
        self.still = still;
        self.locked_aspect = None;
        self.set_path(&suggestion.with_extension(self.extension()));
    }

    /// Takes over a path, and the format its ending names.
    pub(super) fn set_path(&mut self, path: &Path) {
        self.path = path.display().to_string();
        self.follow_path();
    }

    /// The file that is named.
    pub(super) fn path(&self) -> PathBuf {
        PathBuf::from(self.path.trim())
    }

    /// Width and height in pixels.
    pub(super) fn size(&self) -> [u32; 2] {
        self.still.size
    }

    /// Whether the scene inside the still will be one that the program accepts.
    pub(super) fn can_be_opened_again(&self) -> bool {
        let [width, height] = self.still.size.map(u64::from);
        width * height <= StillSettings::MAX_PIXELS
    }

    /// Looks whether the file exists.
    pub(super) fn look(&mut self) {
        self.replaces = self.path().is_file();
    }

    /// What keeps the file from being written, if it can be seen from its name.
    pub(super) fn fault(&self) -> Option<&'static str> {
        let path = self.path();
        if path.file_name().is_none() {
            Some("Type a file name, or browse for a folder.")
        } else if path
            .extension()
            .is_some_and(|ending| ending.eq_ignore_ascii_case(self.extension()))
        {
            None
        } else {
            Some("The name must end with .png or .exr.")
        }
    }

    /// The still that is described.
    pub(super) fn order(&self) -> StillOrder {
        StillOrder { path: self.path(), format: self.still_format(), still: self.still }
    }

    /// Shows the form; true when a dialog for the path is asked for.
    pub(super) fn show(&mut self, ui: &mut Ui, window_size: [u32; 2]) -> bool {
        let browse = self.path_ui(ui);
        let tooltip = "PNG is ready to show; OpenEXR keeps the light as it is, for other programs.";
        if choice(ui, "Format", tooltip, &mut self.format, &FORMATS) {
            let path = self.path().with_extension(self.extension());
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
        noise_ui(ui, &mut self.still.noise);
        browse
    }

    fn path_ui(&mut self, ui: &mut Ui) -> bool {
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
        browse
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
        self.look();
        let path = self.path();
        let Some(extension) = path.extension() else { return };
        if extension.eq_ignore_ascii_case("exr") {
            self.format = Format::Exr;
        } else if extension.eq_ignore_ascii_case("png") && self.format == Format::Exr {
            self.format = Format::Png8;
        }
    }
}

fn aspect([width, height]: [u32; 2]) -> f64 {
    f64::from(width) / f64::from(height.max(1))
}
