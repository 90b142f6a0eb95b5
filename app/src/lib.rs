//! Brilliance, a viewer of gemstones: the window and the command line.

pub mod cli;
