//! The shaders against their Rust twins.

mod modules;
mod probe;
mod probes;
