//! The same passes give the same bits.

use brilliance_renderer::settings::TraceSettings;

use crate::scenes::{close_camera, flat_disc, flat_sky, furnace, render, request};
use brilliance_renderer::spectrum::Spectrum;

fn sparkling() -> brilliance_renderer::scene::Scene {
    let mut scene = furnace();
    scene.lights.discs = vec![flat_disc(glam::Vec3::new(0.2, 0.4, 0.8), 2.0, 50.0)];
    scene.lights.environment = Some(flat_sky(0.3));
    scene.ground = Some(brilliance_renderer::scene::Ground {
        height: -3.5,
        square: 1.0,
        reflectance: [Spectrum::Flat(0.8), Spectrum::Flat(0.2)],
    });
    scene
}

#[test]
fn the_film_is_bit_identical_on_any_number_of_threads() {
    let mut request = request(sparkling(), close_camera(7.0), [61, 47], TraceSettings::default());
    request.pass_limit = 3;
    let one = render(&request, 1);
    for threads in [2, 3, 8] {
        let many = render(&request, threads);
        assert_eq!(one.film.sums(), many.film.sums());
        assert_eq!(one.film.counts(), many.film.counts());
        assert_eq!(one.statistics, many.statistics);
    }
}

#[test]
fn passes_differ_and_add_up() {
    let mut request = request(sparkling(), close_camera(7.0), [32, 32], TraceSettings::default());
    let first = render(&request, 0);
    request.pass_limit = 2;
    let both = render(&request, 0);
    assert_eq!(both.film.passes(), 2);
    let seconds: Vec<f32> =
        both.film.sums().iter().zip(first.film.sums()).map(|(two, one)| two - one).collect();
    assert_ne!(first.film.sums(), seconds.as_slice());
    assert_eq!(both.statistics.camera_rays, 2 * 32 * 32);
}
