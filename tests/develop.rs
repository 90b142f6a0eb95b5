//! From film to display, against what is published and what must hold.

use brilliance_renderer::color::{self, Lab};
use brilliance_renderer::develop::XyzImage;
use brilliance_renderer::film::Film;
use brilliance_renderer::settings::{DisplaySettings, ToneCurve, WhitePoint};
use brilliance_renderer::spectrum::{Bins, Illuminant, Spectrum};
use glam::{DMat3, DVec2, DVec3};

/// A film of one pixel per spectrum, exposed `passes` times.
fn film_of(spectra: &[Spectrum], bins: Bins, passes: u32) -> Film {
    let mut film = Film::new(spectra.len() as u32, 1, bins);
    let means: Vec<f32> = spectra.iter().flat_map(|spectrum| spectrum.bin_means(bins)).collect();
    for _ in 0..passes {
        film.sums_mut().iter_mut().zip(&means).for_each(|(sum, mean)| *sum += mean);
        film.complete_pass();
    }
    film
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
    film.complete_pass();
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
    film.complete_pass();
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

/// The matrix of IEC 61966-2-1:1999, printed to four digits.
#[test]
fn the_rec709_matrix_is_the_published_one() {
    let published = DMat3::from_cols_array_2d(&[
        [0.4124, 0.2126, 0.0193],
        [0.3576, 0.7152, 0.1192],
        [0.1805, 0.0722, 0.9505],
    ]);
    assert!(color::xyz_from_rec709().abs_diff_eq(published, 6e-5));
    let identity = color::rec709_from_xyz() * color::xyz_from_rec709();
    assert!(identity.abs_diff_eq(DMat3::IDENTITY, 1e-14));
}

/// D50 to D65 after B. Lindbloom, "Chromatic Adaptation", whites of ASTM E308.
#[test]
fn bradford_adaptation_is_the_published_one() {
    let d50 = DVec3::new(0.96422, 1.0, 0.82521);
    let d65 = DVec3::new(0.95047, 1.0, 1.08883);
    let published = DMat3::from_cols_array_2d(&[
        [0.955_576_6, -0.028_289_5, 0.012_298_2],
        [-0.023_039_3, 1.009_941_6, -0.020_483_0],
        [0.063_163_6, 0.021_007_7, 1.329_909_8],
    ]);
    assert!(color::adaptation(d50, d65).abs_diff_eq(published, 1e-6));
    assert!((color::adaptation(d50, d65) * d50 - d65).abs().max_element() < 1e-14);
    assert!(color::adaptation(d50, 3.0 * d50).abs_diff_eq(DMat3::IDENTITY, 1e-14));
}

#[test]
fn srgb_encoding_has_its_endpoints_and_middle_grey() {
    assert_eq!(color::srgb_encode(0.0), 0.0);
    assert!((color::srgb_encode(1.0) - 1.0).abs() < 1e-15);
    // 18 % grey is code 118 of 255.
    assert!((255.0 * color::srgb_encode(0.18) - 117.65).abs() < 0.01);
    for step in 0..=1000 {
        let linear = f64::from(step) / 1000.0;
        assert!((color::srgb_decode(color::srgb_encode(linear)) - linear).abs() < 1e-7);
    }
    let greys = [0.0, 0.18, 1.0].map(Spectrum::Flat);
    let grey = XyzImage::from_film(&film_of(&greys, Bins::new(16), 1));
    let shown = grey.develop(&settings(WhitePoint::EqualEnergy, ToneCurve::Linear));
    assert_eq!(shown.to_rgba8_srgb(), [0, 0, 0, 255, 118, 118, 118, 255, 255, 255, 255, 255]);
    let rgb16 = shown.to_rgb16_srgb();
    assert_eq!(rgb16[..3], [0; 3]);
    assert!(rgb16[3..6].iter().all(|&code| code.abs_diff(30237) <= 2), "{rgb16:?}");
    assert_eq!(rgb16[6..], [65535; 3]);
}

/// u′, v′ of D65: 0.1978, 0.4683 (CIE 15:2018, table of illuminants).
#[test]
fn chromaticities_of_the_display_white() {
    let white = color::d65_white();
    assert!((color::xy(white) - color::D65_XY).abs().max_element() < 1e-15);
    assert!((color::uv_prime(white) - DVec2::new(0.1978, 0.4683)).abs().max_element() < 1e-4);
}

/// Lab of the sRGB primaries in D65 as commonly tabulated.
#[test]
fn lab_of_white_black_and_red() {
    let lab = |rgb: DVec3| Lab::from_xyz(color::xyz_from_rec709() * rgb, color::d65_white());
    let white = lab(DVec3::ONE);
    assert!((white.l - 100.0).abs() < 1e-9 && white.a.abs() < 1e-9 && white.b.abs() < 1e-9);
    assert!(lab(DVec3::ZERO).l.abs() < 1e-12);
    let red = lab(DVec3::X);
    assert!((red.l - 53.24).abs() < 0.01 && (red.a - 80.09).abs() < 0.02, "{red:?}");
    assert!((red.b - 67.20).abs() < 0.02, "{red:?}");
}

/// The 34 pairs of Sharma, Wu and Dalal 2005, table 1.
#[test]
fn ciede2000_agrees_with_its_published_test_data() {
    for row in SHARMA {
        let [l1, a1, b1, l2, a2, b2, published] = row;
        let (one, two) = (Lab { l: l1, a: a1, b: b1 }, Lab { l: l2, a: a2, b: b2 });
        assert!((one.delta_e_2000(two) - published).abs() < 5.1e-5, "{row:?}");
        assert!((two.delta_e_2000(one) - published).abs() < 5.1e-5, "{row:?} swapped");
        assert_eq!(one.delta_e_2000(one), 0.0);
    }
}

const SHARMA: [[f64; 7]; 34] = [
    [50.0, 2.6772, -79.7751, 50.0, 0.0, -82.7485, 2.0425],
    [50.0, 3.1571, -77.2803, 50.0, 0.0, -82.7485, 2.8615],
    [50.0, 2.8361, -74.0200, 50.0, 0.0, -82.7485, 3.4412],
    [50.0, -1.3802, -84.2814, 50.0, 0.0, -82.7485, 1.0000],
    [50.0, -1.1848, -84.8006, 50.0, 0.0, -82.7485, 1.0000],
    [50.0, -0.9009, -85.5211, 50.0, 0.0, -82.7485, 1.0000],
    [50.0, 0.0, 0.0, 50.0, -1.0, 2.0, 2.3669],
    [50.0, -1.0, 2.0, 50.0, 0.0, 0.0, 2.3669],
    [50.0, 2.4900, -0.0010, 50.0, -2.4900, 0.0009, 7.1792],
    [50.0, 2.4900, -0.0010, 50.0, -2.4900, 0.0010, 7.1792],
    [50.0, 2.4900, -0.0010, 50.0, -2.4900, 0.0011, 7.2195],
    [50.0, 2.4900, -0.0010, 50.0, -2.4900, 0.0012, 7.2195],
    [50.0, -0.0010, 2.4900, 50.0, 0.0009, -2.4900, 4.8045],
    [50.0, -0.0010, 2.4900, 50.0, 0.0010, -2.4900, 4.8045],
    [50.0, -0.0010, 2.4900, 50.0, 0.0011, -2.4900, 4.7461],
    [50.0, 2.5000, 0.0, 50.0, 0.0, -2.5000, 4.3065],
    [50.0, 2.5000, 0.0, 73.0, 25.0, -18.0, 27.1492],
    [50.0, 2.5000, 0.0, 61.0, -5.0, 29.0, 22.8977],
    [50.0, 2.5000, 0.0, 56.0, -27.0, -3.0, 31.9030],
    [50.0, 2.5000, 0.0, 58.0, 24.0, 15.0, 19.4535],
    [50.0, 2.5000, 0.0, 50.0, 3.1736, 0.5854, 1.0000],
    [50.0, 2.5000, 0.0, 50.0, 3.2972, 0.0, 1.0000],
    [50.0, 2.5000, 0.0, 50.0, 1.8634, 0.5757, 1.0000],
    [50.0, 2.5000, 0.0, 50.0, 3.2592, 0.3350, 1.0000],
    [60.2574, -34.0099, 36.2677, 60.4626, -34.1751, 39.4387, 1.2644],
    [63.0109, -31.0961, -5.8663, 62.8187, -29.7946, -4.0864, 1.2630],
    [61.2901, 3.7196, -5.3901, 61.4292, 2.2480, -4.9620, 1.8731],
    [35.0831, -44.1164, 3.7933, 35.0232, -40.0716, 1.5901, 1.8645],
    [22.7233, 20.0904, -46.6940, 23.0331, 14.9730, -42.5619, 2.0373],
    [36.4612, 47.8580, 18.3852, 36.2715, 50.5065, 21.2231, 1.4146],
    [90.8027, -2.0831, 1.4410, 91.1528, -1.6435, 0.0447, 1.4441],
    [90.9257, -0.5406, -0.9208, 88.6381, -0.8985, -0.7239, 1.5381],
    [6.7747, -0.2908, -2.4247, 5.8714, -0.0985, -2.2286, 0.6377],
    [2.0776, 0.0795, -1.1350, 0.9033, -0.0636, -0.5514, 0.9082],
];
