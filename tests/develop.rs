//! From film to display, against what is published and what must hold.

use brilliance_renderer::color;
use brilliance_renderer::develop::{
    ColorPath, CountImage, GamutFault, HeatMap, NOTHING, XyzImage, brightest_srgb8, interval_srgb8,
};
use brilliance_renderer::film::{Counts, Film};
use brilliance_renderer::settings::{DisplaySettings, ToneCurve, WhitePoint};
use brilliance_renderer::spectrum::{Bins, Illuminant, Observer, Spectrum};
use glam::{DVec3, Vec3};

/// A film of one pixel per spectrum, exposed `passes` times.
fn film_of(spectra: &[Spectrum], bins: Bins, passes: u32) -> Film {
    let mut film = Film::new(spectra.len() as u32, 1, bins);
    let means: Vec<f32> = spectra.iter().flat_map(|spectrum| spectrum.bin_means(bins)).collect();
    for _ in 0..passes {
        film.sums_mut().iter_mut().zip(&means).for_each(|(sum, mean)| *sum += mean);
        complete_pass(&mut film);
    }
    film
}

/// Counts a camera ray of each pixel.
fn complete_pass(film: &mut Film) {
    film.sums_and_counts_mut().1.iter_mut().for_each(|counts| counts.samples += 1.0);
    film.complete_pass();
}

fn settings(white_point: WhitePoint, tone_curve: ToneCurve) -> DisplaySettings {
    DisplaySettings { white_point, tone_curve, ..DisplaySettings::default() }
}

fn image(xyz: Vec<[f32; 3]>) -> XyzImage {
    XyzImage { size: [xyz.len() as u32, 1], bins: Bins::new(16), xyz }
}

/// Colours inside and far outside the gamut, dark and bright, and values that are no colours.
fn all_sorts() -> Vec<[f32; 3]> {
    let levels = [-0.2, 0.0, 1e-6, 0.003, 0.02, 0.18, 0.5, 0.95, 1.0, 1.3, 7.0, 1e4, 1e30];
    let mut xyz = Vec::new();
    for x in levels {
        for y in levels {
            xyz.extend(levels.map(|z| [x, y, z]));
        }
    }
    for wrong in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX] {
        xyz.extend([[wrong, 0.5, 0.5], [0.5, wrong, 0.5], [0.5, 0.5, wrong], [wrong; 3]]);
    }
    xyz
}

fn all_settings() -> Vec<DisplaySettings> {
    let mut all = Vec::new();
    for tone_curve in [ToneCurve::Linear, ToneCurve::Reinhard, ToneCurve::Filmic] {
        for white_point in [WhitePoint::D65, WhitePoint::A, WhitePoint::Temperature(3000.0)] {
            for gamut_mapping in [true, false] {
                let exposure_ev = 0.7;
                all.push(DisplaySettings { exposure_ev, white_point, tone_curve, gamut_mapping });
            }
        }
    }
    all
}

#[test]
fn a_flat_spectrum_of_radiance_1_develops_to_luminance_1() {
    for count in 4..=64 {
        for passes in [1, 3, 7] {
            let film = film_of(&[Spectrum::Flat(1.0)], Bins::new(count), passes);
            assert_eq!(XyzImage::from_film(&film).xyz[0][1], 1.0, "{count} bins, {passes} passes");
        }
    }
}

#[test]
fn light_of_the_white_point_is_neutral() {
    let lights = [
        (WhitePoint::EqualEnergy, Spectrum::Flat(1.0)),
        (WhitePoint::D65, Spectrum::Illuminant(Illuminant::D65)),
        (WhitePoint::D50, Spectrum::Illuminant(Illuminant::D50)),
        (WhitePoint::A, Spectrum::Illuminant(Illuminant::A)),
        (WhitePoint::Temperature(3200.0), Spectrum::BlackBody { kelvin: 3200.0 }),
    ];
    for (white_point, light) in lights {
        for count in [4, 16, 64] {
            let film = film_of(std::slice::from_ref(&light), Bins::new(count), 1);
            let settings =
                DisplaySettings { exposure_ev: -1.0, ..settings(white_point, ToneCurve::Linear) };
            let [r, g, b] = XyzImage::from_film(&film).develop(&settings).rgb[0];
            let spread = r.max(g).max(b) - r.min(g).min(b);
            assert!(spread < 2e-6, "{white_point:?}, {count} bins: {r} {g} {b}");
            assert!((g - 0.5).abs() < 0.02, "{white_point:?}, {count} bins: {r} {g} {b}");
        }
    }
}

#[test]
fn another_white_point_tints_the_light() {
    let film = film_of(&[Spectrum::Illuminant(Illuminant::A)], Bins::new(16), 1);
    let settings =
        DisplaySettings { exposure_ev: -2.0, ..settings(WhitePoint::D65, ToneCurve::Linear) };
    let [r, g, b] = XyzImage::from_film(&film).develop(&settings).rgb[0];
    assert!(r > 1.5 * g && g > 1.5 * b, "tungsten in daylight is orange: {r} {g} {b}");
}

#[test]
fn one_stop_of_exposure_doubles_linear_light() {
    let image = image(vec![[0.1, 0.11, 0.12], [0.02, 0.01, 0.03]]);
    let mut settings = settings(WhitePoint::D65, ToneCurve::Linear);
    let before = image.develop(&settings);
    settings.exposure_ev += 1.0;
    let after = image.develop(&settings);
    for (before, after) in before.rgb.iter().zip(&after.rgb) {
        assert_eq!(before.map(|channel| 2.0 * channel), *after);
    }
}

/// The tone curve scales a colour: ratios of red, green and blue stay.
#[test]
fn the_tone_curve_keeps_hue_and_saturation() {
    let image = image(vec![[0.20, 0.18, 0.15], [0.30, 0.35, 0.40]]);
    let linear = image.develop(&settings(WhitePoint::D65, ToneCurve::Linear));
    for curve in [ToneCurve::Reinhard, ToneCurve::Filmic] {
        let curved = image.develop(&settings(WhitePoint::D65, curve));
        for (linear, curved) in linear.rgb.iter().zip(&curved.rgb) {
            let gain = curved[1] / linear[1];
            assert!((gain - 1.0).abs() > 0.05, "{curve:?} does nothing");
            assert!((0..3).all(|i| (curved[i] / linear[i] / gain - 1.0).abs() < 1e-5));
        }
    }
}

/// Laser light of 500 nm is far outside Rec. 709: with gamut mapping it keeps its luminance and
/// touches the boundary, without it the channels are cut off.
#[test]
fn gamut_mapping_keeps_luminance_and_clipping_does_not() {
    let bins = Bins::new(64);
    let mut film = Film::new(1, 1, bins);
    film.sums_mut()[22] = 5.0;
    complete_pass(&mut film);
    let image = XyzImage::from_film(&film);
    let mut settings = settings(WhitePoint::EqualEnergy, ToneCurve::Linear);
    let luminance = |rgb: [f32; 3]| color::luminance(DVec3::from_array(rgb.map(f64::from)));

    let white = film_of(&[Spectrum::Flat(1.0)], bins, 1);
    let white = DVec3::from_array(XyzImage::from_film(&white).xyz[0].map(f64::from));
    let scene = DVec3::from_array(image.xyz[0].map(f64::from));
    let y = (color::adaptation(white, color::d65_white()) * scene).y;

    let mapped = image.develop(&settings).rgb[0];
    assert!((luminance(mapped) - y).abs() < 1e-6, "{mapped:?} for luminance {y}");
    assert!(mapped[0] < 1e-7, "on the boundary: {mapped:?}");

    settings.gamut_mapping = false;
    let clipped = image.develop(&settings).rgb[0];
    assert_eq!(clipped[0], 0.0);
    assert!(luminance(clipped) > y + 0.01, "{clipped:?} for luminance {y}");
}

#[test]
fn what_is_no_colour_is_black_and_does_not_spread() {
    let bins = Bins::new(8);
    let mut film = Film::new(4, 1, bins);
    film.sums_mut().fill(0.5);
    film.sums_mut()[3] = f32::NAN;
    film.sums_mut()[bins.count() + 2] = f32::INFINITY;
    film.sums_mut()[2 * bins.count() + 7] = f32::NEG_INFINITY;
    complete_pass(&mut film);
    let image = XyzImage::from_film(&film);
    for settings in all_settings() {
        let rgb = image.develop(&settings).rgb;
        assert_eq!(rgb[..3], [[0.0; 3]; 3]);
        assert!(rgb[3].iter().all(|&channel| channel > 0.1), "{rgb:?}");
    }
    assert!(image.linear_rgb().iter().flatten().all(|channel| channel.is_finite()));
}

#[test]
fn every_developed_channel_lies_between_black_and_white() {
    let image = image(all_sorts());
    for settings in all_settings() {
        for (xyz, rgb) in image.xyz.iter().zip(image.develop(&settings).rgb) {
            assert!(rgb.iter().all(|c| (0.0..=1.0).contains(c)), "{xyz:?} → {rgb:?}");
        }
    }
}

#[test]
fn the_viewport_shows_code_for_code_what_is_exported() {
    let image = image(all_sorts());
    for settings in all_settings() {
        assert_eq!(image.develop_rgba8(&settings), image.develop(&settings).to_rgba8_srgb());
    }
}

#[test]
fn an_empty_film_develops_to_an_empty_image() {
    let image = XyzImage::from_film(&Film::new(0, 0, Bins::new(16)));
    assert!(image.develop_rgba8(&DisplaySettings::default()).is_empty());
}

#[test]
fn scene_linear_rgb_is_neither_exposed_nor_bounded() {
    let d65 = color::d65_white().as_vec3() * 12.0;
    let [r, g, b] = image(vec![d65.to_array()]).linear_rgb()[0];
    assert!([r, g, b].iter().all(|channel| (channel - 12.0).abs() < 1e-4), "{r} {g} {b}");
}

/// Middle grey of 18 % is code 118 of 255.
#[test]
fn black_middle_grey_and_white_have_their_codes() {
    let greys = [0.0, 0.18, 1.0].map(Spectrum::Flat);
    let gray = XyzImage::from_film(&film_of(&greys, Bins::new(16), 1));
    let shown = gray.develop(&settings(WhitePoint::EqualEnergy, ToneCurve::Linear));
    assert_eq!(shown.to_rgba8_srgb(), [0, 0, 0, 255, 118, 118, 118, 255, 255, 255, 255, 255]);
    let rgb16 = shown.to_rgb16_srgb();
    assert_eq!(rgb16[..3], [0; 3]);
    assert!(rgb16[3..6].iter().all(|&code| code.abs_diff(30237) <= 2), "{rgb16:?}");
    assert_eq!(rgb16[6..], [65535; 3]);
}

fn lightness([r, g, b]: [u8; 3]) -> f64 {
    let linear = [r, g, b].map(|code| color::srgb_decode(f64::from(code) / 255.0));
    let xyz = color::xyz_from_rec709() * DVec3::from_array(linear);
    color::Lab::from_xyz(xyz, color::d65_white()).l
}

#[test]
fn a_heat_map_gets_lighter_with_the_number_and_ends_where_its_scale_ends() {
    for map in HeatMap::ALL {
        let [low, high] = map.scale_ends();
        let mut before = lightness(map.color(low));
        assert!(lightness(NOTHING) < before - 5.0, "nothing is told from the least");
        for step in 1..=200 {
            let now = lightness(map.color(low * (high / low).powf(step as f32 / 200.0)));
            // Codes are whole numbers, so that the steps are not even.
            assert!(now > before - 0.1, "{map:?}, step {step}: {before} {now}");
            before = before.max(now);
        }
        assert!(before > 85.0, "{map:?} ends at {before}");
        assert_eq!(map.color(0.0), NOTHING);
        assert_eq!(map.color(0.5 * low), map.color(low));
        assert_eq!(map.color(2.0 * high), map.color(high));
    }
}

#[test]
fn a_heat_map_shows_the_mean_of_its_count_in_8_and_in_16_bits() {
    let mut film = Film::new(2, 1, Bins::new(4));
    film.sums_and_counts_mut().1[1] =
        Counts { rays: 300.0, depth: 48.0, pruned: 0.03, ..Counts::default() };
    (0..3).for_each(|_| complete_pass(&mut film));
    let image = CountImage::from_film(&film);
    assert_eq!(image.size, [2, 1]);
    for (map, mean) in [(HeatMap::Rays, 100.0), (HeatMap::Depth, 16.0), (HeatMap::Pruned, 0.01)] {
        let rgba8 = image.develop_rgba8(map);
        let [r, g, b] = map.color(mean);
        let [r0, g0, b0] = NOTHING;
        assert_eq!(rgba8, [r0, g0, b0, 255, r, g, b, 255], "{map:?}");
        for (code16, code) in image.develop_rgb16(map)[3..].iter().zip([r, g, b]) {
            assert!(code16.abs_diff(257 * u16::from(code)) <= 129, "{map:?}: {code16} {code}");
        }
    }
}

#[test]
fn the_path_of_a_colour_is_that_of_a_pixel() {
    let image = image(all_sorts());
    for settings in all_settings() {
        let (rgb, codes) = (image.develop(&settings).rgb, image.develop_rgba8(&settings));
        for (i, &xyz) in image.xyz.iter().enumerate() {
            let path = ColorPath::new(Vec3::from(xyz).as_dvec3(), image.bins, &settings);
            assert_eq!(
                (path.shown, &path.srgb8[..]),
                (rgb[i], &codes[4 * i..4 * i + 3]),
                "{xyz:?}"
            );
            let is_black = path.shown == [0.0; 3];
            assert!(path.is_color() || is_black, "{xyz:?}");
            if let Some(shift) = path.gamut_shift() {
                assert!((0.0..=1.0).contains(&shift.towards_white), "{xyz:?}: {shift:?}");
            }
        }
    }
}

#[test]
fn a_colour_that_the_display_has_is_not_moved() {
    let bins = Bins::new(16);
    let settings = settings(WhitePoint::D65, ToneCurve::Linear);
    let white = Observer::binned_xyz(&WhitePoint::D65.spectrum(), bins);
    let white = white / white.y;
    for share in [0.0, 1e-3, 0.2, 1.0] {
        let path = ColorPath::new(share * white, bins, &settings);
        assert_eq!(path.gamut_shift(), None, "{path:?}");
        assert_eq!(path.is_color(), share > 0.0);
        assert!((path.shown_xyz() - share * color::d65_white()).length() < 1e-5);
    }
}

#[test]
fn a_single_wavelength_is_moved_straight_towards_white_and_keeps_its_luminance() {
    let bins = Bins::new(64);
    let settings = settings(WhitePoint::EqualEnergy, ToneCurve::Reinhard);
    let white = color::uv_prime(color::d65_white());
    for lambda_nm in [450.0, 490.0, 520.0, 560.0, 600.0, 650.0] {
        let pure = Observer::color_matching_at(lambda_nm);
        let path = ColorPath::new(0.1 / pure.y * pure, bins, &settings);
        let shift = path.gamut_shift().expect("no display has it");
        assert_eq!(shift.fault, GamutFault::TooPure);
        let [wanted, shown] = [path.exposed_xyz(), path.shown_xyz()].map(color::uv_prime);
        assert!((shift.uv_prime - wanted.distance(shown)).abs() < 1e-4, "{lambda_nm}: {shift:?}");
        let aside = (wanted - white).normalize().perp_dot(shown - white);
        assert!(aside.abs() < 1e-4, "{lambda_nm}: {aside} beside the line");
        assert!(shown.distance(white) < wanted.distance(white));
        assert!(shift.delta_e_2000 > 2.0, "{lambda_nm}: {shift:?}");
        let low = path.shown.iter().fold(1.0_f32, |low, &channel| low.min(channel));
        assert!(low < 1e-5, "moved as far as the edge of the gamut and no further: {path:?}");
        let gain = f64::from(path.toned[1] / path.exposed[1]);
        assert!((path.shown_xyz().y - gain * path.exposed_xyz().y).abs() < 1e-5);
    }
}

#[test]
fn a_colour_that_is_too_bright_is_told_from_one_that_is_too_pure() {
    let settings = settings(WhitePoint::D65, ToneCurve::Linear);
    let bins = Bins::new(64);
    let shift = |rgb: [f64; 3]| {
        let xyz = color::xyz_from_rec709() * DVec3::from_array(rgb);
        ColorPath::new(xyz, bins, &settings).gamut_shift().expect("it is moved")
    };
    let blue = shift([0.2, 0.2, 3.0]);
    assert_eq!(blue.fault, GamutFault::TooBright);
    assert!(blue.towards_white > 0.5 && blue.towards_white < 1.0, "{blue:?}");
    let gray = shift([2.0; 3]);
    assert_eq!(gray.fault, GamutFault::BeyondWhite);
    assert!(gray.uv_prime < 1e-3, "white it was: {gray:?}");
    let sparkle = shift([9.0, 0.5, 0.5]);
    assert_eq!((sparkle.fault, sparkle.towards_white), (GamutFault::BeyondWhite, 1.0));
}

#[test]
fn the_brightest_of_a_chromaticity_is_on_the_edge_of_the_gamut() {
    let xyz = |rgb: DVec3| color::xyz_from_rec709() * rgb;
    assert_eq!(brightest_srgb8(0.3 * color::d65_white()), [255; 3]);
    for level in [1e-4, 1.0, 1e4] {
        assert_eq!(brightest_srgb8(level * xyz(DVec3::X)), [255, 0, 0]);
        assert_eq!(brightest_srgb8(level * xyz(DVec3::Z)), [0, 0, 255]);
    }
    for lambda_nm in (380..=730).step_by(10).map(f64::from) {
        let code = brightest_srgb8(Observer::color_matching_at(lambda_nm));
        assert_eq!(code.iter().max(), Some(&255), "{lambda_nm}: {code:?}");
        assert_eq!(code.iter().min(), Some(&0), "{lambda_nm}: {code:?}");
    }
    assert_eq!(brightest_srgb8(DVec3::ZERO), [0; 3]);
}

#[test]
fn intervals_have_the_colours_of_their_wavelengths_and_the_whole_spectrum_is_white() {
    assert_eq!(interval_srgb8([380.0, 730.0]), [255; 3]);
    let [red, green, blue] = [640.0, 530.0, 450.0].map(|nm| interval_srgb8([nm, nm]));
    assert!(red[0] == 255 && red[1] < 120 && red[2] < 120, "{red:?}");
    assert!(green[1] == 255 && green[0] < 160 && green[2] < 160, "{green:?}");
    assert!(blue[2] == 255 && blue[0] < 160 && blue[1] < 120, "{blue:?}");
    for ends in [[380.0, 380.0], [730.0, 730.0], [0.0, 0.0], [500.0, 500.1]] {
        assert_eq!(interval_srgb8(ends).into_iter().max(), Some(255), "{ends:?}");
    }
}
