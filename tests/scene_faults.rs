//! Faults in scene files: the place, the key, the finding and the remedy are named, and nothing
//! panics or hangs.

use std::path::Path;

use brilliance_renderer::scene_file::{Document, scenes};

/// What is wrong, the text of the file, and the parts that its message must have.
type Case<'a> = (&'a str, String, &'a [&'a str]);

fn read(text: &str) -> Result<Document, String> {
    Document::from_toml(text, Path::new("")).map_err(|error| error.to_string())
}

fn assert_faults(cases: &[Case]) {
    for (what, text, wanted) in cases {
        let fault = read(text).expect_err(what);
        for part in *wanted {
            assert!(fault.contains(part), "{what}: no {part:?} in: {fault}");
        }
    }
}

#[test]
fn faults_in_the_form_of_the_file() {
    assert_faults(&[
        ("no format", String::new(), &["`format`", "missing"]),
        ("future format", "format = 2\n".into(), &["line 1, column 1", "`format`", "format 1"]),
        ("not TOML", "format = 1\n[trace\n".into(), &["line 2"]),
        (
            "typo",
            "format = 1\n[trace]\nsplit_cuont = 3\n".into(),
            &["line 3, column 1", "`trace.split_cuont`", "did you mean `split_count`", "max_depth"],
        ),
        (
            "wrong type",
            "format = 1\n[trace]\nbins = \"many\"\n".into(),
            &["line 3", "`trace.bins`", "the text \"many\"", "a whole number"],
        ),
        (
            "range",
            "format = 1\n[trace]\nbins = 1000\n".into(),
            &["line 3", "`trace.bins`", "found 1000", "4 to 64"],
        ),
        ("negative count", "format = 1\nstill.passes = -1\n".into(), &["`still.passes`", "-1"]),
        (
            "unknown top table",
            "format = 1\n[cameras]\n".into(),
            &["line 2", "`cameras`", "did you mean `camera`"],
        ),
        ("infinity", "format = 1\n[ground]\nheight_mm = inf\n".into(), &["line 3", "finite"]),
        (
            "beyond single precision",
            "format = 1\n[ground]\nheight_mm = 1e300\n".into(),
            &["line 3", "`ground.height_mm`", "too large"],
        ),
        (
            "huge still",
            "format = 1\nstill.size = [16384, 16384]\n".into(),
            &["`still.size`", "67108864"],
        ),
    ]);
}

#[test]
fn faults_in_objects_and_materials() {
    let stone = "format = 1\n[[objects]]\nround_brilliant = {}\n";
    assert_faults(&[
        (
            "unknown library material",
            format!("{stone}material.library = \"dimond\"\n"),
            &["line 4", "`objects.0.material.library`", "\"dimond\"", "did you mean `Diamond`"],
        ),
        (
            "impossible index",
            format!("{stone}material = {{ library = \"Diamond\", n_d = 0.5 }}\n"),
            &["line 4", "`objects.0.material`", "index of refraction", "from 1 to 5"],
        ),
        ("no material", stone.into(), &["line 2", "`objects.0.material`", "missing"]),
        (
            "two shapes",
            format!("{stone}polyhedron.half_spaces = []\nmaterial.library = \"Quartz\"\n"),
            &["`objects.0.polyhedron`", "`round_brilliant` is there too"],
        ),
        (
            "open polyhedron",
            "format = 1\n[[objects]]\nmaterial.library = \"Quartz\"\n\
             polyhedron.half_spaces = [{ normal = [0, 0, 1], distance_mm = 1 }]\n"
                .into(),
            &["line 4", "`objects.0.polyhedron.half_spaces`"],
        ),
        (
            "impossible brilliant",
            "format = 1\n[[objects]]\nmaterial.library = \"Quartz\"\n\
             round_brilliant.table = 56\n"
                .into(),
            &["line 4", "`objects.0.round_brilliant.table`", "found 56"],
        ),
        (
            "unknown proportions",
            "format = 1\n[[objects]]\nmaterial.library = \"Quartz\"\n\
             round_brilliant.proportions = \"Tolkovsky (1919)\"\n"
                .into(),
            &["line 4", "did you mean `Tolkowsky (1919)`"],
        ),
        (
            "diffuse glass",
            format!("{stone}material = {{ diffuse = 0.5, n_d = 1.5 }}\n"),
            &["`objects.0.material.n_d`", "clear materials"],
        ),
        (
            "missing mesh file",
            "format = 1\n[[objects]]\nmesh.file = \"no-such-file.glb\"\n".into(),
            &["line 3", "`objects.0.mesh.file`", "no-such-file.glb"],
        ),
    ]);
}

#[test]
fn faults_in_lights_ground_and_camera() {
    let disc = "format = 1\n[[lights.discs]]\nelevation_degrees = 10\n";
    assert_faults(&[
        (
            "bright reflectance",
            "format = 1\n[ground]\nheight_mm = 0\nreflectance = [0.5, 1.5]\n".into(),
            &["line 4", "`ground.reflectance.1`", "found 1.5", "0 to 1"],
        ),
        (
            "illuminant as reflectance",
            "format = 1\n[ground]\nheight_mm = 0\nreflectance = [0.5, \"D65\"]\n".into(),
            &["`ground.reflectance.1`", "spectrum of a light"],
        ),
        (
            "unknown illuminant",
            format!("{disc}radius_degrees = 1\nradiance = 1\nspectrum = \"D56\"\n"),
            &["line 6", "`lights.discs.0.spectrum`", "\"D56\"", "D65"],
        ),
        (
            "no brightness",
            format!("{disc}radius_degrees = 1\n"),
            &["line 2", "`lights.discs.0`", "`radiance`, `irradiance`"],
        ),
        (
            "rig and more",
            "format = 1\n[lights]\nrig = \"Candle\"\nhemisphere = {}\n".into(),
            &["line 3", "`lights.rig`"],
        ),
        (
            "wavelengths out of order",
            "format = 1\n[lights.backdrop]\n\
             spectrum = { lambda_nm = [500, 400], value = [1, 1] }\n"
                .into(),
            &["line 3", "`lights.backdrop.spectrum`", "must increase"],
        ),
        (
            "three numbers",
            "format = 1\n[camera]\nup = [0, 1]\n".into(),
            &["line 3", "`camera.up`", "found 2 values, expected 3"],
        ),
        (
            "upright camera",
            "format = 1\n[camera]\nposition_mm = [0, 0, 9]\n".into(),
            &["`camera.up`", "parallel", "[0, 1, 0]"],
        ),
        (
            "blind camera",
            "format = 1\n[camera]\nposition_mm = [0, 0, 9]\ntarget_mm = [0, 0, 9]\n".into(),
            &["line 3", "`camera.position_mm`", "on the target"],
        ),
    ]);
}

/// A small generator (xorshift), so that a failure can be made again.
struct Mutations(u64);

impl Mutations {
    fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % count as u64) as usize
    }

    /// The text with a few characters dropped, doubled, replaced or swapped for a nasty token.
    fn mutate(&mut self, text: &str) -> String {
        const NASTY: [&str; 18] = [
            "",
            "\"",
            "[",
            "]",
            "{",
            "}",
            "=",
            "\n",
            ".",
            "-1",
            "1e308",
            "-0.0",
            "nan",
            "\u{0}",
            "99999999999999999999",
            "[[",
            "é",
            "true",
        ];
        let mut characters: Vec<String> = text.chars().map(String::from).collect();
        for _ in 0..=self.below(4) {
            let at = self.below(characters.len());
            let until = (at + self.below(8)).min(characters.len());
            let token = NASTY[self.below(NASTY.len())].to_owned();
            characters.splice(at..until, [token]);
        }
        characters.concat()
    }
}

#[test]
fn no_mutation_of_a_good_file_panics() {
    let mut mutations = Mutations(0x9e37_79b9_7f4a_7c15);
    let page = include_str!("../docs/scene-file.md");
    let (_, example) = page.split_once("```toml\n").unwrap();
    let written = Document::default().to_toml(Path::new(""));
    let sources: Vec<&str> = scenes()
        .iter()
        .map(|scene| scene.text)
        .chain([written.as_str(), example.split_once("```").unwrap().0])
        .collect();
    let (mut good, mut bad) = (0, 0);
    for round in 0..3000 {
        let text = mutations.mutate(sources[round % sources.len()]);
        match read(&text) {
            Ok(document) => {
                good += 1;
                // What was read can be written and is read again as the same.
                assert_eq!(read(&document.to_toml(Path::new(""))).as_ref(), Ok(&document));
            }
            Err(fault) => {
                bad += 1;
                assert!(!fault.is_empty());
            }
        }
    }
    assert!(good > 100 && bad > 1000, "{good} good, {bad} bad");
}

#[test]
fn faults_in_prints() {
    let print = |keys: &str| {
        format!(
            "format = 1\n[[objects]]\nround_brilliant = {{}}\nmaterial.diffuse = 1\n\
             material.print = {{ {keys} }}\n"
        )
    };
    let word = |keys: &str| print(&format!("library = \"The word prism\", {keys}"));
    assert_faults(&[
        ("no image", print("width_mm = 3"), &["line 5", "`objects.0.material.print`", "`file`"]),
        (
            "two images",
            word("file = \"a.png\", width_mm = 3"),
            &["`objects.0.material.print.library`", "give only one"],
        ),
        (
            "unknown image",
            print("library = \"The word prisma\", width_mm = 3"),
            &["`objects.0.material.print.library`", "did you mean `The word prism`"],
        ),
        ("no size", word("up = [0, 1, 0]"), &["print.width_mm`", "missing", "height_mm"]),
        ("no width", word("width_mm = 0"), &["print.width_mm`", "found 0"]),
        ("negative", word("width_mm = 1, height_mm = -2"), &["print.height_mm`", "found -2"]),
        ("too far", word("width_mm = 1e30"), &["print.width_mm`", "1000000"]),
        ("no facing", word("width_mm = 1, facing = [0, 0, 0]"), &["print.facing`", "point"]),
        (
            "up and facing",
            word("width_mm = 1, facing = [0, 2, 0], up = [0, -1, 0]"),
            &["print.up`", "parallel"],
        ),
        (
            "outside",
            word("width_mm = 1, outside = \"mirrored\""),
            &["print.outside`", "did you mean `mirror`", "repeat"],
        ),
        ("tint", word("width_mm = 1, tint = [1, 2, 1]"), &["print.tint`", "found 2"]),
        (
            "missing file",
            print("file = \"nowhere.png\", width_mm = 1"),
            &["line 5", "`objects.0.material.print.file`", "nowhere.png"],
        ),
        (
            "not an image",
            print("file = \"Cargo.toml\", width_mm = 1"),
            &["print.file`", "Cargo.toml", "neither PNG nor JPEG", "convert"],
        ),
        (
            "on a clear stone",
            "format = 1\n[[objects]]\nround_brilliant = {}\nmaterial.library = \"Diamond\"\n\
             material.print = { library = \"The word prism\", width_mm = 1 }\n"
                .into(),
            &["line 5", "`objects.0.material.print`", "`diffuse`"],
        ),
    ]);
}

#[test]
fn deep_nesting_and_long_keys_are_faults() {
    for text in [
        format!("a{} = 1", ".a".repeat(200_000)),
        format!("a = {}", "[".repeat(200_000)),
        format!("a = {}1{}", "{a=".repeat(5000), "}".repeat(5000)),
        format!("{} = 1", "k".repeat(1_000_000)),
    ] {
        assert!(read(&text).is_err());
    }
}
