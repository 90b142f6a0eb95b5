//! The mean spectrum of a region of a film in the memory of a graphics device.

use bytemuck::{Pod, Zeroable};
use wgpu::BufferUsages;

use super::{Band, GpuDeveloper};
use crate::error::RendererError;
use crate::film::{PixelRect, mean_of_pixels};
use crate::spectrum::Bins;

/// Columns that are added up before their sum is added to that of the row.
pub(super) const COLUMNS_PER_GROUP: u32 = 64;

/// The rows of a region that lie in one band, as the shader knows them.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
struct RegionRows {
    /// Pixels in a row of the film.
    width: u32,
    /// The region's first column, and its first row as the band counts them.
    first_column: u32,
    first_row: u32,
    column_count: u32,
    row_count: u32,
    bin_count: u32,
    /// The row of the sums that the first row's sums are written to.
    first_sum: u32,
    /// Where the band's counts begin, in words.
    first_count: u32,
}

impl RegionRows {
    /// What lies in `band` of the region `rect` of a film of `width` columns; none where nothing
    /// does.
    fn in_band(rect: PixelRect, band: &Band, width: u32, bins: Bins) -> Option<Self> {
        let first = rect.min[1].max(band.first_row);
        let end = (rect.min[1] + rect.size[1]).min(band.first_row + band.rows);
        (first < end).then(|| Self {
            width,
            first_column: rect.min[0],
            first_row: first - band.first_row,
            column_count: rect.size[0],
            row_count: end - first,
            bin_count: bins.count() as u32,
            first_sum: first - rect.min[1],
            first_count: width * band.rows * bins.count() as u32,
        })
    }
}

impl GpuDeveloper {
    /// Mean spectral radiance of the pixels of `rect` that lie in a film of `size` pixels in
    /// `bands`, one value per bin; 0 where none does. A sum that is not finite counts as none.
    ///
    /// The device adds up rows of pixels' means; only those sums are read back.
    ///
    /// # Errors
    /// The device fails.
    pub fn mean_spectrum(
        &self,
        size: [u32; 2],
        bins: Bins,
        bands: &[Band],
        rect: PixelRect,
    ) -> Result<Vec<f32>, RendererError> {
        let Some(rect) = rect.within(size) else { return Ok(vec![0.0; bins.count()]) };
        let sums = self.graphics.guard("add up a region of the film", |device| {
            let sums = device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("sums of a region"),
                size: u64::from(rect.size[1]) * (bins.count() * size_of::<f32>()) as u64,
                usage: BufferUsages::STORAGE | BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            });
            let parts: Vec<_> = bands
                .iter()
                .filter_map(|band| Some((band, RegionRows::in_band(rect, band, size[0], bins)?)))
                .map(|(band, rows)| {
                    let usage = BufferUsages::UNIFORM;
                    (band, rows, self.buffer(device, usage, bytemuck::bytes_of(&rows)))
                })
                .collect();
            let runs = parts.iter().map(|(band, rows, uniform)| {
                let resources = [uniform, &band.buffer, &sums].map(wgpu::Buffer::as_entire_binding);
                ([rows.bin_count, rows.row_count], resources.to_vec())
            });
            self.submit(device, &self.pipelines.sum_rows, runs);
            sums
        })?;
        let bytes = self.graphics.read_buffer(&sums)?;
        let sums = bytes.chunks_exact(size_of::<f32>());
        let sums = sums.map(|sum| f64::from(bytemuck::pod_read_unaligned::<f32>(sum)));
        Ok(mean_of_pixels(sums, bins, rect.count()))
    }
}

#[cfg(test)]
mod tests {
    use super::super::source;
    use super::*;
    use crate::shaders::REGION;
    use crate::shaders::layout::{assert_twins, parse};

    #[test]
    fn the_shader_reads_a_region_as_it_is_written() {
        let module = parse(&source(REGION));
        assert_twins!(
            &module,
            RegionRows {
                width,
                first_column,
                first_row,
                column_count,
                row_count,
                bin_count,
                first_sum,
                first_count,
            }
        );
    }
}
