//! Undo, opening, saving.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use brilliance::app::{App, Services};
use brilliance::notice::NoticeKind;
use brilliance_renderer::cuts::RoundBrilliant;
use brilliance_renderer::scene_file::{Document, scenes};
use eframe::egui::{DroppedFile, Event, Key, Modifiers};
use egui_kittest::kittest::Queryable as _;

use crate::window::*;

#[test]
fn edits_are_undone_one_gesture_at_a_time() {
    let mut harness = harness();
    set(&mut harness, "Crown angle", 30.0);
    rest(&mut harness);
    set(&mut harness, "Table", 60.0);
    set(&mut harness, "Table", 62.0);
    assert!(harness.state().title().starts_with('\u{2022}'));

    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run_steps(2);
    let cut = brilliant(&request(&harness));
    assert_eq!(cut.table, RoundBrilliant::default().table);
    assert_eq!(cut.crown_angle_degrees, 30.0);

    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run_steps(2);
    assert_eq!(brilliant(&request(&harness)), RoundBrilliant::default());
    assert!(!harness.state().title().contains('\u{2022}'));

    for _ in 0..2 {
        harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    }
    harness.run_steps(2);
    assert_eq!(brilliant(&request(&harness)).table, 0.62);
}

#[test]
fn a_file_that_cannot_be_opened_is_named_until_dismissed_and_the_scene_stays() {
    let mut harness = harness();
    let before = request(&harness);
    let path = PathBuf::from("/no/such/folder/heart.toml");
    harness.event(Event::PointerGone);
    harness.step();
    harness.state_mut().open_file(path);
    wait(&mut harness, "the notice", |app| !app.notices().list().is_empty());
    let notice = harness.state().notices().list()[0].clone();
    assert_eq!(notice.kind, NoticeKind::Error);
    assert!(notice.text.contains("/no/such/folder/heart.toml"), "{}", notice.text);
    assert_eq!(request(&harness), before);

    rest(&mut harness);
    assert_eq!(harness.state().notices().list().len(), 1);
    harness.get_by_label("Dismiss").click();
    harness.run_steps(3);
    assert!(harness.state().notices().list().is_empty());
}

/// A file as the desktop drops it.
#[derive(Debug)]
struct Dropped(PathBuf);

impl DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        std::fs::read(&self.0).map_err(|fault| fault.to_string())
    }
}

#[test]
fn a_file_that_is_dropped_on_the_window_is_opened() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("prism.toml");
    let prism = scenes().iter().find(|scene| scene.name == "Prism").expect("it ships");
    std::fs::write(&path, prism.text).expect("the scene is written");
    let mut harness = harness();
    harness.input_mut().dropped_files.push(Arc::new(Dropped(path)));
    harness.step();
    wait(&mut harness, "the prism", |app| app.document().scene.objects[0].name == "Prism");
    harness.run_steps(2);
    assert!(harness.state().title().contains("prism"), "{}", harness.state().title());
    assert_eq!(request(&harness).scene.objects[0].name, "Prism");
}

#[test]
fn unsaved_changes_are_asked_about_before_another_scene_is_opened() {
    let mut harness = harness();
    set(&mut harness, "Crown angle", 30.0);
    harness.get_by_label("File").click();
    harness.run_steps(3);
    harness.get_by_label_contains("Open scene").click();
    harness.run_steps(3);
    harness.get_by_label(scenes()[0].name).click();
    wait(&mut harness, "the question", App::asks_about_changes);
    harness.run_steps(3);
    harness.get_by_label("Save your changes?");
    harness.get_by_label("Cancel").click();
    harness.run_steps(3);
    assert!(harness.query_by_label("Save your changes?").is_none());
    assert_eq!(brilliant(&request(&harness)).crown_angle_degrees, 30.0);
}

#[test]
fn save_writes_the_scene_file_and_clears_the_mark() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("stone.toml");
    let answer = file.clone();
    let services = Services { ask_path: Arc::new(move |_| Some(answer.clone())), ..services() };
    let mut harness = harness_with(Document::default(), None, services);
    set(&mut harness, "Crown angle", 30.0);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::S);
    wait(&mut harness, "saving", |app| app.title().starts_with("stone.toml"));
    assert_eq!(harness.state().notices().list()[0].kind, NoticeKind::Confirmation);
    assert!(harness.state().notices().list()[0].text.contains("stone.toml"));
}

#[test]
fn without_a_file_dialog_a_path_can_be_typed() {
    let mut harness = harness();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::O);
    wait(&mut harness, "the field", |_| true);
    for _ in 0..100 {
        harness.step();
        if harness.query_by_label("Path").is_some() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    harness.get_by_label("Path").focus();
    harness.run_steps(2);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.event(Event::Text("/no/such/stone.glb".to_owned()));
    harness.run_steps(2);
    harness.key_press(Key::Enter);
    wait(&mut harness, "the notice", |app| !app.notices().list().is_empty());
    assert!(harness.state().notices().list()[0].text.contains("/no/such/stone.glb"));
}

#[test]
fn what_is_not_saved_is_rescued_where_the_program_has_to_end() {
    let mut harness = harness();
    assert!(harness.state().rescue().is_none(), "nothing was edited");
    set(&mut harness, "Crown angle", 30.0);
    let path = harness.state().rescue().expect("an edit").expect("a file");
    let rescued = Document::open(&path).expect("a scene");
    std::fs::remove_file(&path).expect("the file goes");
    assert_eq!(rescued.scene.objects, harness.state().document().scene.objects);
}
