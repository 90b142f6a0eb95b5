//! A film in the memory of a graphics device.

use wgpu::BufferUsages;

use crate::develop::Band;
use crate::error::RendererError;
use crate::film::{Counts, Film};
use crate::gpu::Graphics;
use crate::settings::TraceSettings;
use crate::spectrum::Bins;

/// A film in the memory of a graphics device: bands of rows, each in a buffer that a shader can be
/// given whole.
#[derive(Debug)]
pub struct GpuFilm {
    size: [u32; 2],
    bins: Bins,
    passes: u32,
    bands: Vec<Band>,
}

impl GpuFilm {
    /// An empty film, in the buffers of `used` as far as they are large enough.
    ///
    /// # Errors
    /// The device's memory is full, a single row is larger than the device takes, or it fails.
    pub(super) fn new(
        graphics: &Graphics,
        size: [u32; 2],
        bins: Bins,
        used: Option<Self>,
    ) -> Result<Self, RendererError> {
        let row_bytes = Film::bytes([size[0], 1], bins.count() as u32);
        let band_rows = (graphics.largest_binding() / row_bytes.max(1)).min(u64::from(size[1]));
        let is_for_walkers = bins.count() as u32 <= *TraceSettings::BINS.end();
        if band_rows == 0 || size[0] == 0 || !is_for_walkers {
            return Err(RendererError::Graphics(format!(
                "the graphics device {} can't hold a film of {} × {} pixels and {} bins; choose a \
                 smaller picture, or trace on the CPU",
                graphics.name(),
                size[0],
                size[1],
                bins.count()
            )));
        }
        let used = used.map_or_else(Vec::new, |film| film.bands);
        let mut used = used.into_iter().map(|band| band.buffer);
        let mut film = Self { size, bins, passes: 0, bands: Vec::new() };
        for first_row in (0..size[1]).step_by(band_rows as usize) {
            let rows = (size[1] - first_row).min(band_rows as u32);
            let bytes = u64::from(rows) * row_bytes;
            let buffer = match used.next().filter(|buffer| buffer.size() >= bytes) {
                Some(buffer) => buffer,
                None => create(graphics, bytes)?,
            };
            film.bands.push(Band { first_row, rows, buffer });
        }
        // What the device still works on in a cancelled film comes before this.
        graphics.submit("clear the film", |encoder| {
            for band in &film.bands {
                encoder.clear_buffer(&band.buffer, 0, Some(u64::from(band.rows) * row_bytes));
            }
        })?;
        Ok(film)
    }

    /// Width and height in pixels.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// The division of the spectrum.
    pub fn bins(&self) -> Bins {
        self.bins
    }

    /// Complete passes in the sums.
    pub fn passes(&self) -> u32 {
        self.passes
    }

    /// The sums and the counts.
    pub fn bands(&self) -> &[Band] {
        &self.bands
    }

    /// Counts passes that were added to the sums.
    pub(super) fn complete_passes(&mut self, passes: u32) {
        self.passes += passes;
    }

    /// A copy in the processor's memory.
    ///
    /// # Errors
    /// The device fails.
    pub(super) fn read(&self, graphics: &Graphics) -> Result<Film, RendererError> {
        let [width, height] = self.size.map(|side| side as usize);
        let mut sums = vec![0.0_f32; width * height * self.bins.count()];
        let mut counts = vec![Counts::default(); width * height];
        let (mut sums_left, mut counts_left) = (&mut sums[..], &mut counts[..]);
        for band in &self.bands {
            let pixels = band.rows as usize * width;
            let sums = sums_left.split_off_mut(..pixels * self.bins.count()).unwrap_or_default();
            let sums: &mut [u8] = bytemuck::cast_slice_mut(sums);
            graphics.fetch(&band.buffer, 0, sums)?;
            let counts = counts_left.split_off_mut(..pixels).unwrap_or_default();
            let counts = bytemuck::cast_slice_mut(counts);
            graphics.fetch(&band.buffer, sums.len() as u64, counts)?;
        }
        Ok(Film::from_sums(self.size, self.bins, (sums, counts), self.passes))
    }
}

fn create(graphics: &Graphics, bytes: u64) -> Result<wgpu::Buffer, RendererError> {
    graphics.guard("hold the film", |device| {
        device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("film"),
            size: bytes,
            usage: BufferUsages::STORAGE | BufferUsages::COPY_SRC | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        })
    })
}
