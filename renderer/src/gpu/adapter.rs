//! The choice among a machine's graphics devices.

use wgpu::{Adapter, AdapterInfo, Backends, DeviceType, DownlevelFlags};

use crate::error::RendererError;

/// Opens the best device that can compute, with all that its adapter offers but what `restrict`
/// takes away.
pub(super) fn open(
    allow_software: bool,
    restrict: impl Fn(&mut wgpu::Limits),
) -> Result<(wgpu::Device, wgpu::Queue, AdapterInfo), RendererError> {
    let mut fault = "no graphics device was found; install its driver (Vulkan, Metal or \
                     DirectX 12), or trace on the CPU"
        .to_owned();
    for adapter in adapters() {
        let info = adapter.get_info();
        if info.device_type == DeviceType::Cpu && !allow_software {
            fault = format!(
                "the only graphics device is software ({}), slower than the CPU tracer; install \
                 the driver of the graphics card, or trace on the CPU",
                info.name
            );
            continue;
        }
        let mut required_limits = adapter.limits();
        restrict(&mut required_limits);
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("brilliance"),
            required_limits,
            ..Default::default()
        };
        match pollster::block_on(adapter.request_device(&descriptor)) {
            Ok((device, queue)) => return Ok((device, queue, info)),
            Err(error) => {
                fault = format!(
                    "the graphics device {} can't be opened: {error}; update its driver, or trace \
                     on the CPU",
                    info.name
                );
            }
        }
    }
    Err(RendererError::Graphics(fault))
}

/// The adapters that can compute, the best first. Others than those of the modern interfaces are
/// looked for only where these have none: to ask OpenGL takes as long again as all the rest.
fn adapters() -> Vec<Adapter> {
    for backends in [Backends::PRIMARY, Backends::SECONDARY] {
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle_from_env();
        descriptor.backends &= backends;
        let instance = wgpu::Instance::new(descriptor);
        let mut adapters = pollster::block_on(instance.enumerate_adapters(backends));
        adapters.retain(computes);
        if !adapters.is_empty() {
            adapters.sort_by_key(|adapter| rank(&adapter.get_info()));
            return adapters;
        }
    }
    Vec::new()
}

fn computes(adapter: &Adapter) -> bool {
    adapter.get_downlevel_capabilities().flags.contains(DownlevelFlags::COMPUTE_SHADERS)
}

/// Least for the device to prefer.
fn rank(info: &AdapterInfo) -> u32 {
    match info.device_type {
        DeviceType::DiscreteGpu => 0,
        DeviceType::IntegratedGpu => 1,
        DeviceType::VirtualGpu => 2,
        DeviceType::Other => 3,
        DeviceType::Cpu => 4,
    }
}
