//! One view of a body at its place on the sheet.

use glam::{DVec2, DVec3};

use super::body::FacetedBody;
use super::rect::Rect;
use super::sheet::{Ink, Sheet};
use super::view::{Cover, View, VisibleEdge, crossing};

/// Width of the pen for outlines, in mm.
const OUTLINE_MM: f64 = 0.42;
/// Width of the pen for edges between facets, in mm.
const EDGE_MM: f64 = 0.22;
/// A line this near to a corner seems to end there, in mm.
const NEAR_MM: f64 = 0.8;
/// How finely places in a facet are tried, per side.
const TRIES: u32 = 24;
/// Lengths that differ by less are equal but for rounding, in mm.
const ALIKE_MM: f64 = 1e-6;

/// A view of a body on paper.
pub(super) struct Figure<'a> {
    pub(super) body: &'a FacetedBody,
    pub(super) view: View,
    /// Millimetres of paper per millimetre of the body.
    scale: f64,
    /// Where the origin of the body's frame lies on paper.
    origin: DVec2,
    /// What is seen, on paper.
    pub(super) edges: Vec<VisibleEdge>,
    cover: Cover,
    /// The room that the body takes on paper.
    pub(super) bounds: Rect,
}

/// A place in a facet, and how far it is from the facet's edges.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub(super) at: DVec2,
    pub(super) clearance: f64,
}

impl<'a> Figure<'a> {
    /// `body` seen by `view`, with the middle of what is seen at `center`.
    pub(super) fn new(body: &'a FacetedBody, view: View, scale: f64, center: DVec2) -> Self {
        let flip = |seen: DVec2| DVec2::new(seen.x, -seen.y) * scale;
        let seen = body.vertices.iter().map(|vertex| flip(view.project(*vertex)));
        let seen = Rect::about(seen).unwrap_or(Rect::centered(DVec2::ZERO, DVec2::ZERO));
        let origin = center - seen.center();
        let bounds = Rect { min: seen.min + origin, max: seen.max + origin };
        let mut edges = view.visible_edges(body);
        for edge in &mut edges {
            edge.ends = edge.ends.map(|end| origin + flip(end));
        }
        let cover = Cover::new(&view, body);
        Self { body, view, scale, origin, edges, cover, bounds }
    }

    /// Where a point of the body lies on paper.
    pub(super) fn place(&self, point: DVec3) -> DVec2 {
        let seen = self.view.project(point);
        self.origin + self.scale * DVec2::new(seen.x, -seen.y)
    }

    /// Draws the edges, the outline last and stronger.
    pub(super) fn draw(&self, sheet: &mut Sheet) {
        for (is_outline, width_mm) in [(false, EDGE_MM), (true, OUTLINE_MM)] {
            for edge in self.edges.iter().filter(|edge| edge.is_outline == is_outline) {
                sheet.stroke(edge.ends, width_mm, Ink::Main);
            }
        }
    }

    /// The facet's edges on paper.
    pub(super) fn rim(&self, facet: usize) -> Vec<[DVec2; 2]> {
        let place = |v: u32| self.place(self.body.vertices[v as usize]);
        self.body.facets[facet].rim.iter().map(|ends| ends.map(place)).collect()
    }

    /// How much the line `ends` disturbs the drawing: the edges that it crosses, and those whose ends
    /// it passes so closely that it seems to belong to them.
    pub(super) fn disturbance(&self, ends: [DVec2; 2]) -> usize {
        let crossed = self.edges.iter().filter(|edge| crossing(ends, edge.ends).is_some());
        // A corner counts for each of the edges that end there.
        let corners = self.edges.iter().flat_map(|edge| edge.ends);
        let near = corners.filter(|corner| distance(*corner, ends) < NEAR_MM);
        crossed.count() + near.count()
    }

    /// How far the body reaches to the right (`side` 1) or left (−1) at the heights from `top` to
    /// `bottom`; `None` where there is nothing.
    pub(super) fn reach(&self, side: f64, [top, bottom]: [f64; 2]) -> Option<f64> {
        self.edges
            .iter()
            .filter(|edge| edge.is_outline)
            .filter_map(|edge| clipped(edge.ends, [top, bottom]))
            .flatten()
            .map(|point| side * point.x)
            .reduce(f64::max)
            .map(|reach| side * reach)
    }

    /// The place in `facet` that is farthest from its edges and has room for a box of `size`.
    pub(super) fn spot(&self, facet: usize, size: DVec2) -> Option<Spot> {
        if !self.view.faces(self.body, facet) {
            return None;
        }
        let rim = self.rim(facet);
        let bounds = Rect::about(rim.iter().flatten().copied())?;
        let room = bounds.size() - size;
        if room.min_element() <= 0.0 {
            return None;
        }
        let mut best: Option<Spot> = None;
        for (column, row) in (0..=TRIES).flat_map(|c| (0..=TRIES).map(move |r| (c, r))) {
            let fraction = DVec2::new(f64::from(column), f64::from(row)) / f64::from(TRIES);
            let at = bounds.center() + room * (fraction - 0.5);
            let rect = Rect::centered(at, size);
            if !is_inside(at, &rim) || rim.iter().any(|edge| rect.is_crossed_by(*edge)) {
                continue;
            }
            let clearance = rim
                .iter()
                .flat_map(|edge| rect.corners().map(|corner| distance(corner, *edge)))
                .fold(f64::INFINITY, f64::min);
            let spot = Spot { at, clearance };
            let off_center = |spot: &Spot| spot.at.distance(bounds.center());
            // A later place must be better, not only otherwise rounded.
            let is_better = best.is_none_or(|best| {
                clearance > best.clearance + ALIKE_MM
                    || (clearance > best.clearance - ALIKE_MM
                        && off_center(&spot) < off_center(&best) - ALIKE_MM)
            });
            if is_better && self.is_seen(facet, rect) {
                best = Some(spot);
            }
        }
        best
    }

    /// Places in `facet` where a leader may end: that farthest from the edges, and others that are
    /// nearly as far from them.
    pub(super) fn footholds(&self, facet: usize) -> Vec<DVec2> {
        const AWAY: [f64; 2] = [0.45, 0.8];
        let Some(best) = self.spot(facet, DVec2::ZERO) else { return Vec::new() };
        let rim = self.rim(facet);
        let clearance =
            |at: DVec2| rim.iter().map(|edge| distance(at, *edge)).fold(f64::INFINITY, f64::min);
        let others = rim
            .iter()
            .flat_map(|[a, b]| AWAY.map(|fraction| best.at.lerp(0.5 * (*a + *b), fraction)));
        let others = others.filter(|at| {
            is_inside(*at, &rim)
                && clearance(*at) > 0.75 * best.clearance
                && self.is_seen(facet, Rect::centered(*at, DVec2::ZERO))
        });
        std::iter::once(best.at).chain(others).collect()
    }

    /// True if nothing stands before `rect` on `facet`.
    fn is_seen(&self, facet: usize, rect: Rect) -> bool {
        if self.body.is_convex {
            return true;
        }
        let normal = self.body.facets[facet].normal;
        let Some([on_it, _]) = self.body.facets[facet].rim.first() else { return false };
        let distance = normal.dot(self.body.vertices[*on_it as usize]);
        let View { right, up, toward, .. } = self.view;
        let seen = (rect.center() - self.origin) / self.scale * DVec2::new(1.0, -1.0);
        let depth = (distance - normal.dot(right * seen.x + up * seen.y)) / normal.dot(toward);
        !self.cover.hides(seen, depth) && !self.edges.iter().any(|e| rect.is_crossed_by(e.ends))
    }
}

/// Whether `point` lies within the edges `rim`, in any order (even-odd rule).
fn is_inside(point: DVec2, rim: &[[DVec2; 2]]) -> bool {
    let crossed = rim.iter().filter(|[a, b]| {
        (a.y > point.y) != (b.y > point.y)
            && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)
    });
    crossed.count() % 2 == 1
}

/// Distance of `point` from a line with ends.
fn distance(point: DVec2, [a, b]: [DVec2; 2]) -> f64 {
    let along = b - a;
    let t =
        ((point - a).dot(along) / along.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    point.distance(a + t * along)
}

/// The part of a line at the heights from `top` to `bottom`.
fn clipped([a, b]: [DVec2; 2], [top, bottom]: [f64; 2]) -> Option<[DVec2; 2]> {
    let (low, high) = (a.y.min(b.y), a.y.max(b.y));
    if high < top || low > bottom {
        return None;
    }
    let at = |y: f64| {
        let t = if b.y == a.y { 0.0 } else { ((y - a.y) / (b.y - a.y)).clamp(0.0, 1.0) };
        a.lerp(b, t)
    };
    Some(if a.y == b.y { [a, b] } else { [at(top), at(bottom)] })
}
