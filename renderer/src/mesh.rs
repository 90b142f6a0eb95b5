//! Triangle meshes.

use glam::Vec3;

/// An indexed triangle mesh, counter-clockwise seen from outside.
#[derive(Debug)]
pub struct Mesh {
    /// Vertex positions in millimetres.
    pub positions: Vec<Vec3>,
    /// Three vertex indices per triangle.
    pub triangles: Vec<[u32; 3]>,
}
