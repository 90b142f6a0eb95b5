//! How much work a submission gets, so that it takes a few milliseconds whatever the scene.

use std::time::Duration;

use crate::kernel::reach::REACH_BISECTIONS;
use crate::packed::{CONVEX, NONE, PackedMaterial, PackedScene};
use crate::settings::Splitting;

/// Time that a submission should take. Two are in flight, so that the device, which may draw a
/// desktop too, is never away for longer than twice that.
const TARGET: Duration = Duration::from_millis(4);
/// The same where the device is the processor, which shares its time out by itself, and to which
/// each submission costs more.
const SOFTWARE_TARGET: Duration = Duration::from_millis(40);
/// Rays per walker of the first submission of something new.
const FIRST_BUDGET: u32 = 8;
/// Fewest rays per walker: less would be spent on coming and going.
const MIN_BUDGET: u32 = 2;
/// Most rays per walker.
const MAX_BUDGET: u32 = 1 << 16;
/// The same where the device is software: Mesa's ends all loops of an invocation when they have
/// turned 65535 times in all (`LP_MAX_TGSI_LOOP_ITERATIONS`), and a ray takes hundreds of turns.
const SOFTWARE_MAX_BUDGET: u32 = 32;
/// What is then left for one ray.
const SOFTWARE_RAY_TURNS: u64 = SOFTWARE_TURNS / SOFTWARE_MAX_BUDGET as u64;
const SOFTWARE_TURNS: u64 = 65535;
/// Turns that a ray takes at most, or near enough, to meet a mesh.
const MESH_TURNS: u64 = 256;
/// Most that the budget grows at a time.
const MAX_GROWTH: f64 = 2.0;
/// How many times the target the least budget may take before fewer walkers get on at a time. More
/// than halving them gains, or they would come and go.
const TOO_SLOW: u32 = 4;
/// Most parts that the walkers are taken in. A device with few of them idles, so that more parts
/// would hardly shorten the submissions any more.
const MAX_PARTS: u32 = 16;

/// The work of one submission.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ration {
    /// Rays that each walker may follow.
    pub(super) budget: u32,
    /// Into how many parts the walkers are divided, of which one gets on. More than 1 only where
    /// even the least budget is too much for all.
    pub(super) parts: u32,
}

impl Ration {
    const FIRST: Self = Self { budget: FIRST_BUDGET, parts: 1 };

    fn is_less_than(self, other: Self) -> bool {
        self.budget * other.parts < other.budget * self.parts
    }
}

/// Rays divided like this that a walker on a software device can follow in this scene without running
/// out of turns; 0 where not even one.
pub(super) fn software_budget(scene: &PackedScene, splitting: Splitting) -> u32 {
    let per_segment = scene.top_nodes.len() as u64 + body_turns(scene).sum::<u64>();
    // At worst a matte point follows all passages back in all bins, by three rays each.
    let per_passage = 1 + 3 * per_segment * scene.bins.count() as u64;
    let per_ray = SOFTWARE_RAY_TURNS + per_passage * scene.passages.len() as u64;
    let more = match splitting {
        Splitting::Paper => 0,
        Splitting::Exact => fan_turns(scene),
    };
    (SOFTWARE_TURNS / (per_ray + more)) as u32
}

/// Turns that a ray takes at most to meet each of the bodies, or near enough.
fn body_turns(scene: &PackedScene) -> impl Iterator<Item = u64> + '_ {
    scene.instances.iter().map(|instance| match instance.kind {
        CONVEX => u64::from(instance.count),
        _ => MESH_TURNS,
    })
}

/// Turns that a fan takes beyond those of a ray: in search of where it parts it traces rays, and so
/// it does at a matte surface, one to each light for each bin. Such a ray comes near to one body.
fn fan_turns(scene: &PackedScene) -> u64 {
    let per_segment = scene.top_nodes.len() as u64 + body_turns(scene).max().unwrap_or(0);
    let is_on_ground = scene.ground.reflectance[0] != NONE;
    let mut segments = 0;
    if is_on_ground || scene.instances.len() > 1 {
        segments += 2 * u64::from(1 + REACH_BISECTIONS);
    }
    if is_on_ground || scene.materials.iter().any(PackedMaterial::is_opaque) {
        segments += (scene.bins.count() * (scene.discs.len() + 1)) as u64;
    }
    segments * per_segment
}

/// Sizes the next submission from what the last ones took.
///
/// Towards the end of a round ever fewer walkers have work and each gets on faster, so that the
/// ration grows; the next round, where all have work again, begins with what was right when all
/// had.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pace {
    target: Duration,
    max_budget: u32,
    ration: Ration,
    loaded_ration: Ration,
}

impl Pace {
    /// Begins carefully.
    pub(super) fn new(is_software: bool) -> Self {
        let (target, max_budget) =
            if is_software { (SOFTWARE_TARGET, SOFTWARE_MAX_BUDGET) } else { (TARGET, MAX_BUDGET) };
        Self { target, max_budget, ration: Ration::FIRST, loaded_ration: Ration::FIRST }
    }

    /// Something else is traced, whose rays may cost a thousand times as much.
    pub(super) fn begin_carefully(&mut self) {
        if Ration::FIRST.is_less_than(self.loaded_ration) {
            self.loaded_ration = Ration::FIRST;
        }
    }

    /// All walkers get work again.
    pub(super) fn begin_round(&mut self) {
        self.ration = self.loaded_ration;
    }

    /// The work of the next submission.
    pub(super) fn ration(self) -> Ration {
        self.ration
    }

    /// Learns that a submission of `ration` took `elapsed`; `is_loaded` where every walker had
    /// work all the while.
    pub(super) fn observe(&mut self, ration: Ration, elapsed: Duration, is_loaded: bool) {
        let Ration { budget, parts } = ration;
        let ratio = self.target.as_secs_f64() / elapsed.as_secs_f64().max(1e-9);
        let fitting = (f64::from(budget) * ratio.min(MAX_GROWTH)) as u32;
        self.ration = if budget == MIN_BUDGET && elapsed > self.target * TOO_SLOW {
            Ration { budget, parts: (2 * parts).min(MAX_PARTS) }
        } else if parts == 1 {
            Ration { budget: fitting.clamp(MIN_BUDGET, self.max_budget), parts }
        } else {
            Ration { budget, parts: if elapsed < self.target { parts / 2 } else { parts } }
        };
        // What is too much for some is too much for all.
        if is_loaded || self.ration.is_less_than(self.loaded_ration) {
            self.loaded_ration = self.ration;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A device that takes a fixed time per submission and a time per ray, two in flight.
    fn run(pace: &mut Pace, submissions: usize, per_ray: Duration, is_loaded: bool) -> Vec<Ration> {
        let mut rations = vec![pace.ration(), pace.ration()];
        for i in 0..submissions {
            pace.observe(rations[i], time(rations[i], per_ray), is_loaded);
            rations.push(pace.ration());
        }
        rations
    }

    fn time(ration: Ration, per_ray: Duration) -> Duration {
        Duration::from_micros(100) + per_ray * ration.budget / ration.parts
    }

    fn whole(budget: u32) -> Ration {
        Ration { budget, parts: 1 }
    }

    #[test]
    fn it_settles_at_the_target() {
        for per_ray_us in [10, 40, 300] {
            let per_ray = Duration::from_micros(per_ray_us);
            let mut pace = Pace::new(false);
            run(&mut pace, 30, per_ray, true);
            let time = per_ray * pace.ration().budget;
            assert!(time <= TARGET && time * 10 >= TARGET * 8, "{per_ray_us}: {time:?}");
        }
    }

    #[test]
    fn it_grows_by_no_more_than_twofold_and_not_for_ever() {
        let mut pace = Pace::new(false);
        let rations = run(&mut pace, 60, Duration::ZERO, true);
        let budgets: Vec<_> = rations.iter().map(|ration| ration.budget).collect();
        assert!(budgets.windows(3).all(|w| w[2] <= 2 * w[0].max(w[1])), "{budgets:?}");
        assert_eq!(pace.ration(), whole(MAX_BUDGET));
        let mut pace = Pace::new(true);
        run(&mut pace, 60, Duration::ZERO, true);
        assert_eq!(pace.ration(), whole(SOFTWARE_MAX_BUDGET));
    }

    #[test]
    fn it_reacts_at_once_to_a_slow_submission() {
        let mut pace = Pace::new(false);
        run(&mut pace, 30, Duration::from_micros(10), true);
        let before = pace.ration();
        pace.observe(before, TARGET * 10, true);
        assert!(pace.ration().budget <= before.budget / 10 + 1);
        pace.observe(before, Duration::from_secs(1), true);
        assert_eq!(pace.ration(), whole(MIN_BUDGET));
    }

    #[test]
    fn rays_that_cost_a_thousand_times_as_much_don_t_hold_the_device_up() {
        let mut pace = Pace::new(false);
        let cheap = Duration::from_nanos(100);
        run(&mut pace, 60, cheap, true);
        assert!(time(pace.ration(), 1000 * cheap) > 100 * TARGET);
        pace.begin_carefully();
        pace.begin_round();
        for ration in run(&mut pace, 60, 1000 * cheap, true) {
            assert!(time(ration, 1000 * cheap) <= 2 * TARGET, "{ration:?}");
        }
        // And back: it has the old pace again after some submissions that take no time.
        pace.begin_carefully();
        pace.begin_round();
        run(&mut pace, 24, cheap, true);
        assert!(2 * time(pace.ration(), cheap) > TARGET, "{pace:?}");
    }

    #[test]
    fn where_the_least_budget_takes_too_long_fewer_walkers_get_on() {
        let mut pace = Pace::new(false);
        let (dear, cheap) = (10 * TARGET, TARGET / 100);
        run(&mut pace, 30, dear, true);
        assert_eq!(pace.ration().budget, MIN_BUDGET);
        assert!(time(pace.ration(), dear) <= TOO_SLOW * TARGET, "{pace:?}");
        // It stays so, and a new scene is no less careful.
        let settled = pace.ration();
        let rations = run(&mut pace, 30, dear, true);
        assert!(rations.iter().all(|&ration| ration == settled), "{rations:?}");
        pace.begin_carefully();
        pace.begin_round();
        assert_eq!(pace.ration(), settled);
        // And all get on again where there is room.
        run(&mut pace, 30, cheap, true);
        assert!(pace.ration().parts == 1 && pace.ration().budget > 50, "{pace:?}");
        // There is an end to it.
        run(&mut pace, 30, 1000 * TARGET, true);
        assert_eq!(pace.ration(), Ration { budget: MIN_BUDGET, parts: MAX_PARTS });
    }

    #[test]
    fn what_the_last_walkers_reach_is_not_given_to_all() {
        let mut pace = Pace::new(false);
        run(&mut pace, 30, Duration::from_micros(100), true);
        let loaded = pace.ration();
        run(&mut pace, 30, Duration::from_micros(1), false);
        assert!(pace.ration().budget > 20 * loaded.budget);
        pace.begin_round();
        assert_eq!(pace.ration(), loaded);
    }

    #[test]
    fn what_is_too_slow_for_some_is_not_given_to_all() {
        let mut pace = Pace::new(false);
        run(&mut pace, 30, Duration::from_micros(10), true);
        pace.observe(pace.ration(), TARGET * 4, false);
        let slowed = pace.ration();
        pace.observe(slowed, TARGET / 2, false);
        pace.begin_round();
        assert_eq!(pace.ration(), slowed);
    }
}
