//! `--backend`: what is to trace.

use brilliance_renderer::tracer::Backend;
use clap::ValueEnum;

/// What is to trace.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum BackendChoice {
    /// A graphics card where there is one, else the processor
    #[default]
    Auto,
    /// The processor
    Cpu,
    /// A graphics device, even one made of software; having none is an error, while for one that
    /// fails later the processor takes over, with a warning
    Gpu,
}

impl From<BackendChoice> for Backend {
    fn from(choice: BackendChoice) -> Self {
        match choice {
            BackendChoice::Auto => Self::Auto,
            BackendChoice::Cpu => Self::Cpu,
            BackendChoice::Gpu => Self::Gpu,
        }
    }
}
