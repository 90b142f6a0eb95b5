//! Joins vertices at equal positions.

use glam::Vec3;
use rayon::slice::ParallelSliceMut;

/// Leaves in `positions` the different ones that `triangles` use, in their order, and returns for
/// each vertex its new index (0 for unused ones).
///
/// Positions are equal when their coordinates are; −0 equals 0. Sorted rather than hashed, so that
/// no choice of positions makes it slow.
pub(super) fn weld(positions: &mut Vec<Vec3>, triangles: &[[u32; 3]]) -> Vec<u32> {
    let mut used = vec![false; positions.len()];
    for v in triangles.iter().flatten() {
        used[*v as usize] = true;
    }
    let mut keys: Vec<u128> =
        (0..positions.len()).filter(|&v| used[v]).map(|v| key(positions[v], v as u32)).collect();
    keys.par_sort_unstable();

    // The first of each run of equal positions stands for all of them.
    let mut first_of: Vec<u32> = (0..positions.len() as u32).collect();
    for run in keys.chunk_by(|a, b| a >> 32 == b >> 32) {
        for key in run {
            first_of[*key as u32 as usize] = run[0] as u32;
        }
    }
    let mut count = 0;
    let mut index_of = vec![0; positions.len()];
    for v in (0..positions.len()).filter(|&v| used[v]) {
        let first = first_of[v] as usize;
        if first == v {
            positions[count] = positions[v];
            index_of[v] = count as u32;
            count += 1;
        } else {
            index_of[v] = index_of[first];
        }
    }
    positions.truncate(count);
    index_of
}

/// The bits of the position above the index of the vertex.
fn key(position: Vec3, index: u32) -> u128 {
    // Adding 0 turns −0 into 0.
    let bits = position.to_array().map(|coordinate| u128::from((coordinate + 0.0).to_bits()));
    bits[0] << 96 | bits[1] << 64 | bits[2] << 32 | u128::from(index)
}
