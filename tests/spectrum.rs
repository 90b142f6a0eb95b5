//! Spectra against published colours: observer, illuminants, black bodies, reflectances.

use brilliance_renderer::color;
use brilliance_renderer::spectrum::{Bins, DominantWavelength, Illuminant, Observer, Spectrum};
use glam::{DVec2, DVec3};

fn luminance_of_flat(bins: Bins) -> f64 {
    Observer::color_matching(bins).iter().map(|weight| f64::from(weight[1])).sum()
}

#[test]
fn a_flat_spectrum_of_radiance_1_has_luminance_1() {
    for count in 1..=64 {
        let luminance = luminance_of_flat(Bins::new(count));
        assert_eq!(luminance as f32, 1.0, "{count} bins: {luminance}");
    }
    assert!((Observer::xyz(&Spectrum::Flat(1.0)).y - 1.0).abs() < 1e-14);
}

/// The equal-energy white is 1/3, 1/3 by construction of the CIE system; 380–730 nm miss a little
/// of it.
#[test]
fn the_equal_energy_white_is_a_third_each() {
    let xy = color::xy(Observer::xyz(&Spectrum::Flat(1.0)));
    assert!((xy - DVec2::splat(1.0 / 3.0)).abs().max_element() < 3e-4, "{xy}");
}

#[test]
fn fine_bins_add_up_to_coarse_ones() {
    let coarse = Observer::color_matching(Bins::new(4));
    let fine = Observer::color_matching(Bins::new(64));
    for (whole, parts) in coarse.iter().zip(fine.chunks_exact(16)) {
        for i in 0..3 {
            let sum: f32 = parts.iter().map(|part| part[i]).sum();
            assert!((sum - whole[i]).abs() < 1e-6);
        }
    }
}

/// Chromaticities for the 2° observer: CIE 15:2018, tables of illuminants.
#[test]
fn illuminants_have_their_published_chromaticities() {
    let published = [
        (Illuminant::D65, [0.31272, 0.32903]),
        (Illuminant::D50, [0.34567, 0.35851]),
        (Illuminant::A, [0.44758, 0.40745]),
        (Illuminant::F2, [0.3721, 0.3751]),
        (Illuminant::F11, [0.3805, 0.3769]),
        (Illuminant::LedB3, [0.3756, 0.3723]),
    ];
    for (illuminant, [x, y]) in published {
        let xyz = Observer::xyz(&Spectrum::Illuminant(illuminant));
        assert!((xyz.y - 1.0).abs() < 1e-12, "{illuminant:?} has luminance {}", xyz.y);
        let off = (color::xy(xyz) - DVec2::new(x, y)).abs().max_element();
        assert!(off < 5e-4, "{illuminant:?}: {} is off by {off}", color::xy(xyz));
    }
}

/// Illuminant A is by definition a black body of 2856 K (CIE 15:2004, 3.1).
#[test]
fn illuminant_a_is_a_black_body() {
    let body = Spectrum::BlackBody { kelvin: 2856.0 };
    let a = Spectrum::Illuminant(Illuminant::A);
    for lambda_nm in (380..=730).step_by(5) {
        let (body, a) = (body.at(lambda_nm as f32), a.at(lambda_nm as f32));
        assert!((body / a - 1.0).abs() < 1e-3, "{lambda_nm} nm: {body} against {a}");
    }
}

/// Points of the Planckian locus: Wyszecki & Stiles, *Color Science*, 2nd ed., 3.11.
#[test]
fn black_bodies_lie_on_the_planckian_locus() {
    let locus =
        [(2000.0, [0.5267, 0.4133]), (4000.0, [0.3805, 0.3768]), (10000.0, [0.2807, 0.2884])];
    for (kelvin, [x, y]) in locus {
        let xyz = Observer::xyz(&Spectrum::BlackBody { kelvin });
        assert!((xyz.y - 1.0).abs() < 1e-12);
        let off = (color::xy(xyz) - DVec2::new(x, y)).abs().max_element();
        assert!(off < 1e-3, "{kelvin} K: {} is off by {off}", color::xy(xyz));
    }
}

/// Points of the spectrum locus: CIE 15:2004, table T.4.
#[test]
fn single_wavelengths_lie_on_the_published_locus() {
    for (lambda_nm, published) in [
        (380.0, [0.1741, 0.0050]),
        (450.0, [0.1566, 0.0177]),
        (520.0, [0.0743, 0.8338]),
        (580.0, [0.5125, 0.4866]),
        (650.0, [0.7260, 0.2740]),
        (700.0, [0.7347, 0.2653]),
    ] {
        let found = color::xy(Observer::color_matching_at(lambda_nm));
        assert!((found - DVec2::from_array(published)).abs().max_element() < 1e-4, "{lambda_nm}");
    }
}

fn dominant_wavelength(xy: [f64; 2]) -> Option<DominantWavelength> {
    let xyz = color::xyz_from_xy(DVec2::from_array(xy), 0.2);
    DominantWavelength::of(xyz, color::d65_white())
}

/// The sRGB primaries in D65 as commonly tabulated, to the nanometre; and the examples in the
/// documentation of the package colour-science 0.4 for Python.
#[test]
fn dominant_wavelengths_are_the_published_ones() {
    for (xy, lambda_nm, is_complementary) in [
        ([0.64, 0.33], 611.4, false),
        ([0.30, 0.60], 549.1, false),
        ([0.15, 0.06], 464.2, false),
        ([0.543_695_57, 0.321_079_44], 616.0, false),
        ([0.376_055_06, 0.244_522_25], 509.0, true),
    ] {
        let found = dominant_wavelength(xy).expect("it has a hue");
        assert_eq!(found.is_complementary, is_complementary, "{xy:?}");
        assert!((found.lambda_nm - lambda_nm).abs() < 0.6, "{xy:?}: {found:?}");
    }
    let purity = dominant_wavelength([0.543_695_57, 0.321_079_44]).expect("a hue").purity;
    assert!((purity - 0.622_885_6).abs() < 2e-3, "{purity}");
}

/// On a corner of the locus, where two of its lines meet.
#[test]
fn single_wavelengths_are_their_own_dominant_ones() {
    for lambda_nm in (380..=700).map(f64::from) {
        let pure = color::xy(Observer::color_matching_at(lambda_nm));
        let found = dominant_wavelength(pure.to_array()).expect("it has a hue");
        assert!(!found.is_complementary, "{lambda_nm}: {found:?}");
        // At its ends the locus is not quite convex.
        if (400.0..=680.0).contains(&lambda_nm) {
            assert!((found.lambda_nm - lambda_nm).abs() < 0.05, "{lambda_nm}: {found:?}");
            assert!((found.purity - 1.0).abs() < 1e-4, "{lambda_nm}: {found:?}");
        }
    }
}

#[test]
fn mixtures_with_white_have_the_wavelength_and_the_share_that_were_mixed() {
    let white = color::d65_white();
    for lambda_nm in (400..=680).step_by(7).map(f64::from) {
        let pure = color::xy(Observer::color_matching_at(lambda_nm));
        for purity in [0.05, 0.5, 0.99] {
            let xy = color::D65_XY.lerp(pure, purity);
            let found = dominant_wavelength(xy.to_array()).expect("it has a hue");
            assert!((found.lambda_nm - lambda_nm).abs() < 0.05, "{lambda_nm}: {found:?}");
            assert!((found.purity - purity).abs() < 1e-4, "{lambda_nm}: {found:?}");
            // Across the white lies what is complementary, if it is no single wavelength itself.
            let opposite = color::D65_XY - 0.2 * (pure - color::D65_XY);
            let opposite = dominant_wavelength(opposite.to_array()).expect("it has a hue");
            if opposite.is_complementary {
                assert!((opposite.lambda_nm - lambda_nm).abs() < 0.05, "{opposite:?}");
            }
        }
    }
    for hueless in [white, DVec3::ZERO, DVec3::NAN, 3.0 * white] {
        assert_eq!(DominantWavelength::of(hueless, white), None);
    }
    assert_eq!(DominantWavelength::of(white, DVec3::ZERO), None);
}

#[test]
fn a_flat_spectrum_has_exactly_its_value_in_every_bin() {
    for count in [1, 7, 16, 64] {
        let means = Spectrum::Flat(0.3).bin_means(Bins::new(count));
        assert_eq!(means, vec![0.3; count as usize]);
    }
}

/// A triangle 2 high and 7 nm wide, of area 7 nm, inside the third of 35 bins of 10 nm; and a ramp whose mean is its value in the middle of the bin.
#[test]
fn bin_means_are_exact_for_straight_lines() {
    let peak =
        Spectrum::Tabulated { lambda_nm: vec![402.0, 404.5, 409.0], value: vec![0.0, 2.0, 0.0] };
    let means = peak.bin_means(Bins::new(35));
    assert_eq!(means[2], 0.7);
    assert!(means.iter().enumerate().all(|(index, &mean)| index == 2 || mean == 0.0));

    let ramp = Spectrum::Tabulated { lambda_nm: vec![380.0, 730.0], value: vec![0.0, 1.0] };
    for count in [4, 16, 23, 64] {
        let bins = Bins::new(count);
        for (index, mean) in ramp.bin_means(bins).into_iter().enumerate() {
            let center = (bins.center_nm(index) - 380.0) / 350.0;
            assert!((f64::from(mean) - center).abs() < 1e-7, "{count} bins, bin {index}");
        }
    }
}

/// The mean of each bin, whatever its edges, against the sum over a thousand points.
#[test]
fn bin_means_agree_with_brute_force() {
    let spectra = [
        Spectrum::Illuminant(Illuminant::F11),
        Spectrum::BlackBody { kelvin: 3200.0 },
        Spectrum::Rgb([0.9, 0.2, 0.05]),
    ];
    let bins = Bins::new(13);
    for spectrum in spectra {
        for (index, mean) in spectrum.bin_means(bins).into_iter().enumerate() {
            let (low, high) = bins.range_nm(index);
            let sum: f64 = (0..400)
                .map(|i| f64::from(spectrum.at(low + (high - low) * (i as f32 + 0.5) / 400.0)))
                .sum();
            let brute = sum / 400.0;
            assert!(
                (f64::from(mean) - brute).abs() < 1e-4 * brute.max(0.1),
                "{spectrum:?} {index}"
            );
        }
    }
}

/// Linear sRGB of a reflectance in the equal-energy light, adapted to the display's white.
fn rgb_under_equal_energy(reflectance: &Spectrum) -> DVec3 {
    let white = Observer::xyz(&Spectrum::Flat(1.0));
    let adapted = color::adaptation(white, color::d65_white()) * Observer::xyz(reflectance);
    color::rec709_from_xyz() * adapted
}

#[test]
fn a_colour_becomes_a_reflectance_and_develops_to_the_same_colour() {
    let levels = [0.0, 1e-3, 0.03, 0.2, 0.5, 0.8, 0.97, 1.0];
    for r in levels {
        for g in levels {
            for b in levels {
                let spectrum = Spectrum::Rgb([r, g, b]);
                let target = DVec3::new(r.into(), g.into(), b.into());
                let error = (rgb_under_equal_energy(&spectrum) - target).abs().max_element();
                assert!(error < 1e-8, "{target} is off by {error:e}");
                let means = spectrum.bin_means(Bins::new(64));
                assert!(means.iter().all(|mean| (0.0..=1.0).contains(mean)), "{target}");
            }
        }
    }
}

/// Red, green and blue are all there is of white, at every wavelength, and each is a reflectance.
#[test]
fn the_primaries_add_up_to_white() {
    let [red, green, blue] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Spectrum::Rgb);
    for lambda_nm in (0..=3500).map(|i| 380.0 + 0.1 * i as f32) {
        let parts = [&red, &green, &blue].map(|primary| primary.at(lambda_nm));
        assert!(parts.iter().all(|part| (0.0..=1.0).contains(part)), "{lambda_nm} nm: {parts:?}");
        assert!((parts.iter().sum::<f32>() - 1.0).abs() < 1e-6, "{lambda_nm} nm: {parts:?}");
    }
}

/// Between two texels a print has the mixture of their reflectances: that must be the reflectance
/// of the mixture of their colours.
#[test]
fn a_mixture_of_colours_has_the_mixture_of_their_reflectances() {
    let [warm, cold] = [[0.9_f32, 0.3, 0.1], [0.05, 0.2, 0.8]];
    let bins = Bins::new(16);
    for part in [0.1, 0.5, 0.7] {
        let mix = |a: f32, b: f32| a + part * (b - a);
        let mixed = Spectrum::Rgb(std::array::from_fn(|i| mix(warm[i], cold[i]))).bin_means(bins);
        let [warm, cold] = [warm, cold].map(|colour| Spectrum::Rgb(colour).bin_means(bins));
        for (bin, mixed) in mixed.into_iter().enumerate() {
            assert!((mixed - mix(warm[bin], cold[bin])).abs() < 1e-6, "{part}, bin {bin}");
        }
    }
}

/// A film sees means over its bins; each halving of the bins brings the colour about four times
/// nearer.
#[test]
fn more_bins_show_a_colour_more_exactly() {
    let white = Observer::xyz(&Spectrum::Flat(1.0));
    let rgb_from_xyz = color::rec709_from_xyz() * color::adaptation(white, color::d65_white());
    for (count, tolerance) in [(16, 0.02), (32, 0.005), (64, 0.00125)] {
        let mut worst = 0.0_f64;
        for rgb in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.8, 0.3, 0.1]] {
            let binned = Observer::binned_xyz(&Spectrum::Rgb(rgb), Bins::new(count));
            let target = DVec3::from_array(rgb.map(f64::from));
            worst = worst.max((rgb_from_xyz * binned - target).abs().max_element());
        }
        assert!(worst < tolerance, "{count} bins are off by {worst}");
    }
}

#[test]
fn greys_reflect_every_wavelength_alike() {
    for level in [0.0, 0.18, 0.5, 1.0] {
        assert_eq!(Spectrum::Rgb([level; 3]).bin_means(Bins::new(16)), vec![level; 16]);
    }
}

#[test]
fn a_spectrum_that_means_nothing_is_refused_in_words() {
    let table = |lambda_nm: &[f32], value: &[f32]| Spectrum::Tabulated {
        lambda_nm: lambda_nm.into(),
        value: value.into(),
    };
    let refused = [
        (Spectrum::Flat(f32::NAN), "NaN"),
        (Spectrum::Flat(-1.0), "-1"),
        (table(&[], &[]), "empty"),
        (table(&[400.0, 500.0], &[1.0]), "2 wavelengths but 1 values"),
        (table(&[500.0, 400.0], &[1.0, 1.0]), "increase"),
        (table(&[500.0, 500.0], &[1.0, 1.0]), "increase"),
        (table(&[400.0, f32::NAN], &[1.0, 1.0]), "NaN"),
        (table(&[400.0, 500.0], &[1.0, f32::INFINITY]), "inf at 500 nm"),
        (Spectrum::BlackBody { kelvin: 0.0 }, "0 K"),
        (Spectrum::BlackBody { kelvin: f32::NAN }, "NaN K"),
        (Spectrum::Rgb([0.0, 1.5, 0.0]), "1.5"),
    ];
    for (spectrum, words) in refused {
        let message = spectrum.validate().expect_err(words);
        assert!(message.contains(words), "{message}");
    }
    for illuminant in Illuminant::ALL {
        assert_eq!(Spectrum::Illuminant(illuminant).validate(), Ok(()));
    }
    assert_eq!(table(&[400.0, 500.0], &[0.0, 2.0]).validate(), Ok(()));
    assert_eq!(Spectrum::Rgb([0.0, 1.0, 0.5]).validate(), Ok(()));
}
