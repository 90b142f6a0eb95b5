//! What three wavelengths of a fan meet at an interface, and whether three are enough.

use glam::Vec3A;

use crate::kernel::axis::indices_at;
use crate::kernel::band::fan_energy;
use crate::kernel::fan::{Fan, axis_width, fan_through, position_of};
use crate::kernel::fan_walk::largest;
use crate::kernel::interface::Interface;
use crate::kernel::nodes::{basis_of, dot_each};
use crate::kernel::walk::Walk;
use crate::packed::PackedScene;

/// Difference of the squared cosines of refraction at the ends of a fan, over their sum, from which on
/// its middle node is drawn to the critical wavelength.
pub const DRAWING_CONTRAST: f32 = 0.4;

/// Energy in the wrong part, in units of the camera ray's, that is let be whatever the threshold: telling
/// less apart fills the stack with parts next to the critical wavelength.
pub const LEAST_MISJUDGED: f32 = 1e-6;

/// What three nodes of a fan meet at an interface.
#[derive(Clone, Copy, Debug)]
pub struct Crossing {
    /// Relative indices n₁/n₂.
    pub eta: Vec3A,
    /// Cosines of the angles of incidence.
    pub cos_i: Vec3A,
    /// Squared cosines of the angles of refraction; 0 or less beyond the critical angle.
    pub cos_t_squared: Vec3A,
}

/// What the nodes of a fan meet at an interface.
#[inline]
pub fn crossing_of(scene: &PackedScene, at: &Interface, fan: &Fan) -> Crossing {
    let eta =
        indices_at(scene, at.medium_from, fan.axis) / indices_at(scene, at.medium_to, fan.axis);
    let cos_i = -dot_each(&fan.direction, at.normal);
    let sin_i_squared = Vec3A::ONE - cos_i * cos_i;
    Crossing { eta, cos_i, cos_t_squared: Vec3A::ONE - eta * eta * sin_i_squared }
}

/// Unpolarised Fresnel reflectances at the nodes, as `fresnel` has them for one ray; 1 beyond the
/// critical angle.
#[inline]
pub fn reflectances(crossing: &Crossing) -> Vec3A {
    let (eta, cos_i) = (crossing.eta, crossing.cos_i.max(Vec3A::ZERO));
    let cos_t = crossing.cos_t_squared.max(Vec3A::ZERO).sqrt();
    // At the critical angle both amplitudes are 1 by themselves.
    let parallel = (cos_i - eta * cos_t) / (cos_i + eta * cos_t).max(Vec3A::splat(1e-12));
    let perpendicular = (eta * cos_i - cos_t) / (eta * cos_i + cos_t).max(Vec3A::splat(1e-12));
    let reflectance = (parallel * parallel + perpendicular * perpendicular) * 0.5;
    let is_total = crossing.cos_t_squared.cmple(Vec3A::ZERO);
    Vec3A::select(is_total, Vec3A::ONE, reflectance.clamp(Vec3A::ZERO, Vec3A::ONE))
}

/// Whether between the nodes the parabola through the reflectances puts more energy into the wrong part
/// than is worth telling apart.
#[inline]
pub fn is_misjudged(walk: &Walk<'_, Fan>, at: &Interface, fan: &Fan, reflectance: Vec3A) -> bool {
    let between = fan_through(fan, Vec3A::new(-0.5, 0.0, 0.5));
    let judged = basis_of(Vec3A::new(-0.5, 0.0, 0.5)) * reflectance;
    let missed = (reflectances(&crossing_of(walk.scene, at, &between)) - judged).abs();
    let energy = missed.x.max(missed.z) * largest(fan.weight) * axis_width(fan);
    energy > walk.rules.cut_threshold.max(LEAST_MISJUDGED)
}

/// The fan with its middle node so near to the critical wavelength that the cosine of refraction there
/// is about the mean of those at the ends, if that is elsewhere than it was: the cosine is the root of
/// what is linear along the axis, and with it go reflectance and direction.
#[inline]
pub fn drawn_to_critical(scene: &PackedScene, fan: &Fan, crossing: &Crossing) -> Option<Fan> {
    let low = crossing.cos_t_squared.x.max(0.0);
    let high = crossing.cos_t_squared.z.max(0.0);
    let difference = high - low;
    if difference.abs() <= DRAWING_CONTRAST * (high + low) {
        return None;
    }
    let mean = 0.5 * (low.sqrt() + high.sqrt());
    let share = (mean * mean - low) / difference;
    let middle = position_of(fan, fan.axis.x + share * axis_width(fan));
    let mut drawn = fan_through(fan, Vec3A::new(-1.0, middle, 1.0));
    // Another parabola through the weights has another integral; the ledger must not notice.
    let energy = fan_energy(scene, fan);
    let drawn_energy = fan_energy(scene, &drawn);
    if drawn_energy < 0.25 * energy || drawn_energy <= 0.0 {
        return None;
    }
    drawn.weight *= energy / drawn_energy;
    Some(drawn)
}
