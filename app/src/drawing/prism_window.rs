//! The window with the prism diagram: how rays are divided, without and with `perturb`.

use brilliance_renderer::drawing::{PerturbShown, PrismSetup, Sheet, prism_diagram};
use eframe::egui::{Context, RichText, Ui, Window, vec2};

use super::sheet_files::SaveSheet;
use super::sheet_view::SheetView;
use crate::row::{SliderRow, choice};
use crate::theme;

/// Width of the column of controls, in points.
const CONTROLS: f32 = 320.0;

/// The window, what it is set to and what was drawn of that.
#[derive(Default)]
pub struct PrismWindow {
    open: bool,
    wanted: Wanted,
    drawn: Option<(Wanted, Result<Sheet, String>)>,
    view: SheetView,
}

/// All that the diagram depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Wanted {
    setup: PrismSetup,
    shown: PerturbShown,
}

impl Default for Wanted {
    fn default() -> Self {
        Self { setup: PrismSetup::CLUMPING, shown: PerturbShown::default() }
    }
}

impl PrismWindow {
    /// Opens the window, or closes it.
    pub fn toggle(&mut self) {
        self.open = !self.open;
        self.view = SheetView::default();
    }

    /// Closes the window; true if it was open.
    pub fn close(&mut self) -> bool {
        std::mem::take(&mut self.open)
    }

    /// The diagram that is shown.
    pub fn sheet(&self) -> Option<&Sheet> {
        self.drawn.as_ref().filter(|_| self.open).and_then(|(_, sheet)| sheet.as_ref().ok())
    }

    /// Shows the diagram beside its controls.
    pub fn show(&mut self, ctx: &Context) -> Option<SaveSheet> {
        if !self.open {
            return None;
        }
        let mut open = true;
        let shown = Window::new("How rays are divided")
            .open(&mut open)
            .collapsible(false)
            .default_size([1120.0, 620.0])
            .min_size([CONTROLS + 240.0, 320.0])
            .default_pos(ctx.content_rect().left_top() + vec2(24.0, 56.0))
            .show(ctx, |ui| {
                ui.horizontal_top(|ui| {
                    let order = ui.vertical(|ui| self.controls_ui(ui)).inner;
                    self.update();
                    self.picture_ui(ui);
                    order
                })
                .inner
            });
        self.open = open;
        shown.and_then(|window| window.inner).flatten()
    }

    /// Draws anew if what is wanted has changed.
    fn update(&mut self) {
        if self.drawn.as_ref().is_none_or(|(wanted, _)| *wanted != self.wanted) {
            let Wanted { setup, shown } = self.wanted;
            let sheet = prism_diagram(&setup, shown).map_err(|fault| fault.to_string());
            self.drawn = Some((self.wanted, sheet));
        }
    }

    fn picture_ui(&mut self, ui: &mut Ui) {
        match &self.drawn {
            Some((_, Ok(sheet))) => {
                let size = ui.available_size();
                self.view.show(ui, sheet, size);
            }
            Some((_, Err(fault))) => {
                ui.label(RichText::new(fault).color(theme::WARNING));
            }
            None => {}
        }
    }

    fn controls_ui(&mut self, ui: &mut Ui) -> Option<SaveSheet> {
        ui.set_width(CONTROLS);
        ui.label(
            "Where a ray is divided, each part should arrive from the direction of its own \
             wavelengths (Thomas 1986, perturb). Otherwise the parts leave in clumps, or cross.",
        );
        ui.add_space(6.0);
        ui.horizontal(|ui| {
            for (text, setup) in
                [("Clumps", PrismSetup::CLUMPING), ("Crossings", PrismSetup::CROSSING)]
            {
                if ui.add(theme::dialog_button(text)).clicked() {
                    self.wanted.setup = setup;
                }
            }
        });
        ui.add_space(6.0);
        choice(
            ui,
            "Perturb",
            "Whether the parts of a divided ray take their own directions.",
            &mut self.wanted.shown,
            &[
                (PerturbShown::Off, "Off"),
                (PerturbShown::On, "On"),
                (PerturbShown::Both, "Off and on, side by side"),
            ],
        );
        setup_ui(ui, &mut self.wanted.setup);
        ui.add_space(8.0);
        let sheet = self.sheet()?;
        ui.horizontal(|ui| SaveSheet::buttons_ui(ui, sheet)).inner
    }
}

fn setup_ui(ui: &mut Ui, setup: &mut PrismSetup) {
    let default = PrismSetup::CLUMPING;
    let row = SliderRow::new;
    row(
        "Apex",
        "Angle between the two sides of the prism.",
        PrismSetup::APEX_DEGREES,
        default.apex_degrees,
    )
    .unit("°")
    .decimals(1)
    .show(ui, &mut setup.apex_degrees);
    row(
        "Incidence",
        "Angle at which the ray meets the left side, positive from below.",
        PrismSetup::INCIDENCE_DEGREES,
        default.incidence_degrees,
    )
    .unit("°")
    .decimals(1)
    .show(ui, &mut setup.incidence_degrees);
    row("Index", "Index of refraction at the D line, 589 nm.", PrismSetup::N_D, default.n_d)
        .decimals(3)
        .show(ui, &mut setup.n_d);
    row(
        "Dispersion B\u{2013}G",
        "Index at 431 nm less that at 687 nm. Diamond has 0.044; more makes it plainer.",
        PrismSetup::DISPERSION_BG,
        default.dispersion_bg,
    )
    .decimals(3)
    .show(ui, &mut setup.dispersion_bg);
    row(
        "Smallest lamp",
        "Rays are divided until they are fine enough for a lamp of this width.",
        PrismSetup::LAMP_DEGREES,
        default.lamp_degrees,
    )
    .unit("°")
    .decimals(1)
    .show(ui, &mut setup.lamp_degrees);
    row(
        "Split count",
        "How many of the parts should hit that lamp.",
        PrismSetup::SPLIT_COUNT,
        default.split_count,
    )
    .decimals(1)
    .show(ui, &mut setup.split_count);
}
