//! The noise of a film in the memory of a graphics device.

use bytemuck::{Pod, Zeroable};
use wgpu::{Buffer, BufferUsages, ComputePipeline};

use super::region::COLUMNS_PER_GROUP;
use super::{Band, GpuDeveloper};
use crate::error::RendererError;
use crate::film::{BUCKETS, NoiseHistogram, typical_brightness};
use crate::settings::NoiseGoal;
use crate::spectrum::Bins;

/// A band as the shaders know it, and what is wanted of its noise.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
struct NoiseRows {
    /// Pixels in a row.
    width: u32,
    row_count: u32,
    bin_count: u32,
    /// The row of the sums that the first row's sums are written to.
    first_sum: u32,
    /// The square of the mean of the roots of the brightness of all pixels.
    typical_brightness: f32,
    /// The noise at which pixels are settled.
    noise_target: f32,
    /// Whether pixels settle at all.
    is_adaptive: u32,
    padding: u32,
}

impl GpuDeveloper {
    /// The noise of a film of `size` pixels in `bands`, as
    /// [`Film::measure_noise`](crate::film::Film::measure_noise) finds it. Marks in the bands the
    /// pixels that later passes leave out by `goal`. Behind the counts of a band's rows there must be a word
    /// for each pixel. Neighbours in another band are not looked at.
    ///
    /// # Errors
    /// The device fails.
    pub(crate) fn measure_noise(
        &self,
        [width, height]: [u32; 2],
        bins: Bins,
        bands: &[Band],
        goal: NoiseGoal,
    ) -> Result<f32, RendererError> {
        let mut rows = NoiseRows {
            width,
            bin_count: bins.count() as u32,
            noise_target: goal.target,
            is_adaptive: goal.adapts().into(),
            ..NoiseRows::zeroed()
        };
        let groups = width.div_ceil(COLUMNS_PER_GROUP);
        let sums =
            self.run_over(&self.pipelines.sum_roots, rows, bands, groups, groups * height)?;
        let roots: f64 = sums.into_iter().map(|sum| f64::from(f32::from_bits(sum))).sum();
        rows.typical_brightness = typical_brightness(roots, width as usize * height as usize);
        let counts = self.run_over(&self.pipelines.noise, rows, bands, width, BUCKETS as u32)?;
        Ok(NoiseHistogram::of_counts(counts).percentile_98())
    }

    /// What `pipeline` makes of all bands, in `columns` columns each: `words` words, which are 0
    /// before.
    fn run_over(
        &self,
        pipeline: &ComputePipeline,
        rows: NoiseRows,
        bands: &[Band],
        columns: u32,
        words: u32,
    ) -> Result<Vec<u32>, RendererError> {
        let made = self.graphics.guard("measure the noise", |device| {
            let made = device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("noise"),
                size: u64::from(words) * size_of::<u32>() as u64,
                usage: BufferUsages::STORAGE | BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            });
            let rows = bands.iter().map(|band| {
                let rows = NoiseRows { row_count: band.rows, first_sum: band.first_row, ..rows };
                self.buffer(device, BufferUsages::UNIFORM, bytemuck::bytes_of(&rows))
            });
            let rows: Vec<_> = rows.collect();
            let runs = bands.iter().zip(&rows).map(|(band, rows)| {
                let resources = [rows, &band.buffer, &made].map(Buffer::as_entire_binding);
                ([columns, band.rows], resources.to_vec())
            });
            self.submit(device, pipeline, runs);
            made
        })?;
        let bytes = self.graphics.read_buffer(&made)?;
        Ok(bytes.chunks_exact(size_of::<u32>()).map(bytemuck::pod_read_unaligned).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::super::source;
    use super::*;
    use crate::shaders::layout::{assert_twins, parse};
    use crate::shaders::{NOISE, ROOTS};

    #[test]
    fn the_shaders_read_rows_as_they_are_written() {
        for modules in [NOISE, ROOTS] {
            let module = parse(&source(modules));
            assert_twins!(
                &module,
                NoiseRows {
                    width,
                    row_count,
                    bin_count,
                    first_sum,
                    typical_brightness,
                    noise_target,
                    is_adaptive,
                    padding,
                }
            );
        }
    }
}
