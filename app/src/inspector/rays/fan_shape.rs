//! Where the rays of a fan run, wavelength by wavelength.

use brilliance_renderer::inspect::RecordedRay;
use glam::Vec3;

/// The rays of all wavelengths of an interval: between its shortest, its central and its longest
/// wavelength all is a quadratic function of a position in −1..=1.
pub(super) struct FanShape {
    starts: [Vec3; 3],
    ends: [Vec3; 3],
    lambdas_nm: [f32; 3],
}

impl FanShape {
    /// The fan of a ray; one that meets no surface is `length_mm` long.
    pub(super) fn new(ray: &RecordedRay, length_mm: f32) -> Self {
        let [low, high] = ray.edges;
        let end = |start: Vec3, direction: Vec3, end: Option<Vec3>| {
            end.unwrap_or(start + direction * length_mm)
        };
        Self {
            starts: [low.origin_mm, ray.origin_mm, high.origin_mm],
            ends: [
                end(low.origin_mm, low.direction, low.end_mm),
                end(ray.origin_mm, ray.direction, ray.end_mm),
                end(high.origin_mm, high.direction, high.end_mm),
            ],
            lambdas_nm: [ray.lambda_low_nm, ray.central_nm, ray.lambda_high_nm],
        }
    }

    /// Start and end of one wavelength's ray.
    pub(super) fn ray_at(&self, position: f32) -> [Vec3; 2] {
        let weights = quadratic_weights(position);
        [self.starts, self.ends]
            .map(|[low, middle, high]| low * weights[0] + middle * weights[1] + high * weights[2])
    }

    /// The wavelength, in nm, of the ray at `position`.
    pub(super) fn lambda_nm_at(&self, position: f32) -> f32 {
        let weights = quadratic_weights(position);
        let lambda_nm: f32 = weights.iter().zip(&self.lambdas_nm).map(|(w, nm)| w * nm).sum();
        lambda_nm.clamp(self.lambdas_nm[0], self.lambdas_nm[2])
    }
}

/// How much the values at −1, 0 and 1 count at `position` in the quadratic function through them.
fn quadratic_weights(position: f32) -> [f32; 3] {
    let half = 0.5 * position;
    [half * (position - 1.0), 1.0 - position * position, half * (position + 1.0)]
}
