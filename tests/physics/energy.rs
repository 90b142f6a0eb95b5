//! The white furnace and the energy ledger.

use brilliance_renderer::camera::Camera;
use brilliance_renderer::light::Lights;
use brilliance_renderer::material::{Dielectric, Dispersion, Material};
use brilliance_renderer::settings::TraceSettings;
use brilliance_renderer::spectrum::Spectrum;
use glam::DVec3;

use crate::scenes::{
    DIAMOND, block, brilliant, clear, close_camera, exact, flat_disc, flat_sky, furnace, mean,
    object, paper, render, request, scene,
};

const SIZE: [u32; 2] = [72, 64];

fn settings(significance_threshold: f32, max_depth: u32) -> TraceSettings {
    TraceSettings { significance_threshold, max_depth, ..paper() }
}

#[test]
fn a_lossless_stone_in_a_uniform_environment_is_as_bright_as_it() {
    let of_paper = [(1e-1, 4), (1e-2, 16), (1e-3, 64)];
    let mut cases = of_paper.map(|(threshold, depth)| settings(threshold, depth)).to_vec();
    // What chance takes from one ray and gives to another is booked as well.
    cases.extend([TraceSettings::default(), TraceSettings { max_depth: 16, ..exact() }]);
    for settings in cases {
        // A dark light of 1° makes the rays split without adding any radiance.
        let mut furnace = furnace();
        furnace.lights.discs = vec![flat_disc(glam::Vec3::Z, 0.5, 0.0)];
        let still = render(&request(furnace, close_camera(7.0), SIZE, settings.clone()), 0);
        assert!(still.statistics.mean_segments_per_camera_ray() > 10.0);
        let ledger = still.statistics.ledger;
        let kept = 1.0 - (ledger.pruned + ledger.cut_off) / ledger.entered;
        let seen = mean(&still.film.means());
        assert!((seen - kept).abs() < 1e-4, "{settings:?}: {seen} and {kept}");
        assert!(ledger.pruned != 0.0);
        assert_eq!(ledger.lost, 0.0);
    }
}

#[test]
fn at_the_default_settings_the_furnace_loses_less_than_half_a_thousandth() {
    let still =
        render(&request(furnace(), Camera::default(), [160, 100], TraceSettings::default()), 0);
    let seen = mean(&still.film.means());
    assert!((seen - 1.0).abs() < 5e-4, "{seen}");
}

#[test]
fn every_joule_is_accounted_for() {
    let mut everything = furnace();
    everything.lights.discs = vec![flat_disc(glam::Vec3::new(0.3, 0.2, 0.9), 1.0, 100.0)];
    everything.objects.push(object(block(DVec3::splat(1.0)), absorbing(0.3)));
    everything.objects[1].transform.translation = glam::Vec3::new(5.0, 0.0, 0.0);
    // Fans are integrated bin by bin, and by less digits.
    let of_fans = TraceSettings { max_depth: 24, ..TraceSettings::default() };
    for (settings, tolerance) in [(settings(1e-3, 24), 1e-5), (of_fans, 1e-5)] {
        let request = request(everything.clone(), close_camera(12.0), SIZE, settings);
        let ledger = render(&request, 0).statistics.ledger;
        assert!(ledger.absorbed > 0.0 && ledger.pruned != 0.0, "{ledger:?}");
        assert!(ledger.cut_off > 0.0, "{ledger:?}");
        assert!(ledger.imbalance().abs() / ledger.entered < tolerance, "{ledger:?}");
    }
}

#[test]
fn the_loss_falls_with_the_threshold() {
    let losses: Vec<f64> = [3e-1, 1e-1, 1e-2, 1e-3, 1e-4]
        .into_iter()
        .map(|threshold| {
            let request = request(furnace(), close_camera(7.0), SIZE, settings(threshold, 64));
            render(&request, 0).statistics.ledger.pruned
        })
        .collect();
    assert!(losses.windows(2).all(|pair| pair[1] < pair[0]), "{losses:?}");
}

/// Glass of the index of air that absorbs: light goes straight through.
fn absorbing(per_mm: f32) -> Material {
    Material::Dielectric(Dielectric {
        name: "filter".to_owned(),
        dispersion: Dispersion::Linear { n_d: 1.000_001, dispersion_bg: 0.0 },
        absorption_per_mm: Some(Spectrum::Tabulated {
            lambda_nm: vec![380.0, 554.9, 555.0, 730.0],
            value: vec![per_mm, per_mm, 0.0, 0.0],
        }),
    })
}

/// From so far above that all rays are as good as parallel.
fn straight_down() -> Camera {
    Camera {
        position: glam::Vec3::Z * 1000.0,
        up: glam::Vec3::Y,
        fov_y_radians: 0.001,
        ..Camera::default()
    }
}

#[test]
fn absorption_follows_beer_and_lambert_over_the_real_path() {
    let lights = Lights { environment: Some(flat_sky(1.0)), ..Lights::default() };
    let scene = scene(vec![object(block(DVec3::splat(1.5)), absorbing(0.4))], lights);
    let camera = straight_down();
    let still = render(&request(scene, camera, [4, 4], TraceSettings::default()), 0);
    let pixel = still.film.pixel(1, 1);
    // 3 mm at 0.4 per mm.
    assert!((f64::from(pixel[0]) - (-1.2_f64).exp()).abs() < 1e-4, "{pixel:?}");
    assert!((pixel[15] - 1.0).abs() < 1e-4, "{pixel:?}");
}

#[test]
fn two_differently_coloured_bodies_multiply_their_transmittances() {
    let lights = Lights { environment: Some(flat_sky(1.0)), ..Lights::default() };
    let mut first = object(block(DVec3::splat(1.0)), absorbing(0.4));
    first.transform.translation.z = 2.0;
    let second = object(block(DVec3::splat(1.0)), absorbing(0.7));
    let scene = scene(vec![first, second], lights);
    for settings in [paper(), exact()] {
        let still = render(&request(scene.clone(), straight_down(), [2, 2], settings), 0);
        let pixel = still.film.pixel(0, 0);
        assert!((f64::from(pixel[2]) - (-2.2_f64).exp()).abs() < 1e-4, "{pixel:?}");
        assert!((pixel[13] - 1.0).abs() < 1e-4, "{pixel:?}");
    }
}

#[test]
fn a_stone_inside_a_stone_keeps_both_media() {
    // The outer filter's path goes on behind the clear core: e^(−0.2·4), not half of it.
    let lights = Lights { environment: Some(flat_sky(1.0)), ..Lights::default() };
    let outer = object(block(DVec3::splat(3.0)), absorbing(0.2));
    let core = object(
        block(DVec3::splat(1.0)),
        clear(Dispersion::Linear { n_d: 1.000_001, dispersion_bg: 0.0 }),
    );
    let camera = straight_down();
    let request =
        request(scene(vec![outer, core], lights), camera, [2, 2], TraceSettings::default());
    let still = render(&request, 0);
    let pixel = still.film.pixel(0, 0);
    assert!((f64::from(pixel[0]) - (-0.8_f64).exp()).abs() < 1e-3, "{pixel:?}");
    assert!(still.statistics.ledger.imbalance().abs() < 1e-4);
}

#[test]
fn absorption_prunes() {
    let lights = Lights { environment: Some(flat_sky(1.0)), ..Lights::default() };
    let segments = |per_mm: f32| {
        let material = Material::Dielectric(Dielectric {
            name: "smoke".to_owned(),
            dispersion: DIAMOND,
            absorption_per_mm: Some(Spectrum::Flat(per_mm)),
        });
        let mut stone = brilliant(DIAMOND);
        stone.material = material;
        let scene = scene(vec![stone], lights.clone());
        let request = request(scene, close_camera(7.0), [24, 24], TraceSettings::default());
        render(&request, 0).statistics.segments
    };
    let (clear, smoky, black) = (segments(0.0), segments(0.3), segments(10.0));
    assert!(smoky < clear && black < smoky / 2, "{clear} {smoky} {black}");
}

#[test]
fn a_stone_of_the_index_of_air_is_invisible() {
    let air = Dispersion::Linear { n_d: 1.0, dispersion_bg: 0.0 };
    let lights = Lights { hemisphere: Some(flat_sky(1.0)), ..Lights::default() };
    let with = request(
        scene(vec![brilliant(air)], lights.clone()),
        close_camera(9.0),
        SIZE,
        TraceSettings::default(),
    );
    let without =
        request(scene(Vec::new(), lights), close_camera(9.0), SIZE, TraceSettings::default());
    assert_eq!(render(&with, 0).film.sums(), render(&without, 0).film.sums());
    assert_ne!(
        render(&request(furnace(), close_camera(9.0), SIZE, settings(1e-1, 2)), 0).film.sums(),
        render(&without, 0).film.sums(),
        "the comparison can fail"
    );
}
