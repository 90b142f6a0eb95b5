//! A fan that ends at a matte surface: its wavelengths meet it at different places.

use crate::kernel::axis::wavelength_at;
use crate::kernel::band::retire_fan;
use crate::kernel::diffuse::shade_diffuse;
use crate::kernel::fan::{Fan, axis_position_in, is_dispersed, ray_in_fan};
use crate::kernel::fan_walk::{largest, least_of};
use crate::kernel::parabola::{parabola_at, parabola_through};
use crate::kernel::ray::Hit;
use crate::kernel::rng;
use crate::kernel::walk::Walk;

/// Part of itself by which the weight of a ray may vary over its interval.
pub const WEIGHT_TOLERANCE: f32 = 0.02;

/// Deposits the light that the surface at `hit` sends back along the fan, which ends there: ray by ray,
/// each of a part of the interval. All ask for the same points of the lights, so that shadows have no
/// colours.
#[inline]
pub fn shade_fan(walk: &mut Walk<'_, Fan>, fan: &Fan, hit: &Hit) {
    let scene = walk.scene;
    let weight = parabola_through(fan.weight);
    let path_mm = parabola_through(fan.path_mm);
    let count = matte_ray_count(walk, fan);
    let place = rng::wavelength_sample(walk.pass_index);
    let step = 2.0 / count as f32;
    for i in 0..count {
        let low = i as f32 * step - 1.0;
        let high = low + step;
        let position = low + step * place;
        let mut ray = ray_in_fan(fan, position);
        ray.lambda_low_nm = wavelength_at(scene, axis_position_in(fan, low));
        ray.lambda_high_nm = wavelength_at(scene, axis_position_in(fan, high));
        let middle = parabola_at(&weight, 0.5 * (low + high));
        let ends = parabola_at(&weight, low) + parabola_at(&weight, high);
        ray.significance = ((4.0 * middle + ends) * (1.0 / 6.0)).max(0.0);
        ray.absorber = fan.absorber;
        ray.path_mm = parabola_at(&path_mm, position).max(0.0);
        walk.seed = fan.seed;
        shade_diffuse(walk, &ray, hit);
    }
    let energy = retire_fan(walk, fan);
    walk.tally.returned += energy;
}

/// Rays that a fan is divided into at a matte surface: one per bin where its wavelengths arrive apart,
/// else as many as its weight varies.
#[inline]
pub fn matte_ray_count(walk: &Walk<'_, Fan>, fan: &Fan) -> u32 {
    let scene = walk.scene;
    let width_nm = wavelength_at(scene, fan.axis.z) - wavelength_at(scene, fan.axis.x);
    // Rounding must not make one more of whole bins.
    let bins = (width_nm / scene.bins.width_nm() - 1e-3).ceil().max(1.0);
    if is_dispersed(fan) {
        return bins as u32;
    }
    let variation = (largest(fan.weight) - least_of(fan.weight)) / largest(fan.weight).max(1e-12);
    (variation / WEIGHT_TOLERANCE).ceil().clamp(1.0, bins) as u32
}
