//! Shader modules as text: their order, and the names in them.

use brilliance_renderer::shaders::{KERNEL, join};
use wgpu::naga::valid::{Capabilities, ValidationFlags, Validator};

use crate::wgsl::parse;

/// A module that used something from a later one would not validate before that is there.
#[test]
fn every_prefix_of_the_kernel_validates() {
    for count in 0..=KERNEL.len() {
        let source = join(&KERNEL[..count]);
        let last = KERNEL[..count].last().map_or("constants", |module| module.name);
        Validator::new(ValidationFlags::all(), Capabilities::empty())
            .validate(&parse(&source))
            .unwrap_or_else(|error| panic!("{last}: {}", error.emit_to_string(&source)));
    }
}
