//! A dispersive ray tracer of gemstones: scenes in, spectral films and pictures out.

pub mod accel;
pub mod camera;
pub mod color;
pub mod cuts;
pub mod develop;
pub mod error;
pub mod film;
pub mod image_file;
pub mod import;
pub mod kernel;
pub mod light;
pub mod material;
pub mod mesh;
pub mod packed;
pub mod rigs;
pub mod scene;
pub mod scene_file;
pub mod scheduler;
pub mod session;
pub mod settings;
pub mod solid;
pub mod spectrum;
pub mod statistics;
pub mod still;
pub mod tracer;
pub mod whole_file;
