//! Flat facets of a triangle mesh.

use glam::{DVec3, Vec3};
use rayon::slice::ParallelSliceMut;

use super::edges::Edges;

/// Distance from the facet's plane within which a vertex lies on it, over the mesh's largest
/// coordinate: 16 units in the last place of an `f32`, as node transforms and exporters leave them.
/// A sphere of a million triangles bends thirty times more from one triangle to the next.
const FLATNESS: f64 = 16.0 * (f32::EPSILON as f64) / 2.0;

const NONE: u32 = u32::MAX;

/// Numbers the facets in the order of their first triangles.
///
/// Each facet grows over edges from its largest triangle, whose plane is the most certain, and
/// takes what lies in that plane; a smooth surface therefore can't creep into one facet.
pub(super) fn flat_facets(positions: &[Vec3], triangles: &[[u32; 3]], edges: &Edges) -> Vec<u32> {
    let normals: Vec<DVec3> = triangles.iter().map(|t| doubled_area(positions, *t)).collect();
    let largest = positions.iter().map(|p| p.abs().max_element()).fold(0.0, f32::max);
    let tolerance = FLATNESS * f64::from(largest);
    let across = edges.across();

    let mut facet = vec![NONE; triangles.len()];
    let mut front = Vec::new();
    for seed in by_area(&normals) {
        if facet[seed as usize] != NONE {
            continue;
        }
        let normal = normals[seed as usize].normalize_or_zero();
        let origin = positions[triangles[seed as usize][0] as usize].as_dvec3();
        let in_plane = |t: u32| {
            normal.dot(normals[t as usize]) >= 0.0
                && triangles[t as usize].iter().all(|&v| {
                    normal.dot(positions[v as usize].as_dvec3() - origin).abs() <= tolerance
                })
        };
        facet[seed as usize] = seed;
        front.push(seed);
        while let Some(t) = front.pop() {
            for &neighbour in &across[3 * t as usize..3 * t as usize + 3] {
                if neighbour != NONE && facet[neighbour as usize] == NONE && in_plane(neighbour) {
                    facet[neighbour as usize] = seed;
                    front.push(neighbour);
                }
            }
        }
    }
    renumber(&mut facet);
    facet
}

/// The triangles from the largest to the smallest.
fn by_area(doubled_areas: &[DVec3]) -> impl Iterator<Item = u32> {
    let mut keys: Vec<u64> = doubled_areas
        .iter()
        .enumerate()
        // The bits of a positive float sort as the float does.
        .map(|(t, area)| u64::from(!(area.length() as f32).to_bits()) << 32 | t as u64)
        .collect();
    keys.par_sort_unstable();
    keys.into_iter().map(|key| key as u32)
}

/// Twice the area vector of a triangle.
fn doubled_area(positions: &[Vec3], corners: [u32; 3]) -> DVec3 {
    let [a, b, c] = corners.map(|v| positions[v as usize].as_dvec3());
    (b - a).cross(c - a)
}

/// Replaces each seed by a count from 0.
fn renumber(facet: &mut [u32]) {
    let mut number_of = vec![NONE; facet.len()];
    let mut count = 0;
    for seed in facet {
        let number = &mut number_of[*seed as usize];
        if *number == NONE {
            *number = count;
            count += 1;
        }
        *seed = *number;
    }
}
