//! The look of the window: quiet and dark, so that the stone is what one sees.

use eframe::egui::style::{HandleShape, ScrollStyle};
use eframe::egui::{
    Button, Color32, Context, CornerRadius, FontId, Frame, Id, Margin, Modal, RichText, Shadow,
    Stroke, TextStyle, Theme, WidgetText, vec2,
};

/// Behind the picture.
pub const BACKDROP: Color32 = Color32::from_rgb(13, 14, 16);
/// Panels and bars.
pub const PANEL: Color32 = Color32::from_rgb(23, 24, 27);
/// Menus, windows and messages, above the panels.
pub const RAISED: Color32 = Color32::from_rgb(32, 34, 38);
/// Hairlines between areas.
pub const LINE: Color32 = Color32::from_rgb(42, 44, 49);
/// Rails and fields.
pub const FIELD: Color32 = Color32::from_rgb(44, 47, 53);
/// What can be ignored: units, explanations.
pub const TEXT_WEAK: Color32 = Color32::from_rgb(130, 135, 144);
/// What is read.
pub const TEXT: Color32 = Color32::from_rgb(196, 200, 206);
/// What stands out.
pub const TEXT_STRONG: Color32 = Color32::from_rgb(240, 242, 245);
/// What is chosen or turned: the blue of a good diamond's fluorescence.
pub const ACCENT: Color32 = Color32::from_rgb(112, 160, 222);
/// The accent where text stands on it.
pub const ACCENT_DIM: Color32 = Color32::from_rgb(52, 82, 122);
/// Something to know.
pub const WARNING: Color32 = Color32::from_rgb(226, 178, 94);
/// Something wrong.
pub const ERROR: Color32 = Color32::from_rgb(232, 116, 106);

/// Dresses the context.
pub fn apply(ctx: &Context) {
    ctx.set_theme(Theme::Dark);
    ctx.style_mut_of(Theme::Dark, |style| {
        style.text_styles = [
            (TextStyle::Heading, FontId::proportional(16.0)),
            (TextStyle::Body, FontId::proportional(13.0)),
            (TextStyle::Button, FontId::proportional(13.0)),
            (TextStyle::Small, FontId::proportional(11.5)),
            (TextStyle::Monospace, FontId::monospace(12.5)),
        ]
        .into();
        let spacing = &mut style.spacing;
        spacing.item_spacing = vec2(8.0, 4.0);
        spacing.button_padding = vec2(8.0, 3.0);
        spacing.window_margin = Margin::same(14);
        spacing.interact_size = vec2(36.0, 22.0);
        spacing.slider_rail_height = 2.5;
        spacing.combo_width = 60.0;
        spacing.scroll = ScrollStyle::thin();
        style.interaction.selectable_labels = false;
        style.interaction.tooltip_delay = 0.4;
        visuals(&mut style.visuals);
    });
}

/// A dialog above everything else.
pub fn dialog(ctx: &Context, name: &str) -> Modal {
    let frame = Frame::popup(&ctx.global_style()).inner_margin(16);
    Modal::new(Id::unique(name)).frame(frame)
}

/// The button of a dialog that does what the dialog is for.
pub fn main_button(text: &str) -> Button<'_> {
    dialog_button(RichText::new(text).color(TEXT_STRONG)).fill(ACCENT_DIM)
}

/// Another button of a dialog.
pub fn dialog_button<'a>(text: impl Into<WidgetText>) -> Button<'a> {
    Button::new(text.into()).min_size(vec2(88.0, 26.0))
}

fn visuals(visuals: &mut eframe::egui::Visuals) {
    visuals.panel_fill = PANEL;
    visuals.window_fill = RAISED;
    visuals.window_stroke = Stroke::new(1.0, LINE);
    visuals.window_corner_radius = CornerRadius::same(8);
    visuals.menu_corner_radius = CornerRadius::same(6);
    visuals.window_shadow =
        Shadow { offset: [0, 8], blur: 24, spread: 0, color: Color32::from_black_alpha(120) };
    visuals.popup_shadow =
        Shadow { offset: [0, 4], blur: 12, spread: 0, color: Color32::from_black_alpha(110) };
    visuals.extreme_bg_color = BACKDROP;
    visuals.faint_bg_color = Color32::from_rgb(28, 29, 33);
    visuals.weak_text_color = Some(TEXT_WEAK);
    visuals.hyperlink_color = ACCENT;
    visuals.warn_fg_color = WARNING;
    visuals.error_fg_color = ERROR;
    visuals.selection.bg_fill = ACCENT_DIM;
    visuals.selection.stroke = Stroke::new(1.0, TEXT_STRONG);
    visuals.slider_trailing_fill = true;
    visuals.handle_shape = HandleShape::Circle;
    visuals.indent_has_left_vline = false;

    let widgets = &mut visuals.widgets;
    for (widget, fill, text) in [
        (&mut widgets.noninteractive, PANEL, TEXT),
        (&mut widgets.inactive, FIELD, TEXT),
        (&mut widgets.hovered, Color32::from_rgb(56, 60, 68), TEXT_STRONG),
        (&mut widgets.active, Color32::from_rgb(66, 71, 80), TEXT_STRONG),
        (&mut widgets.open, FIELD, TEXT_STRONG),
    ] {
        widget.bg_fill = fill;
        widget.weak_bg_fill = fill;
        widget.bg_stroke = Stroke::NONE;
        widget.fg_stroke = Stroke::new(1.0, text);
        widget.corner_radius = CornerRadius::same(4);
        widget.expansion = 0.0;
    }
    widgets.noninteractive.bg_stroke = Stroke::new(1.0, LINE);
    widgets.hovered.fg_stroke = Stroke::new(1.5, TEXT_STRONG);
    widgets.active.fg_stroke = Stroke::new(1.5, TEXT_STRONG);
}
