//! The CPU tracer: strips of pixels over all cores.

use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use super::{Tracer, TracerName, View, rules};
use crate::develop::{CountImage, LatentImage, XyzImage};
use crate::error::RendererError;
use crate::film::{Counts, Film, PixelRect};
use crate::kernel::camera::{camera_ray, pixel_seed};
use crate::kernel::fan_trace::trace_fans;
use crate::kernel::ray::Ray;
use crate::kernel::trace::trace;
use crate::kernel::walk::{RayStack, Tally, TraceRules, Walk};
use crate::packed::PackedScene;
use crate::settings::{NoiseGoal, Splitting, TraceSettings};
use crate::spectrum::Bins;
use crate::statistics::{Ledger, Statistics};

/// Pixels of a strip: the unit of work.
const STRIP_PIXELS: usize = 64;

/// Traces on a pool of threads of its own.
pub struct CpuTracer {
    pool: ThreadPool,
}

impl CpuTracer {
    /// Starts `threads` threads; 0 is one per core.
    ///
    /// # Errors
    /// The system refuses the threads.
    pub fn new(threads: usize) -> Result<Self, RendererError> {
        ThreadPoolBuilder::new()
            .num_threads(threads)
            .thread_name(|i| format!("tracer {i}"))
            .build()
            .map(|pool| Self { pool })
            .map_err(|error| {
                RendererError::Invalid(format!("no threads to trace with: {error}; try fewer"))
            })
    }

    /// Number of threads.
    pub fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }

    /// Traces one camera ray per pixel that is not settled and adds what it finds to `film`. The film's
    /// bits depend only on the arguments and the number of the pass, not on the threads.
    ///
    /// Returns `None` where `is_cancelled` came true, asked before every pixel; the film is then
    /// of no more use.
    fn trace_pass(
        &self,
        scene: &PackedScene,
        view: &View,
        settings: &TraceSettings,
        film: &mut Film,
        is_cancelled: &(dyn Fn() -> bool + Sync),
    ) -> Option<Statistics> {
        let (rules, pass_index) = (rules(view, settings), film.passes());
        let (size, bins) = (film.size(), film.bins().count());
        let pass = Pass { scene, view, rules: &rules, index: pass_index, size, is_cancelled };
        let strips = self.pool.install(|| {
            let (sums, counts, settled) = film.parts_mut();
            let strips = sums
                .par_chunks_mut(STRIP_PIXELS * bins)
                .zip(counts.par_chunks_mut(STRIP_PIXELS))
                .zip(settled.par_chunks(STRIP_PIXELS))
                .enumerate()
                .map(|(number, ((sums, counts), settled))| Strip {
                    number,
                    bins,
                    sums,
                    counts,
                    settled,
                });
            match settings.splitting {
                Splitting::Paper => strips
                    .map_init(RayStack::new, |stack, strip| pass.trace_strip(strip, stack, trace))
                    .collect::<Option<Vec<_>>>(),
                Splitting::Exact => strips
                    .map_init(RayStack::of_fans, |stack, strip| {
                        pass.trace_strip(strip, stack, trace_fans)
                    })
                    .collect(),
            }
        })?;
        film.complete_pass();
        let mut statistics = Statistics::default();
        for strip in strips {
            statistics += strip;
        }
        Some(statistics)
    }
}

/// What is the same for all pixels of a pass.
struct Pass<'a> {
    scene: &'a PackedScene,
    view: &'a View,
    rules: &'a TraceRules,
    index: u32,
    size: [u32; 2],
    is_cancelled: &'a (dyn Fn() -> bool + Sync),
}

/// Pixels that follow each other.
struct Strip<'a> {
    number: usize,
    bins: usize,
    sums: &'a mut [f32],
    counts: &'a mut [Counts],
    settled: &'a [bool],
}

impl Pass<'_> {
    /// Follows the camera ray of each pixel of a strip that is not settled; nothing where the pass is
    /// cancelled.
    fn trace_strip<R: Copy>(
        &self,
        strip: Strip<'_>,
        stack: &mut RayStack<R>,
        trace: impl Fn(&mut Walk<'_, R>, &Ray),
    ) -> Option<Statistics> {
        let mut statistics = Statistics::default();
        let mut radiance = vec![0.0; strip.bins];
        let pixels = strip.sums.chunks_exact_mut(strip.bins).zip(strip.counts).zip(strip.settled);
        for (i, ((pixel, counts), is_settled)) in pixels.enumerate() {
            if (self.is_cancelled)() {
                return None;
            }
            if *is_settled {
                continue;
            }
            let number = (strip.number * STRIP_PIXELS + i) as u32;
            let (x, y) = (number % self.size[0], number / self.size[0]);
            radiance.fill(0.0);
            let seed = pixel_seed(x, y);
            let mut walk =
                Walk::new(self.scene, self.rules, self.index, seed, stack, &mut radiance);
            trace(&mut walk, &camera_ray(&self.view.frame, self.size, x, y, self.index));
            let tally = walk.tally;
            pixel.iter_mut().zip(&radiance).for_each(|(sum, found)| *sum += found);
            *counts += Counts::of_sample(&tally, &radiance);
            statistics += pixel_statistics(&tally);
        }
        Some(statistics)
    }
}

impl Tracer for CpuTracer {
    type Scene = PackedScene;
    type Film = Film;

    fn name(&self) -> TracerName {
        TracerName::Cpu { threads: self.threads() }
    }

    fn load(&self, scene: PackedScene) -> Result<PackedScene, RendererError> {
        Ok(scene)
    }

    fn film(&self, size: [u32; 2], bins: Bins, used: Option<Film>) -> Result<Film, RendererError> {
        Ok(match used {
            Some(mut film) if film.size() == size && film.bins() == bins => {
                film.clear();
                film
            }
            _ => Film::new(size[0], size[1], bins),
        })
    }

    fn trace(
        &self,
        scene: &PackedScene,
        view: &View,
        settings: &TraceSettings,
        film: &mut Film,
        passes: u32,
        is_cancelled: &(dyn Fn() -> bool + Sync),
    ) -> Result<Statistics, RendererError> {
        let mut statistics = Statistics::default();
        for _ in 0..passes {
            statistics += self
                .trace_pass(scene, view, settings, film, is_cancelled)
                .ok_or(RendererError::Cancelled)?;
        }
        Ok(statistics)
    }

    fn expose(&self, film: &Film) -> Result<LatentImage, RendererError> {
        let (light, counts) = (XyzImage::from_film(film), CountImage::from_film(film));
        Ok(LatentImage::Memory { light, counts })
    }

    fn mean_spectrum(&self, film: &Film, rect: PixelRect) -> Result<Vec<f32>, RendererError> {
        Ok(self.pool.install(|| film.mean_spectrum(rect)))
    }

    fn measure_noise(&self, film: &mut Film, goal: NoiseGoal) -> Result<f32, RendererError> {
        Ok(self.pool.install(|| film.measure_noise(goal)))
    }

    fn copy_means(&self, film: &Film) -> Option<Vec<f32>> {
        Some(film.means())
    }

    fn read(&self, film: Film) -> Result<Film, RendererError> {
        Ok(film)
    }
}

/// The counts of one pixel in one pass.
fn pixel_statistics(tally: &Tally) -> Statistics {
    Statistics {
        camera_rays: 1,
        segments: u64::from(tally.segments),
        max_segments_per_camera_ray: tally.segments,
        ledger: Ledger::of_tally(tally),
    }
}
