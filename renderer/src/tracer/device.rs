//! What a tracer is made for: a graphics device, or what a test takes for one.

use super::{GpuTracer, Tracer};
use crate::error::RendererError;
use crate::gpu::Graphics;

/// What the user reads where something panicked that had to do with a device.
pub(crate) const DEVICE_PANICKED: &str = "the GPU tracer failed, which is a fault of the program \
    or of the graphics driver; please report it with the scene file and the name of the device";

/// A device that a tracer can be made for. Cloning shares it.
pub(crate) trait Device: Clone + Send + 'static {
    /// What traces on the device.
    type Tracer: Tracer<Scene: Send, Film: Send> + Send + Sync + 'static;

    /// Whether the device is the processor in disguise.
    fn is_software(&self) -> bool;

    /// Whether both are one device.
    fn is_same(&self, other: &Self) -> bool;

    /// Compiles the shaders, which takes up to some seconds.
    ///
    /// # Errors
    /// The device lacks something that tracing needs, or fails.
    fn prepare(&self) -> Result<Self::Tracer, RendererError>;
}

impl Device for Graphics {
    type Tracer = GpuTracer;

    fn is_software(&self) -> bool {
        Self::is_software(self)
    }

    fn is_same(&self, other: &Self) -> bool {
        Self::is_same(self, other)
    }

    fn prepare(&self) -> Result<GpuTracer, RendererError> {
        GpuTracer::new(self)
    }
}
