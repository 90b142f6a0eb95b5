//! Passes that leave out settled pixels make the same picture for less.

use std::sync::atomic::AtomicBool;

use brilliance_renderer::film::{Counts, Film};
use brilliance_renderer::session::RenderRequest;
use brilliance_renderer::settings::NoiseGoal;
use brilliance_renderer::still::{Still, StillLimits};

use crate::films::{Diamond, LONG, SIZE, brightness, relative_errors, request};
use crate::noise::percentile_98;

const GOAL: NoiseGoal = NoiseGoal { target: 0.03, is_adaptive: true };

fn samples(film: &Film) -> Vec<u32> {
    film.counts().iter().map(|counts: &Counts| counts.samples as u32).collect()
}

#[test]
fn settled_pixels_get_no_rays() {
    let diamond = Diamond::new();
    let mut film = diamond.film();
    diamond.trace(&mut film, 8);
    film.measure_noise(GOAL);
    let before = film.clone();
    let statistics = diamond.trace(&mut film, 4);
    let traced = samples(&film).iter().filter(|&&samples| samples == 12).count();
    assert_eq!(
        samples(&film).iter().filter(|&&samples| samples == 8).count(),
        film.counts().len() - traced
    );
    assert_eq!((film.passes(), statistics.camera_rays), (12, 4 * traced as u64));
    let share = traced as f64 / film.counts().len() as f64;
    assert!((0.1..0.9).contains(&share), "{share} of the pixels are traced on");
    let bins = film.bins().count();
    for (pixel, counts) in film.counts().iter().enumerate().filter(|(_, it)| it.samples < 9.0) {
        let sums = pixel * bins..(pixel + 1) * bins;
        assert_eq!(film.sums()[sums.clone()], before.sums()[sums]);
        assert_eq!(*counts, before.counts()[pixel]);
    }
    // Without a target, or where nothing is to be left out, all pixels are traced again.
    for goal in [NoiseGoal::NONE, NoiseGoal { is_adaptive: false, ..GOAL }] {
        let mut film = film.clone();
        film.measure_noise(goal);
        let all = film.counts().len() as u64;
        assert_eq!(diamond.trace(&mut film, 1).camera_rays, all, "{goal:?}");
    }
}

/// One pixel of a dark film that found light in one of eight samples: its neighbours, whose samples
/// all missed it, are not taken for settled; the others are.
#[test]
fn neighbours_of_a_glint_are_traced_on() {
    let diamond = Diamond::new();
    let mut film = diamond.film();
    let bins = film.bins().count();
    let (sums, counts) = film.sums_and_counts_mut();
    let glint = (20 * SIZE[0] + 10) as usize;
    sums.fill(8.0);
    counts.fill(Counts { samples: 8.0, squares: 8.0, ..Counts::default() });
    sums[glint * bins..][..bins].fill(16.0);
    counts[glint].squares = 7.0 + 81.0;
    film.measure_noise(GOAL);
    diamond.trace(&mut film, 1);
    let expected: Vec<_> = (0..SIZE[0] * SIZE[1])
        .map(|i| {
            let (x, y) = (i % SIZE[0], i / SIZE[0]);
            if x.abs_diff(10) <= 1 && y.abs_diff(20) <= 1 { 9 } else { 8 }
        })
        .collect();
    assert_eq!(samples(&film), expected);
}

/// Not much more than half the error, by what the goal is about, with no more than three quarters of the
/// ray segments.
#[test]
fn an_adaptive_picture_is_nearer_to_the_long_one_for_less() {
    let diamond = Diamond::new();
    let (even, even_cost, _) = diamond.trace_to(NoiseGoal::NONE, 32);
    let (adaptive, adaptive_cost, _) = diamond.trace_to(GOAL, 128);
    let error = |film: &Film| percentile_98(&relative_errors(film, &LONG));
    let [cost, even_cost] = [adaptive_cost, even_cost].map(|cost| cost.segments as f64);
    assert!(cost < 0.75 * even_cost, "{cost} of {even_cost} segments");
    let [adaptive, even] = [adaptive, even].map(|film| error(&film));
    assert!(adaptive < 0.6 * even, "error of {adaptive}, of {even} without");
}

/// Pixels that stop when they look settled stop a little sooner where a glint was missed. In all that
/// is not seen; without the brightest pixels, which hold half of the light, it is far less than the
/// noise. Half of it is what any noise loses to the limit: 0.2 % without a goal.
#[test]
fn an_adaptive_picture_is_neither_brighter_nor_darker() {
    let diamond = Diamond::new();
    let (film, ..) = diamond.trace_to(GOAL, 128);
    for (limit, tolerance) in [(f64::INFINITY, 0.001), (16.0, 0.005)] {
        let light = |film: &Film| brightness(film).iter().map(|it| it.min(limit)).sum::<f64>();
        let ratio = light(&film) / light(&LONG);
        assert!((ratio - 1.0).abs() < tolerance, "{ratio} up to {limit}");
    }
}

fn render(request: &RenderRequest) -> Still {
    Still::render(request, StillLimits::default(), None, &AtomicBool::new(false), |_, _| {})
        .expect("it is rendered")
}

#[test]
fn a_still_ends_when_its_noise_is_low_enough() {
    let goal = NoiseGoal { target: 0.05, is_adaptive: true };
    let still = render(&request(goal, 1000));
    assert!(still.noise.is_some_and(|noise| noise <= goal.target), "{:?}", still.noise);
    assert!((16..400).contains(&still.passes), "{} passes", still.passes);
    let even = render(&request(NoiseGoal { is_adaptive: false, ..goal }, 1000));
    assert!(even.noise.is_some_and(|noise| noise <= goal.target), "{:?}", even.noise);
    assert!(still.statistics.segments < even.statistics.segments);
    // The pass before the last measurement was not enough.
    let all = render(&request(goal, still.passes - 1));
    assert_eq!(all.passes, still.passes - 1);
    assert!(all.noise.is_none_or(|noise| noise > goal.target), "{:?}", all.noise);
    let few = render(&request(goal, 5));
    assert_eq!((few.passes, few.noise), (5, None), "nothing is known after so few passes");
}
