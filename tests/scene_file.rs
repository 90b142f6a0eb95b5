//! Scene files: round trips, defaults, overrides, meshes beside the scene, saving and opening.

use std::path::Path;

use brilliance_renderer::camera::Camera;
use brilliance_renderer::cuts::{RoundBrilliant, StandardProportions};
use brilliance_renderer::error::RendererError;
use brilliance_renderer::light::{DiscLight, Lights, SkyLight};
use brilliance_renderer::material::{
    Dielectric, Diffuse, Dispersion, Image, Layout, Material, Outside, Planar, Print,
    SellmeierTerm, find, library,
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
        throws_light: false,
    }
}

fn clear(name: &str, dispersion: Dispersion) -> Material {
    let name = name.to_owned();
    Material::Dielectric(Dielectric { name, dispersion, absorption_per_mm: None })
}

fn table_spectrum() -> Spectrum {
    Spectrum::Tabulated { lambda_nm: vec![400.0, 550.5, 700.0], value: vec![0.1, 0.333, 0.0] }
}

fn shipped(name: &str) -> Document {
    let scene = scenes().iter().find(|scene| scene.name == name).expect("it ships");
    read(scene.text).expect("it is read")
}

#[test]
fn the_start_document_is_the_shipped_diamond() {
    assert_eq!(read(scenes()[0].text).unwrap(), Document::default());
    assert_round_trip(&Document::default());
}

#[test]
fn shipped_scenes_are_read_and_round_trip() {
    assert_eq!(scenes().len(), 9);
    for scene in scenes() {
        let document = read(scene.text).unwrap_or_else(|fault| panic!("{}: {fault}", scene.name));
        assert!(!document.scene.objects.is_empty(), "{}", scene.name);
        assert_round_trip(&document);
    }
    let throwing: Vec<_> = scenes()
        .iter()
        .filter(|scene| read(scene.text).unwrap().scene.objects.iter().any(|it| it.throws_light))
        .map(|scene| scene.name)
        .collect();
    assert_eq!(throwing, ["Beam"], "the key is read, and what is thrown is worth its time");
    let seven = shipped("Seven diamonds");
    assert_eq!(seven.scene.objects.len(), 7);
    assert_eq!(seven.scene.lights.discs.len(), 9);
}

#[test]
fn the_prism_stands_at_minimum_deviation() {
    let prism = shipped("Prism");
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
        materials.push(Material::Diffuse(Diffuse { reflectance, print: None }));
    }
    for material in materials {
        let mut document = Document::default();
        document.scene.objects = vec![stone(material)];
        assert_round_trip(&document);
    }
}

#[test]
fn prints_round_trip() {
    let image = Image::of_library("The word prism").unwrap();
    let tilted = Vec3::new(0.36, -0.48, 0.8);
    for (facing, up, outside, tint) in [
        (Vec3::Z, Vec3::Y, [Outside::Bare; 2], [1.0; 3]),
        (Vec3::NEG_Y, Vec3::Z, [Outside::Mirror; 2], [0.9, 0.5, 0.0]),
        (Vec3::Z, Vec3::Y, [Outside::Repeat, Outside::Edge], [1.0; 3]),
        (tilted, tilted.any_orthonormal_vector(), [Outside::Repeat; 2], [1.0; 3]),
    ] {
        let layout = Layout::Planar(Planar { facing, up, size_mm: [7.1, 0.3] });
        let print = Print { image: image.clone(), layout, outside, tint };
        let reflectance = Spectrum::Rgb([0.8, 0.7, 0.6]);
        let mut document = Document::default();
        let printed = Material::Diffuse(Diffuse { reflectance, print: Some(print) });
        document.scene.objects = vec![stone(printed)];
        assert_round_trip(&document);
    }
}

#[test]
fn a_print_needs_no_more_than_an_image_and_a_width() {
    let print = |keys: &str| {
        let text = format!(
            "format = 1\n[[objects]]\nround_brilliant = {{}}\nmaterial = {{ diffuse = 1, \
             print = {{ library = \"the WORD prism\", {keys} }} }}\n"
        );
        let Material::Diffuse(diffuse) = &read(&text).unwrap().scene.objects[0].material else {
            panic!("not matte")
        };
        let print = diffuse.print.clone().expect("a print");
        let Layout::Planar(planar) = print.layout else { panic!("not planar") };
        (print.outside, planar)
    };
    let planar = Planar { facing: Vec3::Z, up: Vec3::Y, size_mm: [8.0, 4.0] };
    assert_eq!(print("width_mm = 8"), ([Outside::Bare; 2], planar));
    assert_eq!(print("height_mm = 4"), ([Outside::Bare; 2], planar));
    // Upwards is +z where that is to be seen, and always at right angles to where it faces.
    let facing = Vec3::new(0.0, -0.8, 0.6);
    let (outside, planar) =
        print("width_mm = 1, height_mm = 1, facing = [0, -4, 3], outside = \"edge\"");
    assert_eq!((outside, planar.size_mm), ([Outside::Edge; 2], [1.0, 1.0]));
    assert!(planar.facing.distance(facing) < 1e-6);
    assert!(planar.up.distance(Vec3::new(0.0, 0.6, 0.8)) < 1e-6);
}

/// The image beside the scene is found from wherever the scene is saved, and named relative to it.
#[test]
fn an_image_beside_the_scene_is_read_once_and_saved_by_its_path() {
    let folder = tempfile::tempdir().unwrap();
    let image = image::RgbImage::from_pixel(3, 2, image::Rgb([10, 20, 30]));
    image.save(folder.path().join("paper.png")).unwrap();
    let text = "format = 1\n[[objects]]\nround_brilliant = {}\nmaterial.diffuse = 1\n\
                material.print = { file = \"paper.png\", width_mm = 3 }\n[[objects]]\n\
                round_brilliant = {}\nmaterial.diffuse = 0.5\n\
                material.print = { file = \"paper.png\", height_mm = 5 }\n";
    let document = Document::from_toml(text, folder.path()).unwrap();
    let image = |document: &Document, index: usize| {
        let Material::Diffuse(diffuse) = &document.scene.objects[index].material else {
            panic!("not matte")
        };
        diffuse.print.as_ref().expect("a print").image.clone()
    };
    let first = image(&document, 0);
    assert!(std::sync::Arc::ptr_eq(&first, &image(&document, 1)));
    assert_eq!((first.size, first.texels[5]), ([3, 2], 0x1e_14_0a));
    assert_eq!(first.name(), "paper.png");
    for (place, written) in [("scene.toml", "paper.png"), ("scenes/scene.toml", "../paper.png")] {
        let path = folder.path().join(place);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        document.save(&path).unwrap();
        let text = std::fs::read_to_string(&path).unwrap();
        assert!(text.contains(&format!("file = \"{written}\"")), "{text}");
        assert_eq!(image(&Document::open(&path).unwrap(), 0).texels, first.texels);
    }
}

/// Whichever way a path goes about it.
#[test]
fn a_file_is_read_once_by_whatever_path() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("sub")).unwrap();
    let octahedron = include_bytes!("../assets/gems/spinel_octahedron.glb");
    std::fs::write(folder.path().join("stone.glb"), octahedron).unwrap();
    let image = image::RgbImage::from_pixel(3, 2, image::Rgb([10, 20, 30]));
    image.save(folder.path().join("paper.png")).unwrap();
    let object = |to: &str| {
        format!(
            "[[objects]]\nmesh = {{ file = \"{to}stone.glb\" }}\nmaterial.diffuse = 1\n\
             material.print = {{ file = \"{to}paper.png\", width_mm = 3 }}\n"
        )
    };
    let text = format!("format = 1\n{}{}", object(""), object("sub/../"));
    let objects = Document::from_toml(&text, folder.path()).unwrap().scene.objects;
    let [Shape::Mesh(first), Shape::Mesh(second)] = [&objects[0].shape, &objects[1].shape] else {
        panic!("not meshes")
    };
    assert!(std::sync::Arc::ptr_eq(&first.mesh, &second.mesh));
    // Prints are the same when they have the same image in memory.
    assert_eq!(objects[0].material, objects[1].material);
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
    assert!(document.save(&nowhere).unwrap_err().to_string().contains("does not exist"));
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

/// The example in the documentation.
fn example() -> String {
    let page = include_str!("../docs/scene-file.md");
    let (_, after) = page.split_once("```toml\n").expect("an example begins");
    after.split_once("```").expect("the example ends").0.to_owned()
}

#[test]
fn the_documented_example_is_a_scene() {
    let document = read(&example()).unwrap();
    assert_round_trip(&document);
    assert!(document.scene.objects.len() >= 4);
    assert!(document.scene.ground.is_some() && document.scene.lights.environment.is_some());
}

/// A GLB file with a tetrahedron, three of its edges 1 unit long: clear and of index 1.7, or open
/// and matte, with one of its faces left out.
fn tetrahedron_glb(is_open: bool) -> Vec<u8> {
    let indices = if is_open { 9 } else { 12 };
    let transmission = if is_open { 0.0 } else { 1.0 };
    let positions: [[f32; 3]; 4] =
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let triangles: [u16; 12] = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
    let mut binary: Vec<u8> =
        positions.as_flattened().iter().flat_map(|value| value.to_le_bytes()).collect();
    binary.extend(triangles.iter().flat_map(|index| index.to_le_bytes()));
    let mut text = serde_json::json!({
        "asset": { "version": "2.0" },
        "extensionsUsed": ["KHR_materials_ior", "KHR_materials_transmission"],
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "name": "Tetrahedron", "mesh": 0 }],
        "meshes": [{ "primitives": [{
            "attributes": { "POSITION": 0 }, "indices": 1, "material": 0
        }] }],
        "materials": [{ "name": "Clear", "extensions": {
            "KHR_materials_ior": { "ior": 1.7 },
            "KHR_materials_transmission": { "transmissionFactor": transmission }
        } }],
        "buffers": [{ "byteLength": 72 }],
        "bufferViews": [
            { "buffer": 0, "byteOffset": 0, "byteLength": 48 },
            { "buffer": 0, "byteOffset": 48, "byteLength": 24 }
        ],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
              "min": [0, 0, 0], "max": [1, 1, 1] },
            { "bufferView": 1, "componentType": 5123, "count": indices, "type": "SCALAR" }
        ]
    })
    .to_string()
    .into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut glb = b"glTF\x02\0\0\0".to_vec();
    glb.extend((12 + 8 + text.len() as u32 + 8 + binary.len() as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", &text), (b"BIN\0", &binary)] {
        glb.extend((chunk.len() as u32).to_le_bytes());
        glb.extend(kind);
        glb.extend(chunk);
    }
    glb
}

#[test]
fn meshes_are_opened_saved_and_found_again_beside_the_scene() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("stones")).unwrap();
    let glb = folder.path().join("stones/tetrahedron.glb");
    std::fs::write(&glb, tetrahedron_glb(false)).unwrap();

    let opened = Document::open(&glb).unwrap();
    let start = Document::default();
    assert_eq!(opened.scene.lights, start.scene.lights);
    let object = &opened.scene.objects[0];
    assert_eq!(object.name, "Tetrahedron");
    assert!(matches!(&object.material, Material::Dielectric(clear)
        if (clear.dispersion.n_d() - 1.7).abs() < 1e-3));
    // The mesh stands in the middle of the picture and fills it as far as the start stone does.
    let Camera { position, target, .. } = opened.scene.camera;
    assert!((target.abs() - 0.5).abs().max_element() < 1e-6, "{target}");
    let start_camera = start.scene.camera;
    let shrunk = position.distance(target) / start_camera.position.distance(start_camera.target);
    assert!((shrunk - 0.5 / 3.25).abs() < 1e-6, "half the longest side to 3.25 mm: {shrunk}");

    let path = folder.path().join("scene.toml");
    opened.save(&path).unwrap();
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.contains("file = \"stones/tetrahedron.glb\"\nindex = 0\n"), "{text}");
    let again = Document::open(&path).unwrap();
    assert_eq!(again.to_toml(folder.path()), text);
    assert_eq!(again.scene.objects[0].material, object.material);

    let mesh = "format = 1\n[[objects]]\nmesh.file = \"stones/tetrahedron.glb\"\n";
    let from = |text: &str| Document::from_toml(text, folder.path());
    let own = from(mesh).unwrap();
    assert_eq!(own.scene.objects[0].material, object.material, "the material of the file");
    let given = from(&format!("{mesh}material.library = \"Quartz\"\n")).unwrap();
    assert_ne!(given.scene.objects[0].material, object.material);
    let fault = from(&format!("{mesh}mesh.index = 3\n")).unwrap_err().to_string();
    assert!(fault.contains("`objects.0.mesh.index`: found 3"), "{fault}");
    assert!(fault.contains("has 1 meshes"), "{fault}");

    std::fs::write(folder.path().join("open.glb"), tetrahedron_glb(true)).unwrap();
    let open = "format = 1\n[[objects]]\nmesh.file = \"open.glb\"\n";
    assert!(from(open).is_ok());
    let fault = from(&format!("{open}material.library = \"Quartz\"\n")).unwrap_err().to_string();
    assert!(fault.contains("line 3") && fault.contains("must be closed"), "{fault}");

    let set = |text: &str| Document::open_with(&glb, &[text.to_owned()]);
    assert_eq!(set("objects.0.material.n_d=2").unwrap().scene.objects.len(), 1);
    assert!(set("objects.0.materail.n_d=2").unwrap_err().to_string().contains("did you mean"));
}
