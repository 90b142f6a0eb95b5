//! Views of a texture.

use wgpu::{BindGroupEntry, BindingResource, BufferUsages, TextureFormat, TextureUsages};

use crate::GRAPHICS;

/// What a shader sees of `texture` through a view of `format`.
pub(crate) fn load(texture: &wgpu::Texture, format: TextureFormat) -> Vec<f32> {
    const SOURCE: &str = "
        @group(0) @binding(0) var texture: texture_2d<f32>;
        @group(0) @binding(1) var<storage, read_write> texels: array<vec4f>;
        @compute @workgroup_size(1)
        fn load(@builtin(global_invocation_id) at: vec3u) {
            texels[at.y * textureDimensions(texture).x + at.x] = textureLoad(texture, at.xy, 0);
        }";
    let device = GRAPHICS.device();
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: None,
        source: wgpu::ShaderSource::Wgsl(SOURCE.into()),
    });
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: None,
        layout: None,
        module: &module,
        entry_point: None,
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        cache: None,
    });
    let view = texture.create_view(&wgpu::TextureViewDescriptor {
        format: Some(format),
        usage: Some(TextureUsages::TEXTURE_BINDING),
        ..Default::default()
    });
    let texels = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: 16 * u64::from(texture.width()) * u64::from(texture.height()),
        usage: BufferUsages::STORAGE | BufferUsages::COPY_SRC,
        mapped_at_creation: false,
    });
    let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &pipeline.get_bind_group_layout(0),
        entries: &[
            BindGroupEntry { binding: 0, resource: BindingResource::TextureView(&view) },
            BindGroupEntry { binding: 1, resource: texels.as_entire_binding() },
        ],
    });
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
    pass.set_pipeline(&pipeline);
    pass.set_bind_group(0, &group, &[]);
    pass.dispatch_workgroups(texture.width(), texture.height(), 1);
    drop(pass);
    GRAPHICS.queue().submit([encoder.finish()]);
    bytemuck::pod_collect_to_vec(&GRAPHICS.read_buffer(&texels).expect("its texels"))
}
