//! Whole films of both tracers side by side.

use std::path::{Path, PathBuf};

use brilliance_renderer::develop::XyzImage;
use brilliance_renderer::film::{Counts, Film, PixelRect};
use brilliance_renderer::image_file::write_png8;
use brilliance_renderer::settings::{DisplaySettings, Splitting};
use brilliance_renderer::statistics::Statistics;
use brilliance_renderer::tracer::{GpuFilm, GpuTracer, Tracer};

use super::cases::{self, Case};
use super::{TRACER, cpu_film, limited_graphics, relative, total, trace};

/// Means of films, over all bins and of each, agree to this.
const MEAN_TOLERANCE: f64 = 1e-3;

/// How far both sides may be apart, beside the means.
///
/// Both sides do the same arithmetic, but round differently where a device contracts a·b + c,
/// divides or takes a sine its own way. One such rounding, 6e-8, moves a ray by as much, and every
/// bounce off a facet multiplies that; the pixel is the sum over a tree whose first rays carry most
/// of the light, so that nearly all pixels agree to the last digits. Where a ray passes an edge or
/// the critical angle within that rounding it goes another way, and with it a whole branch: such a
/// pixel may differ by anything, which is why there is no bound on the largest difference, but only
/// few rays are so close. A rule that one side has and the other lacks shows in many pixels.
struct Bounds {
    /// How many pixels may differ by how much of their radiance.
    histogram: [(f64, f64); 3],
    /// By what part the numbers of segments may differ.
    segments: f64,
    /// How many pixels may have other counts.
    counted: f64,
    /// What light of a pixel that was pruned is too little to be compared.
    least_pruned: f64,
}

const OF_RAYS: Bounds = Bounds {
    histogram: [(1e-4, 0.05), (1e-2, 0.02), (0.1, 0.005)],
    segments: 1e-3,
    counted: 0.05,
    least_pruned: 0.0,
};

/// Where a fan is divided at edges that are searched for by halves, one rounding moves the place by one
/// of the smallest steps. And where rounding divides a fan on one side only, what comes of its parts lives
/// by other chances.
const OF_FANS: Bounds = Bounds {
    histogram: [(1e-3, 0.12), (1e-2, 0.05), (0.1, 0.015)],
    segments: 5e-3,
    counted: 0.25,
    least_pruned: 1.0,
};

impl Bounds {
    fn of(case: &Case) -> &'static Self {
        match case.settings().splitting {
            Splitting::Paper => &OF_RAYS,
            Splitting::Exact => &OF_FANS,
        }
    }
}

pub(crate) fn assert_in_step(case: &Case, tracer: &GpuTracer) -> (Statistics, Statistics) {
    let (film, gpu_statistics) = trace(tracer, case);
    let cpu_statistics = assert_same(case, tracer, film);
    assert_eq!(gpu_statistics.camera_rays, cpu_statistics.camera_rays);
    let segments = [cpu_statistics, gpu_statistics].map(|statistics| statistics.segments as f64);
    let apart = relative(segments[0], segments[1]);
    assert!(apart < Bounds::of(case).segments, "{}: {segments:?}", case.name);
    let largest =
        [cpu_statistics, gpu_statistics].map(|it| f64::from(it.max_segments_per_camera_ray));
    assert!(relative(largest[0], largest[1]) < 0.05, "{}: {largest:?}", case.name);
    let ledger = gpu_statistics.ledger;
    // Exact splitting closes the books but for what its parabolas miss.
    let apart = ledger.imbalance() - cpu_statistics.ledger.imbalance();
    assert!(apart.abs() < 1e-5 * ledger.entered, "{}: {apart} {ledger:?}", case.name);
    for (what, cpu, gpu) in [
        ("returned", cpu_statistics.ledger.returned, ledger.returned),
        ("absorbed", cpu_statistics.ledger.absorbed, ledger.absorbed),
        ("pruned", cpu_statistics.ledger.pruned, ledger.pruned),
        ("cut off", cpu_statistics.ledger.cut_off, ledger.cut_off),
        ("lost", cpu_statistics.ledger.lost, ledger.lost),
    ] {
        assert!((cpu - gpu).abs() < 1e-4 * ledger.entered, "{}: {what} {cpu} {gpu}", case.name);
    }
    (cpu_statistics, gpu_statistics)
}

/// The film that the device made of all the case's passes is the processor's, whose counts are
/// given back.
pub(crate) fn assert_same(case: &Case, tracer: &GpuTracer, film: GpuFilm) -> Statistics {
    let (cpu, statistics) = cpu_film(case);
    let gpu = tracer.read(film).expect("the film is read");
    assert_eq!((gpu.size(), gpu.passes()), (cpu.size(), cpu.passes()));
    if let Err(fault) = compare(case, &cpu, &gpu) {
        let path = write_side_by_side(case, &cpu, &gpu);
        panic!("{}: {fault}; see {}: CPU, GPU, difference", case.name, path.display());
    }
    assert_same_counts(case, &cpu, &gpu);
    statistics
}

/// The means of the counts agree as those of the films do, and the counts of nearly all pixels.
fn assert_same_counts(case: &Case, cpu: &Film, gpu: &Film) {
    let bounds = Bounds::of(case);
    let least = [("rays", 0.0), ("depth", 0.0), ("pruned", bounds.least_pruned)];
    for (i, (name, least)) in least.into_iter().enumerate() {
        let [on_cpu, on_gpu] = [cpu, gpu].map(|film| {
            let counts: &[f32] = bytemuck::cast_slice(film.counts());
            counts.iter().skip(i).step_by(Counts::LEN).map(|&count| f64::from(count))
        });
        let [cpu_total, gpu_total]: [f64; 2] = [on_cpu.clone().sum(), on_gpu.clone().sum()];
        let pixels = cpu.counts().len() as f64;
        let apart = (cpu_total - gpu_total).abs() / cpu_total.max(1e-3 + least * pixels);
        assert!(apart < bounds.segments, "{}: {name} {cpu_total} {gpu_total}", case.name);
        let is_different = |(cpu, gpu): &(f64, f64)| (cpu - gpu).abs() > 1e-3 * cpu.max(least);
        let share = on_cpu.zip(on_gpu).filter(is_different).count() as f64 / pixels;
        assert!(share < bounds.counted, "{}: {name} of {share} of the pixels", case.name);
    }
}

/// A NaN does.
fn exceeds(difference: f64, threshold: f64) -> bool {
    difference.is_nan() || difference > threshold
}

pub(crate) fn compare(case: &Case, cpu: &Film, gpu: &Film) -> Result<(), String> {
    let bins = cpu.bins().count();
    let mean = relative(total(cpu), total(gpu));
    if exceeds(mean, MEAN_TOLERANCE) {
        return Err(format!("the means differ by {mean:e}"));
    }
    for bin in 0..bins {
        let sum = |film: &Film| -> f64 {
            film.sums().iter().skip(bin).step_by(bins).map(|&sum| f64::from(sum)).sum()
        };
        let difference = relative(sum(cpu), sum(gpu));
        if exceeds(difference, MEAN_TOLERANCE) {
            return Err(format!("the means of bin {bin} differ by {difference:e}"));
        }
    }
    // Dark pixels count by the film's mean, or their last digits would count as much as all else.
    let dark = 0.01 * total(cpu) * bins as f64 / cpu.sums().len() as f64;
    let pixels = cpu.sums().chunks_exact(bins).zip(gpu.sums().chunks_exact(bins));
    let differences: Vec<f64> = pixels
        .map(|(cpu, gpu)| {
            let light: f64 = cpu.iter().map(|&sum| f64::from(sum)).sum();
            let apart = cpu.iter().zip(gpu).map(|(cpu, gpu)| f64::from((cpu - gpu).abs()));
            apart.sum::<f64>() / light.max(dark)
        })
        .collect();
    for (threshold, most) in Bounds::of(case).histogram {
        let count =
            differences.iter().filter(|&&difference| exceeds(difference, threshold)).count();
        let share = count as f64 / differences.len() as f64;
        if share > most {
            return Err(format!("{count} pixels differ by more than {threshold}"));
        }
    }
    Ok(())
}

/// Writes both films and ten times their difference into one picture.
pub(crate) fn write_side_by_side(case: &Case, cpu: &Film, gpu: &Film) -> PathBuf {
    let name = format!("{}-{:?}.png", case.name, case.settings().splitting);
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let [width, height] = cpu.size();
    let develop =
        |film: &Film| XyzImage::from_film(film).develop_rgba8(&DisplaySettings::default());
    let (cpu, gpu) = (develop(cpu), develop(gpu));
    let mut difference = vec![255; cpu.len()];
    for (i, (cpu, gpu)) in cpu.iter().zip(&gpu).enumerate().filter(|(i, _)| i % 4 != 3) {
        difference[i] = cpu.abs_diff(*gpu).saturating_mul(10);
    }
    let row = 4 * width as usize;
    let mut picture = Vec::new();
    for ((cpu, gpu), difference) in
        cpu.chunks_exact(row).zip(gpu.chunks_exact(row)).zip(difference.chunks_exact(row))
    {
        picture.extend([cpu, gpu, difference].concat());
    }
    write_png8(&path, [3 * width, height], &picture, &[]).expect("the picture is written");
    path
}

#[test]
fn single_diamond() {
    assert_in_step(&cases::diamond(), &TRACER);
}

#[test]
fn seven_diamonds_on_a_cloth() {
    assert_in_step(&cases::seven_diamonds(), &TRACER);
}

#[test]
fn mesh_from_gltf() {
    assert_in_step(&cases::mesh(), &TRACER);
}

#[test]
fn prism() {
    assert_in_step(&cases::prism(), &TRACER);
}

#[test]
fn beam_through_a_prism() {
    assert_in_step(&cases::beam(), &TRACER);
}

#[test]
fn word_and_prism() {
    assert_in_step(&cases::print(), &TRACER);
}

#[test]
fn coloured_stones_in_each_other_and_beside_a_matte_block() {
    let (cpu, _) = assert_in_step(&cases::nested(), &TRACER);
    assert!(cpu.ledger.absorbed > 0.05 * cpu.ledger.entered, "the case absorbs: {cpu:?}");
}

#[test]
fn film_in_bands() {
    // A row of 128 pixels takes 35 KiB, and so many fit that they are two bands.
    let graphics = limited_graphics(|limits| limits.max_storage_buffer_binding_size = 3 << 19);
    let tracer = GpuTracer::new(&graphics).expect("the device can trace");
    let case = cases::banded();
    let film = tracer.film(case.size, case.bins(), None).expect("there is room for the film");
    let bands: Vec<_> = film.bands().iter().map(|band| (band.first_row, band.rows)).collect();
    assert_eq!(bands, [(0, 43), (43, 29)]);
    drop(film);
    assert_in_step(&case, &tracer);
    // Rounds of one pass: more than one call has of them, and more than one in each band.
    tracer.limit_rounds(1);
    assert_in_step(&Case { passes: 3, ..case }, &tracer);
}

#[test]
fn a_region_is_read_by_itself() {
    let graphics = limited_graphics(|limits| limits.max_storage_buffer_binding_size = 3 << 19);
    let tracer = GpuTracer::new(&graphics).expect("the device can trace");
    let case = cases::banded();
    let (film, _) = trace(&tracer, &case);
    assert_eq!(film.bands().len(), 2);
    let pixels = [[0, 0], [64, 36], [127, 42], [0, 43], [70, 50], [127, 71]];
    let regions = [
        PixelRect { min: [20, 10], size: [70, 30] },
        PixelRect { min: [50, 40], size: [9, 20] },
        PixelRect { min: [0, 0], size: [128, 72] },
        PixelRect { min: [100, 60], size: [500, 500] },
        PixelRect { min: [128, 0], size: [1, 1] },
    ];
    let pixels = pixels.map(|min| PixelRect { min, size: [1, 1] });
    let rects: Vec<_> = pixels.into_iter().chain(regions).collect();
    let read = |rect: &PixelRect| tracer.mean_spectrum(&film, *rect).expect("a region is read");
    let read: Vec<_> = rects.iter().map(read).collect();
    let film = tracer.read(film).expect("the film is read");
    for (rect, found) in rects.into_iter().zip(&read) {
        let expected = film.mean_spectrum(rect);
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found - expected).abs() <= 1e-6 * expected, "{rect:?}: {found} {expected}");
        }
        if rect.size == [1, 1] && rect.within(film.size()).is_some() {
            assert_eq!(expected, film.pixel(rect.min[0], rect.min[1]));
        }
    }
    assert!(read[1] != read[4], "the pixels differ");
    assert!(read[8].iter().all(|&mean| mean > 0.0), "the whole film is not dark");
    assert!(read[10].iter().all(|&mean| mean == 0.0), "there is nothing beside the film");
}

#[test]
fn white_furnace() {
    let case = cases::furnace();
    let (film, statistics) = trace(&*TRACER, &case);
    let film = TRACER.read(film).expect("the film is read");
    let mean = total(&film) / (film.sums().len() as f64 * f64::from(film.passes()));
    let totals = film.counts().iter().fold(Counts::default(), |mut sum, counts| {
        sum += *counts;
        sum
    });
    assert_eq!(f64::from(totals.rays), statistics.segments as f64);
    let pruned = f64::from(totals.pruned);
    assert!(relative(statistics.ledger.pruned, pruned) < 1e-4, "{pruned} {statistics:?}");
    let ended = statistics.ledger.pruned + statistics.ledger.cut_off;
    let expected = 1.0 - ended / statistics.ledger.entered;
    assert!((mean - expected).abs() < 1e-5, "{mean} {expected}");
    assert_eq!(statistics.ledger.lost, 0.0);
}
