//! Rays through the prism of the diagram clump or cross without `perturb` only.

use brilliance_renderer::drawing::{
    Mark, PerturbShown, PrismRays, PrismSetup, Words, prism_diagram,
};

/// Far enough for every crossing of rays that are not nearly parallel, in mm.
const REACH_MM: f64 = 40.0;

fn trace(setup: &PrismSetup) -> [PrismRays; 2] {
    [false, true].map(|perturb| PrismRays::trace(setup, perturb).unwrap())
}

/// Deviation of light of one wavelength in degrees: the textbook formula (Born & Wolf, §4.7.2).
fn deviation(setup: &PrismSetup, lambda_nm: f64) -> f64 {
    let n = setup.n_d - setup.dispersion_bg * (lambda_nm - 589.3) / (686.7 - 430.8);
    let (apex, incidence) = (setup.apex_degrees.to_radians(), setup.incidence_degrees.to_radians());
    let inside = (incidence.sin() / n).asin();
    let exit = (n * (apex - inside).sin()).asin();
    (incidence + exit - apex).to_degrees()
}

#[test]
fn without_perturb_rays_leave_in_clumps_with_gaps() {
    let [without, with] = trace(&PrismSetup::CLUMPING);
    assert!(without.inside.len() >= 3 && without.leaving.len() >= 6, "{}", without.leaving.len());
    assert!(without.uncovered() > 0.3, "{}", without.uncovered());
    assert!(with.uncovered() < 0.02, "{}", with.uncovered());
    assert_eq!(with.crossings(REACH_MM), 0);
}

#[test]
fn without_perturb_rays_of_a_thin_prism_cross() {
    let [without, with] = trace(&PrismSetup::CROSSING);
    assert!(without.crossings(REACH_MM) > 5, "{}", without.crossings(REACH_MM));
    assert_eq!(with.crossings(REACH_MM), 0);
    assert!(with.uncovered() < 0.02, "{}", with.uncovered());
}

/// With `perturb` each ray leaves as light of its own middle wavelength does.
#[test]
fn perturbed_rays_leave_where_the_formula_says() {
    for setup in [PrismSetup::CLUMPING, PrismSetup::CROSSING] {
        let [without, with] = trace(&setup);
        let worst = |rays: &PrismRays| {
            let errors = rays.leaving.iter().map(|ray| {
                let central_nm = 0.5 * (ray.interval_nm[0] + ray.interval_nm[1]);
                (ray.deviation_degrees(rays.arrival) - deviation(&setup, central_nm)).abs()
            });
            errors.fold(0.0, f64::max)
        };
        let fan = deviation(&setup, 380.0) - deviation(&setup, 730.0);
        assert!(worst(&with) < 0.02 * fan, "{}° of {fan}°", worst(&with));
        assert!(worst(&without) > 3.0 * worst(&with), "{}° of {fan}°", worst(&without));
    }
}

/// In wavelength order the perturbed rays turn steadily, and cover the spectrum once.
#[test]
fn perturbed_rays_keep_the_order_of_the_spectrum() {
    for setup in [PrismSetup::CLUMPING, PrismSetup::CROSSING] {
        let [_, with] = trace(&setup);
        for pair in with.leaving.windows(2) {
            assert!((pair[0].interval_nm[1] - pair[1].interval_nm[0]).abs() < 1e-3);
            let [a, b] = [&pair[0], &pair[1]].map(|ray| ray.deviation_degrees(with.arrival));
            assert!(a > b, "blue is turned more than red");
        }
    }
}

#[test]
fn every_setting_gives_a_sheet_of_finite_numbers() {
    let grid = |range: std::ops::RangeInclusive<f64>| {
        [*range.start(), 0.4 * range.start() + 0.6 * range.end(), *range.end()]
    };
    for apex_degrees in grid(PrismSetup::APEX_DEGREES) {
        for incidence_degrees in grid(PrismSetup::INCIDENCE_DEGREES) {
            for (n_d, dispersion_bg) in [(1.3, 0.4), (1.5, 0.0), (2.6, 0.4)] {
                for (lamp_degrees, split_count) in [(20.0, 0.5), (1.0, 4.0)] {
                    let setup = PrismSetup {
                        apex_degrees,
                        n_d,
                        dispersion_bg,
                        incidence_degrees,
                        lamp_degrees,
                        split_count,
                    };
                    let sheet = prism_diagram(&setup, PerturbShown::Both).unwrap();
                    for mark in &sheet.marks {
                        let points = match mark {
                            Mark::Stroke(stroke) => &stroke.points,
                            Mark::Fill(fill) => &fill.points,
                            Mark::Words(words) => &vec![words.at],
                        };
                        for point in points {
                            let on_paper = point.is_finite()
                                && point.min_element() >= 0.0
                                && point.cmple(sheet.size_mm).all();
                            assert!(on_paper, "{point} in {setup:?}");
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn the_words_of_the_diagram_lie_on_nothing() {
    for setup in [PrismSetup::CLUMPING, PrismSetup::CROSSING] {
        for shown in [PerturbShown::Off, PerturbShown::On, PerturbShown::Both] {
            let sheet = prism_diagram(&setup, shown).unwrap();
            let rooms: Vec<_> = sheet.words().map(Words::bounds).collect();
            for (index, room) in rooms.iter().enumerate() {
                assert!(!rooms[..index].iter().any(|other| other.overlaps(room)), "{room:?}");
                for stroke in sheet.strokes() {
                    for ends in stroke.points.windows(2) {
                        assert!(!room.is_crossed_by([ends[0], ends[1]]), "{room:?} {ends:?}");
                    }
                }
            }
        }
    }
}
