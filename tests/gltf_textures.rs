//! Base colour textures of glTF files: where images come from, how they lie, and what is refused.

#![expect(clippy::unwrap_used, reason = "a test ends where it fails, in its helpers too")]

use std::fmt::Write as _;
use std::io::Cursor;
use std::path::Path;
use std::sync::Arc;

use brilliance_renderer::import::gltf::{GltfScene, load, load_from_memory, load_within};
use brilliance_renderer::material::{Image, Layout, Material, Outside, Print, TexelBudget};
use brilliance_renderer::packed::PackedScene;
use brilliance_renderer::scene_file::Document;
use brilliance_renderer::spectrum::{Bins, Spectrum};
use glam::Vec2;
use image::{ImageFormat, Rgb, RgbImage, Rgba, RgbaImage};
use serde_json::{Value, json};

const POSITIONS: [[f32; 3]; 4] =
    [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
const COORDINATES: [[f32; 2]; 4] = [[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]];
const TRIANGLES: [u16; 6] = [0, 1, 2, 0, 2, 3];

/// Red above blue.
fn picture(format: ImageFormat) -> Vec<u8> {
    let colour = |y| if y < 4 { Rgb([250, 0, 0]) } else { Rgb([0, 0, 250]) };
    let mut bytes = Cursor::new(Vec::new());
    RgbImage::from_fn(8, 8, |_, y| colour(y)).write_to(&mut bytes, format).unwrap();
    bytes.into_inner()
}

fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for group in bytes.chunks(3) {
        let bits = group.iter().fold(0_u32, |bits, byte| bits << 8 | u32::from(*byte));
        let bits = bits << (8 * (3 - group.len()));
        for i in 0..=group.len() {
            text.push(char::from(LETTERS[(bits >> (18 - 6 * i) & 63) as usize]));
        }
        let _ = write!(text, "{}", "=".repeat(3 - group.len()));
    }
    text
}

fn data_uri(bytes: &[u8]) -> String {
    format!("data:application/octet-stream;base64,{}", base64(bytes))
}

/// A square of two triangles with the texture in a data URI.
fn square() -> Value {
    let mut bytes: Vec<u8> = POSITIONS.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
    bytes.extend(COORDINATES.iter().flatten().flat_map(|x| x.to_le_bytes()));
    bytes.extend(TRIANGLES.iter().flat_map(|index| index.to_le_bytes()));
    let png = picture(ImageFormat::Png);
    let image_at = bytes.len();
    bytes.extend(&png);
    json!({
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "square", "mesh": 0}],
        "meshes": [{"primitives": [{
            "attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0,
        }]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 48},
            {"buffer": 0, "byteOffset": 48, "byteLength": 32},
            {"buffer": 0, "byteOffset": 80, "byteLength": 12},
            {"buffer": 0, "byteOffset": image_at, "byteLength": png.len()},
        ],
        "buffers": [{"byteLength": bytes.len(), "uri": data_uri(&bytes)}],
        "materials": [{
            "name": "paint",
            "pbrMetallicRoughness": {
                "baseColorTexture": {"index": 0}, "baseColorFactor": [0.5, 1.0, 0.25, 1.0],
            },
        }],
        "textures": [{"source": 0, "sampler": 0}],
        "samplers": [{}],
        "images": [{"name": "stripes", "uri": data_uri(&png)}],
    })
}

fn read(file: &Value) -> Result<GltfScene, String> {
    let path = Path::new("square.gltf");
    load_from_memory(path, file.to_string().as_bytes()).map_err(|fault| fault.to_string())
}

fn print_of(scene: &GltfScene, index: usize) -> &Print {
    let Material::Diffuse(diffuse) = &scene.objects[index].material else { panic!("not matte") };
    assert_eq!(diffuse.reflectance, Spectrum::Flat(1.0), "the print is on white");
    diffuse.print.as_ref().expect("a print")
}

fn assert_stripes(print: &Print) {
    assert_eq!((print.image.size, print.layout), ([8, 8], Layout::Coordinates));
    let [above, below] = [0, 63].map(|i: usize| print.image.texels[i].to_le_bytes());
    assert!(above[0] > 240 && above[2] < 10 && below[0] < 10 && below[2] > 240, "{above:?}");
}

#[test]
fn images_come_from_data_uris_buffers_and_neighbouring_files() {
    let scene = read(&square()).unwrap();
    assert_stripes(print_of(&scene, 0));
    assert_eq!(print_of(&scene, 0).image.name(), "stripes");
    assert_eq!(print_of(&scene, 0).tint, [0.5, 1.0, 0.25]);
    assert_eq!(print_of(&scene, 0).outside, [Outside::Repeat; 2]);

    let mut file = square();
    file["images"][0] = json!({"bufferView": 3, "mimeType": "image/png"});
    let scene = read(&file).unwrap();
    assert_stripes(print_of(&scene, 0));
    assert_eq!(print_of(&scene, 0).image.name(), "image 0");

    let folder = tempfile::tempdir().unwrap();
    file["images"][0] = json!({"uri": "some%20stripes.jpg"});
    let path = folder.path().join("square.gltf");
    std::fs::write(&path, file.to_string()).unwrap();
    let fault = load(&path).unwrap_err().to_string();
    assert!(
        fault.contains("image 'some%20stripes.jpg'") && fault.contains("square.gltf"),
        "{fault}"
    );
    std::fs::write(folder.path().join("some stripes.jpg"), picture(ImageFormat::Jpeg)).unwrap();
    assert_stripes(print_of(&load(&path).unwrap(), 0));
}

#[test]
fn each_corner_has_its_coordinates() {
    let scene = read(&square()).unwrap();
    let mesh = &scene.objects[0].mesh;
    assert_eq!(mesh.coordinates.len(), 2);
    for (corners, coordinates) in mesh.triangles.iter().zip(&mesh.coordinates) {
        for (&v, at) in corners.iter().zip(coordinates) {
            // y up becomes z up.
            let position = mesh.positions[v as usize];
            assert_eq!(*at, Vec2::new(0.5 + 0.5 * position.x, 0.5 - 0.5 * position.z));
        }
    }
}

/// A mirror turns the corners of triangles round, and their coordinates with them.
#[test]
fn coordinates_follow_a_mirrored_node() {
    let mut file = square();
    file["nodes"][0]["scale"] = json!([-1.0, 1.0, 1.0]);
    let scene = read(&file).unwrap();
    let mesh = &scene.objects[0].mesh;
    for (corners, coordinates) in mesh.triangles.iter().zip(&mesh.coordinates) {
        for (&v, at) in corners.iter().zip(coordinates) {
            let position = mesh.positions[v as usize];
            assert_eq!(*at, Vec2::new(0.5 - 0.5 * position.x, 0.5 - 0.5 * position.z));
        }
    }
}

#[test]
fn wrapping_modes_and_transforms_are_followed() {
    let mut file = square();
    file["samplers"][0] = json!({"wrapS": 33071, "wrapT": 33648});
    // Turned by a right angle, counter-clockwise as one looks at it, scaled first and moved last.
    file["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = json!({
        "KHR_texture_transform": {
            "offset": [0.5, 0.25], "rotation": std::f32::consts::FRAC_PI_2, "scale": [2.0, 3.0],
        },
    });
    let scene = read(&file).unwrap();
    assert_eq!(print_of(&scene, 0).outside, [Outside::Edge, Outside::Mirror]);
    let mesh = &scene.objects[0].mesh;
    for (corners, coordinates) in mesh.triangles.iter().zip(&mesh.coordinates) {
        for (&v, at) in corners.iter().zip(coordinates) {
            let position = mesh.positions[v as usize];
            let (u, v) = (0.5 + 0.5 * position.x, 0.5 - 0.5 * position.z);
            // KHR_texture_transform: u′ = cos·s_u·u + sin·s_v·v + o_u, v′ = −sin·s_u·u + cos·s_v·v + o_v.
            let expected = Vec2::new(3.0 * v + 0.5, -2.0 * u + 0.25);
            assert!(at.distance(expected) < 1e-5, "{at} is not {expected}");
        }
    }
}

#[test]
fn the_set_of_coordinates_is_the_one_that_is_named() {
    let mut file = square();
    file["meshes"][0]["primitives"][0]["attributes"] = json!({"POSITION": 0, "TEXCOORD_1": 1});
    let fault = read(&file).unwrap_err();
    assert!(fault.contains("node 'square'") && fault.contains("no TEXCOORD_0"), "{fault}");
    file["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = json!(1);
    assert_stripes(print_of(&read(&file).unwrap(), 0));
}

#[test]
fn quantised_coordinates_are_read() {
    let mut file = square();
    let mut bytes: Vec<u8> = POSITIONS.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
    let whole = COORDINATES.iter().flatten().map(|x| (x * 65535.0) as u16);
    bytes.extend(whole.flat_map(u16::to_le_bytes));
    bytes.extend(TRIANGLES.iter().flat_map(|index| index.to_le_bytes()));
    file["buffers"][0] = json!({"byteLength": bytes.len(), "uri": data_uri(&bytes)});
    file["bufferViews"] = json!([
        {"buffer": 0, "byteOffset": 0, "byteLength": 48},
        {"buffer": 0, "byteOffset": 48, "byteLength": 16},
        {"buffer": 0, "byteOffset": 64, "byteLength": 12},
    ]);
    file["accessors"][1]["componentType"] = json!(5123);
    file["accessors"][1]["normalized"] = json!(true);
    let scene = read(&file).unwrap();
    let corners: Vec<Vec2> = scene.objects[0].mesh.coordinates.concat();
    assert_eq!(corners, [0, 1, 2, 0, 2, 3].map(|v: usize| Vec2::from_array(COORDINATES[v])));
}

#[test]
fn one_image_is_decoded_once() {
    let mut file = square();
    file["nodes"] = json!([{"name": "square", "mesh": 0}, {"mesh": 0, "translation": [3, 0, 0]}]);
    file["scenes"][0]["nodes"] = json!([0, 1]);
    let scene = read(&file).unwrap();
    assert!(Arc::ptr_eq(&print_of(&scene, 0).image, &print_of(&scene, 1).image));
}

/// What a stone is made of does not come from its texture, which need not even be there.
#[test]
fn textures_of_clear_materials_are_not_looked_at() {
    let mut file = square();
    file["images"][0] = json!({"uri": "nowhere.png"});
    file["materials"][0]["extensions"] =
        json!({"KHR_materials_transmission": {"transmissionFactor": 1.0}});
    let fault = read(&file).unwrap_err();
    assert!(fault.contains("must be closed"), "{fault}");
}

#[test]
fn broken_textures_are_named() {
    let with = |path: &str, value: Value| {
        let mut file = square();
        *file.pointer_mut(path).unwrap() = value;
        read(&file).unwrap_err()
    };
    let png = picture(ImageFormat::Png);
    let texture = "/materials/0/pbrMetallicRoughness/baseColorTexture";
    for (path, value, words) in [
        ("/images/0/uri", json!("nowhere.png"), "image 'stripes': 'nowhere.png'"),
        ("/images/0/uri", json!("/etc/passwd"), "not a relative path"),
        ("/images/0/uri", json!("data:image/png;base64,AAAA"), "neither PNG nor JPEG"),
        ("/images/0/uri", json!(data_uri(&png[..40])), "image 'stripes': the image is broken"),
        ("/images/0", json!({}), "neither URI nor buffer view"),
        ("/images/0", json!({"bufferView": 9}), "buffer view 9 does not exist"),
        ("/textures/0/source", json!(5), "PNG or JPEG"),
        ("/textures/0/sampler", json!(5), "texture 0 has a sampler that does not exist"),
        (texture, json!({"index": 7}), "texture 7 is named but does not exist"),
        ("/accessors/1/type", json!("VEC3"), "texture coordinates must be of type VEC2"),
        ("/accessors/1/count", json!(3), "4 vertices, but 3 texture coordinates"),
    ] {
        let fault = with(path, value);
        assert!(fault.contains("square.gltf") && fault.contains("node 'square'"), "{fault}");
        assert!(fault.contains(words), "{path}: no {words:?} in: {fault}");
    }
    // Not a number.
    let mut file = square();
    let mut bytes: Vec<u8> = POSITIONS.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
    bytes.extend(f32::NAN.to_le_bytes().repeat(8));
    bytes.extend(TRIANGLES.iter().flat_map(|index| index.to_le_bytes()));
    file["buffers"][0] = json!({"byteLength": bytes.len(), "uri": data_uri(&bytes)});
    file["bufferViews"].as_array_mut().unwrap().pop();
    let fault = read(&file).unwrap_err();
    assert!(fault.contains("texture coordinates of triangle 0 are not finite"), "{fault}");
}

/// A scene made of the file leaves the print to it, and finds it there again.
#[test]
fn the_print_is_found_again_by_the_scene_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("square.gltf");
    std::fs::write(&path, square().to_string()).unwrap();
    let document = Document::open(&path).unwrap();
    PackedScene::new(&document.scene, Bins::new(8)).unwrap();
    let saved = folder.path().join("scene.toml");
    document.save(&saved).unwrap();
    let text = std::fs::read_to_string(&saved).unwrap();
    assert!(text.contains("file = \"square.gltf\"") && !text.contains("material"), "{text}");
    let again = Document::open(&saved).unwrap();
    let Material::Diffuse(diffuse) = &again.scene.objects[0].material else { panic!("not matte") };
    assert_stripes(diffuse.print.as_ref().expect("a print"));
    // The same mesh can be given another material.
    let other =
        Document::open_with(&saved, &["objects.0.material.diffuse=0.5".to_owned()]).unwrap();
    let Material::Diffuse(diffuse) = &other.scene.objects[0].material else { panic!("not matte") };
    assert_eq!((&diffuse.reflectance, &diffuse.print), (&Spectrum::Flat(0.5), &None));
}

/// What is opaque, as it is where nothing is said, has no use for alpha (glTF 2.0, §3.9.4).
#[test]
fn alpha_is_ignored_where_the_material_is_opaque() {
    let mut png = Cursor::new(Vec::new());
    RgbaImage::from_pixel(1, 1, Rgba([10, 20, 30, 0]))
        .write_to(&mut png, ImageFormat::Png)
        .unwrap();
    let mut file = square();
    file["images"][0] = json!({"uri": data_uri(png.get_ref())});
    let (colour, white) = (0x1e_14_0a, 0xff_ff_ff);
    for (number, (mode, texel)) in
        [(None, colour), (Some("OPAQUE"), colour), (Some("MASK"), white), (Some("BLEND"), white)]
            .into_iter()
            .enumerate()
    {
        // Every material of the file has the same image.
        let mut material = file["materials"][0].clone();
        let mut primitive = file["meshes"][0]["primitives"][0].clone();
        primitive["material"] = number.into();
        if let Some(mode) = mode {
            material["alphaMode"] = mode.into();
            file["materials"].as_array_mut().unwrap().push(material);
            file["meshes"][0]["primitives"].as_array_mut().unwrap().push(primitive);
        }
        let scene = read(&file).unwrap();
        assert_eq!(print_of(&scene, number).image.texels, [texel], "{mode:?}");
        assert_eq!(print_of(&scene, 0).image.texels, [colour]);
    }
}

#[test]
fn the_images_of_several_files_share_a_budget() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("square.gltf");
    std::fs::write(&path, square().to_string()).unwrap();
    let mut budget = TexelBudget::new(100);
    assert_stripes(print_of(&load_within(&path, &mut budget).unwrap(), 0));
    let fault = load_within(&path, &mut budget).unwrap_err().to_string();
    assert!(fault.contains("image 'stripes'") && fault.contains("128 texels; 100"), "{fault}");
}

#[test]
fn an_image_file_that_is_too_large_is_not_read() {
    let folder = tempfile::tempdir().unwrap();
    let mut file = square();
    file["images"][0] = json!({"uri": "large.png"});
    let path = folder.path().join("square.gltf");
    std::fs::write(&path, file.to_string()).unwrap();
    let large = std::fs::File::create(folder.path().join("large.png")).unwrap();
    large.set_len(Image::MAX_FILE_BYTES + 1).unwrap();
    let fault = load(&path).unwrap_err().to_string();
    assert!(fault.contains("large.png") && fault.contains("too many"), "{fault}");
}
