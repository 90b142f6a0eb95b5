//! What to trace next: a pure value machine without clocks or threads.

mod round;
#[cfg(test)]
mod tests;

pub use round::Machine;
pub(crate) use round::round;

use crate::film::next_measurement;
use crate::settings::NoiseGoal;

/// A round of tracing: passes between which nothing is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Work {
    /// The picture's width and height are divided by this; 1 is full resolution.
    pub divisor: u32,
    /// With how much care the passes are traced.
    pub effort: Effort,
    /// Number of passes, at least 1.
    pub passes: u32,
    /// Whether the round begins an empty film.
    pub begins_film: bool,
}

/// With how much care a pass is traced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// With [`TraceSettings::draft`](crate::settings::TraceSettings::draft): shown until
    /// something better is there.
    Draft,
    /// With the settings as they are.
    Full,
}

/// Chooses resolution and effort of each pass, and how many make a round, for one tracer.
///
/// After a restart the first pass is a draft as fine as fits the preview budget; as long as no
/// other restart comes, each next draft halves the divisor, and after the one at full resolution
/// passes of full effort accumulate. Where those fit the budget themselves there is no draft.
#[derive(Clone, Debug, PartialEq)]
pub struct Scheduler {
    machine: Machine,
    draft: Cost,
    full: Cost,
    pixels: u64,
    pass_limit: u32,
    noise: NoiseGoal,
    /// Whether the noise is no more than is wanted.
    is_settled: bool,
    stage: Stage,
    /// Whether nothing was completed since the restart.
    is_first: bool,
    patience_seconds: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    Draft { divisor: u32 },
    Accumulate { passes: u32 },
}

/// What a pass costs, per pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Cost {
    seconds: f64,
    is_measured: bool,
}

impl Cost {
    /// Weight of the newest measurement.
    const SMOOTHING: f64 = 0.5;

    const fn guess(seconds: f64) -> Self {
        Self { seconds, is_measured: false }
    }

    /// Moves towards `seconds`. The first measurement counts alone: a guess that is a thousand
    /// times too high for a graphics card would be long in fading.
    fn measure(&mut self, seconds: f64) {
        let weight = if self.is_measured { Self::SMOOTHING } else { 1.0 };
        self.seconds += weight * (seconds - self.seconds);
        self.is_measured = true;
    }

    /// Takes note that it is `seconds` or more.
    fn raise(&mut self, seconds: f64) {
        self.seconds = self.seconds.max(seconds);
    }
}

impl Scheduler {
    /// Time that the first pass after a change may take, in seconds: 40 frames per second leave
    /// room for developing and for the window.
    pub const PREVIEW_SECONDS: f64 = 0.025;
    /// Least time between two published states of an accumulating film, in seconds.
    pub const PUBLISH_SECONDS: f64 = 0.033;
    /// Time that a round of several passes is to take, in seconds: long enough that the few
    /// pixels that every round waits for at its end weigh little.
    pub const ROUND_SECONDS: f64 = 0.1;
    /// Time that the first round after a change is given to become a picture though something newer
    /// is asked for, in seconds. A hand that drags asks for another picture at every frame; without
    /// this it would see none until it rests.
    pub const PATIENCE_SECONDS: f64 = 0.1;
    /// The same where even the coarsest drafts turn out to take longer.
    pub const MAX_PATIENCE_SECONDS: f64 = 1.6;
    /// Coarsest draft: pixels of 32 × 32.
    pub const MAX_DIVISOR: u32 = 32;
    /// What a draft is guessed to cost of a full pass.
    const DRAFT_SHARE: f64 = 0.1;

    /// Nothing to do yet.
    pub fn new(machine: Machine) -> Self {
        let guess = machine.guess();
        Self {
            machine,
            draft: Cost::guess(Self::DRAFT_SHARE * guess),
            full: Cost::guess(guess),
            pixels: 0,
            pass_limit: 0,
            noise: NoiseGoal::NONE,
            is_settled: false,
            stage: Stage::Accumulate { passes: 0 },
            is_first: false,
            patience_seconds: Self::PATIENCE_SECONDS,
        }
    }

    /// Starts a new picture of `size` that is done after `pass_limit` passes.
    pub fn restart(&mut self, size: [u32; 2], pass_limit: u32) {
        self.pixels = u64::from(size[0]) * u64::from(size[1]);
        self.limit_passes(pass_limit);
        self.is_settled = false;
        self.is_first = true;
        let pixels = self.pixels as f64;
        self.stage = if self.full.seconds * pixels <= Self::PREVIEW_SECONDS {
            Stage::Accumulate { passes: 0 }
        } else {
            let drafts = self.draft.seconds * pixels / Self::PREVIEW_SECONDS;
            Stage::Draft { divisor: (drafts.sqrt().ceil() as u32).clamp(1, Self::MAX_DIVISOR) }
        };
    }

    /// Changes when the picture is done, and nothing else.
    pub fn limit_passes(&mut self, pass_limit: u32) {
        self.pass_limit = if self.pixels == 0 { 0 } else { pass_limit };
    }

    /// Changes which noise is good enough, and nothing else.
    pub fn aim_at(&mut self, noise: NoiseGoal) {
        self.noise = noise;
        self.is_settled = false;
    }

    /// Takes note that the noise is no more than is wanted: the picture is done.
    pub fn settle(&mut self) {
        self.is_settled = true;
    }

    /// The next round; `None` when the picture is done.
    pub fn next(&self) -> Option<Work> {
        match self.stage {
            _ if self.pass_limit == 0 || self.is_settled => None,
            Stage::Draft { divisor } => {
                Some(Work { divisor, effort: Effort::Draft, passes: 1, begins_film: true })
            }
            Stage::Accumulate { passes } if passes < self.pass_limit => Some(Work {
                divisor: 1,
                effort: Effort::Full,
                passes: self.round(passes),
                begins_film: passes == 0,
            }),
            Stage::Accumulate { .. } => None,
        }
    }

    fn round(&self, done: u32) -> u32 {
        let pass_seconds = self.full.seconds * self.pixels as f64;
        round(self.machine, pass_seconds, done, self.pass_limit, self.noise)
    }

    /// Seconds that the next round is given though something newer is asked for.
    pub fn patience_seconds(&self) -> f64 {
        if self.is_first { self.patience_seconds } else { 0.0 }
    }

    /// Has the first round after a restart be given so long from now on, within limits.
    fn be_patient_for(&mut self, seconds: f64) {
        self.patience_seconds = seconds.clamp(Self::PATIENCE_SECONDS, Self::MAX_PATIENCE_SECONDS);
    }

    /// Takes note that `work`, which [`next`](Self::next) gave, was completed in `seconds`.
    pub fn complete(&mut self, work: Work, seconds: f64) {
        if self.is_first {
            self.be_patient_for(2.0 * seconds);
        }
        self.is_first = false;
        if !self.leaves_out_pixels() {
            let seconds = seconds / self.traced_pixels(work);
            self.cost_mut(work.effort).measure(seconds);
        }
        self.stage = match self.stage {
            Stage::Draft { divisor: 1 } => Stage::Accumulate { passes: 0 },
            Stage::Draft { divisor } => Stage::Draft { divisor: divisor / 2 },
            Stage::Accumulate { passes } => Stage::Accumulate { passes: passes + work.passes },
        };
    }

    /// Takes note that `work`, which [`next`](Self::next) gave, was not complete after `seconds`,
    /// so that it costs more. A restart must follow, since the film is spoilt.
    pub fn interrupt(&mut self, work: Work, seconds: f64) {
        if self.is_first && seconds >= self.patience_seconds {
            self.be_patient_for(2.0 * self.patience_seconds);
        }
        let seconds = seconds / self.traced_pixels(work);
        self.cost_mut(work.effort).raise(seconds);
        if work.effort == Effort::Full && !self.draft.is_measured {
            self.draft.raise(Self::DRAFT_SHARE * seconds);
        }
    }

    /// Whether the next pass may leave out pixels, so that it tells nothing of others.
    fn leaves_out_pixels(&self) -> bool {
        let is_measured = |passes| passes >= next_measurement(0);
        matches!(self.stage, Stage::Accumulate { passes } if is_measured(passes))
            && self.noise.adapts()
    }

    /// Pixels of all passes of `work`, at least 1.
    fn traced_pixels(&self, work: Work) -> f64 {
        let traced = self.pixels as f64 / f64::from(work.divisor).powi(2) * f64::from(work.passes);
        traced.max(1.0)
    }

    fn cost_mut(&mut self, effort: Effort) -> &mut Cost {
        match effort {
            Effort::Draft => &mut self.draft,
            Effort::Full => &mut self.full,
        }
    }
}
