//! The render thread: serves the newest request, pass by pass.

use std::sync::Arc;
use std::time::{Duration, Instant};

use super::{Activity, Progress, RenderRequest, Shared, lock};
use crate::develop::XyzImage;
use crate::error::RendererError;
use crate::film::Film;
use crate::packed::PackedScene;
use crate::scheduler::{Scheduler, Work};
use crate::spectrum::Bins;
use crate::statistics::Statistics;
use crate::tracer::{CpuTracer, View};

/// Least time between two published states of an accumulating film.
const PUBLISH_INTERVAL: Duration = Duration::from_millis(33);

/// Serves requests until the session closes.
pub(super) fn run(shared: &Shared, tracer: &CpuTracer) {
    let mut scheduler = Scheduler::new();
    let mut previous = None;
    let mut waiting = None;
    loop {
        let request = match waiting.take() {
            Some(request) => request,
            None => match shared.requests.wait() {
                Some(request) => request,
                None => return,
            },
        };
        let job = match Job::new(request, previous.take()) {
            Ok(job) => job,
            Err(error) => {
                let error = Some(error.to_string());
                shared.publish(Progress {
                    activity: Activity::Failed,
                    error,
                    ..Progress::default()
                });
                continue;
            }
        };
        let (job, next) = job.serve(shared, tracer, &mut scheduler);
        previous = Some(job);
        match next {
            Next::Request(request) => waiting = Some(request),
            Next::Wait => {}
            Next::Close => return,
        }
    }
}

/// What ended the work on a request.
enum Next {
    /// A newer request.
    Request(RenderRequest),
    /// The picture is done.
    Wait,
    /// The session closes.
    Close,
}

/// A request with its scene packed.
struct Job {
    request: RenderRequest,
    scene: PackedScene,
    view: View,
}

impl Job {
    /// Packs the request's scene, or takes it over from the previous job where it is the same.
    fn new(request: RenderRequest, previous: Option<Self>) -> Result<Self, RendererError> {
        let view = View::new(&request.camera, request.size);
        let bins = Bins::new(request.trace.bins);
        let scene = match previous {
            Some(previous)
                if previous.scene.bins == bins && is_same_scene(&previous.request, &request) =>
            {
                previous.scene
            }
            _ => PackedScene::new(&request.scene, bins)?,
        };
        Ok(Self { request, scene, view })
    }

    fn serve(self, shared: &Shared, tracer: &CpuTracer, scheduler: &mut Scheduler) -> (Self, Next) {
        scheduler.restart(self.request.size, self.request.pass_limit);
        let mut exposure = None;
        while let Some(work) = scheduler.next() {
            let Some((letter, generation)) = shared.requests.take() else {
                return (self, Next::Close);
            };
            if let Some(request) = letter {
                return (self, Next::Request(request));
            }
            if work.begins_film {
                exposure = None;
            }
            let exposure = exposure.get_or_insert_with(|| Exposure::new(&self, work));
            let started = Instant::now();
            let statistics = tracer.trace_pass(
                &self.scene,
                &self.view,
                &self.request.trace,
                &mut exposure.film,
                || shared.requests.generation() != generation,
            );
            let Some(statistics) = statistics else { continue };
            let seconds = started.elapsed().as_secs_f64();
            scheduler.complete(seconds);
            exposure.add(&statistics, seconds);
            let is_done = scheduler.next().is_none();
            exposure.publish(shared, &self.request, is_done);
        }
        (self, Next::Wait)
    }
}

fn is_same_scene(a: &RenderRequest, b: &RenderRequest) -> bool {
    Arc::ptr_eq(&a.scene, &b.scene) || a.scene == b.scene
}

/// A film and what it has cost.
struct Exposure {
    film: Film,
    divisor: u32,
    statistics: Statistics,
    seconds: f64,
    published: Option<Instant>,
}

impl Exposure {
    fn new(job: &Job, work: Work) -> Self {
        let [width, height] = job.request.size.map(|length| length.div_ceil(work.divisor));
        Self {
            film: Film::new(width, height, job.scene.bins),
            divisor: work.divisor,
            statistics: Statistics::default(),
            seconds: 0.0,
            published: None,
        }
    }

    fn add(&mut self, statistics: &Statistics, seconds: f64) {
        self.statistics += *statistics;
        self.seconds += seconds;
    }

    /// Hands the film on, unless that was done a moment ago and more is to come.
    fn publish(&mut self, shared: &Shared, request: &RenderRequest, is_done: bool) {
        let is_recent = self.published.is_some_and(|at| at.elapsed() < PUBLISH_INTERVAL);
        if is_recent && !is_done {
            return;
        }
        self.published = Some(Instant::now());
        *lock(&shared.image) = Some(Arc::new(XyzImage::from_film(&self.film)));
        shared.develop();
        let activity = match (is_done, self.divisor) {
            (true, _) => Activity::Done,
            (false, 1) => Activity::Accumulating,
            (false, _) => Activity::Preview,
        };
        shared.publish(Progress {
            activity,
            passes: self.film.passes(),
            pass_limit: request.pass_limit,
            size: self.film.size(),
            statistics: self.statistics,
            tracing_seconds: self.seconds,
            error: None,
        });
    }
}
