//! Scene files: round trips, defaults, overrides, and errors that name the place and the remedy.

use std::path::Path;

use brilliance_renderer::camera::Camera;
use brilliance_renderer::cuts::{RoundBrilliant, StandardProportions};
use brilliance_renderer::error::RendererError;
use brilliance_renderer::light::{DiscLight, Lights, SkyLight};
use brilliance_renderer::material::{
    Dielectric, Diffuse, Dispersion, Material, SellmeierTerm, find, library,
};
use brilliance_renderer::rigs::rigs;
use brilliance_renderer::scene::{Ground, Object, Shape, Transform};
use brilliance_renderer::scene_file::{Document, scenes};
use brilliance_renderer::settings::{ToneCurve, WhitePoint};
use brilliance_renderer::solid::HalfSpace;
use brilliance_renderer::spectrum::{Illuminant, Spectrum};
use glam::{DVec3, Quat, Vec3};

fn read(text: &str) -> Result<Document, String> {
    Document::from_toml(text, Path::new("")).map_err(|error| error.to_string())
}

fn fault_of(text: &str) -> String {
    read(text).expect_err(text)
}

/// Fails unless the document is read back from its text with every bit.
fn assert_round_trip(document: &Document) {
    let text = document.to_toml(Path::new(""));
    let again = read(&text).unwrap_or_else(|fault| panic!("{fault}\n{text}"));
    assert_eq!(&again, document, "{text}");
}

fn stone(material: Material) -> Object {
    Object {
        name: "Stone".to_owned(),
        shape: Shape::RoundBrilliant(RoundBrilliant::default()),
        transform: Transform::default(),
        material,
    }
}

fn clear(name: &str, dispersion: Dispersion) -> Material {
    let name = name.to_owned();
    Material::Dielectric(Dielectric { name, dispersion, absorption_per_mm: None })
}

fn table_spectrum() -> Spectrum {
    Spectrum::Tabulated { lambda_nm: vec![400.0, 550.5, 700.0], value: vec![0.1, 0.333, 0.0] }
}

#[test]
fn the_start_document_is_the_shipped_diamond() {
    assert_eq!(read(scenes()[0].text).unwrap(), Document::default());
    assert_round_trip(&Document::default());
}

#[test]
fn shipped_scenes_are_read_and_round_trip() {
    assert_eq!(scenes().len(), 5);
    for scene in scenes() {
        let document = read(scene.text).unwrap_or_else(|fault| panic!("{}: {fault}", scene.name));
        assert!(!document.scene.objects.is_empty(), "{}", scene.name);
        assert_round_trip(&document);
    }
    let seven = read(scenes()[1].text).unwrap();
    assert_eq!(seven.scene.objects.len(), 7);
    assert_eq!(seven.scene.lights.discs.len(), 9);
}

#[test]
fn the_prism_stands_at_minimum_deviation() {
    let prism = read(scenes()[2].text).unwrap();
    let n = find("SF11").unwrap().dispersion.n_d();
    let deviation = 2.0 * (n * 0.5).asin().to_degrees() - 60.0;
    let to_light = prism.scene.lights.discs[0].direction;
    let view = (prism.scene.camera.target - prism.scene.camera.position).normalize_or_zero();
    let turned = f64::from(view.angle_between(to_light)).to_degrees();
    assert!((turned - deviation).abs() < 0.02, "{turned} {deviation}");
}

#[test]
fn every_rig_round_trips_and_is_found_by_name() {
    for rig in rigs() {
        let mut document = Document::default();
        document.scene.lights = (rig.lights)();
        assert_round_trip(&document);
        let text = format!("format = 1\nlights.rig = \"{}\"\n", rig.name.to_uppercase());
        assert_eq!(read(&text).unwrap().scene.lights, document.scene.lights);
    }
}

#[test]
fn every_material_round_trips() {
    let mut materials: Vec<Material> = library()
        .iter()
        .flat_map(|material| {
            let stretched = material.dispersion.rescaled(2.05, 0.0715);
            [
                Material::Dielectric(material.dielectric()),
                clear(&material.name, material.linear()),
                clear(&material.name, stretched.clone()),
                clear("Other name", material.dispersion.clone()),
                clear("Other name", stretched),
            ]
        })
        .collect();
    let term = SellmeierTerm { strength: 1.1, resonance_um2: 0.01 };
    let custom = Dispersion::Sellmeier { constant: 0.25, terms: vec![term] };
    materials.push(clear("", Dispersion::cauchy_from(1.7, 0.02)));
    materials.push(Material::Dielectric(Dielectric {
        name: "Tinted \"glass\"\n".to_owned(),
        dispersion: custom,
        absorption_per_mm: Some(table_spectrum()),
    }));
    for reflectance in [Spectrum::Flat(0.18), Spectrum::Rgb([0.1, 0.9, 0.3]), table_spectrum()] {
        materials.push(Material::Diffuse(Diffuse { reflectance }));
    }
    for material in materials {
        let mut document = Document::default();
        document.scene.objects = vec![stone(material)];
        assert_round_trip(&document);
    }
}

#[test]
fn a_stretched_library_curve_is_written_by_its_figures() {
    let mut document = Document::default();
    let stretched = find("Sapphire").unwrap().dispersion.rescaled(1.9, 0.03);
    document.scene.objects = vec![stone(clear("Sapphire", stretched))];
    let text = document.to_toml(Path::new(""));
    assert!(text.contains("library = \"Sapphire\"\nn_d = 1.9\ndispersion_bg = 0.03\n"), "{text}");
}

#[test]
fn lights_ground_camera_and_settings_round_trip() {
    let mut document = Document::default();
    let spectra = [
        Spectrum::Illuminant(Illuminant::D50),
        Spectrum::Illuminant(Illuminant::A),
        Spectrum::Illuminant(Illuminant::E),
        Spectrum::Illuminant(Illuminant::F2),
        Spectrum::Illuminant(Illuminant::LedB3),
        Spectrum::BlackBody { kelvin: 3200.0 },
        table_spectrum(),
    ];
    let disc = |(index, spectrum): (usize, Spectrum)| DiscLight {
        name: format!("Disc {index}"),
        direction: Vec3::new(0.1, -0.7, 0.3 + index as f32).normalize_or_zero(),
        angular_radius_radians: 0.01 + 0.1 * index as f32,
        radiance: 1.0 / 3.0,
        spectrum,
    };
    document.scene.lights = Lights {
        discs: spectra.into_iter().enumerate().map(disc).collect(),
        hemisphere: Some(SkyLight::daylight(0.1)),
        environment: Some(SkyLight { radiance: 0.0, spectrum: Spectrum::Flat(1.5) }),
        observer_shadow_radians: 0.2,
        backdrop: Some(SkyLight { radiance: 1e-3, spectrum: Spectrum::Rgb([0.1, 0.2, 0.3]) }),
    };
    document.scene.ground = Some(Ground {
        height: -3.3,
        square: 0.7,
        reflectance: [Spectrum::Flat(0.9), Spectrum::Rgb([0.0, 0.1, 0.7])],
    });
    document.scene.camera = Camera {
        position: Vec3::new(1.1, 2.2, 3.3),
        target: Vec3::new(0.1, 0.0, -0.3),
        up: Vec3::new(1.0, 2.0, -0.5).normalize_or_zero(),
        fov_y_radians: 0.333,
    };
    document.trace.split_count = 2.5;
    document.trace.significance_threshold = 3e-5;
    document.trace.max_depth = 48;
    document.trace.perturb = false;
    document.trace.bins = 32;
    document.still.size = [320, 200];
    document.still.passes = 3;
    for white_point in [
        WhitePoint::EqualEnergy,
        WhitePoint::D65,
        WhitePoint::D50,
        WhitePoint::A,
        WhitePoint::Temperature(4321.5),
    ] {
        document.display.white_point = white_point;
        assert_round_trip(&document);
    }
    for tone_curve in [ToneCurve::Linear, ToneCurve::Reinhard, ToneCurve::Filmic] {
        document.display.tone_curve = tone_curve;
        document.display.exposure_ev = -1.7;
        document.display.gamut_mapping = false;
        assert_round_trip(&document);
    }
    document.scene.lights = Lights::default();
    document.scene.ground = None;
    document.scene.objects.clear();
    assert_round_trip(&document);
}

#[test]
fn shapes_and_transforms_round_trip() {
    let mut document = Document::default();
    let mut object = stone(Material::Dielectric(find("quartz").unwrap().dielectric()));
    for set in StandardProportions::ALL {
        object.shape = Shape::RoundBrilliant(set.of_diameter(4.2));
        document.scene.objects.push(object.clone());
    }
    let directions = [
        DVec3::new(1.0, 1.0, 1.0),
        DVec3::new(-1.0, -1.0, 1.0),
        DVec3::new(-1.0, 1.0, -1.0),
        DVec3::new(1.0, -1.0, -1.0),
    ];
    let face = |(index, normal): (usize, &DVec3)| HalfSpace {
        normal: normal.normalize(),
        distance: 1.0 + 0.1 * index as f64,
        name: format!("face {index}"),
    };
    object.shape = Shape::Polyhedron(directions.iter().enumerate().map(face).collect());
    let rotations = [
        Quat::IDENTITY,
        Quat::from_rotation_z(0.5),
        Quat::from_rotation_x(std::f32::consts::PI),
        Quat::from_axis_angle(Vec3::new(0.36, 0.48, 0.8), 2.0),
        -Quat::from_rotation_y(1.0),
    ];
    for (index, rotation) in rotations.into_iter().enumerate() {
        object.transform = Transform {
            translation: Vec3::new(index as f32, -0.1, 1.0 / 3.0),
            rotation,
            scale: 0.7,
        };
        document.scene.objects.push(object.clone());
    }
    assert_round_trip(&document);
}

#[test]
fn irradiance_becomes_radiance_over_the_solid_angle() {
    let text = "format = 1\n[[lights.discs]]\nelevation_degrees = 90\nradius_degrees = 0.265\n\
                irradiance = 3\n";
    let disc = read(text).unwrap().scene.lights.discs.remove(0);
    let solid_angle = std::f64::consts::TAU * (1.0 - 0.265_f64.to_radians().cos());
    let ratio = f64::from(disc.radiance) * solid_angle / 3.0;
    assert!((ratio - 1.0).abs() < 1e-5, "{ratio}");
    assert_eq!(disc.direction, Vec3::Z);
}

#[test]
fn what_is_left_out_has_a_default() {
    let bare = read("format = 1\n").unwrap();
    let start = Document::default();
    assert!(bare.scene.objects.is_empty());
    assert_eq!(bare.scene.lights, start.scene.lights);
    assert_eq!(bare.scene.camera, start.scene.camera);
    assert_eq!((bare.trace, bare.display, bare.still), (start.trace, start.display, start.still));
}

#[test]
fn faults_name_line_key_finding_and_remedy() {
    let stone = "format = 1\n[[objects]]\nround_brilliant = {}\n";
    let disc = "format = 1\n[[lights.discs]]\nelevation_degrees = 10\n";
    let cases: &[(&str, String, &[&str])] = &[
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
            &["line 3", "`lights.backdrop.spectrum.lambda_nm.1`", "must increase"],
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
            "format = 1\n[camera]\nposition_mm = [0, 0, 0]\n".into(),
            &["line 3", "`camera.position_mm`", "on the target"],
        ),
        ("infinity", "format = 1\n[ground]\nheight_mm = inf\n".into(), &["line 3", "finite"]),
        (
            "beyond single precision",
            "format = 1\n[ground]\nheight_mm = 1e300\n".into(),
            &["line 3", "`ground.height_mm`", "too large"],
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
        (
            "huge still",
            "format = 1\nstill.size = [16384, 16384]\n".into(),
            &["`still.size`", "67108864"],
        ),
    ];
    for (what, text, wanted) in cases {
        let fault = fault_of(text);
        for part in *wanted {
            assert!(fault.contains(part), "{what}: no {part:?} in: {fault}");
        }
    }
}

#[test]
fn overrides_replace_values_and_are_named_in_faults() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, scenes()[0].text).unwrap();
    let open = |overrides: &[&str]| {
        let overrides: Vec<String> = overrides.iter().map(|&text| text.to_owned()).collect();
        Document::open_with(&path, &overrides).map_err(|error| error.to_string())
    };
    let document = open(&[
        "trace.split_count=3",
        "objects.0.material.n_d = 1.9",
        "display.tone_curve=linear",
        "display.white_point.kelvin=4000",
        "still.size=[64, 32]",
        "objects.0.name=2nd stone",
    ])
    .unwrap();
    assert_eq!(document.trace.split_count, 3.0);
    assert_eq!(document.still.size, [64, 32]);
    assert_eq!(document.display.tone_curve, ToneCurve::Linear);
    assert_eq!(document.display.white_point, WhitePoint::Temperature(4000.0));
    assert_eq!(document.scene.objects[0].name, "2nd stone");
    let expected = clear("Diamond", Dispersion::Linear { n_d: 1.9, dispersion_bg: 0.044 });
    assert_eq!(document.scene.objects[0].material, expected);

    for (text, wanted) in [
        ("trace.split_count=99", "override `trace.split_count=99`: `trace.split_count`: found 99"),
        ("trace.splitcount=3", "override `trace.splitcount=3`: `trace.splitcount`: there is no"),
        ("trace.bins=lots", "override `trace.bins=lots`: `trace.bins`: found the text \"lots\""),
        ("objects.1.name=x", "there are 1 of these"),
        ("format.x=1", "no such key inside the number 1"),
        ("trace.split_count", "key.path=value"),
        ("trace..bins=1", "a key is empty"),
        ("trace.bins=nan", "finite"),
    ] {
        let fault = open(&[text]).unwrap_err();
        assert!(fault.contains(wanted), "{text}: {fault}");
        assert!(fault.contains("scene.toml"), "{text}: {fault}");
        assert!(fault.contains(&format!("override `{text}`")), "{text}: {fault}");
    }
}

#[test]
fn files_are_saved_whole_and_opened_again() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("saved.toml");
    let mut document = Document::default();
    document.save(&path).unwrap();
    document.still.passes = 7;
    document.save(&path).unwrap();
    assert_eq!(Document::open(&path).unwrap(), document);
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "a temporary file is left");

    let nowhere = folder.path().join("no/such/folder/scene.toml");
    assert!(
        matches!(document.save(&nowhere), Err(RendererError::Io { path, .. }) if path == nowhere)
    );
    assert!(matches!(Document::open(&nowhere), Err(RendererError::Io { .. })));
    let open = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        Document::open(&path).unwrap_err().to_string()
    };
    assert!(open("scene.txt", b"").contains(".gltf or .glb"));
    assert!(open("latin.toml", b"format = 1 # \xe9").contains("byte 13 is not UTF-8"));
    let fault = open("bad.toml", b"format = 1\nformat = 2\n");
    assert!(fault.contains("bad.toml: line 2"), "{fault}");
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
    let sources: Vec<String> = scenes()
        .iter()
        .map(|scene| scene.text.to_owned())
        .chain([Document::default().to_toml(Path::new("")), example()])
        .collect();
    let (mut good, mut bad) = (0, 0);
    for round in 0..3000 {
        let text = mutations.mutate(&sources[round % sources.len()]);
        match read(&text) {
            Ok(document) => {
                good += 1;
                assert_round_trip(&document);
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
fn deep_nesting_and_long_keys_are_faults() {
    for text in [
        format!("a{} = 1", ".a".repeat(200_000)),
        format!("a = {}", "[".repeat(200_000)),
        format!("a = {}1{}", "{a=".repeat(5000), "}".repeat(5000)),
        format!("{} = 1", "k".repeat(1_000_000)),
    ] {
        assert!(fault_of(&text).len() < 2_000_000);
    }
}

/// The example in the documentation.
fn example() -> String {
    let page = include_str!("../docs/scene-file.md");
    let start = page.find("```toml\n").unwrap() + "```toml\n".len();
    page[start..start + page[start..].find("```").unwrap()].to_owned()
}

#[test]
fn the_documented_example_is_a_scene() {
    let document = read(&example()).unwrap();
    assert_round_trip(&document);
    assert!(document.scene.objects.len() >= 4);
    assert!(document.scene.ground.is_some() && document.scene.lights.environment.is_some());
}
