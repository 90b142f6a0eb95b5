//! The spectrum of a region that is watched.

use std::sync::atomic::AtomicBool;

use brilliance_renderer::film::{Film, PixelRect, Region};
use brilliance_renderer::session::{Activity, RenderRequest};
use brilliance_renderer::still::{Still, StillLimits};

use crate::watched::{Watched, request};

const SIZE: [u32; 2] = [48, 32];

/// The film that a session makes of the request on the processor, bit by bit.
fn film(request: &RenderRequest) -> Film {
    let limits = StillLimits::default();
    let still = Still::render(request, limits, None, &AtomicBool::new(false), |_, _| {});
    still.expect("it renders").film
}

#[test]
fn a_reading_is_the_mean_of_the_film_in_the_region() {
    let request = request(SIZE, 3);
    let film = film(&request);
    let mut watched = Watched::new();
    let pixel = PixelRect { min: [24, 15], size: [1, 1] };
    let patch = PixelRect { min: [10, 8], size: [21, 13] };
    watched.session.watch(Some(Region::of(pixel, SIZE)));
    watched.session.request(request);
    watched.wait_for_done(SIZE);
    for pixels in [pixel, patch, pixel] {
        let region = Region::of(pixels, SIZE);
        watched.session.watch(Some(region));
        let is_there = |passes, of| (passes, of) == (3, region);
        watched.wait(|session| session.reading().is_some_and(|it| is_there(it.passes, it.region)));
        let reading = watched.session.reading().expect("it is there");
        assert_eq!((reading.pixels, reading.film_size, reading.bins), (pixels, SIZE, film.bins()));
        assert_eq!(reading.spectrum, film.mean_spectrum(pixels));
        assert!(!reading.is_draft);
        assert!(reading.spectrum.iter().any(|&mean| mean > 0.0), "the stone is lit");
    }
    assert_eq!(watched.session.progress().statistics.camera_rays, 3 * 48 * 32, "none anew");
}

#[test]
fn nothing_is_read_unless_something_is_watched() {
    let mut watched = Watched::new();
    watched.session.watch(Some(Region::WHOLE));
    watched.session.watch(None);
    watched.session.request(request(SIZE, 2));
    watched.wait_for_done(SIZE);
    assert_eq!(watched.session.reading(), None);
    // The same region once more is read once more.
    for _ in 0..2 {
        watched.session.watch(Some(Region::WHOLE));
        watched.wait(|session| session.reading().is_some());
        watched.session.watch(None);
        assert_eq!(watched.session.reading(), None);
    }
}

#[test]
fn readings_come_with_the_passes_and_drafts_say_that_they_are() {
    let mut watched = Watched::new();
    watched.session.watch(Some(Region::of_pixel_at([0.5; 2], [4000, 4000])));
    watched.session.request(request([4000, 4000], 1_000_000));
    watched.wait(|session| session.reading().is_some());
    let draft = watched.session.reading().expect("it is there");
    assert!(draft.is_draft && draft.film_size[0] < 4000, "{draft:?}");
    assert_eq!(draft.pixels.size, [1, 1]);

    watched.session.request(request([32, 32], 60));
    let mut last = (0, 0);
    while last.0 < 60 {
        watched.wait(|session| session.reading().is_some_and(|it| it.serial > last.1));
        let reading = watched.session.reading().expect("it is there");
        if reading.film_size == [32, 32] && !reading.is_draft {
            assert!(reading.passes > last.0, "a newer reading of more passes");
            last.0 = reading.passes;
        }
        last.1 = reading.serial;
    }
    watched.wait(|session| session.progress().activity == Activity::Done);
    assert_eq!(watched.session.reading().expect("it is there").serial, last.1);
}
