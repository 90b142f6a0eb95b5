//! The scheduler by itself, with costs as they are told.

use super::*;

const SIZE: [u32; 2] = [1280, 800];
const PIXELS: f64 = 1280.0 * 800.0;

/// Completes all work at these costs per pixel.
fn run(scheduler: &mut Scheduler, draft: f64, full: f64) -> Vec<Work> {
    let mut done = Vec::new();
    while let Some(work) = scheduler.next() {
        done.push(work);
        scheduler.complete(work, seconds(work, draft, full));
    }
    done
}

fn seconds(work: Work, draft: f64, full: f64) -> f64 {
    let cost = if work.effort == Effort::Draft { draft } else { full };
    cost * PIXELS * f64::from(work.passes) / f64::from(work.divisor.pow(2))
}

#[test]
fn drafts_get_finer_until_full_effort_accumulates() {
    let mut scheduler = Scheduler::new(Machine::Processor);
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
    let mut scheduler = Scheduler::new(Machine::Processor);
    scheduler.restart([40, 40], 2);
    assert_eq!(scheduler.next().map(|work| work.effort), Some(Effort::Full));
}

#[test]
fn the_first_pass_after_a_change_keeps_to_the_preview_budget() {
    for draft in [1e-8, 1e-7, 1e-6, 4e-6] {
        let mut scheduler = Scheduler::new(Machine::Processor);
        scheduler.restart(SIZE, 20);
        run(&mut scheduler, draft, 10.0 * draft);
        scheduler.restart(SIZE, 20);
        let work = scheduler.next().expect("there is work");
        let seconds = seconds(work, draft, 10.0 * draft);
        assert!(seconds <= Scheduler::PREVIEW_SECONDS * 1.05, "{seconds}");
    }
}

#[test]
fn a_higher_limit_carries_on() {
    let mut scheduler = Scheduler::new(Machine::Processor);
    scheduler.restart(SIZE, 2);
    run(&mut scheduler, 1e-6, 1e-5);
    scheduler.limit_passes(4);
    let more = run(&mut scheduler, 1e-6, 1e-5);
    assert_eq!(more.len(), 2);
    assert!(more.iter().all(|work| !work.begins_film));
}

const ADAPTIVE: NoiseGoal = NoiseGoal { target: 0.01, is_adaptive: true };

#[test]
fn rounds_end_where_pixels_are_left_out_and_teach_nothing_after_that() {
    let mut scheduler = Scheduler::new(Machine::GraphicsCard);
    scheduler.aim_at(ADAPTIVE);
    scheduler.restart(SIZE, 100);
    let mut ends = Vec::new();
    while let Some(work) = scheduler.next() {
        let done = ends.last().map_or(0, |&end| end) + work.passes;
        // What is left of the pixels later is a tenth of the work.
        let share = if done > next_measurement(0) { 0.1 } else { 1.0 };
        scheduler.complete(work, share * seconds(work, FAST, FAST));
        ends.push(done);
    }
    assert_eq!(ends, [1, 2, 4, 8, 12, 16, 20, 24, 28, 32, 40, 48, 56, 64, 80, 96, 100]);
    assert!((scheduler.full.seconds / FAST - 1.0).abs() < 1e-9, "{scheduler:?}");
}

#[test]
fn a_picture_that_is_good_enough_is_done_until_more_is_wanted_of_it() {
    let mut scheduler = Scheduler::new(Machine::Processor);
    scheduler.aim_at(ADAPTIVE);
    scheduler.restart([40, 40], 100);
    scheduler.complete(scheduler.next().expect("there is work"), 1e-3);
    scheduler.settle();
    assert_eq!(scheduler.next(), None);
    scheduler.limit_passes(200);
    assert_eq!(scheduler.next(), None, "more passes are no better picture");
    scheduler.aim_at(NoiseGoal { target: 0.005, ..ADAPTIVE });
    assert!(scheduler.next().is_some_and(|work| !work.begins_film));
    scheduler.settle();
    scheduler.restart([40, 40], 100);
    assert!(scheduler.next().is_some_and(|work| work.begins_film));
}

/// A pass of a graphics card: 1280 × 800 in half a millisecond.
const FAST: f64 = 5e-4 / PIXELS;

#[test]
fn fast_passes_come_in_rounds_that_double_the_film_up_to_a_tenth_of_a_second() {
    let mut scheduler = Scheduler::new(Machine::Processor);
    scheduler.restart(SIZE, 1000);
    run(&mut scheduler, FAST, FAST);
    scheduler.restart(SIZE, 1000);
    let works = run(&mut scheduler, FAST, FAST);
    let passes: Vec<_> = works.iter().map(|work| work.passes).collect();
    assert_eq!(&passes[..9], [1, 1, 2, 4, 8, 16, 32, 64, 128]);
    assert!(passes[9..passes.len() - 1].iter().all(|passes| (190..=200).contains(passes)));
    assert_eq!(passes.iter().sum::<u32>(), 1000, "no more than was asked for");
    assert!(works.iter().all(|work| work.effort == Effort::Full), "{works:?}");
}

#[test]
fn passes_longer_than_the_publish_interval_come_one_by_one() {
    for full in [0.034 / PIXELS, 1.0 / PIXELS] {
        let mut scheduler = Scheduler::new(Machine::Processor);
        scheduler.restart(SIZE, 12);
        let works = run(&mut scheduler, full / 4.0, full);
        assert!(works.iter().all(|work| work.passes == 1), "{works:?}");
    }
}

#[test]
fn a_graphics_card_begins_at_full_resolution() {
    for size in [SIZE, [3840, 2160]] {
        let mut scheduler = Scheduler::new(Machine::GraphicsCard);
        scheduler.restart(size, 1);
        assert_eq!(scheduler.next().map(|work| work.divisor), Some(1));
    }
}

#[test]
fn a_graphics_card_finds_out_that_rounds_hide_what_a_single_pass_waits_for() {
    let mut scheduler = Scheduler::new(Machine::GraphicsCard);
    scheduler.restart(SIZE, 500);
    let mut rounds = Vec::new();
    while let Some(work) = scheduler.next() {
        rounds.push(work.passes);
        // Each round waits for its heaviest pixel, whatever the number of passes.
        scheduler.complete(work, 0.06 + 0.002 * f64::from(work.passes));
    }
    // A tenth of a second has room for 20 passes and the wait.
    assert!(rounds[rounds.len() - 2] >= 15, "{rounds:?}");
}

#[test]
fn work_that_is_always_interrupted_gets_smaller_until_it_is_done() {
    // The guess for a graphics card is far too low for these. Every restart halves the sides.
    for full in [0.3 / PIXELS, 3.0 / PIXELS, 30.0 / PIXELS] {
        let mut scheduler = Scheduler::new(Machine::GraphicsCard);
        let restarts = (1..10).find(|_| {
            scheduler.restart(SIZE, 20);
            let work = scheduler.next().expect("there is work");
            let is_done = seconds(work, full, full) <= Scheduler::PATIENCE_SECONDS;
            if !is_done {
                scheduler.interrupt(work, Scheduler::PATIENCE_SECONDS);
            }
            is_done
        });
        assert!(restarts.is_some_and(|restarts| restarts <= 7), "{full}: {restarts:?}");
    }
}

#[test]
fn drafts_that_take_long_however_coarse_are_given_longer() {
    let mut scheduler = Scheduler::new(Machine::Processor);
    let mut shown = Vec::new();
    for _ in 0..8 {
        scheduler.restart(SIZE, 20);
        let work = scheduler.next().expect("there is work");
        let patience = scheduler.patience_seconds();
        shown.push(patience >= 0.3);
        if patience >= 0.3 {
            scheduler.complete(work, 0.3);
            assert!(scheduler.patience_seconds() <= 0.0, "only the first round is given any");
        } else {
            scheduler.interrupt(work, patience);
        }
    }
    assert_eq!(shown, [false, false, true, true, true, true, true, true]);
    scheduler.restart(SIZE, 20);
    let work = scheduler.next().expect("there is work");
    scheduler.complete(work, 0.01);
    scheduler.restart(SIZE, 20);
    assert!(scheduler.patience_seconds() <= Scheduler::PATIENCE_SECONDS, "it is not for ever");
}

#[test]
fn what_is_interrupted_soon_teaches_nothing() {
    let mut scheduler = Scheduler::new(Machine::Processor);
    scheduler.restart(SIZE, 3);
    run(&mut scheduler, 1e-6, 1e-5);
    scheduler.restart(SIZE, 3);
    let before = scheduler.clone();
    let work = scheduler.next().expect("there is work");
    scheduler.interrupt(work, 1e-3);
    assert_eq!(scheduler, before);
}

#[test]
fn the_first_measurement_replaces_the_guess() {
    let mut scheduler = Scheduler::new(Machine::Processor);
    scheduler.restart(SIZE, 1);
    run(&mut scheduler, FAST, FAST);
    scheduler.restart(SIZE, 1);
    assert_eq!(scheduler.next().map(|work| work.effort), Some(Effort::Full));
}

#[test]
fn an_empty_picture_or_no_passes_is_no_work() {
    let mut scheduler = Scheduler::new(Machine::Processor);
    scheduler.restart([0, 800], 10);
    assert_eq!(scheduler.next(), None);
    scheduler.restart([100, 100], 0);
    assert_eq!(scheduler.next(), None);
}
