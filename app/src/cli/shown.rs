//! `--show`: what the picture is to show.

use brilliance_renderer::develop::{HeatMap, Shown};
use clap::ValueEnum;

/// What the picture is to show.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum ShownChoice {
    /// The stone in its colours
    #[default]
    Color,
    /// A heat map of the ray segments per pixel and pass, from 1 to 10,000
    Rays,
    /// A heat map of the interfaces that the deepest ray of a pixel had met, from 1 to 256
    Depth,
    /// A heat map of the part of the light that was pruned, from 0.001 to 100 %
    Pruned,
}

impl From<ShownChoice> for Shown {
    fn from(choice: ShownChoice) -> Self {
        match choice {
            ShownChoice::Color => Self::Color,
            ShownChoice::Rays => Self::Heat(HeatMap::Rays),
            ShownChoice::Depth => Self::Heat(HeatMap::Depth),
            ShownChoice::Pruned => Self::Heat(HeatMap::Pruned),
        }
    }
}
