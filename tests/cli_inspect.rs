//! `brilliance inspect`, run as the user runs it.
#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::path::Path;
use std::process::{Command, Output, Stdio};

use brilliance_renderer::scene_file::Document;
use serde_json::Value;
use tempfile::TempDir;

fn command(folder: &Path, arguments: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_brilliance"));
    command
        .args(arguments.split_whitespace())
        .current_dir(folder)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("RUST_LOG");
    command
}

fn run(folder: &Path, arguments: &str) -> Output {
    command(folder, arguments).output().unwrap()
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap()
}

fn folder_with_scene() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    Document::default().save(&folder.path().join("stone.toml")).unwrap();
    folder
}

fn json(folder: &Path, options: &str) -> Value {
    let output = run(folder, &format!("inspect stone.toml --json {options}"));
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn the_tree_is_told_line_by_line() {
    let folder = folder_with_scene();
    let output = run(folder.path(), "inspect stone.toml --pixel 24,24 --size 48x48");
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let told = text(&output.stdout);
    for word in [
        "pixel 24,24 of 48x48, pass 0",
        "% returned",
        "% pruned",
        "camera 380.0–730.0 nm",
        "reflected",
        "totally reflected",
        "table",
        "main",
        "→ pruned",
        "lamp ",
        "n 1.0000 to 2.4",
    ] {
        assert!(told.contains(word), "no {word:?} in {told}");
    }
    let tree = json(folder.path(), "--pixel 24,24 --size 48x48");
    let rays = tree["rays"].as_array().unwrap().len();
    let [pixel, counts, energy, blank] = [0, 1, 2, 3].map(|i| told.lines().nth(i).unwrap());
    assert!(pixel.starts_with("pixel") && energy.starts_with("energy") && blank.is_empty());
    assert!(counts.starts_with(&format!("{rays} rays")), "{counts}");
    let numbers: Vec<usize> = counts.split(' ').filter_map(|word| word.parse().ok()).collect();
    assert_eq!(numbers[1..].iter().sum::<usize>(), rays, "each ray ends somehow: {counts}");
    assert_eq!(told.lines().count(), 4 + rays, "a line for each ray");
}

#[test]
fn the_json_is_the_tree_of_the_pixel_that_was_asked_for() {
    let folder = folder_with_scene();
    let tree = json(folder.path(), "--pixel 30,20 --size 64x40 --pass 3");
    assert_eq!(tree["pixel"], serde_json::json!([30, 20]));
    assert_eq!(tree["size_px"], serde_json::json!([64, 40]));
    assert_eq!(tree["pass_index"], 3);
    let ended: f64 = tree["rays"]
        .as_array()
        .unwrap()
        .iter()
        .map(|ray| ["energy_at_end", "energy_gained"].map(|part| ray[part].as_f64().unwrap()))
        .map(|[at_end, gained]| at_end - gained)
        .sum();
    assert!((ended - 1.0).abs() < 1e-4, "{ended}");

    let number_of_rays = |tree: &Value| tree["rays"].as_array().unwrap().len();
    let of_paper = |settings: &str| {
        let pixel = "--pixel 30,20 --size 64x40 --pass 3 --set trace.splitting=paper";
        json(folder.path(), &format!("{pixel} {settings}"))
    };
    let unsplit = of_paper("--set trace.split_count=0 --set trace.bins=8");
    assert_eq!(unsplit["splitting"], "paper");
    assert_eq!(unsplit["radiance_per_bin"].as_array().unwrap().len(), 8);
    assert!(number_of_rays(&unsplit) < number_of_rays(&of_paper("")));
}

#[test]
fn the_size_is_that_of_the_scene_where_none_is_given() {
    let folder = folder_with_scene();
    let [width, height] = Document::default().still.size;
    let tree = json(folder.path(), &format!("--pixel {},{}", width - 1, height - 1));
    assert_eq!(tree["size_px"], serde_json::json!([width, height]));
}

#[test]
fn what_makes_no_sense_is_refused_in_one_line() {
    let folder = folder_with_scene();
    let cases: [(&str, i32, &[&str]); 7] = [
        ("inspect stone.toml", 2, &["--pixel"]),
        ("inspect stone.toml --pixel 3", 2, &["--pixel", "320,200"]),
        ("inspect stone.toml --pixel -1,2", 2, &["--pixel"]),
        ("inspect stone.toml --pixel 1,2 --pass x", 2, &["--pass"]),
        ("inspect stone.toml --pixel 64,2 --size 64x40", 1, &["64,2", "64x40", "columns 0 to 63"]),
        ("inspect no-such.toml --pixel 1,2", 1, &["no-such.toml"]),
        ("inspect stone.toml --pixel 1,2 --set nonsense.key=1", 1, &["nonsense"]),
    ];
    for (arguments, code, words) in cases {
        let output = run(folder.path(), arguments);
        let told = text(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{arguments}: {told}");
        assert_eq!(text(&output.stdout), "", "{arguments}");
        for word in words {
            assert!(told.contains(word), "no {word:?} in {told}");
        }
        assert!(code == 2 || told.lines().count() == 1, "{told}");
    }
}

/// As `brilliance inspect … | head -1` does.
#[test]
fn a_reader_that_has_seen_enough_is_no_error() {
    let folder = folder_with_scene();
    for option in ["", "--json"] {
        let mut child = command(
            folder.path(),
            &format!("inspect stone.toml --pixel 24,24 --size 48x48 {option}"),
        )
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(0));
        assert_eq!(text(&output.stderr), "");
    }
}
