//! Draws the newest picture into the window by a shader of its own.

use std::sync::Arc;

use brilliance_renderer::develop::Pixels;
use brilliance_renderer::session::Picture;
use eframe::egui::{PaintCallback, PaintCallbackInfo, Rect};
use eframe::egui_wgpu::{
    Callback, CallbackResources, CallbackTrait, RenderState, ScreenDescriptor,
};
use wgpu::util::DeviceExt as _;

/// Prepares the window's graphics for [`paint_picture`].
pub fn install(graphics: &RenderState) {
    let painter = PicturePainter::new(&graphics.device, graphics.target_format);
    graphics.renderer.write().callback_resources.insert(painter);
}

/// What paints `picture` over `rect`: texel for pixel, or smoothly where it is of another size.
pub fn paint_picture(rect: Rect, picture: &Arc<Picture>, smooth: bool) -> PaintCallback {
    Callback::new_paint_callback(rect, PaintPicture { picture: Arc::clone(picture), smooth })
}

struct PaintPicture {
    picture: Arc<Picture>,
    smooth: bool,
}

impl CallbackTrait for PaintPicture {
    fn prepare(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        _screen: &ScreenDescriptor,
        _encoder: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        if let Some(painter) = resources.get_mut::<PicturePainter>() {
            painter.show(device, queue, &self.picture, self.smooth);
        }
        Vec::new()
    }

    fn paint(
        &self,
        _info: PaintCallbackInfo,
        pass: &mut wgpu::RenderPass<'static>,
        resources: &CallbackResources,
    ) {
        if let Some(painter) = resources.get::<PicturePainter>() {
            painter.paint(pass);
        }
    }
}

/// The pipeline, and the picture that it shows.
struct PicturePainter {
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
    format: wgpu::TextureFormat,
    /// For a picture of the screen's pixels, and for a smooth one.
    samplers: [wgpu::Sampler; 2],
    shown: Option<Shown>,
}

/// A picture in the graphics memory.
struct Shown {
    serial: u64,
    smooth: bool,
    bindings: wgpu::BindGroup,
}

impl PicturePainter {
    fn new(device: &wgpu::Device, target_format: wgpu::TextureFormat) -> Self {
        let module = device.create_shader_module(wgpu::include_wgsl!("picture.wgsl"));
        let layout = bindings_layout(device);
        let pipeline = pipeline(device, &module, &layout, target_format);
        // The picture is encoded for the screen. A target that encodes by itself must be given the
        // light that it encodes.
        let format = if target_format.is_srgb() {
            wgpu::TextureFormat::Rgba8UnormSrgb
        } else {
            wgpu::TextureFormat::Rgba8Unorm
        };
        let samplers = [wgpu::FilterMode::Nearest, wgpu::FilterMode::Linear]
            .map(|filter| sampler(device, filter));
        Self { pipeline, layout, format, samplers, shown: None }
    }

    /// Binds `picture` unless that is done; one that only the processor's memory holds is uploaded.
    fn show(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        picture: &Picture,
        smooth: bool,
    ) {
        let is_shown = |shown: &Shown| shown.serial == picture.serial && shown.smooth == smooth;
        if self.shown.as_ref().is_some_and(is_shown) {
            return;
        }
        let bindings = match &picture.pixels {
            Pixels::Rgba8(rgba8) => {
                let texture = self.upload(device, queue, picture.size, rgba8);
                self.bind(device, &texture, smooth)
            }
            // Of this device: the session drops the pictures of a device that another replaces.
            Pixels::Texture(texture) => self.bind(device, texture, smooth),
        };
        self.shown = Some(Shown { serial: picture.serial, smooth, bindings });
    }

    fn upload(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        [width, height]: [u32; 2],
        rgba8: &[u8],
    ) -> wgpu::Texture {
        device.create_texture_with_data(
            queue,
            &wgpu::TextureDescriptor {
                label: Some("picture"),
                size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format: self.format,
                usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
                view_formats: &[],
            },
            wgpu::util::TextureDataOrder::LayerMajor,
            rgba8,
        )
    }

    fn bind(
        &self,
        device: &wgpu::Device,
        texture: &wgpu::Texture,
        smooth: bool,
    ) -> wgpu::BindGroup {
        let view = texture.create_view(&wgpu::TextureViewDescriptor {
            label: Some("picture"),
            format: Some(self.format),
            usage: Some(wgpu::TextureUsages::TEXTURE_BINDING),
            ..wgpu::TextureViewDescriptor::default()
        });
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("picture"),
            layout: &self.layout,
            entries: &[
                wgpu::BindGroupEntry {
                    binding: 0,
                    resource: wgpu::BindingResource::TextureView(&view),
                },
                wgpu::BindGroupEntry {
                    binding: 1,
                    resource: wgpu::BindingResource::Sampler(&self.samplers[usize::from(smooth)]),
                },
            ],
        })
    }

    fn paint(&self, pass: &mut wgpu::RenderPass<'static>) {
        if let Some(shown) = &self.shown {
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &shown.bindings, &[]);
            pass.draw(0..3, 0..1);
        }
    }
}

fn sampler(device: &wgpu::Device, filter: wgpu::FilterMode) -> wgpu::Sampler {
    device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("picture"),
        mag_filter: filter,
        min_filter: filter,
        ..wgpu::SamplerDescriptor::default()
    })
}

fn bindings_layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    let entry = |binding, ty| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty,
        count: None,
    };
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("picture"),
        entries: &[
            entry(
                0,
                wgpu::BindingType::Texture {
                    sample_type: wgpu::TextureSampleType::Float { filterable: true },
                    view_dimension: wgpu::TextureViewDimension::D2,
                    multisampled: false,
                },
            ),
            entry(1, wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering)),
        ],
    })
}

fn pipeline(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    bindings: &wgpu::BindGroupLayout,
    target_format: wgpu::TextureFormat,
) -> wgpu::RenderPipeline {
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("picture"),
        bind_group_layouts: &[Some(bindings)],
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("picture"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some("corner"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: None,
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some("texel"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(target_format.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}
