//! Picking in the picture for the inspector.

use eframe::egui::{Key, Modifiers, PointerButton, vec2};
use egui_kittest::kittest::Queryable as _;

use crate::window::*;

#[test]
fn a_click_picks_a_pixel_only_while_the_inspector_is_open() {
    let mut harness = harness();
    let center = picture_centre(&harness);
    click(&mut harness, center);
    assert_eq!(harness.state().inspector().pick(), None);

    harness.key_press(Key::I);
    harness.run_steps(3);
    harness.get_by_label_contains("Click on the picture");
    let center = picture_centre(&harness);
    click(&mut harness, center);
    let pick = harness.state().inspector().pick().copied().expect("a pixel is picked");
    assert_eq!(pick.pixels.count(), 1);
    let size = request(&harness).size;
    assert_eq!(pick.size, size);
    for (picked, side) in pick.pixels.min.into_iter().zip(size) {
        assert!(picked.abs_diff(side / 2) <= 1, "{pick:?}");
    }
    assert_eq!(pick.camera, harness.state().camera());
    harness.get_by_label_contains("pixel ");

    harness.key_press(Key::I);
    harness.run_steps(3);
    assert!(!harness.state().inspector().is_shown());
}

#[test]
fn a_drag_with_the_command_key_picks_a_region_and_does_not_turn_the_stone() {
    let mut harness = harness();
    harness.key_press(Key::I);
    harness.run_steps(3);
    let before = harness.state().camera();
    drag(&mut harness, PointerButton::Primary, Modifiers::COMMAND, vec2(40.0, -20.0));
    assert_eq!(harness.state().camera(), before);
    let pick = harness.state().inspector().pick().copied().expect("a region is picked");
    assert!(pick.pixels.count() > 400, "{pick:?}");

    drag(&mut harness, PointerButton::Primary, Modifiers::NONE, vec2(40.0, -20.0));
    assert_ne!(harness.state().camera(), before);
    assert_eq!(harness.state().inspector().pick(), Some(&pick), "what is picked stays");
}
