//! What a tracer is made for: a graphics device, or what a test takes for one.

use std::fmt;
use std::sync::Arc;

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

/// A graphics device to trace on, with the shaders compiled for it where that was done already.
/// Cloning shares it.
#[derive(Clone)]
pub struct TracingDevice {
    graphics: Graphics,
    /// What has the compiled shaders.
    ready: Option<Arc<GpuTracer>>,
}

impl From<Graphics> for TracingDevice {
    fn from(graphics: Graphics) -> Self {
        Self { graphics, ready: None }
    }
}

impl From<Arc<GpuTracer>> for TracingDevice {
    fn from(tracer: Arc<GpuTracer>) -> Self {
        Self { graphics: tracer.graphics().clone(), ready: Some(tracer) }
    }
}

impl TracingDevice {
    /// Whether there is nothing left to compile.
    pub fn is_ready(&self) -> bool {
        self.ready.is_some()
    }
}

impl fmt::Debug for TracingDevice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("TracingDevice")
            .field("name", &self.graphics.name())
            .field("is_ready", &self.is_ready())
            .finish_non_exhaustive()
    }
}

impl Device for TracingDevice {
    type Tracer = GpuTracer;

    fn is_software(&self) -> bool {
        self.graphics.is_software()
    }

    fn is_same(&self, other: &Self) -> bool {
        self.graphics.is_same(&other.graphics)
    }

    fn prepare(&self) -> Result<GpuTracer, RendererError> {
        match &self.ready {
            Some(tracer) => tracer.sibling(),
            None => GpuTracer::new(&self.graphics),
        }
    }
}
