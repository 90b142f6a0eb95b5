//! What to trace next: a pure value machine without clocks or threads.

/// One pass of tracing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Work {
    /// The picture's width and height are divided by this; 1 is full resolution.
    pub divisor: u32,
    /// With how much care the pass is traced.
    pub effort: Effort,
    /// Whether the pass begins an empty film.
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

/// Chooses resolution and effort of each pass.
///
/// After a restart the first pass is a draft as fine as fits the preview budget; as long as no
/// other restart comes, each next draft halves the divisor, and after the one at full resolution
/// passes of full effort accumulate. Where those fit the budget themselves there is no draft.
#[derive(Clone, Debug, PartialEq)]
pub struct Scheduler {
    draft_seconds_per_pixel: f64,
    full_seconds_per_pixel: f64,
    pixels: u64,
    pass_limit: u32,
    stage: Stage,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    Draft { divisor: u32 },
    Accumulate { passes: u32 },
}

impl Scheduler {
    /// Time that the first pass after a change may take, in seconds: 40 frames per second leave
    /// room for developing and for the window.
    pub const PREVIEW_SECONDS: f64 = 0.025;
    /// Coarsest draft: pixels of 32 × 32.
    pub const MAX_DIVISOR: u32 = 32;
    /// Costs of a pixel before the first is measured, in seconds.
    const UNMEASURED_DRAFT: f64 = 1e-6;
    const UNMEASURED_FULL: f64 = 1e-5;
    /// Weight of the newest measurement.
    const SMOOTHING: f64 = 0.5;

    /// Nothing to do yet.
    pub fn new() -> Self {
        Self {
            draft_seconds_per_pixel: Self::UNMEASURED_DRAFT,
            full_seconds_per_pixel: Self::UNMEASURED_FULL,
            pixels: 0,
            pass_limit: 0,
            stage: Stage::Accumulate { passes: 0 },
        }
    }

    /// Starts a new picture of `size` that is done after `pass_limit` passes.
    pub fn restart(&mut self, size: [u32; 2], pass_limit: u32) {
        self.pixels = u64::from(size[0]) * u64::from(size[1]);
        self.pass_limit = if self.pixels == 0 { 0 } else { pass_limit };
        let pixels = self.pixels as f64;
        self.stage = if self.full_seconds_per_pixel * pixels <= Self::PREVIEW_SECONDS {
            Stage::Accumulate { passes: 0 }
        } else {
            let drafts = self.draft_seconds_per_pixel * pixels / Self::PREVIEW_SECONDS;
            Stage::Draft { divisor: (drafts.sqrt().ceil() as u32).clamp(1, Self::MAX_DIVISOR) }
        };
    }

    /// Changes when the picture is done, and nothing else.
    pub fn limit_passes(&mut self, pass_limit: u32) {
        self.pass_limit = if self.pixels == 0 { 0 } else { pass_limit };
    }

    /// The next pass; `None` when the picture is done.
    pub fn next(&self) -> Option<Work> {
        match self.stage {
            _ if self.pass_limit == 0 => None,
            Stage::Draft { divisor } => {
                Some(Work { divisor, effort: Effort::Draft, begins_film: true })
            }
            Stage::Accumulate { passes } if passes < self.pass_limit => {
                Some(Work { divisor: 1, effort: Effort::Full, begins_film: passes == 0 })
            }
            Stage::Accumulate { .. } => None,
        }
    }

    /// Takes note that the pass of [`next`](Self::next) was completed in `seconds`.
    pub fn complete(&mut self, seconds: f64) {
        let (cost, divisor, next) = match self.stage {
            Stage::Draft { divisor: 1 } => {
                (&mut self.draft_seconds_per_pixel, 1, Stage::Accumulate { passes: 0 })
            }
            Stage::Draft { divisor } => {
                (&mut self.draft_seconds_per_pixel, divisor, Stage::Draft { divisor: divisor / 2 })
            }
            Stage::Accumulate { passes } => {
                (&mut self.full_seconds_per_pixel, 1, Stage::Accumulate { passes: passes + 1 })
            }
        };
        let traced = (self.pixels as f64 / f64::from(divisor * divisor)).max(1.0);
        *cost += Self::SMOOTHING * (seconds / traced - *cost);
        self.stage = next;
    }
}

impl Default for Scheduler {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [u32; 2] = [1280, 800];
    const PIXELS: f64 = 1280.0 * 800.0;

    /// Completes all work at these costs per pixel.
    fn run(scheduler: &mut Scheduler, draft: f64, full: f64) -> Vec<Work> {
        let mut done = Vec::new();
        while let Some(work) = scheduler.next() {
            let cost = if work.effort == Effort::Draft { draft } else { full };
            done.push(work);
            scheduler.complete(cost * PIXELS / f64::from(work.divisor.pow(2)));
        }
        done
    }

    #[test]
    fn drafts_get_finer_until_full_effort_accumulates() {
        let mut scheduler = Scheduler::new();
        scheduler.restart(SIZE, 3);
        let works = run(&mut scheduler, 1e-6, 1e-5);
        let (drafts, passes) = works.split_at(works.len() - 3);
        let divisors: Vec<_> = drafts.iter().map(|work| work.divisor).collect();
        assert_eq!(divisors, [7, 3, 1]);
        assert!(drafts.iter().all(|work| work.effort == Effort::Draft && work.begins_film));
        assert!(passes.iter().all(|work| work.effort == Effort::Full && work.divisor == 1));
        let begins: Vec<_> = passes.iter().map(|work| work.begins_film).collect();
        assert_eq!(begins, [true, false, false]);
    }

    #[test]
    fn cheap_pictures_need_no_draft() {
        let mut scheduler = Scheduler::new();
        scheduler.restart([40, 40], 2);
        assert_eq!(scheduler.next().map(|work| work.effort), Some(Effort::Full));
    }

    #[test]
    fn the_first_pass_after_a_change_keeps_to_the_preview_budget() {
        for draft in [1e-8, 1e-7, 1e-6, 4e-6] {
            let mut scheduler = Scheduler::new();
            scheduler.restart(SIZE, 20);
            run(&mut scheduler, draft, 10.0 * draft);
            scheduler.restart(SIZE, 20);
            let work = scheduler.next().expect("there is work");
            let cost = if work.effort == Effort::Draft { draft } else { 10.0 * draft };
            let seconds = cost * PIXELS / f64::from(work.divisor.pow(2));
            assert!(seconds <= Scheduler::PREVIEW_SECONDS * 1.05, "{seconds}");
        }
    }

    #[test]
    fn a_higher_limit_carries_on() {
        let mut scheduler = Scheduler::new();
        scheduler.restart(SIZE, 2);
        run(&mut scheduler, 1e-6, 1e-5);
        scheduler.limit_passes(4);
        let more = run(&mut scheduler, 1e-6, 1e-5);
        assert_eq!(more.len(), 2);
        assert!(more.iter().all(|work| !work.begins_film));
    }

    #[test]
    fn an_empty_picture_or_no_passes_is_no_work() {
        let mut scheduler = Scheduler::new();
        scheduler.restart([0, 800], 10);
        assert_eq!(scheduler.next(), None);
        scheduler.restart([100, 100], 0);
        assert_eq!(scheduler.next(), None);
    }
}
