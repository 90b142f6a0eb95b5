//! Snell and Fresnel for one wavelength (Born & Wolf, *Principles of Optics*, 7th ed., §1.5).

use glam::DVec3;

/// What an interface makes of a ray.
pub(crate) struct Interface {
    pub(crate) reflected: DVec3,
    pub(crate) refracted: DVec3,
    /// Reflectance of unpolarised light; 1 beyond the critical angle.
    pub(crate) reflectance: f64,
}

impl Interface {
    /// For unit vectors; `normal` stands on the side that the ray comes from.
    pub(crate) fn new(direction: DVec3, normal: DVec3, n_from: f64, n_to: f64) -> Self {
        let cos_i = -direction.dot(normal);
        let reflected = (direction + 2.0 * cos_i * normal).normalize();
        // Snell's law for the parts along the surface.
        let along = (direction + cos_i * normal) * (n_from / n_to);
        let cos_t_squared = 1.0 - along.length_squared();
        if cos_t_squared <= 0.0 {
            return Self { reflected, refracted: DVec3::ZERO, reflectance: 1.0 };
        }
        let cos_t = cos_t_squared.sqrt();
        let perpendicular = (n_from * cos_i - n_to * cos_t) / (n_from * cos_i + n_to * cos_t);
        let parallel = (n_to * cos_i - n_from * cos_t) / (n_to * cos_i + n_from * cos_t);
        Self {
            reflected,
            refracted: (along - cos_t * normal).normalize(),
            reflectance: 0.5 * (perpendicular * perpendicular + parallel * parallel),
        }
    }
}
