//! Parametric cuts, each a function from the proportions a cutter states to half-spaces.

mod round_brilliant;

pub use round_brilliant::RoundBrilliant;
