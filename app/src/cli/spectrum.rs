//! `brilliance spectrum`: the spectrum of a pixel or of a region, as numbers.

use std::io::{self, ErrorKind, Write as _};
use std::path::PathBuf;

use anyhow::{Context as _, ensure};
use brilliance_renderer::color;
use brilliance_renderer::develop::ColorPath;
use brilliance_renderer::film::PixelRect;
use brilliance_renderer::scene_file::{Document, StillSettings};
use brilliance_renderer::settings::DisplaySettings;
use brilliance_renderer::spectrum::{DominantWavelength, Observer};
use brilliance_renderer::still::{Still, StillLimits};
use clap::{ArgGroup, Args};
use serde::Serialize;

use super::arguments::within;
use super::assignment::{Assignment, open_with};
use super::backend::BackendChoice;
use super::image_size::ImageSize;
use super::pixel::Pixel;
use super::render::{cancelled_by_ctrl_c, check_film, trace};
use crate::spectrum_csv::{Column, spectrum_csv};

/// Pixels whose light is taken apart.
#[derive(Args, Debug)]
#[command(group(ArgGroup::new("place").required(true).args(["pixel", "region"])))]
pub(super) struct SpectrumArguments {
    /// Scene (.toml), mesh (.gltf, .glb) or a still made before (.png, .exr)
    scene: PathBuf,

    /// Column and row of the pixel, counted from 0 at the upper left corner
    #[arg(long, value_name = "X,Y")]
    pixel: Option<Pixel>,

    /// Column and row of the first pixel of a region, its width and its height, in pixels
    #[arg(long, value_name = "X,Y,W,H", value_parser = parse_region)]
    region: Option<PixelRect>,

    /// Width and height of the picture in pixels [default: the scene's]
    #[arg(long, value_name = "WxH")]
    size: Option<ImageSize>,

    /// Passes, each of one camera ray per pixel [default: the scene's]
    #[arg(long, value_name = "N", value_parser = within(StillSettings::PASSES))]
    passes: Option<u32>,

    /// What traces
    #[arg(long, value_enum, default_value_t)]
    backend: BackendChoice,

    /// Change a value of the scene, named by its path in the scene file; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    assignments: Vec<Assignment>,

    /// Print the spectrum and its colour as JSON rather than as comma-separated values
    #[arg(long)]
    json: bool,
}

/// Traces the picture and prints the spectrum.
pub(super) fn spectrum(arguments: &SpectrumArguments) -> anyhow::Result<()> {
    let document = open(arguments)?;
    check_film(&document)?;
    let size = document.still.size;
    let pixel = arguments.pixel.map(|Pixel(min)| PixelRect { min, size: [1, 1] });
    let place = pixel.or(arguments.region).context("no pixel and no region")?;
    ensure!(
        place.within(size) == Some(place),
        "{place}: outside of the picture of {}x{} pixels; columns and rows count from 0",
        size[0],
        size[1],
    );
    let cancel = cancelled_by_ctrl_c()?;
    let still = trace(&document, arguments.backend.into(), StillLimits::default(), &cancel)?;
    let spectrum = still.film.mean_spectrum(place);
    let printed = if arguments.json {
        serde_json::to_string(&SpectrumReport::new(&still, place, &spectrum, &document.display))?
    } else {
        let passes = if still.passes == 1 { "pass" } else { "passes" };
        let origin = format!("{place} of {}x{}, {} {passes}", size[0], size[1], still.passes);
        let column = Column { name: "radiance", bins: still.film.bins(), spectrum: &spectrum };
        spectrum_csv(&[origin], &[column])
    };
    match writeln!(io::stdout(), "{}", printed.trim_end()) {
        // Who reads the spectrum has seen enough.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        result => result.context("the spectrum can't be printed on the standard output"),
    }
}

fn open(arguments: &SpectrumArguments) -> anyhow::Result<Document> {
    let mut document = open_with(&arguments.scene, &arguments.assignments)?;
    if let Some(size) = arguments.size {
        document.still.size = size.0;
    }
    if let Some(passes) = arguments.passes {
        document.still.passes = passes;
    }
    Ok(document)
}

/// A spectrum and its colour, for other programs.
#[derive(Serialize)]
struct SpectrumReport {
    /// Column and row of the first pixel, width and height.
    region: [u32; 4],
    size: [u32; 2],
    passes: u32,
    /// Ends of the bins, one more than there are bins.
    bin_edges_nm: Vec<f32>,
    /// Mean spectral radiance per bin.
    radiance: Vec<f32>,
    xyz: [f64; 3],
    /// Chromaticities; null where there is no light.
    xy: Option<[f64; 2]>,
    uv_prime: Option<[f64; 2]>,
    dominant_wavelength_nm: Option<f64>,
    is_complementary: Option<bool>,
    purity: Option<f64>,
    linear_rgb_wanted: [f32; 3],
    linear_rgb_shown: [f32; 3],
    srgb8: [u8; 3],
    /// How far gamut mapping moved the colour; null where it did not.
    gamut_shift_uv_prime: Option<f64>,
    gamut_shift_delta_e_2000: Option<f64>,
}

impl SpectrumReport {
    fn new(still: &Still, place: PixelRect, spectrum: &[f32], display: &DisplaySettings) -> Self {
        let bins = still.film.bins();
        let xyz = Observer::xyz_of_means(spectrum, bins);
        let white = Observer::binned_xyz(&display.white_point.spectrum(), bins);
        let dominant = DominantWavelength::of(xyz, white);
        let path = ColorPath::new(xyz, bins, display);
        let shift = path.gamut_shift();
        let finite = |pair: glam::DVec2| pair.is_finite().then(|| pair.to_array());
        let ends = (0..bins.count()).map(|bin| bins.range_nm(bin).1);
        Self {
            region: [place.min[0], place.min[1], place.size[0], place.size[1]],
            size: still.film.size(),
            passes: still.passes,
            bin_edges_nm: [bins.range_nm(0).0].into_iter().chain(ends).collect(),
            radiance: spectrum.to_vec(),
            xyz: xyz.to_array(),
            xy: finite(color::xy(xyz)),
            uv_prime: finite(color::uv_prime(xyz)),
            dominant_wavelength_nm: dominant.map(|it| it.lambda_nm),
            is_complementary: dominant.map(|it| it.is_complementary),
            purity: dominant.map(|it| it.purity),
            linear_rgb_wanted: path.toned,
            linear_rgb_shown: path.shown,
            srgb8: path.srgb8,
            gamut_shift_uv_prime: shift.map(|it| it.uv_prime),
            gamut_shift_delta_e_2000: shift.map(|it| it.delta_e_2000),
        }
    }
}

fn parse_region(text: &str) -> Result<PixelRect, String> {
    let [x, y, width, height] = numbers(text)
        .filter(|[_, _, width, height]| *width > 0 && *height > 0)
        .ok_or("give the first column and row, the width and the height, such as 300,180,40,40")?;
    Ok(PixelRect { min: [x, y], size: [width, height] })
}

/// So many whole numbers with commas between.
fn numbers<const COUNT: usize>(text: &str) -> Option<[u32; COUNT]> {
    let numbers: Option<Vec<u32>> =
        text.split(',').map(|number| number.trim().parse().ok()).collect();
    numbers?.try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regions_are_read() {
        let region = PixelRect { min: [0, 7], size: [40, 3] };
        assert_eq!(parse_region("0,7,40,3"), Ok(region));
        for text in ["", "3,4", "1,2,0,4", "1,2,3,4,5", "-1,2,3,4", "1.5,2,3,4"] {
            assert!(parse_region(text).is_err(), "{text}");
        }
    }
}
