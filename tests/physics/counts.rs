//! What the film counts per pixel: rays, depth, pruned light.

use brilliance_renderer::camera::Camera;
use brilliance_renderer::film::Counts;
use brilliance_renderer::light::Lights;
use brilliance_renderer::material::Dispersion;
use brilliance_renderer::scene::{Ground, Scene};
use brilliance_renderer::settings::TraceSettings;
use brilliance_renderer::spectrum::Spectrum;
use brilliance_renderer::still::Still;
use glam::{DVec3, Vec3};

use crate::scenes::{
    block, clear, close_camera, flat_sky, furnace, object, paper, render, request, scene,
};

const GLASS: Dispersion = Dispersion::Linear { n_d: 1.5, dispersion_bg: 0.0 };

/// From so far above that all rays are as good as parallel.
fn straight_down() -> Camera {
    Camera { position: Vec3::Z * 1000.0, up: Vec3::Y, fov_y_radians: 0.001, ..Camera::default() }
}

fn sky() -> Lights {
    Lights { environment: Some(flat_sky(1.0)), ..Lights::default() }
}

fn slab() -> Scene {
    scene(vec![object(block(DVec3::new(5.0, 5.0, 1.0)), clear(GLASS))], sky())
}

fn counts_of(scene: Scene, significance_threshold: f32) -> Counts {
    let settings = TraceSettings { significance_threshold, ..paper() };
    let mut request = request(scene, straight_down(), [3, 2], settings);
    request.pass_limit = 4;
    let film = render(&request, 0).film;
    let first = film.counts()[0];
    for counts in film.counts() {
        assert_eq!((counts.rays, counts.depth), (first.rays, first.depth));
        assert!((counts.pruned - first.pruned).abs() <= 1e-5 * first.pruned);
    }
    first.mean()
}

/// Glass of index 1.5 reflects R = 0.04 of what falls on it, from either side (Born & Wolf,
/// *Principles of Optics*, §1.5.2).
#[test]
fn a_slab_is_counted_as_by_hand() {
    let (r, t) = (0.04, 0.96);
    let cases = [
        // The camera ray, the ray inside and the one that leaves; both reflections are pruned.
        (0.1, 3.0, 2.0, r + t * r),
        // Beside them the first reflection, the one inside and what leaves of it upwards; the next
        // reflection is T·R·R = 0.0015.
        (0.01, 6.0, 3.0, t * r * r),
        // One more there and one more out.
        (0.001, 8.0, 4.0, t * r * r * r),
    ];
    for (threshold, rays, depth, pruned) in cases {
        let counts = counts_of(slab(), threshold);
        assert_eq!((counts.rays, counts.depth), (rays, depth), "threshold {threshold}");
        assert!((counts.pruned / pruned - 1.0).abs() < 1e-3, "{} {pruned}", counts.pruned);
    }
}

#[test]
fn what_meets_no_interface_has_no_depth() {
    let counts = counts_of(scene(Vec::new(), sky()), 1e-3);
    assert_eq!([counts.rays, counts.depth, counts.pruned], [1.0, 0.0, 0.0]);
    let ground = Ground {
        height: 0.0,
        square: 1.0,
        reflectance: [Spectrum::Flat(0.8), Spectrum::Flat(0.2)],
    };
    let counts = counts_of(Scene { ground: Some(ground), ..scene(Vec::new(), sky()) }, 1e-3);
    // The camera's ray, and one from the ground to the sky.
    assert_eq!([counts.rays, counts.depth, counts.pruned], [2.0, 0.0, 0.0]);
}

fn totals(still: &Still) -> Counts {
    still.film.counts().iter().fold(Counts::default(), |mut sum, counts| {
        sum += *counts;
        sum
    })
}

#[test]
fn the_counts_add_up_to_the_statistics() {
    let settings = TraceSettings { significance_threshold: 1e-2, ..paper() };
    let mut request = request(furnace(), close_camera(7.0), [61, 47], settings);
    request.pass_limit = 3;
    let still = render(&request, 0);
    let camera_rays = still.statistics.camera_rays as f64;
    let totals = totals(&still);
    let rays = f64::from(totals.rays) / camera_rays;
    assert_eq!(rays, still.statistics.mean_segments_per_camera_ray());
    let ledger = still.statistics.ledger;
    let pruned = f64::from(totals.pruned);
    assert!(ledger.pruned > 1e-3 * ledger.entered, "the case prunes: {ledger:?}");
    assert!((pruned / ledger.pruned - 1.0).abs() < 1e-4, "{pruned} {}", ledger.pruned);
}

#[test]
fn no_ray_is_traced_beyond_the_maximum_depth() {
    for max_depth in [1, 2, 5, 30] {
        let settings = TraceSettings { max_depth, ..TraceSettings::default() };
        let still = render(&request(furnace(), close_camera(4.0), [24, 24], settings), 0);
        let depths = still.film.counts().iter().map(|counts| counts.depth);
        assert_eq!(depths.fold(0.0, f32::max), max_depth as f32);
    }
}
