//! Which triangles meet at which edges, and what is wrong with a mesh that is not closed.

use glam::Vec3;

/// Why a mesh encloses no volume.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MeshFault {
    /// Edges that do not join exactly two triangles of equal winding.
    #[error("{}", edge_words(*open, *crowded, *miswound, *first))]
    Edges {
        /// Edges of a single triangle: the rim of a hole.
        open: usize,
        /// Edges of three triangles or more.
        crowded: usize,
        /// Edges whose two triangles face opposite sides.
        miswound: usize,
        /// Ends of the first edge found of the worst kind: open, then crowded, then miswound.
        first: [Vec3; 2],
    },
    /// Closed, but without volume.
    #[error("it is flat and encloses no volume")]
    Flat,
}

fn edge_words(open: usize, crowded: usize, miswound: usize, [a, b]: [Vec3; 2]) -> String {
    let kinds = [
        (open, "open (a hole)"),
        (crowded, "shared by more than two triangles"),
        (miswound, "wound inconsistently (neighbours face opposite sides)"),
    ];
    let counts: Vec<String> = kinds
        .iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, words)| {
            format!("{count} {} {words}", if *count == 1 { "edge is" } else { "edges are" })
        })
        .collect();
    format!("{}; the first runs from {a} to {b}", counts.join(", "))
}

/// The half-edges of a triangle list, sorted by edge; half-edge 3t + k runs from corner k to corner
/// k + 1 of triangle t.
pub(super) struct Edges {
    /// Where the edges with each lower vertex begin in `half_edges`, and the end.
    start: Vec<u32>,
    half_edges: Vec<HalfEdge>,
}

/// Higher vertex (32 bits), half-edge (31 bits), and whether it runs from the higher vertex to the
/// lower (1 bit): packed so that sorting brings the half-edges of one edge together.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
struct HalfEdge(u64);

impl HalfEdge {
    fn new(index: usize, from: u32, to: u32) -> Self {
        Self(u64::from(from.max(to)) << 32 | (index as u64) << 1 | u64::from(from > to))
    }

    fn higher_vertex(self) -> u32 {
        (self.0 >> 32) as u32
    }

    fn index(self) -> usize {
        (self.0 as u32 >> 1) as usize
    }

    fn triangle(self) -> u32 {
        self.index() as u32 / 3
    }

    fn is_reversed(self) -> bool {
        self.0 & 1 == 1
    }
}

impl Edges {
    pub(super) fn new(triangles: &[[u32; 3]], vertex_count: usize) -> Self {
        let ends = triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
        let mut start = vec![0_u32; vertex_count + 1];
        for (from, to) in ends.clone() {
            start[from.min(to) as usize + 1] += 1;
        }
        for v in 0..vertex_count {
            start[v + 1] += start[v];
        }
        let mut next = start.clone();
        let mut half_edges = vec![HalfEdge::default(); 3 * triangles.len()];
        for (index, (from, to)) in ends.enumerate() {
            let place = &mut next[from.min(to) as usize];
            half_edges[*place as usize] = HalfEdge::new(index, from, to);
            *place += 1;
        }
        for bounds in start.windows(2) {
            half_edges[bounds[0] as usize..bounds[1] as usize].sort_unstable();
        }
        Self { start, half_edges }
    }

    /// The lower vertex and the half-edges of one edge after the other.
    fn groups(&self) -> impl Iterator<Item = (usize, &[HalfEdge])> {
        self.start.windows(2).enumerate().flat_map(|(lower, bounds)| {
            self.half_edges[bounds[0] as usize..bounds[1] as usize]
                .chunk_by(|a, b| a.higher_vertex() == b.higher_vertex())
                .map(move |group| (lower, group))
        })
    }

    /// Per half-edge the triangle across it, or [`u32::MAX`] where there is not exactly one.
    pub(super) fn across(&self) -> Vec<u32> {
        let mut across = vec![u32::MAX; self.half_edges.len()];
        for (_, group) in self.groups() {
            if let [a, b] = *group {
                across[a.index()] = b.triangle();
                across[b.index()] = a.triangle();
            }
        }
        across
    }

    /// The edges that keep the mesh from being closed.
    pub(super) fn fault(&self, positions: &[Vec3]) -> Option<MeshFault> {
        let mut counts = [0; 3];
        let mut first = [None; 3];
        for (lower, group) in self.groups() {
            let kind = match *group {
                [_] => 0,
                [a, b] if a.is_reversed() != b.is_reversed() => continue,
                [_, _] => 2,
                _ => 1,
            };
            counts[kind] += 1;
            first[kind].get_or_insert([lower, group[0].higher_vertex() as usize]);
        }
        let first = first.into_iter().flatten().next()?.map(|v| positions[v]);
        let [open, crowded, miswound] = counts;
        Some(MeshFault::Edges { open, crowded, miswound, first })
    }
}
