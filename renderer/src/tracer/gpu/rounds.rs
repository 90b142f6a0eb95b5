//! Rounds of work: some passes over a band of the film, submitted bit by bit.

use std::collections::VecDeque;
use std::sync::{Arc, Weak};
use std::time::Instant;

use bytemuck::bytes_of;
use wgpu::{BindGroup, CommandEncoder, ComputePipeline};

use super::film::GpuFilm;
use super::pace::{Pace, Ration};
use super::pipeline::{WORKGROUP_SIZE, WalkPipeline};
use super::progress::{Headway, Progress};
use super::scene::GpuScene;
use super::walkers::Walkers;
use crate::error::RendererError;
use crate::gpu::{Arrival, Graphics, Readback};
use crate::settings::Splitting;
use crate::shaders::Frame;
use crate::statistics::Statistics;

/// Most items of a round, so that the walkers' counter, which runs on past the last, can't run over.
const MAX_ITEMS: u32 = 1 << 30;
/// Submissions that the device has at a time: while it works on one, the next is ready.
const IN_FLIGHT: usize = 2;

/// What one call asks for: all that stays the same from submission to submission.
#[derive(Clone, Copy)]
pub(super) struct Order<'a> {
    pub(super) graphics: &'a Graphics,
    pub(super) pipeline: &'a WalkPipeline,
    pub(super) kernel: &'a ComputePipeline,
    pub(super) splitting: Splitting,
    pub(super) scene: &'a GpuScene,
    pub(super) is_cancelled: &'a (dyn Fn() -> bool + Sync),
}

/// Keeps the walkers at work: what it learns, and what the device is at, outlast the call.
pub(super) struct Dispatcher {
    walkers: Walkers,
    pace: Pace,
    max_round_items: u32,
    /// The first of the workgroups whose turn is next.
    next_group: u32,
    in_flight: VecDeque<Submission>,
    idle: Vec<Readback>,
    last_done_at: Instant,
    /// What was traced last; of its scene only which one it was.
    last_traced: Option<(Frame, Splitting, Weak<()>)>,
}

/// A submission that the device is at.
struct Submission {
    readback: Readback,
    arrival: Arrival,
    ration: Ration,
    submitted_at: Instant,
    /// Its round is over, by completion or by cancelling.
    is_stale: bool,
}

/// What is forgotten before a round.
type Clear = fn(&Walkers, &mut CommandEncoder);

impl Dispatcher {
    pub(super) fn new(walkers: Walkers, is_software: bool) -> Self {
        Self {
            walkers,
            pace: Pace::new(is_software),
            max_round_items: MAX_ITEMS,
            next_group: 0,
            in_flight: VecDeque::new(),
            idle: Vec::new(),
            last_done_at: Instant::now(),
            last_traced: None,
        }
    }

    /// Makes rounds of at most `items` items, but at least of one pass.
    pub(super) fn limit_rounds(&mut self, items: u32) {
        self.max_round_items = items;
    }

    /// Adds `passes` passes to `film`; `frame` lacks only what differs from round to round.
    pub(super) fn trace(
        &mut self,
        order: Order,
        film: &GpuFilm,
        mut frame: Frame,
        passes: u32,
    ) -> Result<Statistics, RendererError> {
        self.heed_changes(&frame, order);
        let mut statistics = Statistics::default();
        let mut items = 0;
        let mut clear: Clear = Walkers::forget_all;
        for band in film.bands() {
            let film_group = order.graphics.guard("trace", |device| {
                self.walkers.film_group(device, order.pipeline, &band.buffer)
            })?;
            frame.first_row = band.first_row;
            frame.pixel_count = film.size()[0] * band.rows;
            let round_passes = (self.max_round_items / frame.pixel_count).max(1);
            for first_pass in (0..passes).step_by(round_passes as usize) {
                let round_passes = round_passes.min(passes - first_pass);
                frame.first_pass = film.passes() + first_pass;
                frame.item_count = frame.pixel_count * round_passes;
                items += u64::from(frame.item_count);
                statistics = self.finish_round(order, &film_group, frame, clear, items)?;
                clear = Walkers::forget_items;
            }
        }
        Ok(statistics)
    }

    /// The pace that was right for one scene, view and rules may be far too fast for others.
    fn heed_changes(&mut self, frame: &Frame, order: Order) {
        let scene = Arc::downgrade(&order.scene.identity);
        let is_known =
            self.last_traced.as_ref().is_some_and(|(last_frame, splitting, last_scene)| {
                bytes_of(last_frame) == bytes_of(frame)
                    && *splitting == order.splitting
                    && last_scene.ptr_eq(&scene)
            });
        if !is_known {
            self.pace.begin_carefully();
            self.last_traced = Some((*frame, order.splitting, scene));
        }
    }

    /// Works until `items` items are done, those of the call's earlier rounds included.
    ///
    /// What is still in flight at the end is not waited for: whatever is submitted later comes
    /// after it.
    fn finish_round(
        &mut self,
        order: Order,
        film_group: &BindGroup,
        frame: Frame,
        clear: Clear,
        items: u64,
    ) -> Result<Statistics, RendererError> {
        self.pace.begin_round();
        for submission in &mut self.in_flight {
            submission.is_stale = true;
        }
        let mut clear = Some(clear);
        let mut headway = Headway::default();
        loop {
            while self.in_flight.len() < IN_FLIGHT {
                if (order.is_cancelled)() {
                    return Err(RendererError::Cancelled);
                }
                self.submit(order, film_group, frame, clear.take())?;
            }
            let Some((progress, parts)) = self.receive(order.graphics, frame.item_count)? else {
                continue;
            };
            if progress.items() >= items {
                return Ok(progress.statistics());
            }
            if headway.is_lacking(&progress, parts) {
                return Err(RendererError::Graphics(format!(
                    "the graphics device {} makes no progress; update its driver, or trace on the \
                     CPU",
                    order.graphics.name()
                )));
            }
        }
    }

    fn submit(
        &mut self,
        order: Order,
        film_group: &BindGroup,
        mut frame: Frame,
        clear: Option<Clear>,
    ) -> Result<(), RendererError> {
        let readback = match self.idle.pop() {
            Some(readback) => readback,
            None => Readback::new(order.graphics, size_of::<Progress>() as u64)?,
        };
        let mut ration = self.pace.ration();
        ration.budget = ration.budget.min(order.scene.max_budget(order.splitting));
        let all_groups = self.walkers.groups();
        let groups = all_groups.div_ceil(ration.parts).min(all_groups - self.next_group);
        frame.budget = ration.budget;
        frame.first_walker = self.next_group * WORKGROUP_SIZE;
        self.next_group = (self.next_group + groups) % all_groups;
        let submitted_at = Instant::now();
        order.graphics.submit("trace", |encoder| {
            if let Some(clear) = clear {
                clear(&self.walkers, encoder);
            }
            order.graphics.queue().write_buffer(self.walkers.frame(), 0, bytes_of(&frame));
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(order.kernel);
            pass.set_bind_group(0, &order.scene.group, &[]);
            pass.set_bind_group(1, self.walkers.walk_group(), &[]);
            pass.set_bind_group(2, film_group, &[]);
            pass.dispatch_workgroups(groups, 1, 1);
            drop(pass);
            let size = readback.buffer().size();
            encoder.copy_buffer_to_buffer(self.walkers.progress(), 0, readback.buffer(), 0, size);
        })?;
        let arrival = readback.request();
        self.in_flight.push_back(Submission {
            readback,
            arrival,
            ration,
            submitted_at,
            is_stale: false,
        });
        Ok(())
    }

    /// Waits for the oldest submission: how far the work has come, and in how many parts the
    /// walkers were. None where it was of an earlier round.
    fn receive(
        &mut self,
        graphics: &Graphics,
        item_count: u32,
    ) -> Result<Option<(Progress, u32)>, RendererError> {
        let Some(submission) = self.in_flight.pop_front() else { return Ok(None) };
        let Submission { readback, arrival, ration, submitted_at, is_stale } = submission;
        let progress: Progress =
            readback.receive(graphics, &arrival, bytemuck::pod_read_unaligned)?;
        self.idle.push(readback);
        let elapsed = self.last_done_at.max(submitted_at).elapsed();
        self.last_done_at = Instant::now();
        if is_stale {
            return Ok(None);
        }
        self.pace.observe(ration, elapsed, progress.next_item < item_count);
        Ok(Some((progress, ration.parts)))
    }
}

#[cfg(test)]
mod tests {
    use bytemuck::Zeroable;

    use super::*;
    use crate::packed::PackedScene;
    use crate::scene::Scene;
    use crate::spectrum::Bins;

    #[test]
    fn walkers_that_never_get_done_are_an_error() {
        let graphics = Graphics::open(true).expect("there is a device, be it software");
        let pipeline = WalkPipeline::new(&graphics).unwrap();
        let walkers = Walkers::new(&graphics, &pipeline).unwrap();
        let scene = PackedScene::new(&Scene::default(), Bins::new(4)).unwrap();
        let scene = GpuScene::new(&graphics, &pipeline, &scene).unwrap();
        let film = GpuFilm::new(&graphics, [2, 2], Bins::new(4), None).unwrap();
        let group = walkers.film_group(graphics.device(), &pipeline, &film.bands()[0].buffer);
        let mut dispatcher = Dispatcher::new(walkers, true);
        let (pipeline, scene) = (&pipeline, &scene);
        let splitting = Splitting::Paper;
        let kernel = pipeline.of(&graphics, splitting).unwrap();
        let (graphics, is_cancelled) = (&graphics, &|| false);
        let order = Order { graphics, pipeline, kernel, splitting, scene, is_cancelled };
        // Four items are all there is to do.
        let frame = Frame { width: 2, height: 2, pixel_count: 4, item_count: 4, ..Frame::zeroed() };
        let clear = Walkers::forget_all;
        dispatcher.finish_round(order, &group, frame, clear, 4).unwrap();
        let result = dispatcher.finish_round(order, &group, frame, clear, 5);
        assert!(result.unwrap_err().to_string().contains("no progress"));
        assert_eq!(graphics.loss(), None);
    }
}
