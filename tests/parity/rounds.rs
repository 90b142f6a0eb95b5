//! Passes in several rounds, cancelled ones, used films and several tracers at once.

use std::sync::atomic::{AtomicU32, Ordering};

use brilliance_renderer::develop::{CountImage, HeatMap, LatentImage, Pixels, Shown, XyzImage};
use brilliance_renderer::error::RendererError;
use brilliance_renderer::film::Counts;
use brilliance_renderer::settings::DisplaySettings;
use brilliance_renderer::spectrum::Bins;
use brilliance_renderer::tracer::{GpuFilm, Tracer};

use super::films::{assert_in_step, assert_same};
use super::{TRACER, cases, relative, trace};

#[test]
fn passes_one_by_one_make_the_same_film() {
    let case = cases::small_diamond();
    let scene = TRACER.load(case.packed()).unwrap();
    let mut film = TRACER.film(case.size, case.bins(), None).unwrap();
    for pass in 0..case.passes {
        assert_eq!(film.passes(), pass);
        let (view, settings) = (case.view(), case.settings());
        TRACER.trace(&scene, &view, settings, &mut film, 1, &|| false).unwrap();
    }
    assert_same(&case, &TRACER, film);
}

#[test]
fn several_rounds_in_one_call_make_the_same_film() {
    let case = cases::small_diamond();
    let tracer = TRACER.sibling().unwrap();
    // Two passes in the first round, one in the second.
    tracer.limit_rounds(case.size[0] * case.size[1] * 5 / 2);
    assert_in_step(&case, &tracer);
}

/// A film that was cut short after some submissions.
fn cancelled_film(case: &cases::Case) -> GpuFilm {
    let scene = TRACER.load(case.packed()).expect("the scene loads");
    let mut film = TRACER.film(case.size, case.bins(), None).expect("there is room for the film");
    let asked = AtomicU32::new(0);
    let is_cancelled = || asked.fetch_add(1, Ordering::Relaxed) == 4;
    let (view, settings) = (case.view(), case.settings());
    let result = TRACER.trace(&scene, &view, settings, &mut film, 1000, &is_cancelled);
    assert!(matches!(result, Err(RendererError::Cancelled)), "{result:?}");
    assert_eq!(film.passes(), 0);
    // It was asked before each submission, and obeyed at once.
    assert_eq!(asked.into_inner(), 5);
    film
}

#[test]
fn a_cancelled_film_can_be_used_again() {
    let case = cases::small_diamond();
    let used = cancelled_film(&case);
    let scene = TRACER.load(case.packed()).unwrap();
    let mut film = TRACER.film(case.size, case.bins(), Some(used)).unwrap();
    let (view, settings) = (case.view(), case.settings());
    let statistics =
        TRACER.trace(&scene, &view, settings, &mut film, case.passes, &|| false).unwrap();
    let cpu_statistics = assert_same(&case, &TRACER, film);
    assert_eq!(statistics.camera_rays, cpu_statistics.camera_rays);
    let segments = [cpu_statistics, statistics].map(|statistics| statistics.segments as f64);
    assert!(relative(segments[0], segments[1]) < 1e-3, "{segments:?}");
}

#[test]
fn a_used_film_of_any_size_gives_an_empty_one() {
    let sizes = [[48, 40], [13, 7], [48, 40], [64, 50]];
    let mut used = None;
    for size in sizes {
        let case = cases::Case { size, passes: 1, ..cases::small_diamond() };
        let scene = TRACER.load(case.packed()).unwrap();
        let mut film = TRACER.film(size, case.bins(), used).unwrap();
        let (view, settings) = (case.view(), case.settings());
        TRACER.trace(&scene, &view, settings, &mut film, 1, &|| false).unwrap();
        used = Some(film);
    }
    let film = TRACER.film([64, 50], Bins::new(16), used).unwrap();
    assert_eq!(film.passes(), 0);
    let film = TRACER.read(film).unwrap();
    assert_eq!(film.size(), [64, 50]);
    assert!(film.sums().iter().all(|&sum| sum == 0.0));
    assert!(film.counts().iter().all(|&counts| counts == Counts::default()));
}

#[test]
fn an_exposed_film_develops_as_its_copy_in_memory_does() {
    let case = cases::nested();
    let (film, _) = trace(&*TRACER, &case);
    let image = TRACER.expose(&film).unwrap();
    assert!(matches!(image, LatentImage::Graphics { .. }), "the image has left the device");
    let settings = DisplaySettings::default();
    let film = TRACER.read(film).unwrap();
    let (light, counts) = (XyzImage::from_film(&film), CountImage::from_film(&film));
    for shown in [Shown::Color].into_iter().chain(HeatMap::ALL.map(Shown::Heat)) {
        let Pixels::Texture(texture) = image.develop(&settings, shown).unwrap() else {
            panic!("the picture has left the device");
        };
        let developed = TRACER.graphics().read_texture(&texture).unwrap();
        let expected = match shown {
            Shown::Color => light.develop_rgba8(&settings),
            Shown::Heat(map) => counts.develop_rgba8(map),
        };
        assert_eq!(developed.len(), expected.len());
        let apart = developed.iter().zip(&expected).map(|(a, b)| a.abs_diff(*b)).max();
        assert!(apart <= Some(1), "{shown:?}: {apart:?}");
    }
}

#[test]
fn siblings_trace_at_the_same_time() {
    let sibling = TRACER.sibling().unwrap();
    let (diamond, mesh) = (cases::small_diamond(), cases::mesh());
    std::thread::scope(|scope| {
        for (tracer, case) in [(&*TRACER, &diamond), (&sibling, &mesh)] {
            scope.spawn(move || assert_in_step(case, tracer));
        }
    });
}
