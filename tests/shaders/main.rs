//! The shaders against their Rust twins.

mod modules;
