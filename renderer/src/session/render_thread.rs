//! The render thread: serves the newest request, pass by pass.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::{Duration, Instant};

use super::{Activity, Progress, RenderRequest, Shared, lock};
use crate::develop::{LatentImage, XyzImage};
use crate::error::RendererError;
use crate::film::Film;
use crate::packed::PackedScene;
use crate::scheduler::{Effort, Scheduler, Work};
use crate::settings::TraceSettings;
use crate::spectrum::Bins;
use crate::statistics::Statistics;
use crate::tracer::{CpuTracer, Tracer, View};

/// Least time between two published states of an accumulating film.
const PUBLISH_INTERVAL: Duration = Duration::from_millis(33);

/// What the user reads where the tracer has panicked.
const PANICKED: &str = "the tracer failed on this scene, which is a fault of the program; \
    change a setting to try again, and please report it with the scene file";

/// Serves requests until the session closes.
pub(super) fn run(shared: &Shared, tracer: &CpuTracer) {
    let mut scheduler = Scheduler::new();
    let mut job: Option<Job> = None;
    while let Some((request, generation)) = shared.requests.wait() {
        // A film that was cut short is gone, whatever it was of.
        let carries_on = job
            .as_ref()
            .is_some_and(|job| job.exposure.is_some() && job.request.makes_same_film(&request));
        if carries_on {
            scheduler.limit_passes(request.pass_limit);
        } else {
            scheduler.restart(request.size, request.pass_limit);
        }
        let previous = job.take();
        // A bug in the tracer must not leave the window waiting for ever.
        let served = catch_unwind(AssertUnwindSafe(|| {
            let mut next = Job::new(request, previous, carries_on)?;
            next.serve(shared, tracer, &mut scheduler, generation);
            Ok(next)
        }));
        match served.unwrap_or_else(|_| Err(RendererError::Invalid(PANICKED.to_owned()))) {
            Ok(served) => job = Some(served),
            Err(error) => shared.publish(Progress {
                activity: Activity::Failed,
                error: Some(error.to_string()),
                ..Progress::default()
            }),
        }
    }
}

/// A request with its scene packed, and what has been traced of it.
struct Job {
    request: RenderRequest,
    scene: PackedScene,
    view: View,
    draft: TraceSettings,
    exposure: Option<Exposure>,
}

impl Job {
    /// Packs the request's scene, or takes it over from the previous job where it is the same;
    /// the film too where that `carries_on`.
    fn new(
        request: RenderRequest,
        previous: Option<Self>,
        carries_on: bool,
    ) -> Result<Self, RendererError> {
        let bins = Bins::new(request.trace.bins);
        let (scene, exposure) = match previous {
            Some(previous) if carries_on => (previous.scene, previous.exposure),
            Some(previous)
                if previous.scene.bins == bins && previous.request.has_same_scene(&request) =>
            {
                (previous.scene, None)
            }
            _ => (PackedScene::new(&request.scene, bins)?, None),
        };
        let view = View::new(&request.camera, request.size);
        let draft = request.trace.draft();
        Ok(Self { request, scene, view, draft, exposure })
    }

    /// Traces until the picture is done or there is news.
    fn serve(
        &mut self,
        shared: &Shared,
        tracer: &CpuTracer,
        scheduler: &mut Scheduler,
        generation: u64,
    ) {
        while let Some(work) = scheduler.next() {
            let mut exposure = match self.exposure.take() {
                Some(exposure) if !work.begins_film => exposure,
                _ => self.expose(work),
            };
            let started = Instant::now();
            let statistics = tracer.trace(
                &self.scene,
                &self.view,
                self.settings(work.effort),
                &mut exposure.film,
                1,
                &|| shared.requests.generation() != generation,
            );
            // A pass that was cut short has spoilt its film.
            let Ok(statistics) = statistics else { return };
            let seconds = started.elapsed().as_secs_f64();
            scheduler.complete(seconds);
            exposure.add(&statistics, seconds);
            exposure.publish(shared, &self.request, scheduler.next().is_none());
            self.exposure = Some(exposure);
            if shared.requests.has_news() {
                return;
            }
        }
        if let Some(exposure) = &mut self.exposure {
            exposure.publish(shared, &self.request, true);
        }
    }

    fn settings(&self, effort: Effort) -> &TraceSettings {
        match effort {
            Effort::Draft => &self.draft,
            Effort::Full => &self.request.trace,
        }
    }

    fn expose(&self, work: Work) -> Exposure {
        let [width, height] = self.request.size.map(|length| length.div_ceil(work.divisor));
        Exposure {
            film: Film::new(width, height, self.scene.bins),
            effort: work.effort,
            statistics: Statistics::default(),
            seconds: 0.0,
            published: None,
        }
    }
}

/// A film and what it has cost.
struct Exposure {
    film: Film,
    effort: Effort,
    statistics: Statistics,
    seconds: f64,
    /// When, and after how many passes, the film was last handed on.
    published: Option<(Instant, u32)>,
}

impl Exposure {
    fn add(&mut self, statistics: &Statistics, seconds: f64) {
        self.statistics += *statistics;
        self.seconds += seconds;
    }

    /// Hands the film on, unless that was done a moment ago and more is to come.
    fn publish(&mut self, shared: &Shared, request: &RenderRequest, is_done: bool) {
        let is_recent = self.published.is_some_and(|(at, _)| at.elapsed() < PUBLISH_INTERVAL);
        if is_recent && !is_done {
            return;
        }
        let passes = self.film.passes();
        if self.published.is_none_or(|(_, published_passes)| published_passes != passes) {
            *lock(&shared.image) =
                Some(Arc::new(LatentImage::Memory(XyzImage::from_film(&self.film))));
            shared.to_develop.post(());
        }
        self.published = Some((Instant::now(), passes));
        let activity = match (is_done, self.effort) {
            (true, _) => Activity::Done,
            (false, Effort::Full) => Activity::Accumulating,
            (false, Effort::Draft) => Activity::Preview,
        };
        shared.publish(Progress {
            activity,
            passes,
            pass_limit: request.pass_limit,
            size: self.film.size(),
            statistics: self.statistics,
            tracing_seconds: self.seconds,
            error: None,
            tracer: None,
        });
    }
}
