//! The tracing kernel: Thomas 1986 as small pure functions.
//!
//! Nothing here allocates or recurses, and but for the vectors of the plane loop nothing uses what a
//! shader lacks: f32, u32, `Vec3`, slices that stand for storage buffers, explicit stacks of fixed
//! size, no infinities. Each file has a twin in [`shaders`](crate::shaders), function by function.
//!
//! The flow of one camera ray:
//! [`camera`] → [`trace`] ⟲ ([`intersect`] → [`fork`] or [`diffuse`] or [`lights`] → [`deposit`]).
//! Where bodies throw light, [`diffuse`] asks [`passage`] too.

pub mod absorption;
pub mod axis;
pub mod band;
pub mod camera;
pub mod convex;
pub mod crossing;
pub mod deposit;
pub mod diffuse;
pub mod divide;
pub mod facet;
pub mod fan;
pub mod fan_lights;
pub mod fan_matte;
pub mod fan_trace;
pub mod fan_walk;
pub mod fork;
pub mod interface;
pub mod intersect;
pub mod lights;
pub mod mesh;
pub mod nodes;
pub mod parabola;
pub mod passage;
pub mod print;
pub mod ray;
pub mod reach;
pub mod rng;
pub mod spread;
pub mod trace;
pub mod walk;
