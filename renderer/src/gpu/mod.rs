//! A graphics device, and what is common to all that runs on it: opening it, noticing that it
//! failed, waiting for it and reading back.

mod adapter;
mod fault;
mod gate;
mod readback;
mod wait;

use std::sync::{Arc, Mutex, OnceLock};

pub(crate) use readback::{Arrival, Readback};

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
    /// Held by who hands work to the device.
    gate: Mutex<()>,
    /// Why the device is gone; unset while it works.
    loss: Arc<OnceLock<String>>,
}

impl Graphics {
    /// Opens the best device of this machine; a software one only where `allow_software`.
    ///
    /// # Errors
    /// There is no such device, or it can't be opened.
    pub fn open(allow_software: bool) -> Result<Self, RendererError> {
        Self::open_restricted(allow_software, |_| ())
    }

    /// [`open`](Self::open) for tests: the same device, with the limits that `restrict` leaves it.
    ///
    /// # Errors
    /// There is no such device, or it can't be opened.
    #[doc(hidden)]
    pub fn open_restricted(
        allow_software: bool,
        restrict: impl Fn(&mut wgpu::Limits),
    ) -> Result<Self, RendererError> {
        let (device, queue, info) = adapter::open(allow_software, restrict)?;
        Ok(Self::share(&device, &queue, info))
    }

    /// Shares the device that a window draws with. Its errors are logged from now on, where wgpu's
    /// own answer to them is a panic.
    pub fn share(device: &wgpu::Device, queue: &wgpu::Queue, info: wgpu::AdapterInfo) -> Self {
        device.on_uncaptured_error(Arc::new(|error| log::error!("graphics: {error}")));
        let loss = Arc::new(OnceLock::new());
        device.set_device_lost_callback({
            let loss = Arc::clone(&loss);
            move |reason, text| {
                // A second reason adds nothing to the first.
                let _ = loss.set(fault::loss_text(reason, &text));
            }
        });
        let (device, queue) = (device.clone(), queue.clone());
        Self { shared: Arc::new(Shared { device, queue, info, gate: Mutex::new(()), loss }) }
    }

    /// Whether both are clones of one. (wgpu takes the first devices of two of its instances for
    /// equal.)
    pub(crate) fn is_same(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.shared, &other.shared)
    }

    /// The device as its driver names it.
    pub fn name(&self) -> &str {
        &self.shared.info.name
    }

    /// What kind of device it is.
    pub fn device_type(&self) -> wgpu::DeviceType {
        self.shared.info.device_type
    }

    /// Whether the device is the processor in disguise.
    pub fn is_software(&self) -> bool {
        self.device_type() == wgpu::DeviceType::Cpu
    }

    /// The device.
    pub fn device(&self) -> &wgpu::Device {
        &self.shared.device
    }

    /// The device's queue.
    pub fn queue(&self) -> &wgpu::Queue {
        &self.shared.queue
    }

    /// Most bytes that a shader can be given in one buffer.
    pub(crate) fn largest_binding(&self) -> u64 {
        let limits = self.device().limits();
        // Sizes are multiples of 4.
        limits.max_storage_buffer_binding_size.min(limits.max_buffer_size) & !3
    }

    /// Submits what `encode` records; `what` as for [`guard`](Self::guard).
    ///
    /// # Errors
    /// The device refuses or fails.
    pub(crate) fn submit(
        &self,
        what: &str,
        encode: impl FnOnce(&mut wgpu::CommandEncoder),
    ) -> Result<(), RendererError> {
        self.guard(what, |device| {
            let mut encoder =
                device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            encode(&mut encoder);
            self.hand_over(encoder.finish());
        })
    }

    /// Why the device is gone, once that is known.
    pub fn loss(&self) -> Option<&str> {
        self.shared.loss.get().map(String::as_str)
    }
}

/// Binds resources in the order of their numbers.
pub(crate) fn bind<'a>(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    resources: impl IntoIterator<Item = wgpu::BindingResource<'a>>,
) -> wgpu::BindGroup {
    let entries = (0..).zip(resources);
    let entries = entries.map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource });
    device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout,
        entries: &entries.collect::<Vec<_>>(),
    })
}
