//! From the device's memory to the processor's.

use std::fmt::Display;
use std::sync::mpsc::{Receiver, channel};

use wgpu::{BufferUsages, Extent3d, MapMode, TexelCopyBufferInfo, TexelCopyBufferLayout};

use super::Graphics;
use crate::error::RendererError;

/// Most bytes that are fetched at a time, which bounds the memory in between.
const CHUNK_BYTES: u64 = 32 << 20;

/// A buffer that the processor can read.
pub(crate) struct Readback {
    buffer: wgpu::Buffer,
}

/// The device's word, to be waited for, that what was asked for is there.
pub(crate) struct Arrival(Receiver<Result<(), wgpu::BufferAsyncError>>);

impl Readback {
    /// A buffer of `size` bytes, a multiple of 4.
    ///
    /// # Errors
    /// The device fails.
    pub(crate) fn new(graphics: &Graphics, size: u64) -> Result<Self, RendererError> {
        let descriptor = wgpu::BufferDescriptor {
            label: Some("readback"),
            size,
            usage: BufferUsages::MAP_READ | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        };
        let buffer =
            graphics.guard("make a buffer to read from", |d| d.create_buffer(&descriptor))?;
        Ok(Self { buffer })
    }

    /// The buffer, to copy to before [`request`](Self::request).
    pub(crate) fn buffer(&self) -> &wgpu::Buffer {
        &self.buffer
    }

    /// Asks for the content as all that was submitted so far will leave it.
    pub(crate) fn request(&self) -> Arrival {
        let (sender, arrival) = channel();
        self.buffer.map_async(MapMode::Read, .., move |result| {
            // Nobody listens any more where the wait was given up.
            let _ = sender.send(result);
        });
        Arrival(arrival)
    }

    /// Waits for the content that was asked for and lets `read` see it.
    ///
    /// # Errors
    /// The device fails.
    pub(crate) fn receive<T>(
        &self,
        graphics: &Graphics,
        arrival: &Arrival,
        read: impl FnOnce(&[u8]) -> T,
    ) -> Result<T, RendererError> {
        let refusal = |error: &dyn Display| {
            RendererError::Graphics(format!(
                "the graphics device {} does not hand over what it has made: {error}",
                graphics.name()
            ))
        };
        if let Some(arrived) = graphics.wait(&arrival.0)? {
            arrived.map_err(|error| refusal(&error))?;
        } else if self.buffer.get_mapped_range(..).is_err() {
            // The callback is gone, and the content is not there: once more.
            let _ = graphics.guard("give up a readback", |_| self.buffer.unmap());
            let arrived = graphics.wait(&self.request().0)?;
            arrived.transpose().map_err(|error| refusal(&error))?;
        }
        let view = self.buffer.get_mapped_range(..).map_err(|error| refusal(&error))?;
        let seen = read(&view);
        drop(view);
        self.buffer.unmap();
        Ok(seen)
    }
}

impl Graphics {
    /// The bytes of a buffer with usage `COPY_SRC` and a size that is a multiple of 4.
    ///
    /// # Errors
    /// The device fails.
    pub fn read_buffer(&self, buffer: &wgpu::Buffer) -> Result<Vec<u8>, RendererError> {
        let mut bytes = vec![0; buffer.size() as usize];
        self.fetch(buffer, 0, &mut bytes)?;
        Ok(bytes)
    }

    /// Fills `bytes` from byte `offset` on of a buffer with usage `COPY_SRC`; multiples of 4.
    ///
    /// # Errors
    /// The device fails.
    pub(crate) fn fetch(
        &self,
        buffer: &wgpu::Buffer,
        offset: u64,
        bytes: &mut [u8],
    ) -> Result<(), RendererError> {
        let chunk = Readback::new(self, (bytes.len() as u64).min(CHUNK_BYTES))?;
        for (number, part) in (0..).zip(bytes.chunks_mut(CHUNK_BYTES as usize)) {
            let (start, size) = (offset + number * CHUNK_BYTES, part.len() as u64);
            self.submit("read a buffer", |encoder| {
                encoder.copy_buffer_to_buffer(buffer, start, chunk.buffer(), 0, size);
            })?;
            let arrival = chunk.request();
            chunk
                .receive(self, &arrival, |content| part.copy_from_slice(&content[..part.len()]))?;
        }
        Ok(())
    }

    /// The texels of a two-dimensional texture with usage `COPY_SRC`, row by row from the top,
    /// without anything between the rows.
    ///
    /// # Errors
    /// The device fails, or the texture's format has no texels of a fixed size.
    pub fn read_texture(&self, texture: &wgpu::Texture) -> Result<Vec<u8>, RendererError> {
        let format = texture.format();
        let texel = format.block_copy_size(None).ok_or_else(|| {
            RendererError::Graphics(format!("a texture of format {format:?} can't be read"))
        })?;
        let (width, height) = (texture.width(), texture.height());
        let row = width * texel;
        let padded_row = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let rows_at_a_time = (CHUNK_BYTES as u32 / padded_row).clamp(1, height);
        let mut texels = Vec::with_capacity(row as usize * height as usize);
        let chunk = Readback::new(self, u64::from(padded_row) * u64::from(rows_at_a_time))?;
        let mut first = 0;
        while first < height {
            let rows = (height - first).min(rows_at_a_time);
            let mut source = texture.as_image_copy();
            source.origin.y = first;
            let layout = TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(padded_row),
                rows_per_image: None,
            };
            let size = Extent3d { width, height: rows, depth_or_array_layers: 1 };
            self.submit("read a texture", |encoder| {
                let target = TexelCopyBufferInfo { buffer: chunk.buffer(), layout };
                encoder.copy_texture_to_buffer(source, target, size);
            })?;
            let arrival = chunk.request();
            chunk.receive(self, &arrival, |content| {
                for padded in content.chunks_exact(padded_row as usize).take(rows as usize) {
                    texels.extend_from_slice(&padded[..row as usize]);
                }
            })?;
            first += rows;
        }
        Ok(texels)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A buffer to read back that holds `content` once the device gets to it.
    fn readback(graphics: &Graphics, content: [u8; 4]) -> Readback {
        let source = graphics.device().create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: 4,
            usage: BufferUsages::COPY_SRC | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        graphics.queue().write_buffer(&source, 0, &content);
        let readback = Readback::new(graphics, 4).unwrap();
        let copy = |encoder: &mut wgpu::CommandEncoder| {
            encoder.copy_buffer_to_buffer(&source, 0, readback.buffer(), 0, 4);
        };
        graphics.submit("test", copy).unwrap();
        readback
    }

    #[test]
    fn a_callback_that_is_never_called_loses_neither_content_nor_device() {
        let graphics = Graphics::open(true).expect("there is a device, be it software");
        let dropped = || Arrival(channel().1);
        let see = |bytes: &[u8]| bytes.to_vec();
        // What was asked for is not there.
        let unasked = readback(&graphics, [1, 2, 3, 4]);
        assert_eq!(unasked.receive(&graphics, &dropped(), see).unwrap(), [1, 2, 3, 4]);
        // It is there, but nobody says so.
        let asked = readback(&graphics, [5, 6, 7, 8]);
        assert_eq!(graphics.wait(&asked.request().0).unwrap(), Some(Ok(())));
        assert_eq!(asked.receive(&graphics, &dropped(), see).unwrap(), [5, 6, 7, 8]);
        assert_eq!(graphics.loss(), None);
        // And both can be used again.
        for readback in [unasked, asked] {
            assert!(readback.receive(&graphics, &readback.request(), see).is_ok());
        }
    }
}
