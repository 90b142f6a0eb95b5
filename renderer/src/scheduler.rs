//! What to trace next: a pure value machine without clocks or threads.

/// One pass of tracing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Work {
    /// The picture's width and height are divided by this; 1 is full resolution.
    pub divisor: u32,
    /// Whether the pass begins an empty film.
    pub begins_film: bool,
}

/// Chooses the resolution of each pass.
///
/// After a restart the first pass is as fine as fits the preview budget; as long as no other
/// restart comes, each next pass halves the divisor until full resolution accumulates.
#[derive(Clone, Debug, PartialEq)]
pub struct Scheduler {
    seconds_per_pixel: f64,
    pixels: u64,
    pass_limit: u32,
    stage: Stage,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    Preview { divisor: u32 },
    Accumulate { passes: u32 },
}

impl Scheduler {
    /// Time that the first pass after a change may take, in seconds: 40 frames per second leave
    /// room for developing and for the window.
    pub const PREVIEW_SECONDS: f64 = 0.025;
    /// Coarsest preview: pixels of 16 × 16.
    pub const MAX_DIVISOR: u32 = 16;
    /// Cost of a pixel before the first is measured, in seconds.
    const UNMEASURED_SECONDS_PER_PIXEL: f64 = 2e-6;
    /// Weight of the newest measurement.
    const SMOOTHING: f64 = 0.5;

    /// Nothing to do yet.
    pub fn new() -> Self {
        Self {
            seconds_per_pixel: Self::UNMEASURED_SECONDS_PER_PIXEL,
            pixels: 0,
            pass_limit: 0,
            stage: Stage::Accumulate { passes: 0 },
        }
    }

    /// Starts a new picture of `size` that is done after `pass_limit` passes.
    pub fn restart(&mut self, size: [u32; 2], pass_limit: u32) {
        self.pixels = u64::from(size[0]) * u64::from(size[1]);
        self.pass_limit = if self.pixels == 0 { 0 } else { pass_limit };
        let full_seconds = self.seconds_per_pixel * self.pixels as f64;
        let divisor = (full_seconds / Self::PREVIEW_SECONDS).sqrt().ceil().max(1.0);
        self.stage = match (divisor as u32).min(Self::MAX_DIVISOR) {
            1 => Stage::Accumulate { passes: 0 },
            divisor => Stage::Preview { divisor },
        };
    }

    /// The next pass; `None` when the picture is done.
    pub fn next(&self) -> Option<Work> {
        match self.stage {
            _ if self.pass_limit == 0 => None,
            Stage::Preview { divisor } => Some(Work { divisor, begins_film: true }),
            Stage::Accumulate { passes } if passes < self.pass_limit => {
                Some(Work { divisor: 1, begins_film: passes == 0 })
            }
            Stage::Accumulate { .. } => None,
        }
    }

    /// Takes note that the pass of [`next`](Self::next) was completed in `seconds`.
    pub fn complete(&mut self, seconds: f64) {
        let (divisor, next) = match self.stage {
            Stage::Preview { divisor } if divisor <= 2 => {
                (divisor, Stage::Accumulate { passes: 0 })
            }
            Stage::Preview { divisor } => (divisor, Stage::Preview { divisor: divisor / 2 }),
            Stage::Accumulate { passes } => (1, Stage::Accumulate { passes: passes + 1 }),
        };
        let traced = (self.pixels as f64 / f64::from(divisor * divisor)).max(1.0);
        self.seconds_per_pixel += Self::SMOOTHING * (seconds / traced - self.seconds_per_pixel);
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

    fn run(scheduler: &mut Scheduler, seconds_per_pixel: f64, pixels: f64) -> Vec<Work> {
        let mut done = Vec::new();
        while let Some(work) = scheduler.next() {
            done.push(work);
            scheduler.complete(seconds_per_pixel * pixels / f64::from(work.divisor.pow(2)));
        }
        done
    }

    #[test]
    fn previews_get_finer_until_full_resolution_accumulates() {
        let mut scheduler = Scheduler::new();
        scheduler.restart([1280, 800], 3);
        let works = run(&mut scheduler, 2e-6, 1280.0 * 800.0);
        let divisors: Vec<_> = works.iter().map(|work| work.divisor).collect();
        assert_eq!(divisors, [10, 5, 2, 1, 1, 1]);
        let begins: Vec<_> = works.iter().map(|work| work.begins_film).collect();
        assert_eq!(begins, [true, true, true, true, false, false]);
    }

    #[test]
    fn cheap_pictures_start_at_full_resolution() {
        let mut scheduler = Scheduler::new();
        scheduler.restart([64, 64], 2);
        assert_eq!(scheduler.next(), Some(Work { divisor: 1, begins_film: true }));
    }

    #[test]
    fn the_first_pass_after_a_change_keeps_to_the_preview_budget() {
        for seconds_per_pixel in [1e-8, 1e-7, 1e-6, 4e-6] {
            let mut scheduler = Scheduler::new();
            scheduler.restart([1280, 800], 20);
            run(&mut scheduler, seconds_per_pixel, 1_024_000.0);
            scheduler.restart([1280, 800], 20);
            let divisor = f64::from(scheduler.next().map_or(0, |work| work.divisor));
            let seconds = seconds_per_pixel * 1_024_000.0 / (divisor * divisor);
            assert!(seconds <= Scheduler::PREVIEW_SECONDS * 1.001, "{seconds}");
        }
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
