//! The table: each splitting against the reference, on every stone under every light.
//!
//! `cargo test --release --workspace --test accuracy table -- --nocapture` prints it. Segments are
//! those of a camera ray that meets a stone, in the mean.

use brilliance_renderer::settings::{Splitting, TraceSettings};
use brilliance_renderer::spectrum::Bins;

use crate::difference::Difference;
use crate::method::{HEAD, METHODS, trace};
use crate::reference::Reference;
use crate::scenes;

/// The reference looks at least once in so many nanometres. Steps of 0.37 nm change the colours by
/// less than 0.01 in the mean and by about 0.1 in one pixel of 100.
const STEP_NM: f64 = 1.0;

#[test]
fn each_splitting_against_every_wavelength_alone() {
    println!("{HEAD}");
    let mut faults = Vec::new();
    let bins = Bins::new(TraceSettings::default().bins);
    for case in scenes::all() {
        let reference = Reference::new(&case, bins, STEP_NM);
        for method in &METHODS {
            let (rough, fine) = (method.settings(), method.fine_settings());
            for (settings, bounds) in [(rough, None), (fine, method.bounds)] {
                let comparison = method.compare(&case, &reference, &settings, bounds);
                println!("{}", comparison.row);
                faults.extend(comparison.fault);
            }
        }
        let segments = reference.mean_over_bodies(reference.segments.iter().copied());
        println!("| {} | one wavelength a ray | | | | | {segments:.0} |", case.name);
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn without_dispersion_nothing_is_split_and_all_methods_agree() {
    for case in scenes::all() {
        let case = case.undispersed();
        for method in &METHODS {
            let settings = method.fine_settings();
            let bins = Bins::new(settings.bins);
            // All wavelengths are alike.
            let reference = Reference::new(&case, bins, f64::from(bins.width_nm()));
            let film = trace(&case, &settings);
            let Difference { mean, high, .. } = Difference::of(&film, &reference);
            // Single pixels differ a lot: rays that pass an edge by less than single precision tells.
            let name = method.name;
            assert!(mean < 0.05 && high < 0.01, "{}, {name}: {mean}, {high}", case.name);
        }
    }
}

#[test]
fn the_paper_s_splitting_comes_nearer_with_every_further_ray() {
    let case = scenes::all().swap_remove(0);
    let settings = |split_count| TraceSettings {
        splitting: Splitting::Paper,
        split_count,
        ..TraceSettings::default()
    };
    let bins = Bins::new(settings(0.0).bins);
    let reference = Reference::new(&case, bins, STEP_NM);
    let mut last = f64::INFINITY;
    // The last is far beyond what the program lets one choose.
    for split_count in [0.5, 6.0, 48.0, 384.0] {
        let mean = Difference::of(&trace(&case, &settings(split_count)), &reference).mean;
        assert!(mean < 0.8 * last, "K {split_count}: {mean} after {last}");
        last = mean;
    }
    assert!(last < 0.5, "{last}");
}
