//! Exact splitting: fans on both tracers.

use brilliance_renderer::scene::Transform;
use brilliance_renderer::settings::{Splitting, TraceSettings};
use brilliance_renderer::tracer::Tracer;

use super::cases::{self, Case};
use super::films::{assert_in_step, write_side_by_side};
use super::{TRACER, cpu_film, relative, total, trace};

/// By exact splitting, and little left to chance. Fans are divided as long as they carry a tenth of the
/// threshold: far enough above what rounding decides.
fn exact(mut case: Case) -> Case {
    let splitting = Splitting::Exact;
    let trace = case.document.trace;
    case.document.trace =
        TraceSettings { splitting, roulette_threshold: 1e-3, max_depth: 12, ..trace };
    case
}

/// Within a block of green glass.
fn glazed(mut case: Case) -> Case {
    let mut glass = cases::nested().document.scene.objects.swap_remove(1);
    glass.transform = Transform { scale: 3.0, ..Transform::default() };
    case.document.scene.objects.push(glass);
    Case { name: "in-glass", passes: 1, ..case }
}

#[test]
fn single_diamond() {
    assert_in_step(&exact(cases::diamond()), &TRACER);
}

#[test]
fn seven_diamonds_on_a_cloth() {
    assert_in_step(&exact(cases::seven_diamonds()), &TRACER);
}

#[test]
fn mesh_in_glass() {
    assert_in_step(&exact(glazed(cases::mesh())), &TRACER);
}

#[test]
fn coloured_stones_in_each_other_and_beside_a_matte_block() {
    assert_in_step(&exact(cases::nested()), &TRACER);
}

#[test]
fn word_and_prism() {
    assert_in_step(&exact(cases::print()), &TRACER);
}

#[test]
fn white_furnace() {
    let case = exact(cases::furnace());
    let (film, statistics) = trace(&*TRACER, &case);
    let film = TRACER.read(film).expect("the film is read");
    let mean = total(&film) / (film.sums().len() as f64 * f64::from(film.passes()));
    let ended = statistics.ledger.pruned + statistics.ledger.cut_off;
    let expected = 1.0 - ended / statistics.ledger.entered;
    assert!((mean - expected).abs() < 1e-4, "{mean} {expected}");
}

/// Where weak fans live by chance the books may be below 0, and the pixels differ where one rounding
/// lets both sides draw differently; not so their mean.
#[test]
fn what_is_left_to_chance_is_the_same_in_the_mean() {
    let mut case = exact(cases::diamond());
    case.document.trace = TraceSettings { roulette_threshold: 0.03, ..case.document.trace };
    let case = Case { name: "chance", passes: 4, ..case };
    let (film, statistics) = trace(&*TRACER, &case);
    let film = TRACER.read(film).expect("the film is read");
    let (cpu, cpu_statistics) = cpu_film(&case);
    let apart = relative(total(&cpu), total(&film));
    if apart > 5e-3 {
        let path = write_side_by_side(&case, &cpu, &film);
        panic!("the means differ by {apart:e}; see {}", path.display());
    }
    let ledgers = [cpu_statistics.ledger, statistics.ledger];
    for ledger in ledgers {
        assert!(ledger.imbalance().abs() < 1e-4 * ledger.entered, "{ledger:?}");
    }
    let [cpu, gpu] = ledgers.map(|ledger| ledger.pruned);
    assert!((cpu - gpu).abs() < 5e-3 * statistics.ledger.entered, "{ledgers:?}");
}
