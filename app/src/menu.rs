//! The menu bar.

use brilliance_renderer::develop::Shown;
use brilliance_renderer::scene_file::scenes;
use eframe::egui::{Button, Frame, Margin, MenuBar, Panel, RichText, Ui};

use crate::command::Command;
use crate::editor::Editor;
use crate::orbit::StandardView;
use crate::shown;
use crate::theme;
use crate::tracers::{self, Tracers};

/// What the menu tells of the program.
#[derive(Clone, Copy, Debug)]
pub struct State<'a> {
    /// What is edited.
    pub editor: &'a Editor,
    /// What traces.
    pub tracers: &'a Tracers,
    /// What is shown of the film.
    pub shown: Shown,
    /// Whether the panel at the right edge is open.
    pub panel_is_open: bool,
    /// Whether the inspector at the left edge is open.
    pub inspector_is_open: bool,
}

/// Shows the bar at the top edge; gives what was chosen.
pub fn show(ui: &mut Ui, state: &State<'_>) -> Option<Command> {
    let frame = Frame::new().fill(theme::PANEL).inner_margin(Margin::symmetric(8, 3));
    let bar = Panel::top("menu").frame(frame).show(ui, |ui| {
        let mut chosen = None;
        MenuBar::new().ui(ui, |ui| {
            ui.menu_button("File", |ui| file_ui(ui, &mut chosen));
            ui.menu_button("Edit", |ui| edit_ui(ui, state.editor, &mut chosen));
            ui.menu_button("View", |ui| view_ui(ui, state, &mut chosen));
            ui.menu_button("Help", |ui| {
                entry(ui, true, "Mouse and keys", Command::ShowKeys, &mut chosen);
                entry(ui, true, "How rays are divided", Command::TogglePrism, &mut chosen);
                entry(ui, true, "About Brilliance", Command::ShowAbout, &mut chosen);
            });
            ui.add_space(12.0);
            ui.label(RichText::new(state.editor.title()).color(theme::TEXT_WEAK));
        });
        chosen
    });
    bar.inner
}

fn file_ui(ui: &mut Ui, chosen: &mut Option<Command>) {
    entry(ui, true, "Open\u{2026}", Command::Open, chosen);
    ui.menu_button("Open scene", |ui| {
        for (index, scene) in scenes().iter().enumerate() {
            if ui.button(scene.name).on_hover_text(description(scene.text)).clicked() {
                *chosen = Some(Command::OpenScene(index));
            }
        }
    });
    ui.separator();
    entry(ui, true, "Save scene", Command::Save, chosen);
    entry(ui, true, "Save scene as\u{2026}", Command::SaveAs, chosen);
    entry(ui, true, "Export still\u{2026}", Command::ExportStill, chosen);
    ui.separator();
    entry(ui, true, "Quit", Command::Quit, chosen);
}

/// What a scene file says of itself in the comment it begins with.
fn description(scene: &str) -> String {
    let comment = scene.lines().map_while(|line| line.strip_prefix('#'));
    comment.map(str::trim).collect::<Vec<_>>().join(" ")
}

fn edit_ui(ui: &mut Ui, editor: &Editor, chosen: &mut Option<Command>) {
    let (has_past, has_future) = editor.has_past_and_future();
    entry(ui, has_past, "Undo", Command::Undo, chosen);
    entry(ui, has_future, "Redo", Command::Redo, chosen);
    ui.separator();
    entry(ui, editor.edited(), "Reset all changes", Command::Reset, chosen);
}

fn view_ui(ui: &mut Ui, state: &State<'_>, chosen: &mut Option<Command>) {
    entry(ui, true, "Face-up", Command::Look(StandardView::FaceUp), chosen);
    entry(ui, true, "Side", Command::Look(StandardView::Side), chosen);
    entry(ui, true, "Pavilion-up", Command::Look(StandardView::Pavilion), chosen);
    entry(ui, true, "Reset camera", Command::ResetCamera, chosen);
    ui.separator();
    ui.menu_button("Show", |ui| shown::menu_ui(ui, state.shown, chosen));
    entry(ui, true, "Line drawing", Command::ToggleDrawing, chosen);
    ui.separator();
    ui.menu_button("Trace with", |ui| tracers::menu_ui(ui, state.tracers, chosen));
    ui.separator();
    let inspector = if state.inspector_is_open { "Hide inspector" } else { "Show inspector" };
    entry(ui, true, inspector, Command::ToggleInspector, chosen);
    let panel = if state.panel_is_open { "Hide panel" } else { "Show panel" };
    entry(ui, true, panel, Command::TogglePanel, chosen);
}

fn entry(ui: &mut Ui, enabled: bool, text: &str, command: Command, chosen: &mut Option<Command>) {
    let shortcut = command.shortcut_text(ui.ctx()).unwrap_or_default();
    let button = Button::new(text).shortcut_text(shortcut);
    if ui.add_enabled(enabled, button).clicked() {
        *chosen = Some(command);
    }
}
