//! Which triangles meet at which edges, and what is wrong with a mesh that is not closed.

use glam::Vec3;
use rayon::slice::ParallelSliceMut;

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

/// The half-edges of a triangle list; half-edge 3t + k runs from corner k to corner k + 1 of
/// triangle t.
pub(super) struct Edges {
    /// Lower vertex, higher vertex and half-edge, packed in this order and sorted.
    half_edges: Vec<u128>,
    /// Whether the half-edge runs from the higher vertex to the lower.
    reversed: Vec<bool>,
}

impl Edges {
    pub(super) fn new(triangles: &[[u32; 3]]) -> Self {
        let ends = triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
        let mut half_edges: Vec<u128> = ends
            .clone()
            .enumerate()
            .map(|(i, (a, b))| u128::from(a.min(b)) << 64 | u128::from(a.max(b)) << 32 | i as u128)
            .collect();
        half_edges.par_sort_unstable();
        Self { half_edges, reversed: ends.map(|(a, b)| a > b).collect() }
    }

    /// The half-edges of one edge after the other.
    fn groups(&self) -> impl Iterator<Item = &[u128]> {
        self.half_edges.chunk_by(|a, b| a >> 32 == b >> 32)
    }

    /// Per half-edge the triangle across it, or [`u32::MAX`] where there is not exactly one.
    pub(super) fn across(&self) -> Vec<u32> {
        let mut across = vec![u32::MAX; self.half_edges.len()];
        for group in self.groups() {
            if let [a, b] = *group {
                across[a as u32 as usize] = b as u32 / 3;
                across[b as u32 as usize] = a as u32 / 3;
            }
        }
        across
    }

    /// The edges that keep the mesh from being closed.
    pub(super) fn fault(&self, positions: &[Vec3]) -> Option<MeshFault> {
        let mut counts = [0; 3];
        let mut first = [None; 3];
        for group in self.groups() {
            let kind = match *group {
                [_] => 0,
                [a, b] if self.reversed[a as u32 as usize] != self.reversed[b as u32 as usize] => {
                    continue;
                }
                [_, _] => 2,
                _ => 1,
            };
            counts[kind] += 1;
            first[kind].get_or_insert(group[0]);
        }
        let edge = first.into_iter().flatten().next()?;
        let end = |shift: u32| positions[(edge >> shift) as u32 as usize];
        let [open, crowded, miswound] = counts;
        Some(MeshFault::Edges { open, crowded, miswound, first: [end(64), end(32)] })
    }
}
