//! The GPU in step with the CPU, on any device there is, software included.

mod cases;
mod device;
mod films;

use brilliance_renderer::gpu::Graphics;

/// A device of the test's own. A machine without any fails the test rather than passing it unseen.
fn graphics() -> Graphics {
    Graphics::open(true).unwrap_or_else(|error| {
        panic!("these tests need a graphics device, be it software (mesa-vulkan-drivers): {error}")
    })
}
