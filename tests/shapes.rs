//! Shapes that several tests make their meshes of.

use glam::Vec3;

/// A sphere of latitude rings; its poles are fans.
pub(crate) fn sphere(rings: u32, segments: u32) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let mut positions = vec![Vec3::Z];
    for ring in 1..rings {
        let (r, z) = (std::f32::consts::PI * ring as f32 / rings as f32).sin_cos();
        for segment in 0..segments {
            let (y, x) = (std::f32::consts::TAU * segment as f32 / segments as f32).sin_cos();
            positions.push(Vec3::new(r * x, r * y, z));
        }
    }
    let south = positions.len() as u32;
    positions.push(Vec3::NEG_Z);
    let at = |ring: u32, segment: u32| 1 + (ring - 1) * segments + segment % segments;
    let mut triangles = Vec::new();
    for s in 0..segments {
        triangles.push([0, at(1, s), at(1, s + 1)]);
        triangles.push([south, at(rings - 1, s + 1), at(rings - 1, s)]);
        for ring in 1..rings - 1 {
            let (a, b) = (at(ring, s), at(ring, s + 1));
            let (c, d) = (at(ring + 1, s), at(ring + 1, s + 1));
            triangles.extend([[a, c, b], [b, c, d]]);
        }
    }
    (positions, triangles)
}
