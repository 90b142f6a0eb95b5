//! What shines on the stone.

use std::f32::consts::PI;

use brilliance_renderer::light::{DiscLight, Lights, SkyLight};
use brilliance_renderer::rigs::{Rig, rigs, scaled};
use eframe::egui::{RichText, Ui};

use crate::row::{SliderRow, combo, labelled, switch};
use crate::theme;

/// Shows the section. The sliders go back to the lights of the rig in use, or to those that were
/// `opened` with the scene.
pub(super) fn show(ui: &mut Ui, lights: &mut Lights, opened: &Lights) {
    let rig = rigs().iter().find(|rig| same_rig(&(rig.lights)(), lights));
    if let Some(chosen) = rig_ui(ui, rig) {
        *lights = (chosen.lights)();
        return;
    }
    let default = &rig.map_or_else(|| opened.clone(), |rig| (rig.lights)());
    if lights.discs.is_empty() {
        ui.label(RichText::new("No lamps: the sky alone lights it.").color(theme::TEXT_WEAK));
    } else {
        discs_ui(ui, lights, &default.discs);
    }
    ambient_ui(ui, lights, default);
    observer_ui(ui, lights, default);
    backdrop_ui(ui, lights);
}

/// The rigs differ by the places of their lights; size and brightness are turned afterwards.
fn same_rig(rig: &Lights, lights: &Lights) -> bool {
    rig == lights
        || (!rig.discs.is_empty()
            && rig.discs.len() == lights.discs.len()
            && rig.discs.iter().zip(&lights.discs).all(|(a, b)| a.direction == b.direction))
}

fn rig_ui(ui: &mut Ui, current: Option<&Rig>) -> Option<&'static Rig> {
    let tooltip = "Puts the stone under another set of lights.";
    let shown = current.map_or("Of this scene", |rig| rig.name);
    labelled(ui, "Lights", tooltip, |ui, label| {
        let mut chosen = None;
        combo(ui, "rig", shown, |ui| {
            for rig in rigs() {
                let item = ui.selectable_label(rig.name == shown, rig.name);
                if item.on_hover_text(rig.description).clicked() {
                    chosen = Some(rig);
                }
            }
        })
        .labelled_by(label.id)
        .on_hover_text(tooltip);
        chosen
    })
}

fn discs_ui(ui: &mut Ui, lights: &mut Lights, default: &[DiscLight]) {
    let mut size = mean_radius_degrees(&lights.discs);
    let old_size = size;
    let resized = SliderRow::new(
        "Light size",
        "Mean angular radius of the lights at the same brightness: small ones make sharp, \
         colourful sparkles.",
        0.05..=45.0,
        mean_radius_degrees(default),
    )
    .unit("°")
    .logarithmic()
    .decimals(3)
    .show_f32(ui, &mut size);
    if resized && old_size > 0.0 {
        *lights = scaled(lights, size / old_size, 1.0, 1.0);
    }

    let mut brightness = brightness(&lights.discs);
    let old_brightness = brightness;
    let brightened = SliderRow::new(
        "Brightness",
        "Light of all lamps together: at 1, a white sheet that faced them all would look white.",
        0.001..=1000.0,
        self::brightness(default),
    )
    .logarithmic()
    .decimals(3)
    .show_f32(ui, &mut brightness);
    if brightened && old_brightness > 0.0 {
        *lights = scaled(lights, 1.0, brightness / old_brightness, 1.0);
    }
}

fn mean_radius_degrees(discs: &[DiscLight]) -> f32 {
    let sum: f32 = discs.iter().map(|disc| disc.angular_radius_radians.to_degrees()).sum();
    sum / discs.len().max(1) as f32
}

/// Radiance of a white matte surface that every light shines on squarely.
fn brightness(discs: &[DiscLight]) -> f32 {
    discs.iter().map(|disc| disc.radiance * disc.solid_angle_steradians()).sum::<f32>() / PI
}

/// The light that surrounds the stone: the hemisphere, unless the scene has an environment.
fn ambient(lights: &Lights) -> f32 {
    lights.environment.as_ref().or(lights.hemisphere.as_ref()).map_or(0.0, |sky| sky.radiance)
}

fn ambient_ui(ui: &mut Ui, lights: &mut Lights, default: &Lights) {
    let mut radiance = ambient(lights);
    let changed = SliderRow::new(
        "Ambient",
        "Radiance of the sky around the stone: it fills the dark facets and dims the contrast.",
        0.0..=4.0,
        ambient(default),
    )
    .decimals(3)
    .show_f32(ui, &mut radiance);
    if changed {
        let sky = if lights.environment.is_some() {
            &mut lights.environment
        } else {
            &mut lights.hemisphere
        };
        sky.get_or_insert_with(|| SkyLight::daylight(0.0)).radiance = radiance;
    }
}

fn observer_ui(ui: &mut Ui, lights: &mut Lights, default: &Lights) {
    let mut degrees = lights.observer_shadow_radians.to_degrees();
    let changed = SliderRow::new(
        "Observer shadow",
        "Half-angle of the dark that your own head makes in the sky; zero leaves it out.",
        0.0..=45.0,
        default.observer_shadow_radians.to_degrees(),
    )
    .unit("°")
    .decimals(1)
    .show_f32(ui, &mut degrees);
    if changed {
        lights.observer_shadow_radians = degrees.to_radians();
    }
}

fn backdrop_ui(ui: &mut Ui, lights: &mut Lights) {
    let mut plain = lights.backdrop.is_some();
    let tooltip = "Shows a plain backdrop behind the stone instead of the sky that lights it.";
    if switch(ui, "Plain backdrop", tooltip, &mut plain) {
        lights.backdrop = plain.then(|| SkyLight::daylight(0.02));
    }
    if let Some(backdrop) = &mut lights.backdrop {
        SliderRow::new("Backdrop", "Radiance of the backdrop.", 0.0..=2.0, 0.02)
            .decimals(3)
            .show_f32(ui, &mut backdrop.radiance);
    }
}
