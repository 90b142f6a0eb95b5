//! The shaders against their Rust twins.

mod constants;
mod layout;
mod modules;
mod probe;
mod probes;
mod twins;
mod wgsl;
