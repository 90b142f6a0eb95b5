//! What the user can tell the program to do, and the keys for it.

use brilliance_renderer::develop::Shown;
use brilliance_renderer::tracer::Backend;
use eframe::egui::{Context, Key, KeyboardShortcut, Modifiers};

use crate::orbit::StandardView;

/// An order from a menu or the keyboard.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Command {
    /// Asks for a file to open.
    Open,
    /// Opens one of the program's own scenes.
    OpenScene(usize),
    /// Writes the scene file.
    Save,
    /// Writes the scene to another file.
    SaveAs,
    /// Opens the export window.
    ExportStill,
    /// Ends the program.
    Quit,
    /// Takes the last edit back.
    Undo,
    /// Makes the undone edit again.
    Redo,
    /// Puts everything back to how it was opened.
    Reset,
    /// Looks from a standard direction.
    Look(StandardView),
    /// Puts the camera back to where the scene has it.
    ResetCamera,
    /// Turns the stone by this many points of drag.
    Turn([f32; 2]),
    /// Comes nearer by this factor.
    Zoom(f32),
    /// Shows this of what was traced.
    Show(Shown),
    /// Shows the next of what can be shown.
    ShowNext,
    /// Traces by another tracer.
    TraceWith(Backend),
    /// Gives a graphics device that has failed another chance.
    RetryGraphics,
    /// Shows or hides the line drawing of the stone.
    ToggleDrawing,
    /// Shows or hides the diagram of how rays are divided.
    TogglePrism,
    /// Shows or hides the inspector.
    ToggleInspector,
    /// Shows or hides the panel.
    TogglePanel,
    /// Lists the mouse buttons and keys.
    ShowKeys,
    /// Says what this program is.
    ShowAbout,
    /// Closes what lies over the picture.
    Dismiss,
}

/// Points of drag per press of an arrow key.
const TURN_STEP: f32 = 12.0;
/// Zoom per press of plus.
const ZOOM_STEP: f32 = 1.15;

const COMMAND_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);

/// Keys with modifiers, those with more modifiers first.
const SHORTCUTS: [(Command, KeyboardShortcut); 8] = [
    (Command::SaveAs, KeyboardShortcut::new(COMMAND_SHIFT, Key::S)),
    (Command::Redo, KeyboardShortcut::new(COMMAND_SHIFT, Key::Z)),
    (Command::Redo, KeyboardShortcut::new(Modifiers::COMMAND, Key::Y)),
    (Command::Undo, KeyboardShortcut::new(Modifiers::COMMAND, Key::Z)),
    (Command::Open, KeyboardShortcut::new(Modifiers::COMMAND, Key::O)),
    (Command::Save, KeyboardShortcut::new(Modifiers::COMMAND, Key::S)),
    (Command::ExportStill, KeyboardShortcut::new(Modifiers::COMMAND, Key::E)),
    (Command::Quit, KeyboardShortcut::new(Modifiers::COMMAND, Key::Q)),
];

/// Plain keys, for when no text is typed.
const VIEW_KEYS: [(Key, Command); 13] = [
    (Key::Num1, Command::Look(StandardView::FaceUp)),
    (Key::F, Command::Look(StandardView::FaceUp)),
    (Key::Num3, Command::Look(StandardView::Side)),
    (Key::S, Command::Look(StandardView::Side)),
    (Key::Num7, Command::Look(StandardView::Pavilion)),
    (Key::P, Command::Look(StandardView::Pavilion)),
    (Key::R, Command::ResetCamera),
    (Key::L, Command::ToggleDrawing),
    (Key::I, Command::ToggleInspector),
    (Key::H, Command::ShowNext),
    (Key::F1, Command::ShowKeys),
    (Key::F9, Command::TogglePanel),
    (Key::Escape, Command::Dismiss),
];

/// Plain keys that a focused slider needs for itself.
const MOTION_KEYS: [(Key, Command); 7] = [
    (Key::ArrowLeft, Command::Turn([-TURN_STEP, 0.0])),
    (Key::ArrowRight, Command::Turn([TURN_STEP, 0.0])),
    (Key::ArrowUp, Command::Turn([0.0, -TURN_STEP])),
    (Key::ArrowDown, Command::Turn([0.0, TURN_STEP])),
    (Key::Plus, Command::Zoom(ZOOM_STEP)),
    (Key::Equals, Command::Zoom(ZOOM_STEP)),
    (Key::Minus, Command::Zoom(1.0 / ZOOM_STEP)),
];

impl Command {
    /// The keys for the menu to show.
    pub fn shortcut_text(self, ctx: &Context) -> Option<String> {
        let plain = || VIEW_KEYS.iter().find(|(_, command)| *command == self);
        SHORTCUTS
            .iter()
            .find(|(command, _)| *command == self)
            .map(|(_, shortcut)| ctx.format_shortcut(shortcut))
            .or_else(|| plain().map(|(key, _)| key.name().to_owned()))
    }
}

/// Whether plain keys are being typed into something.
pub fn is_typing(ctx: &Context) -> bool {
    ctx.text_edit_focused() || ctx.any_popup_open()
}

/// The commands whose keys were pressed in this frame. `over_picture` says that the picture has
/// the focus, if anything has; `was_typing` is [`is_typing`] before the frame's widgets, one of
/// which may have taken the keys and then given up the focus.
pub fn pressed(ctx: &Context, over_picture: bool, was_typing: bool) -> Vec<Command> {
    let mut commands: Vec<_> = ctx.input_mut(|input| {
        let consumed = SHORTCUTS.iter().filter(|(_, shortcut)| input.consume_shortcut(shortcut));
        consumed.map(|(command, _)| *command).collect()
    });
    if was_typing || is_typing(ctx) {
        return commands;
    }
    let unfocused = over_picture || ctx.memory(|memory| memory.focused().is_none());
    let motion = MOTION_KEYS.iter().filter(|_| unfocused);
    ctx.input_mut(|input| {
        for &(key, command) in VIEW_KEYS.iter().chain(motion) {
            // A plus may need the shift key.
            let modifiers = input.modifiers;
            if modifiers.command || modifiers.ctrl || modifiers.alt {
                break;
            }
            let presses = input.count_and_consume_key(Modifiers::NONE, key);
            commands.extend(std::iter::repeat_n(command, presses));
        }
    });
    commands
}
