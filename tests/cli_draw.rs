//! `brilliance draw`, run as the user runs it.
#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::path::Path;
use std::process::{Command, Output};

use brilliance_renderer::scene_file::{Document, scenes};
use tempfile::TempDir;

/// Runs `brilliance draw` in `folder` with no display.
fn draw(folder: &Path, arguments: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_brilliance"))
        .arg("draw")
        .args(arguments.split_whitespace())
        .current_dir(folder)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("RUST_LOG")
        .output()
        .unwrap()
}

/// A folder with the default scene and that of seven diamonds.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    Document::default().save(&folder.path().join("stone.toml")).unwrap();
    let seven = scenes().iter().find(|scene| scene.name.contains("Seven")).unwrap();
    std::fs::write(folder.path().join("seven.toml"), seven.text).unwrap();
    folder
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

fn assert_refused(output: &Output, code: i32, words: &[&str]) {
    let text = text(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{text}");
    for word in words {
        assert!(text.contains(word), "no {word:?} in {text}");
    }
}

#[test]
fn a_stone_becomes_an_svg_and_a_png() {
    let folder = folder();
    for (arguments, size) in [
        ("stone.toml -o drawing.svg", None),
        ("stone.toml -o drawing.png", Some((2339, 1654))),
        ("stone.toml -o drawing.png --size 300x200", Some((300, 200))),
        ("stone.toml -o drawing.png --dpi 50", Some((585, 413))),
    ] {
        let output = draw(folder.path(), arguments);
        assert!(output.status.success(), "{arguments}: {}", text(&output.stderr));
        assert!(text(&output.stdout).starts_with("drawing."), "{}", text(&output.stdout));
        if let Some(size) = size {
            let picture = image::open(folder.path().join("drawing.png")).unwrap();
            assert_eq!((picture.width(), picture.height()), size);
        }
    }
    let svg = std::fs::read_to_string(folder.path().join("drawing.svg")).unwrap();
    for word in ["<svg", ">table<", "33.2°", "main 40.8°", "57 + 16 at the girdle"] {
        assert!(svg.contains(word), "no {word:?}");
    }
}

#[test]
fn the_prism_diagram_needs_no_scene() {
    let folder = folder();
    for case in ["clumping", "crossing"] {
        let output = draw(folder.path(), &format!("--prism {case} -o {case}.svg"));
        assert!(output.status.success(), "{}", text(&output.stderr));
        let svg = std::fs::read_to_string(folder.path().join(format!("{case}.svg"))).unwrap();
        assert!(svg.contains("perturb off") && svg.contains("perturb on"));
    }
    let both = draw(folder.path(), "stone.toml --prism crossing -o drawing.svg");
    assert_refused(&both, 2, &["cannot be used with"]);
}

#[test]
fn an_object_is_chosen_by_name_or_number() {
    let folder = folder();
    let scene = Document::open(&folder.path().join("seven.toml")).unwrap().scene;
    let third = &scene.objects[2].name;
    let arguments = format!("seven.toml -o a.svg --object {}", 3);
    assert!(text(&draw(folder.path(), &arguments).stdout).contains(third.as_str()));
    let first = draw(folder.path(), "seven.toml -o b.svg");
    assert!(text(&first.stdout).contains(scene.objects[0].name.as_str()));
    let none = draw(folder.path(), "seven.toml -o c.svg --object ruby");
    assert_refused(&none, 1, &["no object 'ruby'", third.as_str()]);
    let beyond = draw(folder.path(), "seven.toml -o c.svg --object 99");
    assert_refused(&beyond, 1, &["no object '99'"]);
    assert!(!folder.path().join("c.svg").exists());
}

#[test]
fn wrong_usage_is_told_before_anything_is_done() {
    let folder = folder();
    for (arguments, words) in [
        ("stone.toml -o drawing.pdf", &[".svg or .png"][..]),
        ("stone.toml -o drawing", &[".svg or .png"]),
        ("stone.toml -o drawing.svg --dpi 100", &["no pixels"]),
        ("stone.toml -o drawing.png --dpi 5000", &["10..=600"]),
        ("stone.toml -o drawing.png --size 0x5", &["width"]),
        ("stone.toml -o drawing.png --size 5x5 --dpi 50", &["cannot be used with"]),
        ("stone.toml", &["--output"]),
        ("-o drawing.svg", &["SCENE"]),
    ] {
        assert_refused(&draw(folder.path(), arguments), 2, words);
    }
    let missing = draw(folder.path(), "none.toml -o drawing.svg");
    assert_refused(&missing, 1, &["none.toml"]);
    let nowhere = draw(folder.path(), "stone.toml -o none/drawing.svg");
    assert_refused(&nowhere, 1, &["does not exist"]);
}
