//! The physics of the renderer against formulas, published values and brute force.

mod clumping;
mod counts;
mod determinism;
mod energy;
mod film;
mod interface;
mod intersection;
mod lights;
mod matte;
mod passages;
mod poison;
mod prints;
mod prism;
mod scenes;
mod slab;
mod spread;
