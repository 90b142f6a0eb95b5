//! From the film to CIE XYZ and mean counts on a graphics device.

use bytemuck::{Pod, Zeroable};
use wgpu::{BindingResource, BufferUsages};

use super::{GpuCountImage, GpuDeveloper, GpuXyzImage, exposed_texture};
use crate::error::RendererError;
use crate::spectrum::{Bins, Observer};

/// Rows of a film in the memory of a graphics device.
#[derive(Clone, Debug)]
pub struct Band {
    /// The film's row that is the band's first.
    pub first_row: u32,
    /// Number of rows.
    pub rows: u32,
    /// Sums as f32: radiance row by row, the bins of a pixel side by side, and behind those of all
    /// rows the [`Counts`](crate::film::Counts) of each pixel; behind those, where it is traced on,
    /// a word per pixel that is 1 where the pixel is settled. Its usage has `STORAGE`.
    pub buffer: wgpu::Buffer,
}

/// A band as the shader knows it.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
struct Rows {
    /// Pixels in a row.
    width: u32,
    /// The image's row that is the buffer's first.
    first_row: u32,
    row_count: u32,
    bin_count: u32,
}

impl GpuDeveloper {
    /// Integrates the means over the camera rays of the pixels of a film of `size` pixels in `bands`,
    /// and takes those of their counts. A pixel that holds a NaN or an infinity is black.
    ///
    /// # Errors
    /// The image is larger than the device's textures, or the device fails.
    pub fn expose(
        &self,
        size: [u32; 2],
        bins: Bins,
        bands: &[Band],
    ) -> Result<(GpuXyzImage, GpuCountImage), RendererError> {
        self.check_size(size)?;
        let [exposed, counted] = self.graphics.guard("expose the film", |device| {
            let textures = [(); 2].map(|()| exposed_texture(device, size));
            let [exposed, counted] = textures
                .each_ref()
                .map(|texture| texture.create_view(&wgpu::TextureViewDescriptor::default()));
            let weights = weights(bins);
            let weights =
                self.buffer(device, BufferUsages::STORAGE, bytemuck::cast_slice(&weights));
            let rows = bands.iter().map(|band| {
                let rows = Rows {
                    width: size[0],
                    first_row: band.first_row,
                    row_count: band.rows,
                    bin_count: bins.count() as u32,
                };
                self.buffer(device, BufferUsages::UNIFORM, bytemuck::bytes_of(&rows))
            });
            let rows: Vec<_> = rows.collect();
            let runs = bands.iter().zip(&rows).map(|(band, rows)| {
                let resources = vec![
                    rows.as_entire_binding(),
                    weights.as_entire_binding(),
                    band.buffer.as_entire_binding(),
                    BindingResource::TextureView(&exposed),
                    BindingResource::TextureView(&counted),
                ];
                ([size[0], band.rows], resources)
            });
            self.submit(device, &self.pipelines.expose, runs);
            textures
        })?;
        let counts = GpuCountImage::new(self.clone(), counted);
        Ok((GpuXyzImage::new(self.clone(), exposed, bins), counts))
    }

    /// A texture of this size can be made.
    fn check_size(&self, [width, height]: [u32; 2]) -> Result<(), RendererError> {
        let largest = self.graphics.device().limits().max_texture_dimension_2d;
        if (1..=largest).contains(&width) && (1..=largest).contains(&height) {
            return Ok(());
        }
        Err(RendererError::Graphics(format!(
            "the graphics device {} can't show {width} × {height} pixels: it takes 1 to {largest} \
             a side; choose another size, or trace on the CPU",
            self.graphics.name()
        )))
    }
}

/// What radiance 1 in each bin adds to X, Y and Z. The shader reads three of four.
fn weights(bins: Bins) -> Vec<[f32; 4]> {
    let weights = Observer::bin_weights(bins).into_iter();
    weights.map(|weight| weight.as_vec3().extend(0.0).to_array()).collect()
}

#[cfg(test)]
mod tests {
    use super::super::source;
    use super::*;
    use crate::shaders::EXPOSE;
    use crate::shaders::layout::{assert_twins, parse};

    #[test]
    fn the_shader_reads_rows_as_they_are_written() {
        let module = parse(&source(EXPOSE));
        assert_twins!(&module, Rows { width, first_row, row_count, bin_count });
    }
}
