//! Heat maps have the same colours on both sides.

use brilliance_renderer::develop::{CountImage, HeatMap};

use crate::films::{bands, film_of_counts};
use crate::{GRAPHICS, expose_both};

#[test]
fn mean_counts_are_those_of_the_processor() {
    for passes in [1, 7, 1000] {
        let film = film_of_counts(passes);
        let expected = CountImage::from_film(&film);
        for ends in [vec![], vec![1, 40]] {
            let found = expose_both(&film, &bands(&film, &ends)).1.read().unwrap();
            assert_eq!(found.size, expected.size);
            for (found, expected) in found.means.iter().zip(&expected.means) {
                let pairs = [
                    (found.rays, expected.rays),
                    (found.depth, expected.depth),
                    (found.pruned, expected.pruned),
                ];
                for (found, expected) in pairs {
                    // WGSL allows a division 2.5 ulp.
                    let tolerance = 3.0 * f32::EPSILON * expected;
                    assert!((found - expected).abs() <= tolerance, "{found} for {expected}");
                }
            }
        }
    }
}

/// The colours change by at most 3 codes in a hundredth of a knot, and logarithms differ by far less;
/// so a code differs only where it lies on the edge between two.
#[test]
fn every_count_has_the_colour_that_it_has_on_the_processor() {
    let film = film_of_counts(3);
    let expected = CountImage::from_film(&film);
    let found = expose_both(&film, &bands(&film, &[5])).1;
    for map in HeatMap::ALL {
        let texture = found.develop(map).expect("a heat map");
        assert_eq!([texture.width(), texture.height()], film.size());
        let found = GRAPHICS.read_texture(&texture).expect("its codes");
        let expected = expected.develop_rgba8(map);
        assert_eq!(found.len(), expected.len());
        let apart = found.iter().zip(&expected).map(|(found, expected)| found.abs_diff(*expected));
        assert_eq!(apart.clone().filter(|&apart| apart > 1).count(), 0, "{map:?}");
        let different = apart.filter(|&apart| apart == 1).count();
        assert!(different < expected.len() / 500, "{map:?}: {different} of {}", expected.len());
    }
}
