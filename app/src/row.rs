//! The rows of the panel: a label in one column, its control in the other.

use std::ops::RangeInclusive;

use eframe::egui::{
    self, Align, ComboBox, DragValue, Label, Layout, PointerButton, Response, RichText, Sense,
    Slider, SliderClamping, Ui, vec2,
};

use crate::theme;

const LABEL_WIDTH: f32 = 108.0;
const VALUE_WIDTH: f32 = 82.0;
const SLIDER_HEIGHT: f32 = 13.0;

/// A slider with its label, its typed value and its unit.
///
/// A double click on the label or the slider goes back to the default.
#[must_use = "a row is shown with `show`"]
pub struct SliderRow<'a> {
    label: &'a str,
    tooltip: &'a str,
    range: RangeInclusive<f64>,
    default: f64,
    unit: &'a str,
    decimals: usize,
    scale: f64,
    logarithmic: bool,
}

impl<'a> SliderRow<'a> {
    /// A row for values in `range`; `tooltip` says in one sentence what turning it does.
    pub fn new(
        label: &'a str,
        tooltip: &'a str,
        range: RangeInclusive<f64>,
        default: impl Into<f64>,
    ) -> Self {
        Self {
            label,
            tooltip,
            range,
            default: default.into(),
            unit: "",
            decimals: 2,
            scale: 1.0,
            logarithmic: false,
        }
    }

    /// Writes `unit` after the value.
    pub fn unit(mut self, unit: &'a str) -> Self {
        self.unit = unit;
        self
    }

    /// Shows a fraction as a percentage.
    pub fn percent(mut self) -> Self {
        self.scale = 100.0;
        self.unit(" %")
    }

    /// Decimals shown and kept; on a logarithmic row, significant digits.
    pub fn decimals(mut self, decimals: usize) -> Self {
        self.decimals = decimals;
        self
    }

    /// Spaces the rail by ratio.
    pub fn logarithmic(mut self) -> Self {
        self.logarithmic = true;
        self
    }

    /// Shows the row; true if it changed `value`.
    pub fn show(self, ui: &mut Ui, value: &mut f64) -> bool {
        let before = *value;
        labelled(ui, self.label, self.tooltip, |ui, label| {
            let mut shown = *value * self.scale;
            let (slider, field) = self.controls_ui(ui, &mut shown);
            if slider.changed() || field.changed() {
                *value = shown / self.scale;
            }
            let reset = label.double_clicked() || double_clicked(ui, &slider);
            if reset {
                *value = self.default.clamp(*self.range.start(), *self.range.end());
            }
            let tooltip = format!("{}\nDouble click: back to {}.", self.tooltip, self.text());
            let slider = slider.labelled_by(label.id);
            slider.on_hover_text(tooltip).on_disabled_hover_text(self.tooltip);
            field.accessible_name(format!("{} value", self.label));
        });
        *value != before
    }

    /// As [`show`](Self::show), for single precision.
    pub fn show_f32(self, ui: &mut Ui, value: &mut f32) -> bool {
        let mut wide = f64::from(*value);
        let changed = self.show(ui, &mut wide);
        if changed {
            *value = wide as f32;
        }
        changed
    }

    /// As [`show`](Self::show), for a count.
    pub fn show_u32(self, ui: &mut Ui, value: &mut u32) -> bool {
        let mut wide = f64::from(*value);
        let changed = self.decimals(0).show(ui, &mut wide);
        if changed {
            *value = wide.round() as u32;
        }
        changed
    }

    fn controls_ui(&self, ui: &mut Ui, shown: &mut f64) -> (Response, Response) {
        let range = self.range.start() * self.scale..=self.range.end() * self.scale;
        let spacing = ui.spacing().item_spacing.x;
        let height = ui.spacing().interact_size.y;
        ui.spacing_mut().slider_width = (ui.available_width() - VALUE_WIDTH - spacing).max(24.0);
        ui.spacing_mut().interact_size.y = SLIDER_HEIGHT;
        let mut slider = Slider::new(shown, range.clone())
            .show_value(false)
            .clamping(SliderClamping::Edits)
            .logarithmic(self.logarithmic);
        if !self.logarithmic {
            slider = slider.max_decimals(self.decimals);
            if self.decimals == 0 {
                slider = slider.step_by(1.0);
            }
        } else if *range.start() > 0.0 {
            slider = slider.smallest_positive(*range.start());
        }
        let slider = ui.add(slider);
        ui.spacing_mut().interact_size.y = height;
        let field = ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.add_sized(vec2(VALUE_WIDTH, height), self.field(shown, range))
        });
        (slider, field.inner)
    }

    fn field<'v>(&self, shown: &'v mut f64, range: RangeInclusive<f64>) -> DragValue<'v>
    where
        'a: 'v,
    {
        let speed =
            if self.logarithmic { 0.01 * *shown } else { (range.end() - range.start()) / 400.0 };
        let unit = self.unit;
        let (decimals, logarithmic) = (self.decimals, self.logarithmic);
        DragValue::new(shown)
            .range(range)
            .clamp_existing_to_range(false)
            .speed(speed)
            .suffix(unit)
            .update_while_editing(false)
            .custom_formatter(move |value, _| written(value, decimals, logarithmic))
            .custom_parser(move |text| parsed(text, unit))
    }

    /// The default as the field would show it.
    fn text(&self) -> String {
        let number = written(self.default * self.scale, self.decimals, self.logarithmic);
        format!("{number}{}", self.unit)
    }
}

/// A number with a fixed count of decimals, or of significant digits.
fn written(value: f64, digits: usize, significant: bool) -> String {
    if !significant || value == 0.0 {
        return format!("{value:.digits$}");
    }
    let magnitude = value.abs().log10().floor() as i32;
    let decimals = (digits as i32 - 1 - magnitude).max(0) as usize;
    format!("{value:.decimals$}")
}

/// A number as people type it: with or without its unit, with a point or a comma.
fn parsed(text: &str, unit: &str) -> Option<f64> {
    let text = text.trim();
    let number = text.strip_suffix(unit.trim()).unwrap_or(text).trim();
    number.replace(',', ".").replace('\u{2212}', "-").parse().ok().filter(|v: &f64| v.is_finite())
}

/// A range for a row.
pub fn wide(range: &RangeInclusive<f32>) -> RangeInclusive<f64> {
    f64::from(*range.start())..=f64::from(*range.end())
}

/// A range of counts for a row.
pub fn whole(range: &RangeInclusive<u32>) -> RangeInclusive<f64> {
    f64::from(*range.start())..=f64::from(*range.end())
}

/// A choice among a few values.
pub fn choice<T: PartialEq + Copy>(
    ui: &mut Ui,
    label: &str,
    tooltip: &str,
    value: &mut T,
    choices: &[(T, &str)],
) -> bool {
    let before = *value;
    labelled(ui, label, tooltip, |ui, label_response| {
        let shown = choices.iter().find(|(choice, _)| choice == value).map_or("", |(_, name)| name);
        let response = combo(ui, label, shown, |ui| {
            for (choice, name) in choices {
                ui.selectable_value(value, *choice, *name);
            }
        });
        response.labelled_by(label_response.id).on_hover_text(tooltip);
    });
    *value != before
}

/// A drop-down list as wide as the row allows.
pub fn combo(ui: &mut Ui, id: &str, shown: &str, contents: impl FnOnce(&mut Ui)) -> Response {
    ComboBox::from_id_salt(id)
        .width(ui.available_width())
        .height(320.0)
        .truncate()
        .selected_text(shown)
        .show_ui(ui, contents)
        .response
}

/// A check box in the column of the controls.
pub fn switch(ui: &mut Ui, label: &str, tooltip: &str, value: &mut bool) -> bool {
    let before = *value;
    labelled(ui, label, tooltip, |ui, label_response| {
        let response = ui.add(egui::Checkbox::without_text(value));
        if label_response.clicked() {
            *value = !*value;
        }
        let response = response.labelled_by(label_response.id);
        response.on_hover_text(tooltip).on_disabled_hover_text(tooltip);
    });
    *value != before
}

/// A value that is only read.
pub fn readout(ui: &mut Ui, label: &str, tooltip: &str, text: &str) {
    labelled(ui, label, tooltip, |ui, _| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.add_space(ui.spacing().button_padding.x);
            ui.label(RichText::new(text).color(theme::TEXT_WEAK));
        });
    });
}

/// A row with `label` in the first column and `control` in the second.
pub fn labelled<R>(
    ui: &mut Ui,
    label: &str,
    tooltip: &str,
    control: impl FnOnce(&mut Ui, &Response) -> R,
) -> R {
    ui.horizontal(|ui| {
        let height = ui.spacing().interact_size.y;
        let label = ui
            .allocate_ui_with_layout(
                vec2(LABEL_WIDTH, height),
                Layout::left_to_right(Align::Center),
                |ui| {
                    ui.set_min_width(LABEL_WIDTH);
                    ui.add(Label::new(label).truncate().sense(Sense::CLICK))
                },
            )
            .inner
            .on_hover_text(tooltip)
            .on_disabled_hover_text(tooltip);
        control(ui, &label)
    })
    .inner
}

/// A double click on a widget that itself only senses drags.
fn double_clicked(ui: &Ui, response: &Response) -> bool {
    response.enabled()
        && response.contains_pointer()
        && ui.input(|input| input.pointer.button_double_clicked(PointerButton::Primary))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn typed_numbers_may_carry_their_unit_and_a_comma() {
        assert_eq!(parsed(" 34,5° ", "°"), Some(34.5));
        assert_eq!(parsed("56 %", " %"), Some(56.0));
        assert_eq!(parsed("\u{2212}2", " EV"), Some(-2.0));
        assert_eq!(parsed("inf", ""), None);
        assert_eq!(parsed("wide", " %"), None);
    }

    #[test]
    fn significant_digits_follow_the_magnitude() {
        assert_eq!(written(0.000_123_4, 2, true), "0.00012");
        assert_eq!(written(12.34, 2, true), "12");
        assert_eq!(written(0.0, 2, true), "0.00");
    }
}
