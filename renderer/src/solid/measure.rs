//! What a cutter measures on a solid.

use std::collections::HashSet;

use glam::DVec3;

use super::{Facet, Solid};

impl Solid {
    /// Volume in mm³.
    pub fn volume(&self) -> f64 {
        // Tetrahedra over one corner of the solid keep full precision far from the origin.
        let apex = self.vertices.first().copied().unwrap_or_default();
        let corner = |v: u32| self.vertices[v as usize] - apex;
        let six_fold: f64 =
            self.triangles().map(|([a, b, c], _)| corner(a).dot(corner(b).cross(corner(c)))).sum();
        six_fold / 6.0
    }

    /// Surface in mm².
    pub fn area(&self) -> f64 {
        self.facets.iter().map(|facet| self.facet_area(facet)).sum()
    }

    /// Surface of one of this solid's facets in mm².
    pub fn facet_area(&self, facet: &Facet) -> f64 {
        let apex = self.vertices[facet.vertices[0] as usize];
        let doubled: DVec3 = facet.vertices[1..]
            .windows(2)
            .map(|pair| {
                let [b, c] = [pair[0], pair[1]].map(|v| self.vertices[v as usize] - apex);
                b.cross(c)
            })
            .sum();
        0.5 * doubled.dot(facet.half_space.normal)
    }

    /// Lowest and highest coordinates, in mm.
    pub fn bounds(&self) -> (DVec3, DVec3) {
        self.vertices.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), v| {
            (low.min(*v), high.max(*v))
        })
    }

    /// Size along x, y and z, in mm.
    pub fn extents(&self) -> DVec3 {
        let (low, high) = self.bounds();
        high - low
    }

    /// Vertices − edges + facets: 2 for every convex solid (Euler 1758).
    pub fn euler_characteristic(&self) -> i64 {
        let edges: HashSet<[u32; 2]> = self
            .facets
            .iter()
            .flat_map(|facet| {
                let next = facet.vertices.iter().cycle().skip(1);
                facet.vertices.iter().zip(next).map(|(&a, &b)| [a.min(b), a.max(b)])
            })
            .collect();
        self.vertices.len() as i64 - edges.len() as i64 + self.facets.len() as i64
    }
}
