//! The choice among a machine's graphics devices.

use wgpu::{Adapter, AdapterInfo, Backend, Backends, DeviceType, DownlevelFlags};

use crate::error::RendererError;

/// Opens the best device that can compute, with all that its adapter offers.
pub(super) fn open(
    allow_software: bool,
) -> Result<(wgpu::Device, wgpu::Queue, AdapterInfo), RendererError> {
    let descriptor = wgpu::InstanceDescriptor::new_without_display_handle_from_env();
    let instance = wgpu::Instance::new(descriptor);
    let mut adapters = pollster::block_on(instance.enumerate_adapters(Backends::all()));
    adapters.retain(computes);
    adapters.sort_by_key(|adapter| rank(&adapter.get_info()));
    let mut fault = "no graphics device was found; install its driver (Vulkan, Metal or \
                     DirectX 12), or trace on the CPU"
        .to_owned();
    for adapter in adapters {
        let info = adapter.get_info();
        if info.device_type == DeviceType::Cpu && !allow_software {
            fault = format!(
                "the only graphics device is software ({}), slower than the CPU tracer; install \
                 the driver of the graphics card, or trace on the CPU",
                info.name
            );
            continue;
        }
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("brilliance"),
            required_limits: adapter.limits(),
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

fn computes(adapter: &Adapter) -> bool {
    adapter.get_downlevel_capabilities().flags.contains(DownlevelFlags::COMPUTE_SHADERS)
}

/// Least for the device to prefer. One device may be there through several interfaces; OpenGL is
/// the last to take.
fn rank(info: &AdapterInfo) -> (u32, bool) {
    let kind = match info.device_type {
        DeviceType::DiscreteGpu => 0,
        DeviceType::IntegratedGpu => 1,
        DeviceType::VirtualGpu => 2,
        DeviceType::Other => 3,
        DeviceType::Cpu => 4,
    };
    (kind, info.backend == Backend::Gl)
}
