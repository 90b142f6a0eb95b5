//! The mouse and the keys move the camera, and the picture has the pixels of its room.

use brilliance::opening::Opening;
use eframe::egui::{
    Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, TouchPhase,
    accesskit::Role, vec2,
};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

use crate::window::*;

#[test]
fn the_mouse_turns_moves_and_zooms_the_stone() {
    let mut harness = harness();
    let start = harness.state().camera();
    drag(&mut harness, PointerButton::Primary, Modifiers::NONE, vec2(60.0, 20.0));
    let turned = harness.state().camera();
    assert_ne!(start.position, turned.position);
    assert_eq!(start.target, turned.target);
    assert_eq!(request(&harness).camera, turned);

    drag(&mut harness, PointerButton::Middle, Modifiers::NONE, vec2(30.0, 0.0));
    let moved = harness.state().camera();
    assert_ne!(moved.target, turned.target);
    drag(&mut harness, PointerButton::Primary, Modifiers::SHIFT, vec2(-30.0, 0.0));
    assert!(harness.state().camera().target.abs_diff_eq(turned.target, 1e-3));

    harness.hover_at(picture_centre(&harness));
    harness.event(Event::MouseWheel {
        unit: MouseWheelUnit::Point,
        delta: vec2(0.0, 120.0),
        phase: TouchPhase::Move,
        source: MouseWheelSource::Wheel,
        modifiers: Modifiers::NONE,
    });
    harness.run_steps(20);
    let distance =
        |camera: &brilliance_renderer::camera::Camera| (camera.position - camera.target).length();
    assert!(distance(&harness.state().camera()) < 0.9 * distance(&turned));

    let center = picture_centre(&harness);
    double_click(&mut harness, center);
    assert!(harness.state().camera().position.abs_diff_eq(start.position, 1e-4));
    assert!(!harness.state().title().contains('\u{2022}'), "the camera is no edit");
}

#[test]
fn keys_show_the_standard_views_but_not_while_typing() {
    let mut harness = harness();
    let axis = |harness: &AppHarness| {
        let camera = harness.state().camera();
        (camera.position - camera.target).normalize_or_zero()
    };
    for (keys, expected) in [
        ([Key::Num1, Key::F], [0.0, 0.0, 1.0]),
        ([Key::Num3, Key::S], [0.0, -1.0, 0.0]),
        ([Key::Num7, Key::P], [0.0, 0.0, -1.0]),
    ] {
        for key in keys {
            harness.key_press(Key::R);
            harness.key_press(key);
            harness.run_steps(2);
            let axis = axis(&harness);
            assert!(axis.abs_diff_eq(expected.into(), 1e-5), "{key:?}: {axis}");
        }
    }
    harness.key_press(Key::R);
    harness.key_press(Key::ArrowRight);
    harness.run_steps(2);
    let turned = harness.state().camera();
    assert!(turned.position.x < -0.1, "the stone turns to the right: {}", turned.position);

    harness.get_by_role_and_label(Role::ComboBox, "Material").click();
    harness.run_steps(3);
    harness.key_press(Key::S);
    harness.event(Event::Text("s".to_owned()));
    harness.run_steps(2);
    assert_eq!(harness.state().camera(), turned);
}

#[test]
fn the_picture_has_the_physical_pixels_of_the_viewport() {
    let mut harness = Harness::builder()
        .with_size(vec2(1200.0, 900.0))
        .with_pixels_per_point(1.5)
        .build_eframe(move |creation| app(creation, Opening::default(), services()));
    harness.run_steps(4);
    let points = harness.get_by_label_contains("Picture of the stone").rect().size();
    let size = request(&harness).size;
    assert_eq!(size, [(points.x * 1.5).round() as u32, (points.y * 1.5).round() as u32]);
    harness.key_press(Key::F9);
    harness.run_steps(3);
    assert!(request(&harness).size[0] > size[0], "the picture fills the room of the hidden panel");
}
