//! How much work a submission gets, so that it takes a few milliseconds whatever the scene.

use std::time::Duration;

/// Time that a submission should take. Two are in flight, so that the device, which may draw a
/// desktop too, is never away for longer than twice that.
const TARGET: Duration = Duration::from_millis(4);
/// The same where the device is the processor, which shares its time out by itself, and to which
/// each submission costs more.
const SOFTWARE_TARGET: Duration = Duration::from_millis(40);
/// Rays per walker of the very first submission.
const FIRST_BUDGET: u32 = 8;
/// Fewest rays per walker: less would be spent on coming and going.
const MIN_BUDGET: u32 = 2;
/// Most rays per walker.
const MAX_BUDGET: u32 = 1 << 16;
/// The same where the device is software: Mesa's ends all loops of an invocation when they have
/// turned 65535 times in all (`LP_MAX_TGSI_LOOP_ITERATIONS`), and a ray takes hundreds of turns.
const SOFTWARE_MAX_BUDGET: u32 = 32;
/// Most that the budget grows at a time.
const MAX_GROWTH: f64 = 2.0;

/// Sizes the next submission from what the last ones took.
///
/// Towards the end of a round ever fewer walkers have work and each gets on faster, so that the
/// budget grows; the next round, where all have work again, begins with what was right when all
/// had.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pace {
    target: Duration,
    max_budget: u32,
    budget: u32,
    loaded_budget: u32,
}

impl Pace {
    /// Begins carefully.
    pub(super) fn new(is_software: bool) -> Self {
        let (target, max_budget) =
            if is_software { (SOFTWARE_TARGET, SOFTWARE_MAX_BUDGET) } else { (TARGET, MAX_BUDGET) };
        Self { target, max_budget, budget: FIRST_BUDGET, loaded_budget: FIRST_BUDGET }
    }

    /// All walkers get work again.
    pub(super) fn begin_round(&mut self) {
        self.budget = self.loaded_budget;
    }

    /// Rays that each walker may follow in the next submission.
    pub(super) fn budget(self) -> u32 {
        self.budget
    }

    /// Learns that a submission of `budget` took `elapsed`; `is_loaded` where every walker had
    /// work all the while.
    pub(super) fn observe(&mut self, budget: u32, elapsed: Duration, is_loaded: bool) {
        let ratio = self.target.as_secs_f64() / elapsed.as_secs_f64().max(1e-9);
        let fitting = (f64::from(budget) * ratio.min(MAX_GROWTH)) as u32;
        self.budget = fitting.clamp(MIN_BUDGET, self.max_budget);
        // What is too much for some is too much for all.
        if is_loaded || self.budget < self.loaded_budget {
            self.loaded_budget = self.budget;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A device that takes a fixed time per submission and a time per ray, two in flight.
    fn run(pace: &mut Pace, submissions: usize, per_ray: Duration, is_loaded: bool) -> Vec<u32> {
        let mut budgets = vec![pace.budget(), pace.budget()];
        for i in 0..submissions {
            let elapsed = Duration::from_micros(100) + per_ray * budgets[i];
            pace.observe(budgets[i], elapsed, is_loaded);
            budgets.push(pace.budget());
        }
        budgets
    }

    #[test]
    fn it_settles_at_the_target() {
        for per_ray_us in [10, 40, 300] {
            let per_ray = Duration::from_micros(per_ray_us);
            let mut pace = Pace::new(false);
            run(&mut pace, 30, per_ray, true);
            let time = per_ray * pace.budget();
            assert!(time <= TARGET && time * 10 >= TARGET * 8, "{per_ray_us}: {time:?}");
        }
    }

    #[test]
    fn it_grows_by_no_more_than_twofold_and_not_for_ever() {
        let mut pace = Pace::new(false);
        let budgets = run(&mut pace, 60, Duration::ZERO, true);
        assert!(budgets.windows(3).all(|w| w[2] <= 2 * w[0].max(w[1])), "{budgets:?}");
        assert_eq!(pace.budget(), MAX_BUDGET);
        let mut pace = Pace::new(true);
        run(&mut pace, 60, Duration::ZERO, true);
        assert_eq!(pace.budget(), SOFTWARE_MAX_BUDGET);
    }

    #[test]
    fn it_reacts_at_once_to_a_slow_submission() {
        let mut pace = Pace::new(false);
        run(&mut pace, 30, Duration::from_micros(10), true);
        let before = pace.budget();
        pace.observe(before, TARGET * 10, true);
        assert!(pace.budget() <= before / 10 + 1);
        pace.observe(MIN_BUDGET, Duration::from_secs(1), true);
        assert_eq!(pace.budget(), MIN_BUDGET);
    }

    #[test]
    fn what_the_last_walkers_reach_is_not_given_to_all() {
        let mut pace = Pace::new(false);
        run(&mut pace, 30, Duration::from_micros(100), true);
        let loaded = pace.budget();
        run(&mut pace, 30, Duration::from_micros(1), false);
        assert!(pace.budget() > 20 * loaded);
        pace.begin_round();
        assert_eq!(pace.budget(), loaded);
    }

    #[test]
    fn what_is_too_slow_for_some_is_not_given_to_all() {
        let mut pace = Pace::new(false);
        run(&mut pace, 30, Duration::from_micros(10), true);
        pace.observe(pace.budget(), TARGET * 4, false);
        let slowed = pace.budget();
        pace.observe(slowed, TARGET / 2, false);
        pace.begin_round();
        assert_eq!(pace.budget(), slowed);
    }
}
