//! What a device can't do is an error that says so, and the device can be used on.

use std::path::PathBuf;
use std::sync::Arc;

use brilliance_renderer::mesh::Mesh;
use brilliance_renderer::packed::PackedScene;
use brilliance_renderer::scene::{MeshSource, Scene, Shape};
use brilliance_renderer::scene_file::Document;
use brilliance_renderer::spectrum::Bins;
use brilliance_renderer::tracer::{GpuTracer, Tracer, TracerName};

use super::shapes::sphere;
use super::{TRACER, limited_graphics};

/// The text of what must be an error of the device.
fn refusal<T>(result: Result<T, brilliance_renderer::error::RendererError>) -> String {
    match result {
        Err(brilliance_renderer::error::RendererError::Graphics(text)) => text,
        Err(other) => panic!("another error: {other}"),
        Ok(_) => panic!("the device was content"),
    }
}

#[test]
fn a_device_with_too_few_buffers_is_refused() {
    let graphics = limited_graphics(|limits| limits.max_storage_buffers_per_shader_stage = 8);
    let text = refusal(GpuTracer::new(&graphics));
    assert!(text.contains("8 storage buffers") && text.contains("CPU"), "{text}");
}

#[test]
fn a_device_with_too_small_buffers_is_refused() {
    let graphics = limited_graphics(|limits| limits.max_storage_buffer_binding_size = 1 << 20);
    let text = refusal(GpuTracer::new(&graphics));
    assert!(text.contains("1048576 bytes in a buffer"), "{text}");
}

#[test]
fn a_scene_too_large_for_the_device_is_refused() {
    let graphics = limited_graphics(|limits| limits.max_storage_buffer_binding_size = 3 << 19);
    let tracer = GpuTracer::new(&graphics).unwrap();
    // 28,560 triangles of 64 bytes.
    let (positions, triangles) = sphere(120, 120);
    let mesh = Mesh::new(positions, triangles).unwrap();
    let mut document = Document::default();
    document.scene.objects[0].shape =
        Shape::Mesh(MeshSource { path: PathBuf::new(), index: 0, mesh: Arc::new(mesh) });
    let packed = PackedScene::new(&document.scene, Bins::new(16)).unwrap();
    let text = refusal(tracer.load(packed));
    assert!(text.contains("triangles take 2 MB") && text.contains("CPU"), "{text}");
    tracer.load(PackedScene::new(&Scene::default(), Bins::new(16)).unwrap()).unwrap();
}

#[test]
fn software_refuses_light_that_it_would_cut_short() {
    let mut document = Document::default();
    document.scene.objects[0].throws_light = true;
    let packed = PackedScene::new(&document.scene, Bins::new(16)).unwrap();
    assert!(packed.passages.len() > 100, "{}", packed.passages.len());
    let loaded = TRACER.load(packed);
    if matches!(TRACER.name(), TracerName::Gpu { is_software: true, .. }) {
        let text = refusal(loaded);
        assert!(text.contains("throw") && text.contains("CPU"), "{text}");
    } else {
        loaded.unwrap();
    }
}

#[test]
fn an_impossible_film_is_refused() {
    for (size, bins) in [([1 << 26, 4], 16), ([0, 0], 16), ([64, 64], 65)] {
        let text = refusal(TRACER.film(size, Bins::new(bins), None));
        assert!(text.contains(&format!("{} × {} pixels", size[0], size[1])), "{text}");
    }
    TRACER.film([64, 64], Bins::new(64), None).unwrap();
}

#[test]
fn a_film_of_other_bins_than_the_scene_is_refused() {
    let document = Document::default();
    let scene = TRACER.load(PackedScene::new(&document.scene, Bins::new(8)).unwrap()).unwrap();
    let mut film = TRACER.film([8, 8], Bins::new(16), None).unwrap();
    let view = brilliance_renderer::tracer::View::new(&document.scene.camera, [8, 8]);
    let result = TRACER.trace(&scene, &view, &document.trace, &mut film, 1, &|| false);
    let text = result.unwrap_err().to_string();
    assert!(text.contains("8 bins") && text.contains("16"), "{text}");
}
