//! WGSL as naga understands it.

use wgpu::naga::Module;
use wgpu::naga::front::wgsl;

/// Parses what must be WGSL.
pub(crate) fn parse(source: &str) -> Module {
    wgsl::parse_str(source).unwrap_or_else(|error| panic!("{}", error.emit_to_string(source)))
}
