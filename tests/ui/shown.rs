//! Heat maps: the choice by menu and key, the legend, and what they leave alone.

use brilliance::legend;
use brilliance_renderer::develop::{HeatMap, Shown};
use eframe::egui::{self, Key, Modifiers, accesskit::Role, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _, by};

use crate::window::*;

const HEAT_MAPS: [(&str, Shown); 3] = [
    ("Rays per pixel", Shown::Heat(HeatMap::Rays)),
    ("Depth", Shown::Heat(HeatMap::Depth)),
    ("Pruned light", Shown::Heat(HeatMap::Pruned)),
];

fn choose_shown(harness: &mut AppHarness, name: &str) {
    harness.get_by_label("View").click();
    harness.run_steps(3);
    harness.get_by_label("Show").click();
    harness.run_steps(3);
    harness.get(by().role(Role::RadioButton).label(name)).click();
    harness.run_steps(3);
}

fn wait_until_shown(harness: &mut AppHarness, shown: Shown) {
    wait(harness, "the heat map", |app| {
        app.session().picture().is_some_and(|picture| picture.shown == shown)
    });
    harness.step();
}

fn legends(harness: &AppHarness) -> usize {
    harness.query_all_by_role(Role::Legend).count()
}

#[test]
fn the_menu_shows_heat_maps_with_their_legends() {
    let mut harness = harness();
    let before = request(&harness);
    assert_eq!(legends(&harness), 0);
    for (name, shown) in HEAT_MAPS {
        choose_shown(&mut harness, name);
        wait_until_shown(&mut harness, shown);
        assert_eq!(legends(&harness), 1);
        harness.get(by().role(Role::Legend).label_contains(name));
        // In the status line.
        harness.get(by().role(Role::Label).label(name));
    }
    choose_shown(&mut harness, "Picture");
    wait_until_shown(&mut harness, Shown::Color);
    assert_eq!(legends(&harness), 0);
    assert_eq!(request(&harness), before);
    assert_eq!(harness.state().session().requests_made(), 1, "nothing else was asked for");
}

#[test]
fn a_key_goes_through_all_and_is_neither_an_edit_nor_undone() {
    let mut harness = harness();
    set(&mut harness, "Crown angle", 30.0);
    rest(&mut harness);
    let mut seen = Vec::new();
    for _ in 0..4 {
        harness.key_press(Key::H);
        harness.run_steps(2);
        seen.push(harness.state().session().shown());
    }
    let expected = HEAT_MAPS.map(|(_, shown)| shown).into_iter().chain([Shown::Color]);
    assert_eq!(seen, expected.collect::<Vec<_>>());

    harness.key_press(Key::H);
    harness.run_steps(2);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run_steps(2);
    assert!(
        !harness.state().title().contains('\u{2022}'),
        "the edit is undone, and was the only one"
    );
    assert_eq!(harness.state().session().shown(), Shown::Heat(HeatMap::Rays));
}

/// The text of the legend in a picture of `size` points, if there is one.
fn legend(size: egui::Vec2, is_draft: bool) -> Option<String> {
    let harness = Harness::builder().with_size(size).build_ui(move |ui| {
        legend::show(ui, ui.max_rect(), HeatMap::Depth, is_draft);
    });
    let found = harness.query_by_role(Role::Legend)?;
    found.accesskit_node().label()
}

#[test]
fn the_legend_tells_drafts_and_leaves_small_pictures_alone() {
    let room = vec2(400.0, 300.0);
    assert_eq!(legend(room, false).as_deref(), Some("Legend: Depth"));
    assert_eq!(legend(room, true).as_deref(), Some("Legend: Depth of a draft"));
    assert_eq!(legend(vec2(400.0, 80.0), false), None);
    assert_eq!(legend(vec2(200.0, 300.0), false), None);
}
