//! Colour spaces and colour differences against published values.

use brilliance_renderer::color::{self, Lab};
use glam::{DMat3, DVec2, DVec3};

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
}

/// u′, v′ of D65: 0.1978, 0.4683 (CIE 15:2018, table of illuminants).
#[test]
fn chromaticities_of_the_display_white() {
    let white = color::d65_white();
    assert!((color::xy(white) - color::D65_XY).abs().max_element() < 1e-15);
    assert!((color::uv_prime(white) - DVec2::new(0.1978, 0.4683)).abs().max_element() < 1e-4);
}

/// u′, v′ of the sRGB primaries as commonly tabulated.
#[test]
fn chromaticities_of_the_display_primaries() {
    let published = [[0.4507, 0.5229], [0.1250, 0.5625], [0.1754, 0.1579]];
    for (xy, published) in color::REC709_PRIMARIES_XY.into_iter().zip(published) {
        let found = color::uv_prime(color::xyz_from_xy(xy, 0.3));
        assert!((found - DVec2::from_array(published)).abs().max_element() < 6e-5, "{found}");
    }
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
