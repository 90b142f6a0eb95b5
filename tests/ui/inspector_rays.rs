//! The tree of a pixel's rays in the window.

use brilliance_renderer::inspect::RayTree;
use brilliance_renderer::scene_file::Document;
use eframe::egui::{Key, Modifiers, OutputCommand, PointerButton, Vec2, accesskit::Role, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _, by};

use crate::window::*;

/// The window with the rays of the pixel in the middle.
fn harness_with_rays() -> AppHarness {
    let mut harness = harness();
    harness.key_press(Key::I);
    harness.run_steps(3);
    let center = picture_centre(&harness);
    click(&mut harness, center);
    wait(&mut harness, "a tree", |app| app.inspector().ray_tree().is_some());
    harness.run_steps(3);
    harness
}

fn tree(harness: &AppHarness) -> &RayTree {
    harness.state().inspector().ray_tree().expect("a tree is shown")
}

/// The rows that can be seen.
fn rows(harness: &AppHarness) -> Vec<String> {
    harness
        .query_all(by().role(Role::ListItem).label_contains("ray "))
        .filter_map(|node| node.accesskit_node().label())
        .collect()
}

#[test]
fn a_click_shows_the_rays_of_that_pixel_with_their_totals() {
    let harness = harness_with_rays();
    let pick = harness.state().inspector().pick().expect("a pixel is picked");
    let tree = tree(&harness);
    assert_eq!((tree.pixel, tree.size_px), (pick.pixels.middle(), pick.size));
    harness.get_by_label_contains(&format!("{} rays", tree.rays.len()));
    harness.get_by_label_contains("% returned");
    let rows = rows(&harness);
    assert!(rows.len() > 5 && rows.len() <= tree.rays.len(), "{rows:?}");
    assert!(rows[0].starts_with("ray 0, camera, Round brilliant: "), "{}", rows[0]);
    assert!(rows[1].starts_with("ray 1, reflected, "), "{}", rows[1]);
}

/// It is the tree of the moment of picking, seen from elsewhere.
#[test]
fn turning_the_view_keeps_the_tree() {
    let mut harness = harness_with_rays();
    let before = tree(&harness).clone();
    drag(&mut harness, PointerButton::Primary, Modifiers::NONE, vec2(60.0, -40.0));
    rest(&mut harness);
    assert_ne!(
        Some(harness.state().camera()),
        harness.state().inspector().pick().map(|p| p.camera)
    );
    assert_eq!(tree(&harness), &before);
}

#[test]
fn another_stone_and_other_settings_make_another_tree_of_the_same_camera_ray() {
    let mut harness = harness_with_rays();
    let before = tree(&harness).clone();
    set(&mut harness, "Refractive index", 1.7);
    wait(&mut harness, "the tree of the new stone", |app| {
        app.inspector().ray_tree().is_some_and(|tree| tree.rays[1] != before.rays[1])
    });
    let of_stone = tree(&harness).clone();
    assert_eq!(of_stone.rays[0].direction, before.rays[0].direction);
    assert!(of_stone.rays[1].significance < before.rays[1].significance);

    set(&mut harness, "Maximum depth", 3.0);
    wait(&mut harness, "the shallow tree", |app| {
        app.inspector().ray_tree().is_some_and(|tree| tree.ledger.cut_off > 0.0)
    });
    assert!(tree(&harness).rays.iter().all(|ray| ray.depth <= 4));
}

#[test]
fn a_row_that_is_clicked_on_tells_its_way_to_the_eye() {
    let mut harness = harness_with_rays();
    assert!(harness.query_by_label("eye").is_none());
    harness.get(by().role(Role::ListItem).label_contains("ray 2, ")).click();
    harness.run_steps(3);
    harness.get_by_label("eye");
    harness.get_by_label("Interval");
    let links = harness.query_all(by().role(Role::Link)).count();
    assert_eq!(links, tree(&harness).path_to_camera(2).count());

    harness.get(by().role(Role::ListItem).label_contains("ray 2, ")).click();
    harness.run_steps(3);
    assert!(harness.query_by_label("eye").is_none());
}

#[test]
fn filters_and_order_choose_the_rows() {
    let mut harness = harness_with_rays();
    choose(&mut harness, "Order", "strongest first");
    let listed = rows(&harness);
    let significance = |row: &String| -> f32 {
        let id: usize = row[4..row.find(',').expect("a comma")].parse().expect("an id");
        tree(&harness).rays[id].significance
    };
    assert!(listed.iter().map(significance).is_sorted_by(|a, b| a >= b), "{listed:?}");

    harness.get_by_label("Show").click();
    harness.run_steps(20);
    set(&mut harness, "To depth", 1.0);
    harness.run_steps(3);
    let shallow = rows(&harness);
    assert_eq!(shallow.len(), 3, "camera, reflected, refracted: {shallow:?}");
    harness.get(by().role(Role::Button).label("reflected")).click();
    harness.run_steps(3);
    assert_eq!(rows(&harness).len(), 2);
    set(&mut harness, "From depth", 1.0);
    harness.run_steps(3);
    assert!(rows(&harness)[0].contains("refracted"), "{:?}", rows(&harness));

    harness.get_by_label(&format!("1 of {} rays shown", tree(&harness).rays.len()));
    harness.get_by_label("Show all").click();
    harness.run_steps(3);
    assert!(rows(&harness).len() > 3, "{:?}", rows(&harness));
    assert!(harness.query_by_label("Show all").is_none());
}

/// Moves the pointer about the pixel until it points to a ray that begins there.
fn point_to_a_ray(harness: &mut AppHarness) -> Option<u32> {
    let center = picture_centre(harness);
    for degrees in (0..360).step_by(10) {
        harness.hover_at(center + 25.0 * Vec2::angled((degrees as f32).to_radians()));
        harness.run_steps(2);
        if let Some(ray) = harness.state().inspector().looked_at_ray() {
            return Some(ray);
        }
    }
    None
}

#[test]
fn a_click_on_a_ray_selects_it_and_escape_selects_nothing() {
    let mut harness = harness_with_rays();
    let pick = harness.state().inspector().pick().copied();
    let pointed = point_to_a_ray(&mut harness).expect("rays begin at the pixel");
    let at = harness.ctx.input(|input| input.pointer.latest_pos()).expect("it is over a ray");
    click(&mut harness, at);
    harness.run_steps(2);
    assert_eq!(harness.state().inspector().pick().copied(), pick, "nothing else is picked");
    assert_eq!(harness.state().inspector().looked_at_ray(), Some(pointed));
    harness.get_by_label("eye");
    harness.key_press(Key::Escape);
    harness.run_steps(3);
    assert!(harness.query_by_label("eye").is_none());
}

#[test]
fn no_ray_is_pointed_at_through_a_window() {
    let mut harness = harness_with_rays();
    harness.key_press(Key::L);
    harness.run_steps(5);
    assert_eq!(point_to_a_ray(&mut harness), None);
}

#[test]
fn the_selected_ray_stays_selected_when_the_stone_changes_and_not_for_another_pixel() {
    let mut harness = harness_with_rays();
    harness.get(by().role(Role::ListItem).label_contains("ray 2, ")).click();
    harness.run_steps(3);
    let before = tree(&harness).clone();
    set(&mut harness, "Refractive index", 1.7);
    wait(&mut harness, "the tree of the new stone", |app| {
        app.inspector().ray_tree().is_some_and(|tree| tree.rays[1] != before.rays[1])
    });
    let center = picture_centre(&harness);
    harness.hover_at(center);
    harness.run_steps(3);
    let selected = harness.state().inspector().looked_at_ray().expect("it is selected still");
    let (ray, was) = (&tree(&harness).rays[selected as usize], &before.rays[2]);
    assert_eq!((ray.kind, &ray.from), (was.kind, &was.from));

    click(&mut harness, center + vec2(30.0, 60.0));
    wait(&mut harness, "the other tree", |app| {
        app.inspector().ray_tree().is_some_and(|tree| tree.pixel != before.pixel)
    });
    harness.run_steps(3);
    assert!(harness.query_by_label("eye").is_none());
}

#[test]
fn the_tree_is_copied_as_json() {
    let mut harness = harness_with_rays();
    harness.get_by_label("Copy as JSON").click();
    let mut copied = None;
    for _ in 0..4 {
        harness.step();
        for command in &harness.output().platform_output.commands {
            if let OutputCommand::CopyText(text) = command {
                copied = Some(text.clone());
            }
        }
    }
    let json: serde_json::Value =
        serde_json::from_str(&copied.expect("a text is copied")).expect("it is JSON");
    assert_eq!(json["rays"].as_array().map(Vec::len), Some(tree(&harness).rays.len()));
}

#[test]
fn a_scene_that_cannot_be_traced_says_why() {
    let mut document = Document::default();
    document.scene.objects[0].transform.scale = -1.0;
    let mut harness = harness_with(document, None, services());
    harness.key_press(Key::I);
    harness.run_steps(3);
    let center = picture_centre(&harness);
    click(&mut harness, center);
    for _ in 0..100 {
        harness.run_steps(2);
        if harness.query_by_label("The rays can't be followed").is_some() {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    panic!("nothing is said");
}
