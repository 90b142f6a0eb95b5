//! The best Monte-Carlo form for a clear convex stone, as what the method is held against: one wavelength
//! per path, evenly distributed over the passes of a pixel; what is transmitted is added at every facet,
//! what is reflected is followed.
//!
//! It knows only what it needs, one stone and lights without a place: no stack, no bins, no books.

use std::time::Instant;

use brilliance_renderer::develop::XyzImage;
use brilliance_renderer::error::RendererError;
use brilliance_renderer::kernel::camera::{camera_ray, pixel_seed};
use brilliance_renderer::kernel::convex::{enter_convex, leave_convex};
use brilliance_renderer::kernel::interface::{
    cos_refracted_squared, fresnel, index_of_refraction, reflect,
};
use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::kernel::rng::{WAVELENGTH_STEP, hash, unit_float};
use brilliance_renderer::packed::{CONVEX, NONE, PackedScene};
use brilliance_renderer::spectrum::{Bins, LAMBDA_MAX_NM, LAMBDA_MIN_NM};
use brilliance_renderer::tracer::View;
use glam::Vec3;
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::method::Picture;
use crate::scene::ReferenceScene;
use crate::wavelengths::Wavelengths;

/// Pixels that a thread takes at a time, as many as the tracer's.
const STRIP_PIXELS: usize = 64;
/// Weight below which a path goes on by chance. Of 0.1, 0.03, 0.01, 0.003 and a threshold of 0.001 the one
/// with the least squared error times time.
const ROULETTE_WEIGHT: f32 = 0.01;
/// Facets after which a path ends that is totally reflected again and again.
const MAX_DEPTH: u32 = 256;
/// One for each nanometre: as good as continuous for spectra of lights.
const BINS: u32 = 350;

/// A picture by one wavelength per camera ray.
pub(crate) struct Baseline {
    pool: ThreadPool,
    scene: PackedScene,
    view: View,
    size: [u32; 2],
    wavelengths: Wavelengths,
    /// Number of the first pass: other passes are other samples.
    first_pass: u32,
    passes: u32,
    /// Facets met so far, and camera rays.
    segments: u64,
    /// CIE XYZ per pixel, summed over the passes.
    sums: Vec<Vec3>,
}

impl Baseline {
    /// An empty picture of `scene`, the first pass of which has the number `first_pass`.
    ///
    /// # Errors
    /// There is more in the scene than one clear convex stone.
    pub(crate) fn new(scene: &ReferenceScene, first_pass: u32) -> Result<Self, RendererError> {
        let fault = |text: &str| RendererError::Invalid(format!("{}: {text}", scene.name));
        let packed = PackedScene::new(&scene.document.scene, Bins::new(BINS))?;
        let is_stone = |i: u32| packed.instances[i as usize].kind == CONVEX;
        let is_clear = |i: u32| !packed.material_of(i).is_opaque();
        if packed.instances.len() != 1 || !is_stone(0) || !is_clear(0) {
            return Err(fault("the baseline knows one clear convex stone; remove the others"));
        }
        if packed.material_of(0).absorption != NONE || packed.ground.reflectance[0] != NONE {
            return Err(fault("the baseline knows neither colour nor ground; remove them"));
        }
        let pool = ThreadPoolBuilder::new()
            .thread_name(|i| format!("baseline {i}"))
            .build()
            .map_err(|error| fault(&format!("no threads to trace with: {error}")))?;
        Ok(Self {
            pool,
            scene: packed,
            view: View::new(&scene.document.scene.camera, scene.size),
            size: scene.size,
            wavelengths: Wavelengths::new(),
            first_pass,
            passes: 0,
            segments: 0,
            sums: vec![Vec3::ZERO; (scene.size[0] * scene.size[1]) as usize],
        })
    }

    /// Traces one path and returns the number of its rays.
    fn add_sample(&self, pixel: u32, pass_index: u32, sum: &mut Vec3) -> u64 {
        let (x, y) = (pixel % self.size[0], pixel / self.size[0]);
        let seed = pixel_seed(x, y);
        let number = unit_float(seed.wrapping_add(pass_index.wrapping_mul(WAVELENGTH_STEP)));
        let (lambda_nm, xyz) = self.wavelengths.at(number);
        let mut path = Path {
            baseline: self,
            lambda_nm,
            seed: hash(seed ^ hash(pass_index)),
            radiance: 0.0,
            segments: 1,
        };
        path.follow(&camera_ray(&self.view.frame, self.size, x, y, pass_index));
        *sum += xyz * path.radiance;
        path.segments
    }
}

impl Picture for Baseline {
    fn add_passes(&mut self, passes: u32) -> Result<f64, RendererError> {
        let start = Instant::now();
        for _ in 0..passes {
            let pass_index = self.first_pass.wrapping_add(self.passes);
            let mut sums = std::mem::take(&mut self.sums);
            let this = &*self;
            let trace_strip = |(strip, sums): (usize, &mut [Vec3])| {
                let pixels = sums.iter_mut().zip((strip * STRIP_PIXELS) as u32..);
                pixels.map(|(sum, pixel)| this.add_sample(pixel, pass_index, sum)).sum::<u64>()
            };
            let strips = sums.par_chunks_mut(STRIP_PIXELS).enumerate();
            let segments = this.pool.install(|| strips.map(trace_strip).sum::<u64>());
            self.segments += segments;
            self.sums = sums;
            self.passes += 1;
        }
        Ok(start.elapsed().as_secs_f64())
    }

    fn image(&self) -> XyzImage {
        let xyz = self.sums.iter().map(|sum| (*sum / self.passes as f32).to_array()).collect();
        XyzImage { size: self.size, bins: self.scene.bins, xyz }
    }

    fn mean_segments(&self) -> f64 {
        self.segments as f64 / (u64::from(self.passes) * self.sums.len() as u64) as f64
    }
}

/// The light of one wavelength on its way back from the camera.
struct Path<'a> {
    baseline: &'a Baseline,
    lambda_nm: f32,
    seed: u32,
    radiance: f32,
    segments: u64,
}

impl Path<'_> {
    fn follow(&mut self, camera_ray: &Ray) {
        let scene = &self.baseline.scene;
        let stone = &scene.instances[0];
        let entry = enter_convex(scene, stone, camera_ray);
        if entry.facet == NONE {
            self.see(camera_ray.direction, 1.0, true);
            return;
        }
        let index = index_of_refraction(scene, scene.material_of(0).index_table, self.lambda_nm);
        let origin = camera_ray.origin + camera_ray.direction * entry.distance;
        let cos_i = -camera_ray.direction.dot(entry.normal);
        let cos_t = cos_refracted_squared(cos_i, index.recip()).max(0.0).sqrt();
        let reflectance = fresnel(cos_i, cos_t, index.recip());
        self.see(reflect(camera_ray.direction, entry.normal), reflectance, false);
        let inward = camera_ray.direction / index + entry.normal * (cos_i / index - cos_t);
        self.follow_inside(Ray::white(origin, inward), entry.facet, 1.0 - reflectance);
    }

    /// Follows a ray from facet to facet, and adds what each lets out.
    fn follow_inside(&mut self, mut ray: Ray, mut facet: u32, mut weight: f32) {
        let scene = &self.baseline.scene;
        let stone = &scene.instances[0];
        let index = index_of_refraction(scene, scene.material_of(0).index_table, self.lambda_nm);
        for _ in 0..MAX_DEPTH {
            let hit = leave_convex(scene, stone, &ray, facet);
            self.segments += 1;
            let cos_i = ray.direction.dot(hit.normal);
            let cos_t_squared = cos_refracted_squared(cos_i, index);
            if cos_i > 0.0 && cos_t_squared > 0.0 {
                let cos_t = cos_t_squared.sqrt();
                let reflectance = fresnel(cos_i, cos_t, index);
                let outward = ray.direction * index + hit.normal * (cos_t - index * cos_i);
                self.see(outward, weight * (1.0 - reflectance), false);
                weight *= reflectance;
                if weight < ROULETTE_WEIGHT {
                    self.seed = self.seed.wrapping_add(1);
                    if unit_float(hash(self.seed)) * ROULETTE_WEIGHT >= weight {
                        return;
                    }
                    weight = ROULETTE_WEIGHT;
                }
            }
            ray.origin += ray.direction * hit.distance;
            ray.direction = reflect(ray.direction, hit.normal);
            facet = hit.facet;
        }
    }

    /// Adds what is seen in `direction`, which nothing stands in the way of.
    fn see(&mut self, direction: Vec3, weight: f32, from_camera: bool) {
        let Baseline { scene, view, .. } = self.baseline;
        let sky = &scene.sky;
        let nanometre = (self.lambda_nm - LAMBDA_MIN_NM).min(LAMBDA_MAX_NM - LAMBDA_MIN_NM - 1.0);
        let radiance = |row: u32| scene.spectrum_value(row, nanometre as u32);
        if from_camera && sky.backdrop != NONE {
            self.radiance += weight * radiance(sky.backdrop);
            return;
        }
        let mut seen = 0.0;
        for disc in &scene.discs {
            if is_within(direction, disc.direction, disc.cos_radius, disc.sin_squared_radius) {
                seen += radiance(disc.spectrum);
            }
        }
        let (cos_radius, sin_squared) = (sky.cos_observer_shadow, sky.sin_squared_observer_shadow);
        let has_shadow = sin_squared > 0.0;
        if !(has_shadow && is_within(direction, view.observer, cos_radius, sin_squared)) {
            if sky.environment != NONE {
                seen += radiance(sky.environment);
            }
            if sky.hemisphere != NONE && direction.z > 0.0 {
                seen += radiance(sky.hemisphere);
            }
        }
        self.radiance += weight * seen;
    }
}

/// Whether a direction lies in the cone about `center`; the cosine of a small angle alone is too coarse.
fn is_within(direction: Vec3, center: Vec3, cos_radius: f32, sin_squared_radius: f32) -> bool {
    /// Above the rounding of cosines.
    const MARGIN: f32 = 1e-5;
    let along = direction.dot(center);
    along > cos_radius - MARGIN
        && along > 0.0
        && direction.cross(center).length_squared() <= sin_squared_radius
}
