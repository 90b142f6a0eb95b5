//! A scene in the memory of a graphics device.

use std::sync::Arc;

use bytemuck::{NoUninit, Zeroable, bytes_of, cast_slice};
use wgpu::{BindGroup, BufferUsages};

use super::pace::software_budget;
use super::pipeline::WalkPipeline;
use crate::error::RendererError;
use crate::gpu::{Graphics, bind};
use crate::packed::PackedScene;
use crate::settings::Splitting;
use crate::shaders::Frame;
use crate::spectrum::Bins;

/// A scene in the memory of a graphics device.
#[derive(Debug)]
pub struct GpuScene {
    /// To tell it from others.
    pub(super) identity: Arc<()>,
    pub(super) bins: Bins,
    pub(super) group: BindGroup,
    /// Rays per walker that the device can follow in one submission.
    max_rays: u32,
    /// The same of fans.
    max_fans: u32,
    /// What the kernel is told of it beside its arrays.
    pub(super) frame: Frame,
}

impl GpuScene {
    /// Uploads a scene.
    ///
    /// # Errors
    /// An array is larger than the device takes, the scene is too much for a software device, the
    /// device's memory is full, or it fails.
    pub(super) fn new(
        graphics: &Graphics,
        pipeline: &WalkPipeline,
        scene: &PackedScene,
    ) -> Result<Self, RendererError> {
        let max_budget = |splitting| {
            if graphics.is_software() { software_budget(scene, splitting) } else { u32::MAX }
        };
        let [max_rays, max_fans] = [Splitting::Paper, Splitting::Exact].map(max_budget);
        if max_rays == 0 {
            return Err(RendererError::Graphics(format!(
                "the graphics device {} is software that can't follow so much light through bodies \
                 that throw it: {} passages; let fewer throw light, or trace on the CPU",
                graphics.name(),
                scene.passages.len()
            )));
        }
        let buffers = [
            upload(graphics, "bodies", &scene.instances)?,
            upload(graphics, "hierarchy of bodies", &scene.top_nodes)?,
            upload(graphics, "order of bodies and images", &scene.words)?,
            upload(graphics, "facets", &scene.planes)?,
            upload(graphics, "hierarchies of triangles", &scene.nodes)?,
            upload(graphics, "triangles", &scene.triangles)?,
            upload(graphics, "materials", &scene.materials)?,
            upload(graphics, "spectra and indices of refraction", &scene.spectra)?,
            upload(graphics, "lights", &scene.discs)?,
            upload(graphics, "passages of light", &scene.passages)?,
        ];
        let group = graphics.guard("hold the scene", |device| {
            let buffers = buffers.iter().map(wgpu::Buffer::as_entire_binding);
            bind(device, &pipeline.scene_layout, buffers)
        })?;
        let (identity, bins, frame) = (Arc::new(()), scene.bins, Frame::of(scene));
        Ok(Self { identity, bins, group, max_rays, max_fans, frame })
    }

    /// Rays divided like this that each walker can follow in one submission.
    pub(super) fn max_budget(&self, splitting: Splitting) -> u32 {
        match splitting {
            Splitting::Paper => self.max_rays,
            Splitting::Exact => self.max_fans,
        }
    }
}

/// A buffer with the elements of an array; one of zeros where there are none, since a binding
/// can't be empty.
fn upload<T: NoUninit + Zeroable>(
    graphics: &Graphics,
    what: &str,
    elements: &[T],
) -> Result<wgpu::Buffer, RendererError> {
    let nothing = T::zeroed();
    let bytes = if elements.is_empty() { bytes_of(&nothing) } else { cast_slice(elements) };
    let (size, largest) = (bytes.len() as u64, graphics.largest_binding());
    if size > largest {
        return Err(RendererError::Graphics(format!(
            "the graphics device {} can't hold the scene: its {what} take {} MB, and the device \
             takes {} MB at a time; use a smaller mesh or image, or trace on the CPU",
            graphics.name(),
            size.div_ceil(1_000_000),
            largest / 1_000_000
        )));
    }
    graphics.guard("hold the scene", |device| {
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(what),
            size,
            usage: BufferUsages::STORAGE | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        graphics.queue().write_buffer(&buffer, 0, bytes);
        buffer
    })
}
