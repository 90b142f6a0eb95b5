//! Convex clipping: a polyhedron that starts as a huge cube and loses what lies outside each plane.
//!
//! Every plane sorts the corners into inside, on and outside once; both faces of an edge see the
//! same verdict and share the same cut point, so the surface stays closed whatever rounding does.

use std::collections::{HashMap, HashSet};

use glam::{DMat3, DVec3};

use super::HalfSpace;
use crate::error::RendererError;

/// Half the side of the first cube over the largest plane distance: what reaches it is open.
const CUBE: f64 = 1e4;
/// Distance within which a corner lies on a plane, over the largest plane distance.
const ON_PLANE: f64 = 1e-9;

/// The six sides of the first cube: outward normal and the words for it.
const SIDES: [(DVec3, &str); 6] = [
    (DVec3::X, "+x (right)"),
    (DVec3::NEG_X, "−x (left)"),
    (DVec3::Y, "+y (back)"),
    (DVec3::NEG_Y, "−y (front)"),
    (DVec3::Z, "+z (above the table)"),
    (DVec3::NEG_Z, "−z (below the culet)"),
];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Source {
    /// A side of the first cube, as an index into [`SIDES`].
    Cube(usize),
    /// A half-space, by its index.
    Plane(usize),
}

struct Face {
    source: Source,
    /// Corners, counter-clockwise from outside.
    corners: Vec<u32>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Inside,
    On,
    Outside,
}

/// A closed convex polyhedron on its way to a solid.
pub(super) struct Polyhedron {
    tolerance: f64,
    points: Vec<DVec3>,
    faces: Vec<Face>,
}

impl Polyhedron {
    /// The cube that stands for all of space about planes at distances up to `scale`.
    pub(super) fn cube(scale: f64) -> Self {
        let half_side = CUBE * scale;
        let sign = |bit: usize| if bit == 0 { -half_side } else { half_side };
        let points = (0..8_usize)
            .map(|corner| DVec3::new(sign(corner & 1), sign(corner & 2), sign(corner & 4)))
            .collect();
        let loops =
            [[1, 3, 7, 5], [0, 4, 6, 2], [2, 6, 7, 3], [0, 1, 5, 4], [4, 5, 7, 6], [0, 2, 3, 1]];
        let faces = loops
            .into_iter()
            .enumerate()
            .map(|(side, corners)| Face { source: Source::Cube(side), corners: corners.to_vec() })
            .collect();
        Self { tolerance: ON_PLANE * scale, points, faces }
    }

    /// Removes what lies outside `plane`, whose cap becomes a face with source `index`.
    pub(super) fn clip(&mut self, index: usize, plane: &HalfSpace) -> Result<(), RendererError> {
        let heights: Vec<f64> =
            self.points.iter().map(|point| plane.normal.dot(*point) - plane.distance).collect();
        let mut sides: Vec<Side> = heights.iter().map(|height| self.side(*height)).collect();
        let has = |wanted: Side| {
            self.faces.iter().flat_map(|face| &face.corners).any(|&v| sides[v as usize] == wanted)
        };
        if !has(Side::Outside) {
            return Ok(());
        }
        if !has(Side::Inside) {
            return Err(RendererError::Invalid(format!(
                "facet '{}' leaves nothing of the stone: what the facets before it enclose lies \
                 wholly outside it; check its angle and distance",
                plane.name
            )));
        }
        self.cut_faces(&heights, &mut sides);
        let cap = self.cap(&sides).ok_or_else(|| {
            RendererError::Invalid(format!(
                "facet '{}' nearly coincides with another facet, so that their edge is undefined; \
                 remove one of them or change its angle or distance",
                plane.name
            ))
        })?;
        self.faces.push(Face { source: Source::Plane(index), corners: cap });
        Ok(())
    }

    fn side(&self, height: f64) -> Side {
        if height > self.tolerance {
            Side::Outside
        } else if height < -self.tolerance {
            Side::Inside
        } else {
            Side::On
        }
    }

    /// Trims every face to its part inside, with new corners where edges cross the plane.
    fn cut_faces(&mut self, heights: &[f64], sides: &mut Vec<Side>) {
        let mut cuts: HashMap<[u32; 2], u32> = HashMap::new();
        for face in &mut self.faces {
            let corners = std::mem::take(&mut face.corners);
            let has = |wanted: Side| corners.iter().any(|&v| sides[v as usize] == wanted);
            if !has(Side::Inside) {
                continue;
            }
            if !has(Side::Outside) {
                face.corners = corners;
                continue;
            }
            for (i, &a) in corners.iter().enumerate() {
                let b = corners[(i + 1) % corners.len()];
                let (side_a, side_b) = (sides[a as usize], sides[b as usize]);
                if side_a != Side::Outside {
                    face.corners.push(a);
                }
                let crosses = matches!(
                    (side_a, side_b),
                    (Side::Inside, Side::Outside) | (Side::Outside, Side::Inside)
                );
                if crosses {
                    let edge = [a.min(b), a.max(b)];
                    let cut = *cuts.entry(edge).or_insert_with(|| {
                        self.points.push(crossing(&self.points, heights, edge));
                        sides.push(Side::On);
                        self.points.len() as u32 - 1
                    });
                    face.corners.push(cut);
                }
            }
        }
        self.faces.retain(|face| face.corners.len() >= 3);
    }

    /// The loop of edges left open by the cut, wound to face outwards; `None` unless it is one loop.
    fn cap(&self, sides: &[Side]) -> Option<Vec<u32>> {
        let on = |v: u32| sides[v as usize] == Side::On;
        let mut next: HashMap<u32, u32> = HashMap::new();
        let rim: HashSet<[u32; 2]> = self
            .faces
            .iter()
            .flat_map(|face| {
                let after = face.corners.iter().cycle().skip(1);
                face.corners.iter().zip(after).map(|(&a, &b)| [a, b])
            })
            .filter(|&[a, b]| on(a) && on(b))
            .collect();
        for &[a, b] in &rim {
            // An edge in both directions lies between two faces that stay: it is closed already.
            if !rim.contains(&[b, a]) && next.insert(b, a).is_some() {
                return None;
            }
        }
        let start = *next.keys().min()?;
        let mut corners = vec![start];
        let mut v = next.remove(&start)?;
        while v != start {
            corners.push(v);
            v = next.remove(&v)?;
        }
        (next.is_empty() && corners.len() >= 3).then_some(corners)
    }

    /// Says where the solid runs off to infinity, if it does.
    pub(super) fn opening(&self, planes: &[HalfSpace]) -> Option<String> {
        let open: Vec<&Face> =
            self.faces.iter().filter(|face| matches!(face.source, Source::Cube(_))).collect();
        if open.is_empty() {
            return None;
        }
        let sides: Vec<&str> = SIDES
            .iter()
            .enumerate()
            .filter(|(side, _)| open.iter().any(|face| face.source == Source::Cube(*side)))
            .map(|(_, (_, words))| *words)
            .collect();
        let far = |v: &u32| open.iter().any(|face| face.corners.contains(v));
        let runaways: Vec<&str> = self
            .faces
            .iter()
            .filter(|face| face.corners.iter().any(far))
            .filter_map(|face| match face.source {
                Source::Plane(index) => Some(planes[index].name.as_str()),
                Source::Cube(_) => None,
            })
            .collect();
        let named = match runaways.as_slice() {
            [] => "there are no facets".to_owned(),
            [name] => format!("facet '{name}' has no end there"),
            [name, rest @ ..] => {
                format!("facet '{name}' and {} more have no end there", rest.len())
            }
        };
        Some(format!(
            "the solid is open towards {}: {named}; add the missing facets or correct their angles",
            sides.join(", ")
        ))
    }

    /// Joins the ends of edges shorter than the tolerance allows to tell apart.
    pub(super) fn collapse_short_edges(&mut self) {
        // Two cuts a tolerance apart on a shallow edge leave corners a few tolerances apart.
        let shortest = 8.0 * self.tolerance;
        let mut kept: Vec<u32> = (0..self.points.len() as u32).collect();
        for face in &self.faces {
            for (i, &a) in face.corners.iter().enumerate() {
                let b = face.corners[(i + 1) % face.corners.len()];
                if self.points[a as usize].distance(self.points[b as usize]) < shortest {
                    let (a, b) = (root(&kept, a), root(&kept, b));
                    kept[a.max(b) as usize] = a.min(b);
                }
            }
        }
        for face in &mut self.faces {
            for v in &mut face.corners {
                *v = root(&kept, *v);
            }
            face.corners.dedup();
            while face.corners.len() > 1 && face.corners.first() == face.corners.last() {
                face.corners.pop();
            }
        }
        self.faces.retain(|face| face.corners.len() >= 3);
    }

    /// Moves every corner to where its planes meet: the way there from a huge cube costs digits.
    ///
    /// The shift is the least-squares one, damped so that planes that hardly differ can't throw the
    /// corner along their common line.
    pub(super) fn sharpen(&mut self, planes: &[HalfSpace]) {
        const DAMPING: f64 = 1e-9;
        let mut systems = vec![(DMat3::IDENTITY * DAMPING, DVec3::ZERO); self.points.len()];
        for face in &self.faces {
            let Source::Plane(index) = face.source else { continue };
            let HalfSpace { normal, distance, .. } = &planes[index];
            let outer =
                DMat3::from_cols(*normal * normal.x, *normal * normal.y, *normal * normal.z);
            for &v in &face.corners {
                let (matrix, residual) = &mut systems[v as usize];
                *matrix += outer;
                *residual += *normal * (distance - normal.dot(self.points[v as usize]));
            }
        }
        for (point, (matrix, residual)) in self.points.iter_mut().zip(systems) {
            *point += matrix.inverse() * residual;
        }
    }

    /// The corners still in use and, for each of `count` planes, its loop; empty if it bounds nothing.
    pub(super) fn compact(&self, count: usize) -> (Vec<DVec3>, Vec<Vec<u32>>) {
        let mut loops = vec![Vec::new(); count];
        let mut vertices = Vec::new();
        let mut index_of: HashMap<u32, u32> = HashMap::new();
        let mut faces: Vec<&Face> = self.faces.iter().collect();
        faces.sort_by_key(|face| match face.source {
            Source::Plane(index) | Source::Cube(index) => index,
        });
        for face in faces {
            let Source::Plane(index) = face.source else { continue };
            loops[index] = face
                .corners
                .iter()
                .map(|&v| {
                    *index_of.entry(v).or_insert_with(|| {
                        vertices.push(self.points[v as usize]);
                        vertices.len() as u32 - 1
                    })
                })
                .collect();
        }
        (vertices, loops)
    }
}

/// Where the edge crosses height 0, computed from its inside end for the same result either way.
fn crossing(points: &[DVec3], heights: &[f64], [a, b]: [u32; 2]) -> DVec3 {
    let (height_a, height_b) = (heights[a as usize], heights[b as usize]);
    let t = height_a / (height_a - height_b);
    points[a as usize] + (points[b as usize] - points[a as usize]) * t
}

fn root(kept: &[u32], mut v: u32) -> u32 {
    while kept[v as usize] != v {
        v = kept[v as usize];
    }
    v
}
