//! glTF files: what is read, and that nothing broken or hostile does harm.

#![expect(clippy::unwrap_used, reason = "a test ends where it fails, in its helpers too")]

mod shapes;

use std::path::{Path, PathBuf};

use brilliance_renderer::color;
use brilliance_renderer::import::gltf::{GltfScene, load, load_from_memory};
use brilliance_renderer::material::{Dispersion, Material};
use brilliance_renderer::mesh::Mesh;
use brilliance_renderer::solid::{HalfSpace, Solid};
use brilliance_renderer::spectrum::{Illuminant, Observer, Spectrum};
use glam::{DVec3, Vec3};
use serde_json::{Value, json};
use shapes::sphere;

/// Positions and triangles of the octahedron |x| + |y| + |z| ≤ 1, in glTF's y-up frame.
const POSITIONS: [[f32; 3]; 6] = [
    [1.0, 0.0, 0.0],
    [-1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.0, 0.0, -1.0],
];
const TRIANGLES: [[u32; 3]; 8] =
    [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];

/// A file in memory: the document and its binary chunk.
#[derive(Clone)]
struct File {
    json: Value,
    bin: Vec<u8>,
}

impl File {
    /// One node with one indexed mesh of the default material.
    fn of_mesh(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Self {
        let mut bin: Vec<u8> =
            positions.iter().flatten().flat_map(|coordinate| coordinate.to_le_bytes()).collect();
        let split = bin.len();
        bin.extend(triangles.iter().flatten().flat_map(|index| index.to_le_bytes()));
        let json = json!({
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [{"name": "stone", "mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
            "accessors": [
                {"bufferView": 0, "componentType": 5126, "count": positions.len(), "type": "VEC3"},
                {"bufferView": 1, "componentType": 5125, "count": 3 * triangles.len(), "type": "SCALAR"},
            ],
            "bufferViews": [
                {"buffer": 0, "byteOffset": 0, "byteLength": split},
                {"buffer": 0, "byteOffset": split, "byteLength": bin.len() - split},
            ],
            "buffers": [{"byteLength": bin.len()}],
        });
        Self { json, bin }
    }

    fn octahedron() -> Self {
        Self::of_mesh(&POSITIONS, &TRIANGLES)
    }

    fn with_material(mut self, material: &Value) -> Self {
        self.json["materials"] = json!([material]);
        self.json["meshes"][0]["primitives"][0]["material"] = json!(0);
        self
    }

    fn diamond() -> Self {
        Self::octahedron().with_material(&json!({
            "name": "diamond",
            "extensions": {
                "KHR_materials_transmission": {"transmissionFactor": 1.0},
                "KHR_materials_ior": {"ior": 2.417},
                "KHR_materials_dispersion": {"dispersion": 20.0 / 55.0},
                "KHR_materials_volume": {
                    "thicknessFactor": 1.0,
                    "attenuationDistance": 4.0,
                    "attenuationColor": [0.5, 0.25, 0.75],
                },
            },
        }))
    }

    fn glb(&self) -> Vec<u8> {
        let mut text = self.json.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        let mut bin = self.bin.clone();
        bin.resize(bin.len().next_multiple_of(4), 0);
        let mut glb = b"glTF".to_vec();
        let mut word = |value: usize, bytes: &[u8]| {
            glb.extend((value as u32).to_le_bytes());
            glb.extend(bytes);
        };
        word(2, &[]);
        word(12 + 8 + text.len() + 8 + bin.len(), &[]);
        word(text.len(), b"JSON");
        glb.extend(text);
        glb.extend((bin.len() as u32).to_le_bytes());
        glb.extend(b"BIN\0");
        glb.extend(bin);
        glb
    }

    fn load(&self) -> Result<GltfScene, String> {
        load_bytes(&self.glb())
    }

    fn error(&self) -> String {
        self.load().unwrap_err()
    }
}

fn load_bytes(bytes: &[u8]) -> Result<GltfScene, String> {
    load_from_memory(Path::new("stone.glb"), bytes).map_err(|fault| {
        let text = fault.to_string();
        assert!(text.starts_with("stone.glb: "), "the file is not named: {text}");
        text
    })
}

fn assert_octahedron(scene: &GltfScene) {
    let mesh = &scene.objects[0].mesh;
    assert_eq!((mesh.positions.len(), mesh.triangles.len()), (6, 8));
    assert_eq!(mesh.closed(), Ok(()));
    assert!((mesh.volume() - 4.0 / 3.0).abs() < 1e-6);
}

#[test]
fn a_plain_mesh_is_read() {
    let scene = File::octahedron().load().unwrap();
    assert_eq!(scene.objects.len(), 1);
    assert_eq!(scene.objects[0].name, "stone");
    assert_octahedron(&scene);
    let Material::Diffuse(diffuse) = &scene.objects[0].material else { panic!("not diffuse") };
    assert_eq!(diffuse.reflectance, Spectrum::Rgb([1.0; 3]));
    assert!(scene.lights.is_empty() && scene.cameras.is_empty());
}

#[test]
fn transforms_accumulate_and_y_up_becomes_z_up() {
    let mut file = File::octahedron();
    let half = std::f32::consts::FRAC_1_SQRT_2;
    file.json["scenes"][0]["nodes"] = json!([1]);
    file.json["nodes"] = json!([
        {"mesh": 0, "name": "stone", "translation": [10.0, 0.0, 0.0], "scale": [1.0, 2.0, 3.0]},
        // A quarter turn about glTF's up axis: x goes to −z.
        {"children": [0], "rotation": [0.0, half, 0.0, half], "translation": [0.0, 5.0, 0.0]},
    ]);
    let scene = file.load().unwrap();
    let (low, high) = scene.objects[0].mesh.bounds();
    // glTF: centre (0, 5, −10), half sizes (3, 2, 1); here: centre (0, 10, 5), half sizes (3, 1, 2).
    assert!((low - Vec3::new(-3.0, 9.0, 3.0)).abs().max_element() < 1e-5, "{low}");
    assert!((high - Vec3::new(3.0, 11.0, 7.0)).abs().max_element() < 1e-5, "{high}");
}

#[test]
fn mirrored_nodes_still_face_outwards() {
    let mut file = File::octahedron();
    file.json["nodes"][0]["scale"] = json!([-1.0, 1.0, 1.0]);
    assert_octahedron(&file.load().unwrap());
    // An open mesh can't be turned by its volume: its winding follows the mirror.
    let normal_z = |file: &File| {
        let scene = file.load().unwrap();
        let [a, b, c] =
            scene.objects[0].mesh.triangles[0].map(|v| scene.objects[0].mesh.positions[v as usize]);
        (b - a).cross(c - a).z
    };
    let mut open = File::of_mesh(&POSITIONS, &TRIANGLES[..1]);
    assert!(normal_z(&open) > 0.0);
    open.json["nodes"][0]["scale"] = json!([-1.0, 1.0, 1.0]);
    assert!(normal_z(&open) > 0.0);
}

#[test]
fn clear_materials_become_dielectrics() {
    let scene = File::diamond().load().unwrap();
    let Material::Dielectric(diamond) = &scene.objects[0].material else { panic!("not clear") };
    assert_eq!(diamond.name, "diamond");
    let Dispersion::Cauchy { a, b_nm2 } = diamond.dispersion else { panic!("not Cauchy") };
    let n = |lambda_nm: f64| a + b_nm2 / (lambda_nm * lambda_nm);
    assert!((n(587.5618) - 2.417).abs() < 1e-6);
    let abbe = (n(587.5618) - 1.0) / (n(486.1327) - n(656.2725));
    assert!((abbe - 55.0).abs() < 1e-6, "{abbe}");

    // Beer–Lambert: white light is left with the attenuation colour after the attenuation distance.
    let Some(Spectrum::Tabulated { lambda_nm, value }) = diamond.absorption_per_mm.clone() else {
        panic!("no absorption")
    };
    let left = Spectrum::Tabulated {
        lambda_nm,
        value: value.iter().map(|alpha| (-4.0 * alpha).exp()).collect(),
    };
    let white = Observer::xyz(&Spectrum::Flat(1.0));
    let rgb = color::rec709_from_xyz()
        * color::adaptation(white, color::d65_white())
        * Observer::xyz(&left);
    assert!((rgb - DVec3::new(0.5, 0.25, 0.75)).abs().max_element() < 1e-3, "{rgb}");
}

#[test]
fn which_materials_are_clear() {
    let is_clear = |extensions: Value| {
        let file = File::octahedron().with_material(&json!({"extensions": extensions}));
        matches!(file.load().unwrap().objects[0].material, Material::Dielectric(_))
    };
    assert!(is_clear(json!({"KHR_materials_transmission": {"transmissionFactor": 0.9}})));
    assert!(is_clear(json!({"KHR_materials_volume": {}})));
    assert!(!is_clear(json!({"KHR_materials_ior": {"ior": 2.4}})));
    assert!(!is_clear(json!({"KHR_materials_transmission": {}, "KHR_materials_volume": {}})));
    // Defaults: index 1.5, no dispersion, no absorption.
    let file = File::octahedron().with_material(
        &json!({"extensions": {"KHR_materials_volume": {"attenuationDistance": 2.0}}}),
    );
    let Material::Dielectric(glass) = &file.load().unwrap().objects[0].material.clone() else {
        panic!("not clear")
    };
    assert_eq!(glass.dispersion, Dispersion::Cauchy { a: 1.5, b_nm2: 0.0 });
    assert_eq!(glass.absorption_per_mm, None);
}

#[test]
fn base_colours_are_reflectances() {
    let file = File::octahedron().with_material(
        &json!({"pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.25, 0.5, 1.0]}}),
    );
    let scene = file.load().unwrap();
    let Material::Diffuse(diffuse) = &scene.objects[0].material else { panic!("not diffuse") };
    assert_eq!(diffuse.reflectance, Spectrum::Rgb([0.8, 0.25, 0.5]));
}

#[test]
fn impossible_materials_are_named() {
    for (place, value, words) in [
        ("/KHR_materials_ior/ior", json!(0.5), "index of refraction 0.5"),
        ("/KHR_materials_ior/ior", json!(900.0), "index of refraction 900"),
        ("/KHR_materials_dispersion/dispersion", json!(-1.0), "dispersion of -1"),
        ("/KHR_materials_dispersion/dispersion", json!(1e9), "dispersion of 1000000000"),
        ("/KHR_materials_dispersion/dispersion", json!("much"), "dispersion is not a number"),
        ("/KHR_materials_volume/attenuationDistance", json!(0.0), "attenuation distance 0"),
        ("/KHR_materials_volume/attenuationColor", json!([2.0, 0.0, 0.0]), "colour [2.0"),
    ] {
        let mut file = File::diamond();
        *file.json["materials"][0]["extensions"].pointer_mut(place).unwrap() = value;
        let text = file.error();
        assert!(text.contains("'diamond'") && text.contains(words), "{text}");
    }
}

#[test]
fn a_refracting_mesh_must_be_closed() {
    let mut file = File::diamond();
    file.json["accessors"][1]["count"] = json!(21);
    let text = file.error();
    assert!(text.contains("node 'stone'") && text.contains("3 edges are open"), "{text}");
    assert!(text.contains("fill holes"), "{text}");
    // The same hole in an opaque mesh is nobody's business.
    file.json["materials"][0] = json!({});
    assert_eq!(file.load().unwrap().objects[0].mesh.triangles.len(), 7);
}

#[test]
fn primitives_of_one_material_are_joined_and_others_kept_apart() {
    let mut file = File::diamond();
    let half = |start: usize| json!({"bufferView": 1, "byteOffset": start * 12, "componentType": 5125, "count": 12, "type": "SCALAR"});
    file.json["accessors"][1] = half(0);
    file.json["accessors"].as_array_mut().unwrap().push(half(4));
    let primitive = |indices: u32, material: u32| json!({"attributes": {"POSITION": 0}, "indices": indices, "material": material});
    file.json["meshes"][0]["primitives"] = json!([primitive(1, 0), primitive(2, 0)]);
    assert_octahedron(&file.load().unwrap());

    file.json["materials"] = json!([{}, {}]);
    file.json["meshes"][0]["primitives"] = json!([primitive(1, 1), primitive(2, 0)]);
    let scene = file.load().unwrap();
    let sizes: Vec<_> = scene.objects.iter().map(|object| object.mesh.triangles.len()).collect();
    assert_eq!(sizes, [4, 4]);
    let names: Vec<_> = scene.objects.iter().map(|object| object.name.as_str()).collect();
    assert_eq!(names, ["stone (1)", "stone (2)"]);
}

#[test]
fn strips_fans_and_unindexed_triangles_are_read() {
    let triangles_of = |indices: &[u32], mode: u32| {
        let mut file = File::of_mesh(&POSITIONS, &[]);
        file.bin.truncate(72);
        file.bin.extend(indices.iter().flat_map(|index| index.to_le_bytes()));
        file.json["buffers"][0]["byteLength"] = json!(file.bin.len());
        file.json["bufferViews"][1]["byteLength"] = json!(indices.len() * 4);
        file.json["accessors"][1]["count"] = json!(indices.len());
        file.json["meshes"][0]["primitives"][0]["mode"] = json!(mode);
        file.load().unwrap().objects[0].mesh.triangles.clone()
    };
    assert_eq!(triangles_of(&[0, 1, 2, 3], 5), [[0, 1, 2], [1, 3, 2]]);
    assert_eq!(triangles_of(&[0, 1, 2, 3], 6), [[1, 2, 0], [2, 3, 0]]);
    assert_eq!(triangles_of(&[0, 1, 2, 3, 4], 4), [[0, 1, 2]]);

    let soup: Vec<[f32; 3]> = TRIANGLES.iter().flatten().map(|v| POSITIONS[*v as usize]).collect();
    let mut file = File::of_mesh(&soup, &[]);
    file.json["meshes"][0]["primitives"][0].as_object_mut().unwrap().remove("indices");
    assert_octahedron(&file.load().unwrap());
}

#[test]
fn integer_indices_strides_and_quantised_positions_are_read() {
    // u8 indices, and i8 positions normalised to −1..=1 with a stride of 4.
    let mut file = File::octahedron();
    file.bin = POSITIONS
        .iter()
        .flat_map(|p| [p[0], p[1], p[2], 0.0].map(|c| (c * 127.0) as i8 as u8))
        .chain(TRIANGLES.iter().flatten().map(|v| *v as u8))
        .collect();
    file.json["buffers"][0]["byteLength"] = json!(48);
    file.json["bufferViews"] = json!([
        {"buffer": 0, "byteLength": 24, "byteStride": 4},
        {"buffer": 0, "byteOffset": 24, "byteLength": 24},
    ]);
    file.json["accessors"][0]["componentType"] = json!(5120);
    file.json["accessors"][0]["normalized"] = json!(true);
    file.json["accessors"][1]["componentType"] = json!(5121);
    file.json["extensionsRequired"] = json!(["KHR_mesh_quantization", "KHR_materials_volume"]);
    assert_octahedron(&file.load().unwrap());
}

#[test]
fn sparse_accessors_replace_elements() {
    let mut file = File::octahedron();
    let start = file.bin.len();
    file.bin.extend([2, 0, 0, 0]);
    file.bin.extend([0.0_f32, 3.0, 0.0].iter().flat_map(|c| c.to_le_bytes()));
    file.json["buffers"][0]["byteLength"] = json!(file.bin.len());
    file.json["bufferViews"].as_array_mut().unwrap().extend([
        json!({"buffer": 0, "byteOffset": start, "byteLength": 4}),
        json!({"buffer": 0, "byteOffset": start + 4, "byteLength": 12}),
    ]);
    file.json["accessors"][0]["sparse"] = json!({
        "count": 1,
        "indices": {"bufferView": 2, "componentType": 5121},
        "values": {"bufferView": 3},
    });
    let (_, high) = file.load().unwrap().objects[0].mesh.bounds();
    assert_eq!(high, Vec3::new(1.0, 1.0, 3.0));
    // Without a buffer view the other elements are zeros.
    file.json["accessors"][0].as_object_mut().unwrap().remove("bufferView");
    assert!(file.error().contains("no triangle"));
    file.json["accessors"][0]["count"] = json!(1_u64 << 40);
    assert!(file.error().contains("decimate"));
    file.json["accessors"][0]["count"] = json!(1_000_000);
    assert!(file.error().contains("no data"));
    file.json["accessors"][0]["count"] = json!(2);
    assert!(file.error().contains("element 2 does not exist"));
}

#[test]
fn buffers_come_from_data_uris_and_neighbouring_files() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("stone.gltf");
    let write = |file: &File| std::fs::write(&path, file.json.to_string()).unwrap();
    let mut file = File::octahedron();
    file.json["buffers"][0]["uri"] =
        json!(format!("data:application/octet-stream;base64,{}", base64(&file.bin)));
    write(&file);
    assert_octahedron(&load(&path).unwrap());

    std::fs::write(folder.path().join("stone data.bin"), &file.bin).unwrap();
    file.json["buffers"][0]["uri"] = json!("stone%20data.bin");
    write(&file);
    assert_octahedron(&load(&path).unwrap());

    std::fs::write(folder.path().join("stone data.bin"), &file.bin[..50]).unwrap();
    assert!(load(&path).unwrap_err().to_string().contains("168 bytes are declared, but only 50"));

    for (uri, words) in [
        ("missing.bin", "'missing.bin': "),
        (".", "not a regular file"),
        ("/dev/zero", "not a relative path"),
        ("https://example.com/stone.bin", "not a relative path"),
        ("%zz", "not a valid URI"),
        ("%ff", "not a valid URI"),
        ("data:;base64,a%b", "not valid base64"),
        ("data:,plain", "not base64"),
    ] {
        file.json["buffers"][0]["uri"] = json!(uri);
        write(&file);
        let text = load(&path).unwrap_err().to_string();
        assert!(text.contains("buffer 0: ") && text.contains(words), "{uri}: {text}");
    }
    file.json["buffers"][0].as_object_mut().unwrap().remove("uri");
    write(&file);
    assert!(load(&path).unwrap_err().to_string().contains("neither URI nor binary chunk"));
}

fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    bytes
        .chunks(3)
        .map(|group| {
            let bits = group.iter().fold(0_u32, |bits, byte| bits << 8 | u32::from(*byte));
            let bits = bits << (24 - 8 * group.len());
            let letter = |i: usize| char::from(LETTERS[(bits >> (18 - 6 * i)) as usize & 63]);
            (0..4).map(|i| if i <= group.len() { letter(i) } else { '=' }).collect::<String>()
        })
        .collect()
}

#[test]
fn lights_and_cameras_are_placed() {
    let mut file = File::octahedron();
    file.json["extensions"] = json!({"KHR_lights_punctual": {"lights": [
        {"type": "directional", "intensity": 3.0, "name": "sun"},
        {"type": "point", "intensity": 50.0, "color": [0.5, 0.25, 0.0]},
        {"type": "spot", "intensity": 50.0, "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.2}},
    ]}});
    let light = |light: u32| json!({"KHR_lights_punctual": {"light": light}});
    file.json["scenes"][0]["nodes"] = json!([0, 1, 2, 3, 4, 5]);
    file.json["cameras"] = json!([
        {"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}},
        {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0, "zfar": 9}},
    ]);
    let nodes = file.json["nodes"].as_array_mut().unwrap();
    nodes.extend([
        json!({"extensions": light(0)}),
        json!({"extensions": light(1), "translation": [0.0, 5.0, 0.0]}),
        // A spot that looks past the stone.
        json!({"extensions": light(2), "translation": [0.0, 5.0, 0.0]}),
        json!({"camera": 0, "translation": [0.0, 0.0, 9.0]}),
        json!({"camera": 1}),
    ]);
    let scene = file.load().unwrap();
    assert_eq!(scene.lights.len(), 2);
    let irradiance = |i: usize| {
        let disc = &scene.lights[i];
        std::f32::consts::PI * disc.radiance * disc.angular_radius_radians.sin().powi(2)
    };
    // A directional light shines along its node's −z, glTF's forward and our +y.
    assert_eq!(scene.lights[0].name, "sun");
    assert_eq!(scene.lights[0].direction, Vec3::NEG_Y);
    assert_eq!(scene.lights[0].spectrum, Spectrum::Illuminant(Illuminant::D65));
    assert!((irradiance(0) - 3.0).abs() < 1e-4);
    // A point light five units above: I/d² of its strongest channel.
    assert_eq!(scene.lights[1].direction, Vec3::Z);
    assert_eq!(scene.lights[1].spectrum, Spectrum::Rgb([1.0, 0.5, 0.0]));
    assert!((irradiance(1) - 0.5 * 50.0 / 25.0).abs() < 1e-4);

    let [camera] = scene.cameras[..] else { panic!("{} cameras", scene.cameras.len()) };
    assert_eq!(camera.position, Vec3::new(0.0, -9.0, 0.0));
    assert!(camera.target.length() < 1e-5);
    assert_eq!(camera.up, Vec3::Z);
    assert_eq!(camera.fov_y_radians, 0.5);
}

#[test]
fn every_truncation_is_an_error() {
    let glb = File::diamond().glb();
    assert!(load_bytes(&glb).is_ok());
    for length in 0..glb.len() {
        assert!(load_bytes(&glb[..length]).is_err(), "{length} of {} bytes", glb.len());
    }
    assert!(load_bytes(&glb[..600]).unwrap_err().contains("truncated"));
}

#[test]
fn broken_documents_are_named() {
    let altered = |pointer: &str, value: Value| {
        let mut file = File::diamond();
        *file.json.pointer_mut(pointer).unwrap() = value;
        file.error()
    };
    for (pointer, value, words) in [
        ("/asset/version", json!("1.0"), "glTF 2.0"),
        ("/scene", json!(7), "scene 7 does not exist"),
        ("/scenes", json!([]), "scene 0 does not exist"),
        ("/scenes/0/nodes", json!([]), "no mesh"),
        ("/scenes/0/nodes/0", json!(5), "node 5"),
        ("/nodes/0/mesh", json!(5), "mesh 5"),
        ("/nodes/0", json!({"mesh": 0, "children": [0]}), "its own ancestor"),
        ("/nodes", json!([{"children": [1]}, {"children": [0]}]), "its own ancestor"),
        ("/nodes/0", json!({"mesh": 0, "rotation": [0, 0, 0, 0]}), "rotation without length"),
        ("/nodes/0", json!({"mesh": 0, "scale": [0, 0, 0]}), "no triangle"),
        ("/meshes/0/primitives/0/material", json!(5), "material 5"),
        ("/meshes/0/primitives/0/attributes", json!({}), "no positions"),
        ("/meshes/0/primitives/0/attributes/POSITION", json!(9), "accessor 9"),
        ("/meshes/0/primitives/0/attributes/POSITION", json!(1), "VEC3"),
        ("/meshes/0/primitives/0/indices", json!(0), "SCALAR"),
        ("/meshes/0/primitives/0", json!({"attributes": {"POSITION": 0}, "mode": 1}), "Lines"),
        ("/meshes/0/primitives/0", json!({"attributes": {"POSITION": 0}, "mode": 77}), "mode"),
        ("/accessors/0/count", json!(7), "too short for 7 elements"),
        ("/accessors/0/count", json!(3), "index 4 is beyond its 3 vertices"),
        ("/accessors/1/count", json!(u64::MAX), "decimate"),
        ("/accessors/1/bufferView", json!(9), "buffer view 9"),
        ("/bufferViews/1/buffer", json!(9), "does not exist"),
        ("/bufferViews/1/byteLength", json!(u64::MAX), "beyond its buffer"),
        ("/bufferViews/1/byteOffset", json!(u64::MAX), "beyond its buffer"),
        ("/bufferViews/0", json!({"buffer": 0, "byteLength": 72, "byteStride": 4}), "stride"),
        ("/buffers/0/byteLength", json!(u64::MAX), "truncated"),
        ("/buffers", json!([]), "does not exist"),
    ] {
        let text = altered(pointer, value.clone());
        assert!(text.contains(words), "{pointer} = {value}: {text}");
    }
    let mut file = File::octahedron();
    file.json["extensionsRequired"] = json!(["KHR_draco_mesh_compression"]);
    assert!(file.error().contains("KHR_draco_mesh_compression"));
    for nonsense in ["", "{}", "glTF", "[1, 2]", "{\"asset\": "] {
        assert!(load_bytes(nonsense.as_bytes()).is_err(), "{nonsense}");
    }
}

#[test]
fn positions_that_are_not_finite_are_named() {
    for bad in [f32::NAN, f32::INFINITY] {
        let mut positions = POSITIONS;
        positions[3][1] = bad;
        let text = File::of_mesh(&positions, &TRIANGLES).error();
        assert!(text.contains("node 'stone'") && text.contains("vertex 3"), "{text}");
    }
}

#[test]
fn a_missing_file_a_folder_and_a_device_are_errors() {
    for path in ["no such file.glb", ".", "/dev/zero"] {
        assert!(load(Path::new(path)).is_err(), "{path}");
    }
}

#[test]
fn a_small_file_cannot_ask_for_a_large_scene() {
    // Ten thousand nodes of one mesh with ten thousand primitives each.
    let mut file = File::octahedron();
    let primitive = file.json["meshes"][0]["primitives"][0].clone();
    file.json["meshes"][0]["primitives"] = json!(vec![primitive; 10_000]);
    file.json["nodes"] = json!(vec![json!({"mesh": 0}); 10_000]);
    file.json["scenes"][0]["nodes"] = json!((0..10_000).collect::<Vec<_>>());
    assert!(file.error().contains("decimate"));
}

/// Replaces every number of the document in turn; nothing may panic, hang or take all memory.
#[test]
fn hostile_numbers_do_no_harm() {
    fn numbers(value: &Value, path: &str, found: &mut Vec<String>) {
        match value {
            Value::Number(_) => found.push(path.to_owned()),
            Value::Array(items) => {
                for (i, item) in items.iter().enumerate() {
                    numbers(item, &format!("{path}/{i}"), found);
                }
            }
            Value::Object(items) => {
                for (key, item) in items {
                    numbers(item, &format!("{path}/{key}"), found);
                }
            }
            _ => {}
        }
    }
    let file = File::diamond();
    let mut found = Vec::new();
    numbers(&file.json, "", &mut found);
    assert!(found.len() > 20);
    for pointer in found {
        for hostile in [
            json!(-1),
            json!(0),
            json!(1),
            json!(u32::MAX),
            json!(u64::MAX),
            json!(1e300),
            json!(0.5),
            json!(null),
            json!("x"),
        ] {
            let mut file = file.clone();
            *file.json.pointer_mut(&pointer).unwrap() = hostile;
            // Either outcome is fine; arriving here is the test.
            let _ = file.load();
        }
    }
}

#[test]
fn flipped_bytes_do_no_harm() {
    let glb = File::diamond().glb();
    let mut state = 3_u64;
    let mut random = |below: usize| {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    for _ in 0..4000 {
        let mut bytes = glb.clone();
        for _ in 0..=random(4) {
            let at = random(bytes.len());
            bytes[at] = random(256) as u8;
        }
        // Either outcome is fine; arriving here is the test.
        let _ = load_bytes(&bytes);
    }
}

#[test]
fn a_million_triangles_load() {
    let (positions, triangles) = sphere(501, 1000);
    // glTF's up is y.
    let positions: Vec<_> = positions.iter().map(|p| [p.x, p.z, -p.y]).collect();
    let mut file = File::of_mesh(&positions, &triangles);
    file = file.with_material(&File::diamond().json["materials"][0]);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ball.glb");
    std::fs::write(&path, file.glb()).unwrap();
    let started = std::time::Instant::now();
    let scene = load(&path).unwrap();
    println!("a million triangles load in {:.3} s", started.elapsed().as_secs_f64());
    assert_eq!(scene.objects[0].mesh.triangles.len(), 1_000_000);
}

/// A spinel crystal: the octahedron with its edges and corners beveled, as they grow.
fn spinel() -> File {
    let mut faces = Vec::new();
    for x in -1..=1 {
        for y in -1..=1 {
            for z in -1..=1 {
                let normal = DVec3::new(f64::from(x), f64::from(y), f64::from(z));
                // Distances of {100}, {110} and {111} in millimetres.
                let distance = match x * x + y * y + z * z {
                    1 => 3.0,
                    2 => 2.28,
                    3 => 1.92,
                    _ => continue,
                };
                let distance = distance * normal.length();
                faces.push(HalfSpace { normal, distance, name: format!("{{{x}{y}{z}}}") });
            }
        }
    }
    let solid = Solid::from_half_spaces(&faces).unwrap();
    assert_eq!(solid.facets.len(), 26);
    let mesh = Mesh::from_solid(&solid).unwrap();
    let positions: Vec<[f32; 3]> = mesh.positions.iter().map(|p| [p.x, p.z, -p.y]).collect();
    let mut file = File::of_mesh(&positions, &mesh.triangles).with_material(&json!({
        "name": "spinel",
        "pbrMetallicRoughness": {"metallicFactor": 0.0, "roughnessFactor": 0.0},
        "extensions": {
            "KHR_materials_transmission": {"transmissionFactor": 1.0},
            "KHR_materials_ior": {"ior": 1.718},
            "KHR_materials_dispersion": {"dispersion": 20.0 / 60.0},
            "KHR_materials_volume": {
                "thicknessFactor": 6.0,
                "attenuationDistance": 6.0,
                "attenuationColor": [0.85, 0.08, 0.12],
            },
        },
    }));
    let corner = |pick: fn(f32, f32) -> f32| {
        positions.iter().copied().reduce(|a, b| [0, 1, 2].map(|i| pick(a[i], b[i]))).unwrap()
    };
    file.json["accessors"][0]["min"] = json!(corner(f32::min));
    file.json["accessors"][0]["max"] = json!(corner(f32::max));
    file.json["bufferViews"][0]["target"] = json!(34962);
    file.json["bufferViews"][1]["target"] = json!(34963);
    file.json["asset"]["generator"] = json!("Brilliance, tests/gltf.rs");
    file.json["nodes"][0]["name"] = json!("spinel octahedron");
    file.json["extensionsUsed"] = json!([
        "KHR_materials_transmission",
        "KHR_materials_ior",
        "KHR_materials_dispersion",
        "KHR_materials_volume",
    ]);
    file
}

#[test]
fn the_shipped_spinel_is_what_this_test_computes() {
    let path =
        PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../assets/gems/spinel_octahedron.glb");
    if std::env::var_os("BRILLIANCE_WRITE_ASSETS").is_some() {
        std::fs::write(&path, spinel().glb()).unwrap();
    }
    let (shipped, computed) = (load(&path).unwrap(), spinel().load().unwrap());
    let (a, b) = (&shipped.objects[0], &computed.objects[0]);
    assert_eq!((&a.name, &a.material), (&b.name, &b.material));
    assert_eq!(a.mesh.triangles, b.mesh.triangles);
    for (p, q) in a.mesh.positions.iter().zip(&b.mesh.positions) {
        assert!(p.distance(*q) < 1e-5, "{p} {q}");
    }
    assert_eq!(a.mesh.facet.iter().max(), Some(&25));
    assert!(matches!(a.material, Material::Dielectric(_)));
}
