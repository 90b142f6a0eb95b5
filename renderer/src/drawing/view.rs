//! Looking at a body from far away: which edges are seen, and where.

use glam::{DVec2, DVec3};

use super::body::FacetedBody;

/// A facet faces the viewer if the cosine between its normal and the way to the viewer is more.
const FACING: f64 = 1e-6;
/// How far above a point a surface must lie to hide it, over the body's size.
const ABOVE: f64 = 1e-6;

/// An orthographic view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// What the figure is called.
    pub caption: &'static str,
    /// The way to the right on paper, in the body's frame.
    pub right: DVec3,
    /// The way up on paper.
    pub up: DVec3,
    /// The way to the viewer.
    pub toward: DVec3,
}

/// An edge as it is seen: millimetres to the right and up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VisibleEdge {
    /// Its ends, or those of the part that is seen.
    pub ends: [DVec2; 2],
    /// Its index among the body's edges.
    pub edge: usize,
    /// The body turns away behind it.
    pub is_outline: bool,
}

impl View {
    /// Straight down on the table.
    pub const FACE_UP: Self =
        Self { caption: "Crown, face-up", right: DVec3::X, up: DVec3::Y, toward: DVec3::Z };
    /// Along the girdle plane, from below on the paper of the face-up view.
    pub const SIDE: Self =
        Self { caption: "Side", right: DVec3::X, up: DVec3::Z, toward: DVec3::NEG_Y };
    /// On the pavilion, with the stone turned over sideways.
    pub const PAVILION: Self =
        Self { caption: "Pavilion", right: DVec3::NEG_X, up: DVec3::Y, toward: DVec3::NEG_Z };

    /// Where a point of the body is seen.
    pub fn project(&self, point: DVec3) -> DVec2 {
        DVec2::new(self.right.dot(point), self.up.dot(point))
    }

    /// True if this facet of `body` turns its face to the viewer.
    pub fn faces(&self, body: &FacetedBody, facet: usize) -> bool {
        body.facets[facet].normal.dot(self.toward) > FACING
    }

    /// The edges of `body` that are seen, in parts where something stands before them.
    pub fn visible_edges(&self, body: &FacetedBody) -> Vec<VisibleEdge> {
        let seen: Vec<VisibleEdge> = body
            .edges
            .iter()
            .enumerate()
            .filter_map(|(edge, of_body)| {
                let facing = of_body.facets.map(|facet| self.faces(body, facet as usize));
                let ends = of_body.ends.map(|v| self.project(body.vertices[v as usize]));
                let is_outline = facing[0] != facing[1];
                (facing[0] || facing[1]).then_some(VisibleEdge { ends, edge, is_outline })
            })
            .collect();
        if body.is_convex {
            return seen;
        }
        let outline: Vec<_> = seen.iter().copied().filter(|edge| edge.is_outline).collect();
        let cover = Cover::new(self, body);
        seen.iter().flat_map(|edge| self.uncovered(body, &cover, *edge, &outline)).collect()
    }

    /// The parts of `edge` that nothing hides. What is seen of an edge can only change where it
    /// passes behind an outline.
    fn uncovered(
        &self,
        body: &FacetedBody,
        cover: &Cover,
        edge: VisibleEdge,
        outline: &[VisibleEdge],
    ) -> Vec<VisibleEdge> {
        let [start, end] = edge.ends;
        let mut cuts: Vec<f64> =
            outline.iter().filter_map(|other| crossing(edge.ends, other.ends)).collect();
        cuts.extend([0.0, 1.0]);
        cuts.sort_by(f64::total_cmp);
        cuts.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
        let depths = body.edges[edge.edge].ends.map(|v| self.toward.dot(body.vertices[v as usize]));
        let mut parts: Vec<[f64; 2]> = Vec::new();
        for pair in cuts.windows(2) {
            let [from, to] = [pair[0], pair[1]];
            let middle = 0.5 * (from + to);
            let depth = depths[0] + (depths[1] - depths[0]) * middle;
            if cover.hides(start.lerp(end, middle), depth) {
                continue;
            }
            match parts.last_mut() {
                Some(last) if last[1] == from => last[1] = to,
                _ => parts.push([from, to]),
            }
        }
        let part = |[from, to]: [f64; 2]| VisibleEdge {
            ends: [start.lerp(end, from), start.lerp(end, to)],
            ..edge
        };
        parts.into_iter().map(part).collect()
    }
}

/// The triangles that face the viewer, to be looked up from behind.
pub(super) struct Cover {
    triangles: Vec<[DVec3; 3]>,
    above: f64,
}

impl Cover {
    /// What `body` puts before things; nothing, if it is convex.
    pub(super) fn new(view: &View, body: &FacetedBody) -> Self {
        let (low, high) = body.bounds();
        let place = |v: u32| {
            let vertex = body.vertices[v as usize];
            view.project(vertex).extend(view.toward.dot(vertex))
        };
        let facing = |[a, b, c]: &[DVec3; 3]| {
            (b.truncate() - a.truncate()).perp_dot(c.truncate() - a.truncate()) > 0.0
        };
        let triangles = if body.is_convex { &[][..] } else { &body.triangles[..] };
        let triangles = triangles.iter().map(|corners| corners.map(place)).filter(facing).collect();
        Self { triangles, above: ABOVE * low.distance(high) }
    }

    /// True if a triangle stands before the point seen at `point`, at `depth` towards the viewer.
    pub(super) fn hides(&self, point: DVec2, depth: f64) -> bool {
        self.triangles.iter().any(|corners| {
            let [a, b, c] = corners.map(|corner| corner.truncate() - point);
            let weights = [b.perp_dot(c), c.perp_dot(a), a.perp_dot(b)];
            if weights.iter().any(|weight| *weight < 0.0) {
                return false;
            }
            let sum: f64 = weights.iter().sum();
            let height: f64 =
                weights.iter().zip(corners).map(|(weight, corner)| weight * corner.z).sum();
            height > (depth + self.above) * sum
        })
    }
}

/// Where on the first line, from 0 to 1, the second passes; `None` if it does not.
pub(super) fn crossing([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> Option<f64> {
    let (along, across) = (b - a, d - c);
    let turn = along.perp_dot(across);
    if turn.abs() <= 1e-12 * along.length() * across.length() {
        return None;
    }
    let (t, u) = ((c - a).perp_dot(across) / turn, (c - a).perp_dot(along) / turn);
    (t > 0.0 && t < 1.0 && (-1e-9..=1.0 + 1e-9).contains(&u)).then_some(t)
}
