//! Which tracer is asked for, and which one traced.

use std::fmt;

use serde::Serialize;

/// Which tracer is asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Backend {
    /// A graphics card where there is one, else the processor: discrete or integrated; virtual,
    /// which is mostly a real one lent to a virtual machine; or of an unknown kind, as OpenGL
    /// reports them all. Software, which says that it is, is slower than the processor's tracer.
    #[default]
    Auto,
    /// The processor.
    Cpu,
    /// The graphics device, even one made of software. That none is there is an error; where one
    /// fails later the processor takes over, with a warning.
    Gpu,
}

impl Backend {
    /// Whether a device is traced on where this is asked for.
    pub fn uses_device(self, is_software: bool) -> bool {
        match self {
            Self::Auto => !is_software,
            Self::Cpu => false,
            Self::Gpu => true,
        }
    }
}

/// Which tracer traced.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TracerName {
    /// The processor.
    Cpu {
        /// Threads that traced.
        threads: usize,
    },
    /// A graphics device.
    Gpu {
        /// The device as its driver names it.
        device: String,
        /// Whether the device is the processor in disguise.
        is_software: bool,
    },
}

impl fmt::Display for TracerName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cpu { threads: 1 } => write!(f, "CPU, 1 thread"),
            Self::Cpu { threads } => write!(f, "CPU, {threads} threads"),
            Self::Gpu { device, is_software: false } => write!(f, "GPU, {device}"),
            Self::Gpu { device, is_software: true } => write!(f, "GPU in software, {device}"),
        }
    }
}
