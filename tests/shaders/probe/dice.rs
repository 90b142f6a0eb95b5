//! Random inputs from a fixed seed.

use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::kernel::rng::{hash, unit_float};
use glam::Vec3;

/// Throws the same numbers in every run.
pub(crate) struct Dice(u32);

impl Dice {
    pub(crate) fn new(seed: u32) -> Self {
        Self(hash(seed))
    }

    pub(crate) fn word(&mut self) -> u32 {
        self.0 = self.0.wrapping_add(1);
        hash(self.0)
    }

    pub(crate) fn below(&mut self, count: usize) -> usize {
        self.word() as usize % count
    }

    pub(crate) fn pick<T: Copy>(&mut self, choice: &[T]) -> T {
        choice[self.below(choice.len())]
    }

    pub(crate) fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * unit_float(self.word())
    }

    /// As many small numbers as large ones.
    pub(crate) fn magnitude(&mut self, low: f32, high: f32) -> f32 {
        self.between(low.ln(), high.ln()).exp()
    }

    pub(crate) fn wavelength_nm(&mut self) -> f32 {
        self.between(380.0, 730.0)
    }

    pub(crate) fn point(&mut self, reach: f32) -> Vec3 {
        Vec3::new(
            self.between(-reach, reach),
            self.between(-reach, reach),
            self.between(-reach, reach),
        )
    }

    pub(crate) fn direction(&mut self) -> Vec3 {
        loop {
            let direction = self.point(1.0);
            if (0.01..1.0).contains(&direction.length_squared()) {
                return direction.normalize_or_zero();
            }
        }
    }

    /// A direction at the angle whose cosine is `cos` to the unit vector `axis`.
    pub(crate) fn direction_at(&mut self, axis: Vec3, cos: f32) -> Vec3 {
        let sideways = axis.cross(self.direction()).normalize_or(axis.any_orthonormal_vector());
        (axis * cos + sideways * (1.0 - cos * cos).max(0.0).sqrt()).normalize_or_zero()
    }

    /// An interval of wavelengths: of any width, one in eight of none.
    pub(crate) fn interval_nm(&mut self) -> [f32; 2] {
        let (a, b) = (self.wavelength_nm(), self.wavelength_nm());
        match self.below(8) {
            0 => [self.pick(&[a, a, 380.0, 730.0]); 2],
            1 => [380.0, 730.0],
            2 => [380.0, b],
            3 => [a, 730.0],
            _ => [a.min(b), a.max(b)],
        }
    }

    /// A spread of a length between `least` and `most`, not quite at a right angle to `direction`.
    pub(crate) fn spread(&mut self, direction: Vec3, least: f32, most: f32) -> Vec3 {
        let sideways = self.direction_at(direction, 0.1);
        sideways * self.magnitude(least, most)
    }

    /// A ray in air from near the origin, of any interval, one in eight without spread.
    pub(crate) fn ray(&mut self) -> Ray {
        let [lambda_low_nm, lambda_high_nm] = self.interval_nm();
        let direction = self.direction();
        let spread = match self.below(8) {
            0 => Vec3::ZERO,
            _ => self.spread(direction, 1e-6, 0.3),
        };
        Ray {
            lambda_low_nm,
            lambda_high_nm,
            spread,
            significance: self.magnitude(1e-4, 1.0),
            ..Ray::white(self.point(10.0), direction)
        }
    }
}

/// `count` cases, thrown.
pub(crate) fn throw(
    count: usize,
    mut case: impl FnMut(&mut Dice) -> super::Case,
) -> Vec<super::Case> {
    let mut dice = Dice::new(count as u32);
    (0..count).map(|_| case(&mut dice)).collect()
}
