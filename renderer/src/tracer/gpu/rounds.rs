//! Rounds of work: some passes over a band of the film, submitted bit by bit.

use std::collections::VecDeque;
use std::time::Instant;

use wgpu::BindGroup;

use super::film::GpuFilm;
use super::frame::Frame;
use super::pace::Pace;
use super::pipeline::{WORKGROUP_SIZE, WalkPipeline};
use super::progress::Progress;
use super::scene::GpuScene;
use super::walkers::Walkers;
use crate::error::RendererError;
use crate::gpu::{Arrival, Graphics, Readback};
use crate::statistics::Statistics;

/// Most items of a round, so that the walkers' counter, which runs on past the last, can't run over.
const MAX_ITEMS: u32 = 1 << 30;
/// Submissions that the device has at a time: while it works on one, the next is ready.
const IN_FLIGHT: usize = 2;

/// The work of one call: all that stays the same from submission to submission.
pub(super) struct Work<'a> {
    pub(super) graphics: &'a Graphics,
    pub(super) pipeline: &'a WalkPipeline,
    pub(super) walkers: &'a Walkers,
    pub(super) scene: &'a GpuScene,
    pub(super) is_cancelled: &'a (dyn Fn() -> bool + Sync),
}

/// A submission that the device is at.
struct Submission {
    readback: Readback,
    arrival: Arrival,
    budget: u32,
    submitted_at: Instant,
}

impl Work<'_> {
    /// Adds `passes` passes to `film`; `frame` lacks only what differs from round to round.
    pub(super) fn trace(
        &self,
        film: &GpuFilm,
        mut frame: Frame,
        passes: u32,
        pace: &mut Pace,
    ) -> Result<Statistics, RendererError> {
        let mut statistics = Statistics::default();
        let mut items = 0;
        self.graphics.submit("trace", |encoder| self.walkers.clear(encoder))?;
        for band in film.bands() {
            let film_group = self.graphics.guard("trace", |device| {
                self.walkers.film_group(device, self.pipeline, &band.buffer)
            })?;
            frame.first_row = band.first_row;
            frame.pixel_count = film.size()[0] * band.rows;
            let round_passes = (MAX_ITEMS / frame.pixel_count).max(1);
            for first_pass in (0..passes).step_by(round_passes as usize) {
                let round_passes = round_passes.min(passes - first_pass);
                frame.first_pass = film.passes() + first_pass;
                frame.item_count = frame.pixel_count * round_passes;
                items += u64::from(frame.item_count);
                statistics = self.round(&film_group, frame, items, pace)?;
            }
        }
        Ok(statistics)
    }

    /// Works until `items` items are done, those of earlier rounds included.
    fn round(
        &self,
        film_group: &BindGroup,
        mut frame: Frame,
        items: u64,
        pace: &mut Pace,
    ) -> Result<Statistics, RendererError> {
        pace.begin_round();
        self.graphics.submit("trace", |encoder| {
            encoder.clear_buffer(self.walkers.progress(), 0, Some(size_of::<u32>() as u64));
        })?;
        let mut idle = Vec::new();
        for _ in 0..IN_FLIGHT {
            idle.push(Readback::new(self.graphics, size_of::<Progress>() as u64)?);
        }
        let mut in_flight = VecDeque::new();
        let mut last_done_at = Instant::now();
        let mut done = None;
        let mut is_cancelled = false;
        loop {
            while done.is_none()
                && !is_cancelled
                && let Some(readback) = idle.pop()
            {
                is_cancelled = (self.is_cancelled)();
                if !is_cancelled {
                    frame.budget = pace.budget();
                    in_flight.push_back(self.submit(film_group, &frame, readback)?);
                }
            }
            // What is in flight is waited for in any case, so that it meddles with nothing later.
            let Some(submission) = in_flight.pop_front() else { break };
            let progress: Progress = submission.readback.receive(
                self.graphics,
                &submission.arrival,
                bytemuck::pod_read_unaligned,
            )?;
            let elapsed = last_done_at.max(submission.submitted_at).elapsed();
            last_done_at = Instant::now();
            let is_loaded = progress.next_item < frame.item_count;
            pace.observe(submission.budget, elapsed, is_loaded);
            idle.push(submission.readback);
            if progress.items() >= items {
                done = Some(progress.statistics());
            }
        }
        done.ok_or(RendererError::Cancelled)
    }

    fn submit(
        &self,
        film_group: &BindGroup,
        frame: &Frame,
        readback: Readback,
    ) -> Result<Submission, RendererError> {
        let submitted_at = Instant::now();
        self.graphics.submit("trace", |encoder| {
            let queue = self.graphics.queue();
            queue.write_buffer(self.walkers.frame(), 0, bytemuck::bytes_of(frame));
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(&self.pipeline.pipeline);
            pass.set_bind_group(0, &self.scene.group, &[]);
            pass.set_bind_group(1, self.walkers.walk_group(), &[]);
            pass.set_bind_group(2, film_group, &[]);
            pass.dispatch_workgroups(self.walkers.count() / WORKGROUP_SIZE, 1, 1);
            drop(pass);
            let size = readback.buffer().size();
            encoder.copy_buffer_to_buffer(self.walkers.progress(), 0, readback.buffer(), 0, size);
        })?;
        let arrival = readback.request();
        Ok(Submission { readback, arrival, budget: frame.budget, submitted_at })
    }
}
