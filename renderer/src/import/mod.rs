//! Files that bring stones and meshes.

pub mod gltf;
