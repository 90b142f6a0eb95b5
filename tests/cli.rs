//! The command line, run as the user runs it.
#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use brilliance_renderer::scene_file::Document;
use serde_json::Value;
use tempfile::TempDir;

/// Runs the program in `folder` with no display.
fn brilliance<S: AsRef<OsStr>>(folder: &Path, arguments: &[S]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_brilliance"))
        .args(arguments)
        .current_dir(folder)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("WAYLAND_SOCKET")
        .env_remove("RUST_LOG")
        .output()
        .unwrap()
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// Asserts that the program failed with one line that contains all `words`.
fn assert_failed(output: &Output, words: &[&str]) {
    let text = stderr(output);
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(text.starts_with("brilliance: "), "{text}");
    assert_eq!(text.lines().count(), 1, "{text}");
    for word in words {
        assert!(text.contains(word), "no {word:?} in {text}");
    }
    assert_eq!(stdout(output), "");
}

/// Asserts that the program refused its arguments with a text that contains all `words`.
fn assert_wrong_usage(output: &Output, words: &[&str]) {
    let text = stderr(output);
    assert_eq!(output.status.code(), Some(2), "{text}");
    for word in words {
        assert!(text.contains(word), "no {word:?} in {text}");
    }
}

/// Renders a small picture of `stone.toml` by this backend, on a machine that seems to have no
/// graphics device where `hides_devices`.
fn render_by(backend: &str, folder: &Path, hides_devices: bool) -> Output {
    let arguments = "render stone.toml --size 24x16 --passes 2 -o stone.png --stats stone.json";
    let mut command = Command::new(env!("CARGO_BIN_EXE_brilliance"));
    command.args(arguments.split_whitespace()).args(["--backend", backend]);
    command.current_dir(folder).env_remove("RUST_LOG");
    // Graphics drivers of Linux look for a window system and complain where this is unset.
    command.env("XDG_RUNTIME_DIR", folder);
    if hides_devices {
        // An interface that this system does not have.
        let absent = if cfg!(target_vendor = "apple") { "dx12" } else { "metal" };
        command.env("WGPU_BACKEND", absent);
    }
    command.output().unwrap()
}

/// The statistics that [`render_by`] wrote.
fn statistics(folder: &Path) -> Value {
    let text = std::fs::read_to_string(folder.join("stone.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

/// A folder with a scene file `stone.toml`.
fn folder_with_scene() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    Document::default().save(&folder.path().join("stone.toml")).unwrap();
    folder
}

/// The names in a folder, sorted.
fn names(folder: &Path) -> Vec<PathBuf> {
    let mut names: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| PathBuf::from(entry.unwrap().file_name()))
        .collect();
    names.sort();
    names
}

#[test]
fn help_and_version_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let help = brilliance(folder.path(), &["--help"]);
    assert_eq!(help.status.code(), Some(0));
    assert!(stdout(&help).contains("render"));

    let help = brilliance(folder.path(), &["render", "--help"]);
    assert_eq!(help.status.code(), Some(0));
    for option in [
        "--backend",
        "--size",
        "--passes",
        "--noise",
        "--time",
        "--threads",
        "--bins",
        "--set",
        "--bits",
        "--spectral",
        "--show",
        "--output",
        "--stats",
    ] {
        assert!(stdout(&help).contains(option), "{option}");
    }

    let version = brilliance(folder.path(), &["--version"]);
    assert_eq!(stdout(&version).trim(), concat!("brilliance ", env!("CARGO_PKG_VERSION")));
}

#[test]
fn wrong_usage_ends_with_2_and_says_what_is_wrong() {
    let folder = tempfile::tempdir().unwrap();
    let cases: [(&[&str], &[&str]); 22] = [
        (&["--no-such-option"], &["--no-such-option"]),
        (&["a.toml", "b.toml"], &["b.toml"]),
        (&["render"], &["<SCENE>", "--output"]),
        (&["render", "a.toml", "-o", "a.jpg"], &["a.jpg", ".png", ".exr"]),
        (&["render", "a.toml", "-o", "a"], &[".png", ".exr"]),
        (&["render", "a.toml", "-o", "a.png", "--size", "100"], &["1280x800"]),
        (&["render", "a.toml", "-o", "a.png", "--size", "0x100"], &["width", "16384"]),
        (&["render", "a.toml", "-o", "a.png", "--size", "1x99999"], &["height", "16384"]),
        (&["render", "a.toml", "-o", "a.png", "--size", "16384x16384"], &["--size", "pixels"]),
        (&["render", "a.toml", "-o", "a.png", "--passes", "0"], &["--passes"]),
        (&["render", "a.toml", "-o", "a.png", "--noise", "2"], &["--noise", "0.1"]),
        (&["render", "a.toml", "-o", "a.png", "--time", "nan"], &["--time", "seconds"]),
        (&["render", "a.toml", "-o", "a.png", "--bins", "3"], &["--bins", "4..=64"]),
        (&["render", "a.toml", "-o", "a.png", "--threads", "0"], &["--threads"]),
        (
            &["render", "a.toml", "-o", "a.png", "--backend", "tpu"],
            &["--backend", "auto", "cpu", "gpu"],
        ),
        (
            &["render", "a.toml", "-o", "a.png", "--threads", "2", "--backend", "gpu"],
            &["--threads", "--backend cpu"],
        ),
        (&["--backend", "cpu", "render", "a.toml", "-o", "a.png"], &["--backend"]),
        (&["render", "a.toml", "-o", "a.png", "--set", "bins"], &["equals sign"]),
        (&["render", "a.toml", "-o", "a.png", "--spectral"], &["--spectral", ".exr"]),
        (&["render", "a.toml", "-o", "a.exr", "--bits", "16"], &["--bits", ".png"]),
        (&["render", "a.toml", "-o", "a.png", "--stats", "a.toml"], &["overwrite the scene"]),
        (
            &["render", "a.toml", "-o", "a.png", "--bins", "8", "--set", "trace.bins=9"],
            &["--bins", "trace.bins"],
        ),
    ];
    for (arguments, words) in cases {
        assert_wrong_usage(&brilliance(folder.path(), arguments), words);
    }
    assert!(names(folder.path()).is_empty());
}

#[test]
fn a_missing_scene_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let output = brilliance(folder.path(), &["render", "no-such.toml", "-o", "a.png"]);
    assert_failed(&output, &["no-such.toml"]);
    let output = brilliance(folder.path(), &["no-such.toml"]);
    assert_failed(&output, &["no-such.toml"]);
}

#[test]
fn a_missing_folder_is_told_before_anything_is_traced() {
    let folder = folder_with_scene();
    let output = brilliance(folder.path(), &["render", "stone.toml", "-o", "no/such/a.png"]);
    assert_failed(&output, &["no/such/a.png", "does not exist"]);

    std::fs::create_dir(folder.path().join("folder.png")).unwrap();
    let output = brilliance(folder.path(), &["render", "stone.toml", "-o", "folder.png"]);
    assert_failed(&output, &["folder.png", "is a folder"]);
}

#[test]
fn a_film_beyond_memory_is_refused_with_the_remedy() {
    let folder = folder_with_scene();
    let output = brilliance(
        folder.path(),
        &["render", "stone.toml", "--size", "8192x8192", "--bins", "17", "-o", "a.png"],
    );
    assert_failed(&output, &["8192x8192", "17", "GiB", "--size", "--bins"]);
}

#[test]
fn an_unknown_key_of_set_is_named() {
    let folder = folder_with_scene();
    let output = brilliance(
        folder.path(),
        &["render", "stone.toml", "--set", "nonsense.key=1", "-o", "a.png"],
    );
    assert_failed(&output, &["nonsense"]);
    assert_eq!(names(folder.path()), [Path::new("stone.toml")]);
}

#[test]
fn without_a_display_one_sentence_names_the_render_command() {
    let folder = tempfile::tempdir().unwrap();
    let output = brilliance::<&str>(folder.path(), &[]);
    assert_failed(&output, &["display", "brilliance render SCENE -o OUT.png"]);
}

#[test]
fn a_display_that_is_not_there_is_told_the_same_way() {
    let folder = tempfile::tempdir().unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_brilliance"))
        .current_dir(folder.path())
        .env("DISPLAY", ":54321")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("WAYLAND_SOCKET")
        .env_remove("RUST_LOG")
        .output()
        .unwrap();
    assert_failed(&output, &["window", "brilliance render SCENE -o OUT.png"]);
}

#[test]
fn a_render_ends_when_its_noise_is_low_enough() {
    let folder = folder_with_scene();
    for (noise, limit, expected) in [("0.1", 1000, 8..1000), ("0", 40, 40..41)] {
        let arguments = format!(
            "render stone.toml --backend cpu --size 12x8 --passes {limit} --noise {noise} \
             --set trace.max_depth=4 -o stone.png --stats stone.json"
        );
        let output = brilliance(folder.path(), &arguments.split_whitespace().collect::<Vec<_>>());
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        assert!(stdout(&output).contains("to a noise of"), "{}", stdout(&output));
        let stats = statistics(folder.path());
        let passes = stats["passes"].as_u64().unwrap();
        assert!(expected.contains(&passes), "{passes} passes at {noise}");
        let found = stats["noise"].as_f64().unwrap();
        let target = stats["noise_target"].as_f64().unwrap();
        assert!(target == 0.0 || found <= target, "{found} for {target}");
    }
}

#[test]
fn a_render_writes_the_picture_and_its_statistics() {
    let folder = folder_with_scene();
    let arguments = "render stone.toml --size 24x16 --passes 2 --threads 1 --bins 8 \
                     -o stone.png --stats stone.json";
    let output = brilliance(folder.path(), &arguments.split_whitespace().collect::<Vec<_>>());
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert_eq!(stderr(&output), "", "silent where there is no terminal");
    let summary = stdout(&output);
    assert_eq!(summary.lines().count(), 1, "{summary}");
    for word in ["stone.png", "24x16", "2 passes", "CPU, 1 thread", "ray segments", "returned"] {
        assert!(summary.contains(word), "no {word:?} in {summary}");
    }
    let expected = ["stone.json", "stone.png", "stone.toml"].map(Path::new);
    assert_eq!(names(folder.path()), expected, "nothing temporary is left");

    let picture = image::open(folder.path().join("stone.png")).unwrap();
    assert_eq!((picture.width(), picture.height()), (24, 16));
    assert_eq!(picture.color().bits_per_pixel() / u16::from(picture.color().channel_count()), 8);

    let stats = statistics(folder.path());
    assert_eq!(stats["version"], env!("CARGO_PKG_VERSION"));
    assert_eq!(stats["backend"], "cpu");
    assert_eq!(stats["scene"], "stone.toml");
    assert_eq!(stats["output"], "stone.png");
    assert_eq!(stats["size"], serde_json::json!([24, 16]));
    assert_eq!(stats["passes"], 2);
    assert_eq!(stats["threads"], 1);
    assert_eq!(stats["device"], Value::Null);
    assert_eq!(stats["bins"], 8);
    assert_eq!(stats["camera_rays"], 24 * 16 * 2);
    assert!(stats["segments"].as_u64().unwrap() >= 24 * 16 * 2);
    assert!(stats["max_segments_per_camera_ray"].as_u64().unwrap() >= 1);
    assert!(stats["tracing_seconds"].as_f64().unwrap() > 0.0);
    assert!(stats["segments_per_second"].as_f64().unwrap() > 0.0);
    let entered = stats["ledger"]["entered"].as_f64().unwrap();
    let accounted: f64 = ["returned", "absorbed", "pruned", "cut_off", "lost"]
        .iter()
        .map(|part| stats["ledger"][part].as_f64().unwrap())
        .sum();
    assert!(entered > 0.0);
    assert!((accounted - entered).abs() <= 1e-5 * entered, "{accounted} of {entered}");
}

#[test]
fn without_a_graphics_device_the_processor_traces_unless_one_was_asked_for() {
    let folder = folder_with_scene();
    for backend in ["auto", "cpu"] {
        let output = render_by(backend, folder.path(), true);
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        assert_eq!(stderr(&output), "", "there is nothing wrong with {backend}");
        assert_eq!(statistics(folder.path())["backend"], "cpu");
        assert!(stdout(&output).contains("CPU, "), "{}", stdout(&output));
    }
    std::fs::remove_file(folder.path().join("stone.png")).unwrap();
    let output = render_by("gpu", folder.path(), true);
    assert_failed(&output, &["no graphics device", "driver", "CPU"]);
    assert!(!folder.path().join("stone.png").exists());
}

/// A machine without any device fails the test rather than passing it unseen.
#[test]
fn a_graphics_device_traces_where_it_was_asked_for_and_is_named() {
    let folder = folder_with_scene();
    let output = render_by("gpu", folder.path(), false);
    let text = stderr(&output);
    assert_eq!(output.status.code(), Some(0), "{text}");
    let stats = statistics(folder.path());
    assert_eq!(stats["backend"], "gpu", "{text}");
    assert_eq!(stats["threads"], Value::Null);
    let device = stats["device"].as_str().unwrap();
    assert!(stdout(&output).contains(device), "{}", stdout(&output));
    let is_software = stdout(&output).contains("GPU in software");
    assert_eq!(text.lines().count(), usize::from(is_software), "{text}");
    assert_eq!(text.contains(device) && text.contains("slower"), is_software, "{text}");
}

#[test]
fn the_options_choose_the_format() {
    let folder = folder_with_scene();
    let render = |options: &str| {
        let arguments = format!("render stone.toml --size 8x8 --passes 1 {options}");
        let output = brilliance(folder.path(), &arguments.split_whitespace().collect::<Vec<_>>());
        assert_eq!(output.status.code(), Some(0), "{options}: {}", stderr(&output));
    };
    render("--bits 16 -o deep.png");
    render("-o plain.exr");
    render("--spectral -o spectral.exr");

    let deep = image::open(folder.path().join("deep.png")).unwrap();
    assert_eq!(deep.color().bits_per_pixel() / u16::from(deep.color().channel_count()), 16);
    let plain = image::open(folder.path().join("plain.exr")).unwrap();
    assert_eq!((plain.width(), plain.height()), (8, 8));
    let length = |name: &str| std::fs::metadata(folder.path().join(name)).unwrap().len();
    assert!(length("spectral.exr") > length("plain.exr"), "the bins take room");
}

#[test]
fn heat_maps_are_other_pictures_of_the_same_film() {
    let folder = folder_with_scene();
    let render = |options: &str| {
        let arguments = format!("render stone.toml --size 24x16 --passes 1 {options}");
        brilliance(folder.path(), &arguments.split_whitespace().collect::<Vec<_>>())
    };
    let mut pictures = Vec::new();
    for shown in ["color", "rays", "depth", "pruned"] {
        let output = render(&format!("--show {shown} -o {shown}.png"));
        assert_eq!(output.status.code(), Some(0), "{shown}: {}", stderr(&output));
        pictures.push(image::open(folder.path().join(format!("{shown}.png"))).unwrap().to_rgba8());
    }
    assert!(render("-o plain.png").status.success());
    let plain = image::open(folder.path().join("plain.png")).unwrap().to_rgba8();
    assert!(plain == pictures[0], "the colours are the default");
    for (i, picture) in pictures.iter().enumerate() {
        assert!(pictures[..i].iter().all(|other| other != picture), "{i}");
    }
    // The corner sees the sky past the stone: one ray, and nothing of the others.
    let corner = |i: usize| pictures[i].get_pixel(0, 0).0;
    assert_eq!(
        [corner(1), corner(2), corner(3)],
        [[68, 1, 84, 255], [0, 0, 0, 255], [0, 0, 0, 255]]
    );

    assert!(render("--show depth --bits 16 -o deep.png").status.success());
    let deep = image::open(folder.path().join("deep.png")).unwrap();
    assert!(deep.to_rgba8() == pictures[2], "16 bits round to 8");
    assert_wrong_usage(&render("--show depth -o a.exr"), &["OpenEXR", ".png"]);
    assert_wrong_usage(&render("--show heat -o a.png"), &["heat", "pruned"]);
}

#[test]
fn the_time_limit_ends_a_long_render() {
    let folder = folder_with_scene();
    let arguments = "render stone.toml --size 16x16 --passes 1000000 --time 0.2 -o a.png";
    let output = brilliance(folder.path(), &arguments.split_whitespace().collect::<Vec<_>>());
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(folder.path().join("a.png").exists());
}

/// The picture is made again from the scene it was made of, whatever the number of threads.
#[test]
fn the_same_scene_gives_the_same_file() {
    let folder = folder_with_scene();
    for threads in ["1", "2"] {
        let arguments = format!(
            "render stone.toml --size 32x20 --passes 2 --threads {threads} -o {threads}.png"
        );
        let output = brilliance(folder.path(), &arguments.split_whitespace().collect::<Vec<_>>());
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    }
    let read = |name: &str| std::fs::read(folder.path().join(name)).unwrap();
    assert!(read("1.png") == read("2.png"));
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_no_picture() {
    use std::time::{Duration, Instant};

    let folder = folder_with_scene();
    let arguments = "render stone.toml --backend cpu --size 640x400 --passes 1000000 -o a.png";
    let mut child = Command::new(env!("CARGO_BIN_EXE_brilliance"))
        .args(arguments.split_whitespace())
        .current_dir(folder.path())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_secs(1));
    let interrupt = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(interrupt.success());
    let deadline = Instant::now() + Duration::from_secs(20);
    while child.try_wait().unwrap().is_none() {
        if Instant::now() > deadline {
            child.kill().unwrap();
            panic!("the interrupt is not heard");
        }
        std::thread::sleep(Duration::from_millis(20));
    }
    let output = child.wait_with_output().unwrap();
    assert_failed(&output, &["cancelled"]);
    assert_eq!(names(folder.path()), [Path::new("stone.toml")]);
}

#[test]
fn the_spectrum_of_a_pixel_is_that_of_the_rendered_film() {
    let folder = folder_with_scene();
    let spectrum = |place: &str| {
        let arguments = format!(
            "spectrum stone.toml --size 24x16 --passes 2 --backend cpu --set trace.bins=8 {place}"
        );
        let arguments: Vec<_> = arguments.split_whitespace().collect();
        brilliance(folder.path(), &arguments)
    };
    let csv = stdout(&spectrum("--pixel 12,8"));
    let radiances: Vec<f64> = csv
        .lines()
        .filter(|line| line.starts_with(char::is_numeric))
        .map(|line| line.split(',').nth(2).unwrap().parse().unwrap())
        .collect();
    assert_eq!(radiances.len(), 8, "{csv}");
    assert!(radiances.iter().any(|&radiance| radiance > 0.0), "{csv}");

    let json: Value = serde_json::from_str(&stdout(&spectrum("--region 12,8,1,1 --json"))).unwrap();
    let listed: Vec<f64> =
        json["radiance"].as_array().unwrap().iter().map(|it| it.as_f64().unwrap()).collect();
    assert!(listed.iter().zip(&radiances).all(|(a, b)| (a - b).abs() < 1e-6 * b), "{json}");
    assert_eq!(json["bin_edges_nm"][0], 380.0);
    assert_eq!(json["srgb8"].as_array().unwrap().len(), 3);

    assert_failed(&spectrum("--pixel 24,8"), &["24, 8", "24x16", "outside"]);
    assert_failed(&spectrum("--region 20,8,5,2"), &["5 × 2", "outside"]);
    assert_wrong_usage(&spectrum("--pixel 3"), &["comma"]);
    assert_wrong_usage(&spectrum(""), &["--pixel"]);
}
