//! Each edge that is seen is drawn once, and no other.

use brilliance_renderer::cuts::RoundBrilliant;
use brilliance_renderer::drawing::{FacetedBody, View, VisibleEdge};
use glam::DVec2;

use crate::bodies::*;

const VIEWS: [View; 3] = [View::FACE_UP, View::SIDE, View::PAVILION];

fn distinct(points: impl Iterator<Item = DVec2>) -> usize {
    let mut seen: Vec<DVec2> = Vec::new();
    for point in points {
        if !seen.iter().any(|other| other.distance(point) < 1e-6) {
            seen.push(point);
        }
    }
    seen.len()
}

fn assert_drawn_once(edges: &[VisibleEdge], what: &str) {
    for (index, a) in edges.iter().enumerate() {
        for b in &edges[..index] {
            let same =
                |b: [DVec2; 2]| a.ends[0].distance(b[0]) < 1e-6 && a.ends[1].distance(b[1]) < 1e-6;
            assert!(!same(b.ends) && !same([b.ends[1], b.ends[0]]), "{what}: {a:?} twice");
        }
    }
}

/// The facets that face the viewer tile the outline of a convex body: corners − edges + facets = 1
/// (Euler), with all edges between them and no other.
#[test]
fn what_is_seen_of_a_convex_body_is_one_tiling() {
    let mut objects = vec![brilliant(RoundBrilliant::default()), step_cut(), octahedron()];
    objects.extend(shipped());
    for object in objects {
        let body = FacetedBody::of(&object).unwrap();
        for view in VIEWS {
            let edges = view.visible_edges(&body);
            let what = format!("{} {}", object.name, view.caption);
            assert_drawn_once(&edges, &what);
            let corners = distinct(edges.iter().flat_map(|edge| edge.ends)) as i64;
            let facets = (0..body.facets.len()).filter(|&f| view.faces(&body, f)).count() as i64;
            assert_eq!(corners - edges.len() as i64 + facets, 1, "{what}");
        }
    }
}

/// 33 facets with 32 corners above the girdle make 64 edges, 24 with 25 below it make 48.
#[test]
fn a_brilliant_has_64_edges_above_and_48_below() {
    let body = FacetedBody::of(&brilliant(RoundBrilliant::default())).unwrap();
    assert_eq!(View::FACE_UP.visible_edges(&body).len(), 64);
    assert_eq!(View::PAVILION.visible_edges(&body).len(), 48);
    for view in [View::FACE_UP, View::PAVILION] {
        let outline = view.visible_edges(&body).iter().filter(|edge| edge.is_outline).count();
        assert_eq!(outline, 16, "the girdle");
    }
}

#[test]
fn an_arm_hides_what_lies_under_it() {
    let body = FacetedBody::of(&c_beam()).unwrap();
    assert!(!body.is_convex);
    let edges = View::FACE_UP.visible_edges(&body);
    let has = |a: [f64; 2], b: [f64; 2]| {
        let (a, b) = (DVec2::from(a), DVec2::from(b));
        edges.iter().any(|edge| {
            let [c, d] = edge.ends;
            (c.distance(a) < 1e-6 && d.distance(b) < 1e-6)
                || (c.distance(b) < 1e-6 && d.distance(a) < 1e-6)
        })
    };
    for y in [-1.0, 1.0] {
        assert!(has([0.0, y], [3.0, y]), "the upper arm's side");
        assert!(has([3.0, y], [4.0, y]), "the lower arm's side, from under the upper one on");
    }
    for x in [0.0, 3.0, 4.0] {
        assert!(has([x, -1.0], [x, 1.0]), "an end at {x}");
    }
    assert_eq!(edges.len(), 7, "the corner between spine and lower arm is hidden: {edges:?}");
}

/// Brute force: a point of an edge is drawn if and only if a facet beside it faces the viewer and no
/// facet stands before it.
#[test]
fn hidden_edges_agree_with_looking_at_each_point() {
    let body = FacetedBody::of(&c_beam()).unwrap();
    // Turned so that no two edges lie behind each other.
    let toward = glam::DVec3::new(0.43, -0.32, 0.84).normalize_or_zero();
    let right = glam::DVec3::Y.cross(toward).normalize_or_zero();
    let view = View { caption: "askew", right, up: toward.cross(right), toward };
    let drawn = view.visible_edges(&body);
    let (mut seen_points, mut hidden_points) = (0, 0);
    for (index, edge) in body.edges.iter().enumerate() {
        for step in 1..40 {
            let [a, b] = edge.ends.map(|v| body.vertices[v as usize]);
            let point = a.lerp(b, (f64::from(step) + 0.31) / 41.0);
            let facing = edge.facets.iter().any(|f| view.faces(&body, *f as usize));
            let hidden = body.triangles.iter().any(|corners| {
                let [a, b, c] = corners.map(|v| body.vertices[v as usize]);
                let normal = (b - a).cross(c - a);
                let t = (a - point).dot(normal) / toward.dot(normal);
                let hit = point + t * toward;
                let inside = |p: glam::DVec3, q: glam::DVec3| (q - p).cross(hit - p).dot(normal);
                t > 1e-4 && inside(a, b) >= 0.0 && inside(b, c) >= 0.0 && inside(c, a) >= 0.0
            });
            let at = view.project(point);
            let covered = drawn.iter().filter(|part| part.edge == index).any(|part| {
                let [c, d] = part.ends;
                let t = (at - c).dot(d - c) / (d - c).length_squared();
                (0.0..=1.0).contains(&t)
            });
            assert_eq!(covered, facing && !hidden, "edge {index} at {point}");
            if covered { seen_points += 1 } else { hidden_points += 1 }
        }
    }
    assert!(seen_points > 300 && hidden_points > 200, "{seen_points} and {hidden_points}");
}
