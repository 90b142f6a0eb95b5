//! A request in progress: its scene where the tracer reads it, and the film.

use std::time::{Duration, Instant};

use super::bell::{Generation, Urgency};
use super::develop_thread::develop;
use super::graphics::Refusal;
use super::reading::{FilmCopy, FilmState};
use super::shared::{Exposed, Shared, lock};
use super::workplace::Fault;
use super::{Activity, Progress, Reading, RenderRequest};
use crate::error::RendererError;
use crate::film::next_measurement;
use crate::packed::PackedScene;
use crate::scheduler::{Effort, Scheduler, Work};
use crate::settings::{NoiseGoal, TraceSettings};
use crate::spectrum::Bins;
use crate::statistics::Statistics;
use crate::tracer::{Device, Tracer, View};

/// Least time between two published states of an accumulating film.
const PUBLISH_INTERVAL: Duration = Duration::from_millis((1e3 * Scheduler::PUBLISH_SECONDS) as u64);

/// Rounds that take longer are not waited for to read another region of the film.
const QUICK_ROUND_SECONDS: f64 = 0.1;

/// A request with its scene loaded, and what has been traced of it.
pub(super) struct Job<T: Tracer> {
    request: RenderRequest,
    scene: T::Scene,
    bins: Bins,
    view: View,
    draft: TraceSettings,
    exposure: Option<Exposure<T::Film>>,
    /// A film that is no longer needed, to be used again.
    spare: Option<T::Film>,
}

impl<T: Tracer> Job<T> {
    /// Loads the request's scene, or takes it over from the previous job where it is the same; the
    /// film too where the request wants that.
    pub(super) fn new(
        tracer: &T,
        request: RenderRequest,
        previous: Option<Self>,
    ) -> Result<Self, Fault> {
        let bins = Bins::new(request.trace.bins);
        let carries_on = previous.as_ref().is_some_and(|job| job.has_film_of(&request));
        let (scene, exposure, spare) = match previous {
            Some(job) if carries_on => (Some(job.scene), job.exposure, job.spare),
            Some(job) => {
                let is_same = job.bins == bins && job.request.shows(&request.scene);
                let film = job.exposure.map(|exposure| exposure.film);
                (is_same.then_some(job.scene), None, film.or(job.spare))
            }
            None => (None, None, None),
        };
        let scene = match scene {
            Some(scene) => scene,
            None => load(tracer, &request, bins)?,
        };
        let view = View::new(&request.camera, request.size);
        let draft = request.trace.draft();
        Ok(Self { request, scene, bins, view, draft, exposure, spare })
    }

    /// Whether the request carries on with the film of this job, which is gone where it was cut
    /// short.
    pub(super) fn has_film_of(&self, request: &RenderRequest) -> bool {
        self.exposure.is_some() && self.request.makes_same_film(request)
    }

    /// Traces until the picture is done or there is news. The first round lets newer
    /// requests wait for a moment, so that pictures keep coming while a hand drags.
    pub(super) fn serve<D: Device>(
        &mut self,
        shared: &Shared<D>,
        tracer: &T,
        device: Option<u64>,
        scheduler: &mut Scheduler,
        generation: Generation,
    ) -> Result<(), Fault> {
        self.measure_noise(tracer, scheduler)?;
        while let Some(work) = scheduler.next() {
            let patience = Duration::from_secs_f64(scheduler.patience_seconds());
            let mut exposure = self.exposure_for(work, tracer)?;
            let started = Instant::now();
            let traced = tracer.trace(
                &self.scene,
                &self.view,
                self.settings(work.effort),
                &mut exposure.film,
                work.passes,
                &|| match shared.to_trace.urgency_since(generation) {
                    Urgency::None => false,
                    Urgency::Wish => started.elapsed() >= patience,
                    Urgency::Command => true,
                },
            );
            let statistics = match traced {
                Ok(statistics) => statistics,
                Err(RendererError::Cancelled) => {
                    scheduler.interrupt(work, started.elapsed().as_secs_f64());
                    // A round that was cut short has spoilt its film.
                    self.spare = Some(exposure.film);
                    return Ok(());
                }
                Err(error) => return Err(Fault::new(error)),
            };
            let seconds = started.elapsed().as_secs_f64();
            scheduler.complete(work, seconds);
            exposure.add(work.passes, &statistics, seconds);
            self.exposure = Some(exposure);
            self.measure_noise(tracer, scheduler)?;
            let is_done = scheduler.next().is_none();
            self.publish(shared, tracer, device, is_done)?;
            if shared.to_trace.has_rung() {
                return Ok(());
            }
        }
        self.publish(shared, tracer, device, true)
    }

    /// Measures the film's noise where that is due, and tells the scheduler where it is low enough.
    fn measure_noise(&mut self, tracer: &T, scheduler: &mut Scheduler) -> Result<(), Fault> {
        let goal = self.request.noise;
        let Some(exposure) = &mut self.exposure else { return Ok(()) };
        let noise = exposure.measure_noise(tracer, goal).map_err(Fault::new)?;
        if noise.is_some_and(|noise| goal.is_reached(noise)) {
            scheduler.settle();
        }
        Ok(())
    }

    fn settings(&self, effort: Effort) -> &TraceSettings {
        match effort {
            Effort::Draft => &self.draft,
            Effort::Full => &self.request.trace,
        }
    }

    /// The film to add `work` to.
    fn exposure_for(&mut self, work: Work, tracer: &T) -> Result<Exposure<T::Film>, Fault> {
        let used = match self.exposure.take() {
            Some(exposure) if !work.begins_film => return Ok(exposure),
            Some(exposure) => Some(exposure.film),
            None => self.spare.take(),
        };
        let size = self.request.size.map(|length| length.div_ceil(work.divisor));
        let film = tracer.film(size, self.bins, used).map_err(|error| {
            Fault::of_size(error, Refusal::Film(size, self.bins.count() as u32), tracer, self.bins)
        })?;
        Ok(Exposure::new(film, size, work.effort))
    }

    /// Hands the film on, unless that was done a moment ago and more is to come.
    fn publish<D: Device>(
        &mut self,
        shared: &Shared<D>,
        tracer: &T,
        device: Option<u64>,
        is_done: bool,
    ) -> Result<(), Fault> {
        let Some(exposure) = &mut self.exposure else { return Ok(()) };
        let is_recent = exposure.published.is_some_and(|(at, _)| at.elapsed() < PUBLISH_INTERVAL);
        if is_recent && !is_done {
            return Ok(());
        }
        let passes = exposure.passes;
        if exposure.published.is_none_or(|(_, published_passes)| published_passes != passes) {
            let image = tracer.expose(&exposure.film).map_err(|error| {
                let wanted = Refusal::Film(exposure.size, self.bins.count() as u32);
                Fault::of_size(error, wanted, tracer, self.bins)
            })?;
            show(shared, Exposed { image, device });
        }
        exposure.published = Some((Instant::now(), passes));
        exposure.read_watched(shared, tracer, &self.request, is_done)?;
        let activity = match (is_done, exposure.effort) {
            (true, _) => Activity::Done,
            (false, Effort::Full) => Activity::Accumulating,
            (false, Effort::Draft) => Activity::Preview,
        };
        shared.publish(Progress {
            activity,
            passes,
            pass_limit: self.request.pass_limit,
            noise: exposure.measured.map(|measured| measured.noise),
            noise_target: self.request.noise.target,
            size: exposure.size,
            statistics: exposure.statistics,
            tracing_seconds: exposure.seconds,
            error: None,
            tracer: Some(tracer.name()),
        });
        Ok(())
    }
}

/// Has an image developed: at once where a device does it, which only has to be told and does it
/// before the next round; by the develop thread where the processor has to work for it.
fn show<D: Device>(shared: &Shared<D>, exposed: Exposed) {
    let is_on_device = exposed.device.is_some();
    shared.expose(exposed);
    if is_on_device {
        develop(shared);
    } else {
        shared.to_develop.ring(Urgency::None);
    }
}

fn load<T: Tracer>(tracer: &T, request: &RenderRequest, bins: Bins) -> Result<T::Scene, Fault> {
    let packed = PackedScene::new(&request.scene, bins).map_err(Fault::new)?;
    tracer.load(packed).map_err(|error| {
        let wanted = Refusal::Scene(request.scene.clone(), request.trace.bins);
        Fault::of_size(error, wanted, tracer, bins)
    })
}

/// What the noise of a film was, after how many passes.
#[derive(Clone, Copy)]
struct MeasuredNoise {
    /// What pixels were left out by since then.
    goal: NoiseGoal,
    passes: u32,
    noise: f32,
}

/// A film and what it has cost.
struct Exposure<F> {
    film: F,
    size: [u32; 2],
    effort: Effort,
    passes: u32,
    statistics: Statistics,
    seconds: f64,
    /// Seconds of the last round.
    round_seconds: f64,
    measured: Option<MeasuredNoise>,
    /// When, and after how many passes, the film was last handed on.
    published: Option<(Instant, u32)>,
    /// What was watched, by its number, and after how many passes it was last read.
    read: Option<(u64, u32)>,
}

impl<F> Exposure<F> {
    fn new(film: F, size: [u32; 2], effort: Effort) -> Self {
        Self {
            film,
            size,
            effort,
            passes: 0,
            statistics: Statistics::default(),
            seconds: 0.0,
            round_seconds: 0.0,
            measured: None,
            published: None,
            read: None,
        }
    }

    fn add(&mut self, passes: u32, statistics: &Statistics, seconds: f64) {
        self.passes += passes;
        self.statistics += *statistics;
        self.seconds += seconds;
        self.round_seconds = seconds;
    }

    /// The film's noise when it was measured last, which is done where there are enough passes since
    /// then, or where something else is aimed at.
    fn measure_noise<T: Tracer<Film = F>>(
        &mut self,
        tracer: &T,
        goal: NoiseGoal,
    ) -> Result<Option<f32>, RendererError> {
        let known = self.measured.filter(|measured| measured.goal == goal);
        let due = next_measurement(known.map_or(0, |measured| measured.passes));
        if self.passes >= due {
            let noise = tracer.measure_noise(&mut self.film, goal)?;
            self.measured = Some(MeasuredNoise { goal, passes: self.passes, noise });
        }
        Ok(self.measured.map(|measured| measured.noise))
    }

    /// Reads the region that is watched, if any, unless that was done in this state of the film;
    /// and has others read from a copy where more is to come, but not soon.
    fn read_watched<D: Device, T: Tracer<Film = F>>(
        &mut self,
        shared: &Shared<D>,
        tracer: &T,
        request: &RenderRequest,
        is_done: bool,
    ) -> Result<(), Fault> {
        let watched = lock(&shared.watch).watched();
        let Some((region, number)) = watched else { return Ok(()) };
        let known = self.read.replace((number, self.passes));
        if known == self.read {
            return Ok(());
        }
        let film = FilmState {
            size: self.size,
            bins: Bins::new(request.trace.bins),
            passes: self.passes,
            is_draft: self.effort == Effort::Draft || self.size != request.size,
        };
        if known.is_none_or(|(_, passes)| passes != self.passes) {
            // A draft is quick, but the round after it may not be.
            let is_quick = self.round_seconds <= QUICK_ROUND_SECONDS && !film.is_draft;
            let means = if is_done || is_quick { None } else { tracer.copy_means(&self.film) };
            let copy = means.map(|means| FilmCopy { means, state: film });
            let old = lock(&shared.watch).keep(copy);
            drop(old);
        }
        let pixels = region.pixels(self.size);
        let spectrum = tracer.mean_spectrum(&self.film, pixels).map_err(Fault::new)?;
        let reading = Reading::new(region, film, spectrum);
        lock(&shared.watch).take(number, reading);
        Ok(())
    }
}
