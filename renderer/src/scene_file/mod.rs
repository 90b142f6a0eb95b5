//! Scene files: a TOML form of everything a picture needs, described in `docs/scene-file.md`.
//!
//! Text becomes a tree of values that know their places, the tree fills plain entry types by
//! serde, and each entry checks its values while it becomes a part of the [`Document`]. A fault on
//! that way carries its key, from which the place is found.

mod angle;
mod brilliant;
mod check;
mod deserialize;
mod document;
mod fault;
mod format;
mod gltf_scene;
mod light;
mod material;
mod mesh_file;
mod object;
mod path;
mod print;
mod settings;
mod shipped;
mod spectrum;
mod tree;
mod view;

pub use document::{Document, StillSettings};
pub use shipped::{ShippedScene, scenes};
