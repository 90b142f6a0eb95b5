//! What can trace, what traces, and the choice between them.

use brilliance_renderer::session::GraphicsState;
use brilliance_renderer::tracer::{Backend, TracerName};
use eframe::egui::{RadioButton, RichText, Ui};

use crate::command::Command;
use crate::theme;

/// Widest text in the menu, in points.
const MENU_WIDTH: f32 = 420.0;

/// The tracers as the menu and the status line tell of them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tracers {
    /// What the user asked for.
    pub chosen: Backend,
    /// The processor.
    pub processor: TracerName,
    /// The graphics device, if there is one.
    pub device: Option<TracerName>,
    /// How the session and the graphics device get on.
    pub state: GraphicsState,
    /// Why the processor last took over from a graphics device.
    pub refusal: Option<String>,
    /// What traced the picture that is shown; none before the first.
    pub in_use: Option<TracerName>,
}

/// The choice of a tracer, as a menu.
pub fn menu_ui(ui: &mut Ui, tracers: &Tracers, chosen: &mut Option<Command>) {
    ui.set_max_width(MENU_WIDTH);
    let mut choice = |ui: &mut Ui, backend, name, detail: &str, tooltip, fault: Option<String>| {
        let detail = RichText::new(detail).small().color(theme::TEXT_WEAK);
        let button = RadioButton::new(tracers.chosen == backend, (name, detail));
        let response = ui.add_enabled(fault.is_none(), button).on_hover_text(tooltip);
        if response.clicked() {
            *chosen = Some(Command::TraceWith(backend));
        }
        if let Some(fault) = fault {
            response.on_disabled_hover_text(fault);
        }
    };
    choice(
        ui,
        Backend::Auto,
        "Automatic",
        "",
        "A graphics card where there is one that can trace, else the processor.",
        None,
    );
    let processor = tracers.processor.to_string();
    choice(ui, Backend::Cpu, "Processor", &processor, "All of its cores; always there.", None);
    let device = tracers.device.as_ref().map_or_else(String::new, TracerName::to_string);
    let tooltip = tracers.device_tooltip();
    choice(ui, Backend::Gpu, "Graphics device", &device, tooltip, tracers.device_fault());
    ui.separator();
    let in_use = tracers.in_use.as_ref().unwrap_or(&tracers.processor);
    ui.label(RichText::new(format!("In use: {in_use}")).color(theme::TEXT_WEAK));
    if tracers.state == GraphicsState::Preparing {
        ui.label(RichText::new(PREPARING).color(theme::TEXT_WEAK));
    }
    if let Some((title, reason)) = tracers.fault() {
        ui.separator();
        ui.label(RichText::new(title).color(theme::ERROR));
        ui.label(reason);
        let tooltip = "Gives the graphics device another chance.";
        if ui.button("Try again").on_hover_text(tooltip).clicked() {
            *chosen = Some(Command::RetryGraphics);
        }
    }
}

const PREPARING: &str = "preparing the graphics device\u{2026}";

/// What traced the picture, and whether another tracer is on its way; from right to left.
pub fn status_ui(ui: &mut Ui, tracers: &Tracers) {
    let in_use = tracers.in_use.as_ref().unwrap_or(&tracers.processor).to_string();
    let small = |text: &str| RichText::new(text).small();
    ui.label(small(&in_use)).on_hover_text(
        "What traced the picture. View \u{203a} Trace with chooses between the processor and the \
         graphics device.",
    );
    if tracers.state == GraphicsState::Preparing {
        ui.label(small(PREPARING).color(theme::TEXT_WEAK)).on_hover_text(
            "Its programs are being compiled. Until that is done, the processor traces.",
        );
    }
}

impl Tracers {
    /// Why the processor traces what the graphics device was asked for.
    fn fault(&self) -> Option<(&str, &str)> {
        if let GraphicsState::Failed(reason) = &self.state {
            return Some(("The graphics device failed.", reason));
        }
        let Some(TracerName::Gpu { is_software, .. }) = self.device else { return None };
        let is_refused = self.state == GraphicsState::Ready
            && self.chosen.uses_device(is_software)
            && matches!(self.in_use, Some(TracerName::Cpu { .. }));
        let reason = self.refusal.as_deref().filter(|_| is_refused)?;
        Some(("Too much for the graphics device.", reason))
    }

    fn device_tooltip(&self) -> &'static str {
        if matches!(self.device, Some(TracerName::Gpu { is_software: true, .. })) {
            "This is the processor in disguise: slower than Processor, but a way to try it out."
        } else {
            "What draws this window."
        }
    }

    /// Why the graphics device can't be chosen.
    fn device_fault(&self) -> Option<String> {
        match &self.state {
            GraphicsState::Failed(reason) => {
                Some(format!("It failed; Try again is below.\n{reason}"))
            }
            _ if self.device.is_none() => {
                Some("The window has no graphics device to trace with.".to_owned())
            }
            _ => None,
        }
    }
}
