//! Reading back, and what becomes of a device's errors.

use brilliance_renderer::gpu::Graphics;
use wgpu::util::DeviceExt;

use super::graphics;

fn buffer(graphics: &Graphics, contents: &[u8]) -> wgpu::Buffer {
    graphics.device().create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: None,
        contents,
        usage: wgpu::BufferUsages::COPY_SRC,
    })
}

/// Bytes of no regular pattern.
fn noise(count: usize) -> Vec<u8> {
    (0..count as u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8).collect()
}

#[test]
fn a_buffer_larger_than_one_fetch_is_read_whole() {
    let graphics = graphics();
    let bytes = noise((32 << 20) + 4);
    assert!(graphics.read_buffer(&buffer(&graphics, &bytes)).unwrap() == bytes);
}

#[test]
fn a_texture_is_read_without_what_fills_its_rows() {
    let graphics = graphics();
    let size = wgpu::Extent3d { width: 13, height: 5, depth_or_array_layers: 1 };
    let texels = noise(13 * 5 * 16);
    let texture = graphics.device().create_texture_with_data(
        graphics.queue(),
        &wgpu::TextureDescriptor {
            label: None,
            size,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba32Float,
            usage: wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        },
        wgpu::util::TextureDataOrder::LayerMajor,
        &texels,
    );
    assert_eq!(graphics.read_texture(&texture).unwrap(), texels);
}

#[test]
fn a_refusal_is_an_error_and_no_panic() {
    let graphics = graphics();
    let unreadable = graphics.device().create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: 64,
        usage: wgpu::BufferUsages::STORAGE,
        mapped_at_creation: false,
    });
    let text = graphics.read_buffer(&unreadable).unwrap_err().to_string();
    assert!(text.contains(graphics.name()) && text.contains("read a buffer"), "{text}");
    assert_eq!(text.lines().count(), 1, "{text}");
    assert_eq!(graphics.loss(), None);
    let bytes = noise(64);
    assert_eq!(graphics.read_buffer(&buffer(&graphics, &bytes)).unwrap(), bytes);
}

#[test]
fn a_lost_device_is_an_error_from_then_on() {
    let graphics = graphics();
    let buffer = buffer(&graphics, &noise(64));
    graphics.device().destroy();
    for _ in 0..2 {
        let text = graphics.read_buffer(&buffer).unwrap_err().to_string();
        assert!(text.contains("is lost"), "{text}");
    }
    assert!(graphics.loss().is_some());
}
