//! Images on matte bodies. In an even light of radiance 1 a surface shows its reflectance.

use std::sync::Arc;

use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::light::Lights;
use brilliance_renderer::material::{
    Diffuse, Image, ImageOrigin, Layout, Material, Outside, Planar, Print,
};
use brilliance_renderer::mesh::Mesh;
use brilliance_renderer::packed::{AXIS_LEN, INDEX_TABLE_LEN, NONE, PackedScene};
use brilliance_renderer::scene::{MeshSource, Object, Shape};
use brilliance_renderer::settings::TraceSettings;
use brilliance_renderer::spectrum::{Bins, Spectrum};
use glam::{DVec3, Quat, Vec2, Vec3};

use crate::scenes::{block, flat_sky, object, scene, trace_ray};

/// Red and green above, blue and grey below, in sRGB codes.
const CODES: [[u8; 3]; 4] = [[230, 20, 30], [10, 180, 60], [40, 50, 220], [120, 120, 120]];
const RED: usize = 0;
const GREEN: usize = 1;
const BLUE: usize = 2;
const GREY: usize = 3;

fn image() -> Arc<Image> {
    let texel = |[r, g, b]: [u8; 3]| u32::from_le_bytes([r, g, b, 0]);
    let origin = ImageOrigin::Mesh("test".to_owned());
    Arc::new(Image { origin, size: [2, 2], texels: CODES.map(texel).into() })
}

/// The linear sRGB of a texel (IEC 61966-2-1).
fn linear(texel: usize) -> [f32; 3] {
    CODES[texel].map(|code| {
        let code = f64::from(code) / 255.0;
        let is_dark = code <= 0.04045;
        (if is_dark { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }) as f32
    })
}

/// The colour between texels, each with its part.
fn mixed(parts: &[(usize, f32)]) -> Spectrum {
    let channel = |i: usize| parts.iter().map(|&(texel, part)| part * linear(texel)[i]).sum();
    Spectrum::Rgb([channel(0), channel(1), channel(2)])
}

fn colour(texel: usize) -> Spectrum {
    mixed(&[(texel, 1.0)])
}

/// 4 mm × 2 mm, upwards.
fn print() -> Print {
    let planar = Planar { facing: Vec3::Z, up: Vec3::Y, size_mm: [4.0, 2.0] };
    Print {
        image: image(),
        layout: Layout::Planar(planar),
        outside: [Outside::Bare; 2],
        tint: [1.0; 3],
    }
}

fn continued(outside: Outside) -> Print {
    Print { outside: [outside; 2], ..print() }
}

fn matte(reflectance: Spectrum, print: Print) -> Material {
    Material::Diffuse(Diffuse { reflectance, print: Some(print) })
}

fn slab(print: Print) -> Object {
    object(block(DVec3::new(20.0, 20.0, 1.0)), matte(Spectrum::Flat(1.0), print))
}

/// A rectangle of two triangles at z = 1 with the coordinates that `print` has on the slab.
fn sheet() -> Mesh {
    let corner = |x: f32, y: f32| Vec3::new(2.0 * x, y, 1.0);
    let positions =
        vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
    let triangles = vec![[0, 1, 2], [1, 1, 2], [0, 2, 3]];
    let at = |v: u32| {
        let position: Vec3 = positions[v as usize];
        Vec2::new(0.25 * position.x + 0.5, 0.5 - 0.5 * position.y)
    };
    let coordinates = triangles.iter().map(|corners: &[u32; 3]| corners.map(at)).collect();
    Mesh::with_coordinates(positions, triangles, coordinates).expect("a mesh")
}

fn unwrapped(print: Print) -> Object {
    let source = MeshSource { path: "sheet.glb".into(), index: 0, mesh: Arc::new(sheet()) };
    let print = Print { layout: Layout::Coordinates, ..print };
    object(Shape::Mesh(source), matte(Spectrum::Flat(1.0), print))
}

/// What is seen along a ray.
fn seen(object: &Object, from: Vec3, direction: Vec3) -> Vec<f32> {
    let lights = Lights { environment: Some(flat_sky(1.0)), ..Lights::default() };
    let scene = scene(vec![object.clone()], lights);
    trace_ray(&scene, &TraceSettings::default(), &Ray::white(from, direction)).0
}

fn assert_same(found: &[f32], expected: &Spectrum, what: &str) {
    let expected = expected.bin_means(Bins::new(found.len() as u32));
    for (bin, (found, expected)) in found.iter().zip(expected).enumerate() {
        assert!((found - expected).abs() < 1e-5, "{what}, bin {bin}: {found}, not {expected}");
    }
}

/// Looks at the top from above.
fn assert_shows(object: &Object, [x, y]: [f32; 2], expected: &Spectrum, what: &str) {
    assert_same(&seen(object, Vec3::new(x, y, 10.0), Vec3::NEG_Z), expected, what);
}

#[test]
fn each_texel_shows_its_spectrum_at_its_place() {
    for object in [slab(print()), unwrapped(print())] {
        for (at, texel) in [([-1.0, 0.5], RED), ([1.0, 0.5], GREEN), ([-1.0, -0.5], BLUE)] {
            assert_shows(&object, at, &colour(texel), "the middle of a texel");
        }
        assert_shows(&object, [1.0, -0.5], &colour(GREY), "the middle of a texel");
    }
}

#[test]
fn between_texels_is_the_mixture_of_their_light() {
    for object in [slab(print()), unwrapped(print())] {
        assert_shows(&object, [0.0, 0.5], &mixed(&[(RED, 0.5), (GREEN, 0.5)]), "between two");
        assert_shows(&object, [-1.0, 0.25], &mixed(&[(RED, 0.75), (BLUE, 0.25)]), "a quarter");
        let all = [RED, GREEN, BLUE, GREY].map(|texel| (texel, 0.25));
        assert_shows(&object, [0.0, 0.0], &mixed(&all), "the middle");
        assert_shows(&object, [-1.9, 0.9], &colour(RED), "near a corner of an image that ends");
    }
}

#[test]
fn paper_takes_light_away_and_so_does_the_tint() {
    let falling = Spectrum::Tabulated { lambda_nm: vec![380.0, 730.0], value: vec![0.9, 0.2] };
    let mut object = slab(print());
    object.material = matte(falling.clone(), print());
    let found = seen(&object, Vec3::new(-1.0, 0.5, 10.0), Vec3::NEG_Z);
    let bins = Bins::new(found.len() as u32);
    let factors = colour(RED).bin_means(bins).into_iter().zip(falling.bin_means(bins));
    for (found, (ink, paper)) in found.into_iter().zip(factors) {
        assert!((found - ink * paper).abs() < 1e-6, "{found} {ink} {paper}");
    }
    let tint = [0.5, 0.25, 1.0];
    object.material = matte(Spectrum::Flat(1.0), Print { tint, ..print() });
    let tinted = Spectrum::Rgb(std::array::from_fn(|i| tint[i] * linear(RED)[i]));
    assert_shows(&object, [-1.0, 0.5], &tinted, "a tinted texel");
}

#[test]
fn beyond_the_image_is_what_was_asked_for() {
    let bare = Spectrum::Flat(1.0);
    for (outside, right, above) in [
        (Outside::Bare, bare.clone(), bare.clone()),
        (Outside::Edge, colour(GREEN), colour(RED)),
        (Outside::Repeat, colour(RED), colour(BLUE)),
        (Outside::Mirror, colour(GREEN), colour(RED)),
    ] {
        let slab = slab(continued(outside));
        assert_shows(&slab, [3.0, 0.5], &right, "to the right");
        assert_shows(&slab, [-1.0, 1.5], &above, "above");
        let second = if outside == Outside::Mirror { colour(RED) } else { right };
        let second = if outside == Outside::Repeat { colour(GREEN) } else { second };
        assert_shows(&slab, [5.0, 0.5], &second, "further to the right");
    }
    // The last texel goes over into the first of the next image.
    let half = mixed(&[(RED, 0.5), (GREEN, 0.5)]);
    assert_shows(&slab(continued(Outside::Repeat)), [2.0, 0.5], &half, "on the seam");
    assert_shows(&slab(continued(Outside::Mirror)), [2.0, 0.5], &colour(GREEN), "on the seam");
}

#[test]
fn only_what_faces_the_image_is_printed_on() {
    let object = slab(continued(Outside::Repeat));
    let below = seen(&object, Vec3::new(-1.0, 0.5, -10.0), Vec3::Z);
    assert_same(&below, &Spectrum::Flat(1.0), "the back");
    for i in 0..40 {
        let from = Vec3::new(30.0, 0.3, -0.9 + 0.045 * i as f32);
        assert_same(&seen(&object, from, Vec3::NEG_X), &Spectrum::Flat(1.0), "a side");
    }
}

/// The image is fixed to the body.
#[test]
fn a_print_goes_with_its_body() {
    for mut object in [slab(print()), unwrapped(print())] {
        object.transform.scale = 3.0;
        object.transform.rotation = Quat::from_axis_angle(Vec3::new(0.6, 0.0, 0.8), 1.1);
        object.transform.translation = Vec3::new(5.0, -7.0, 11.0);
        let transform = object.transform;
        for (x, y, texel) in [(-1.0, 0.5, RED), (1.0, 0.5, GREEN), (-1.0, -0.5, BLUE)] {
            let from = transform.point(Vec3::new(x, y, 10.0));
            let found = seen(&object, from, transform.direction(Vec3::NEG_Z));
            assert_same(&found, &colour(texel), "the middle of a texel");
        }
    }
}

/// Images and coordinates are packed once, and a scene without them has none.
#[test]
fn prints_are_packed_once() {
    let pack = |objects: &[Object]| {
        let scene = scene(objects.to_vec(), Lights::default());
        PackedScene::new(&scene, Bins::new(4)).expect("the scene packs")
    };
    let bare = Material::Diffuse(Diffuse { reflectance: Spectrum::Flat(0.5), print: None });
    let plain = pack(&[object(block(DVec3::ONE), bare)]);
    assert_eq!((plain.words.len(), plain.materials[0].print.texels), (1, NONE));
    let mut other = slab(continued(Outside::Repeat));
    let printed = slab(print());
    let Material::Diffuse(diffuse) = &printed.material else { panic!("not matte") };
    let shared = diffuse.print.as_ref().expect("a print").image.clone();
    other.material =
        matte(Spectrum::Flat(1.0), Print { image: shared, ..continued(Outside::Repeat) });
    let twins = pack(&[printed.clone(), printed.clone(), other]);
    // The order of three bodies, the levels, the texels, and two projections.
    assert_eq!(twins.words.len(), 3 + 256 + 4 + 2 * 8);
    let axis = AXIS_LEN + INDEX_TABLE_LEN + 2 * 4;
    assert_eq!((twins.materials.len(), twins.spectra.len()), (2, 4 * (2 + 3) + axis));
    let sheet = unwrapped(print());
    let sheets = pack(&[sheet.clone(), sheet]);
    assert_eq!(sheets.words.len(), 2 + 256 + 4 + 8);
    assert_eq!((sheets.materials.len(), sheets.triangles.len()), (1, 2));
}

/// A flat facet on which the image goes on from triangle to triangle stays whole, so that no ray
/// that leaves it meets it again. Where the image jumps there are two; but only for who is printed
/// on: the same mesh may be clear beside.
#[test]
fn facets_are_divided_where_the_image_jumps() {
    let sheet = sheet();
    let mut jumping = sheet.coordinates.clone();
    jumping[1] = jumping[1].map(|at| at + Vec2::X);
    for (coordinates, printed_facets) in [(sheet.coordinates, 1), (jumping, 2)] {
        let (positions, triangles) = (sheet.positions.clone(), sheet.triangles.clone());
        let mesh = Mesh::with_coordinates(positions, triangles, coordinates).expect("a mesh");
        let mut printed = unwrapped(print());
        let source = MeshSource { path: "sheet.glb".into(), index: 0, mesh: Arc::new(mesh) };
        printed.shape = Shape::Mesh(source);
        let mut bare = printed.clone();
        bare.material =
            Material::Diffuse(Diffuse { reflectance: Spectrum::Flat(1.0), print: None });
        let scene = scene(vec![printed, bare], Lights::default());
        let packed = PackedScene::new(&scene, Bins::new(4)).expect("the scene packs");
        let facets: Vec<_> = packed.triangles.iter().map(|triangle| triangle.facet).collect();
        assert_eq!(facets, [[0, printed_facets - 1], [0, 0]].concat());
        assert_eq!(packed.words.len() as u32, 2 + 256 + 4 + 8 * printed_facets);
    }
}

#[test]
fn a_print_that_cannot_be_laid_on_is_refused() {
    let refusal = |object: Object| {
        let scene = scene(vec![object], Lights::default());
        PackedScene::new(&scene, Bins::new(4)).expect_err("refused").to_string()
    };
    let planar = |facing, up, size_mm| {
        let layout = Layout::Planar(Planar { facing, up, size_mm });
        slab(Print { layout, ..print() })
    };
    for (object, words) in [
        (slab(Print { layout: Layout::Coordinates, ..print() }), "no texture coordinates"),
        (slab(Print { tint: [1.0, 2.0, 0.0], ..print() }), "tint"),
        (planar(Vec3::Z, Vec3::Y, [0.0, 1.0]), "greater than 0"),
        (planar(Vec3::Z, Vec3::Y, [1.0, f32::NAN]), "greater than 0"),
        (planar(Vec3::Z, Vec3::Z, [1.0, 1.0]), "right angles"),
        (planar(Vec3::Z * 2.0, Vec3::Y, [1.0, 1.0]), "unit vectors"),
    ] {
        let text = refusal(object);
        assert!(text.starts_with("print on test: ") && text.contains(words), "{text}");
    }
}
