//! What ends a ray, read with the kernel's own functions.

use serde::Serialize;

use super::branch::{Branch, Meeting};
use super::names::{Name, Names, Surface};
use super::received::{ReceivedLight, received_lights};
use super::tree::RayKind;
use crate::kernel::fork::interface_at;
use crate::kernel::interface::{
    cos_refracted_squared, fresnel, index_of_refraction, relative_index,
};
use crate::kernel::ray::{Hit, Ray};
use crate::kernel::trace::{is_lost, meets_opaque};
use crate::kernel::walk::TraceRules;
use crate::packed::{NONE, PackedScene};

/// What a ray came to.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum RayEnd {
    /// A smooth interface, where it became other rays.
    Interface(InterfaceEvent),
    /// Lights, which its fan covers at least in part.
    Lights {
        /// The lights, lamps first.
        lights: Vec<SeenLight>,
        /// The part of the fan, in 0..=1, that the observer's shadow takes from the sky.
        observer_shadow: f32,
    },
    /// The backdrop, which only a camera ray sees.
    Backdrop,
    /// No surface and no light.
    Dark {
        /// The part of the fan, in 0..=1, that the observer's shadow takes from the sky.
        observer_shadow: f32,
    },
    /// A matte surface, which shows how it is lit.
    Matte {
        /// Where.
        surface: Surface,
        /// How it is lit, lamps first.
        lights: Vec<ReceivedLight>,
    },
    /// It was too weak to be followed.
    Pruned,
    /// It was strong enough to be followed, but for a limit.
    CutOff {
        /// Which.
        limit: Limit,
    },
    /// It slipped through a mesh.
    Lost,
}

/// What cuts off a ray that is not weak.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Limit {
    /// The number of interfaces (`trace.max_depth`).
    Depth,
    /// The number of rays that can wait.
    Stack,
}

/// A ray's meeting with an interface. Angles, indices and coefficients are those of its central
/// wavelength.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct InterfaceEvent {
    /// Where.
    pub surface: Surface,
    /// Angle of incidence in degrees, 0..=90.
    pub incidence_degrees: f32,
    /// Angle of refraction in degrees; none beyond the critical angle.
    pub refraction_degrees: Option<f32>,
    /// Index of refraction of the medium that the ray comes from.
    pub n_before: f32,
    /// Index of refraction of the medium beyond.
    pub n_after: f32,
    /// Fresnel reflectance for unpolarised light, 0..=1; 1 beyond the critical angle.
    pub reflectance: f32,
    /// 1 − reflectance.
    pub transmittance: f32,
    /// Parts that the interface divides into what it does not reflect totally; 0 where it does so with
    /// all.
    pub subrays: u32,
    /// The wavelength in nm that divides total reflection from refraction, where that lies within
    /// the ray's interval; of two the shorter.
    pub dividing_nm: Option<f32>,
}

/// The kinds of light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LightKind {
    /// A disc.
    Lamp,
    /// The hemispherical light.
    Hemisphere,
    /// The light from everywhere.
    Environment,
}

/// A light that a ray sees.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SeenLight {
    /// What it is.
    pub light: LightKind,
    /// The lamp's name.
    pub name: Name,
    /// The part of the ray's fan, in 0..=1, that the light fills.
    pub overlap: f32,
    /// Where in the ray's interval the light is seen: from which wavelength to which, in nm. Empty by
    /// the paper's splitting, which adds the light evenly to the whole interval.
    pub bands_nm: Vec<[f32; 2]>,
}

/// One of those that came of what met an interface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Offspring {
    pub(super) kind: RayKind,
    pub(super) lambda_low_nm: f32,
    pub(super) lambda_high_nm: f32,
}

/// What `meeting` is; `offspring` is what came of it.
pub(super) fn read_end<B: Branch>(
    scene: &PackedScene,
    rules: &TraceRules,
    names: &mut Names,
    meeting: &Meeting<B>,
    offspring: &[Offspring],
) -> RayEnd {
    let Meeting { hit, ray, .. } = meeting;
    if is_lost(ray, hit) {
        return RayEnd::Lost;
    }
    let Some(surface) = names.surface(hit.instance, hit.facet) else {
        if ray.depth == 0 && scene.sky.backdrop != NONE {
            return RayEnd::Backdrop;
        }
        return meeting.part.sky_view(scene, rules, names).into_end();
    };
    if meets_opaque(scene, hit) {
        return RayEnd::Matte { surface, lights: received_lights(scene, rules, names, ray, hit) };
    }
    let central_nm = meeting.part.start(scene).central_nm;
    RayEnd::Interface(read_interface(scene, surface, ray, hit, central_nm, offspring))
}

fn read_interface(
    scene: &PackedScene,
    surface: Surface,
    ray: &Ray,
    hit: &Hit,
    central_nm: f32,
    offspring: &[Offspring],
) -> InterfaceEvent {
    let at = interface_at(scene, ray, hit);
    let eta = relative_index(scene, &at, central_nm);
    let cos_i = (-ray.direction.dot(at.normal)).clamp(0.0, 1.0);
    let cos_t_squared = cos_refracted_squared(cos_i, eta);
    let is_refracted = cos_i > 0.0 && cos_t_squared > 0.0;
    let cos_t = cos_t_squared.max(0.0).sqrt();
    let reflectance = if is_refracted { fresnel(cos_i, cos_t, eta) } else { 1.0 };
    let total = offspring.iter().find(|child| child.kind == RayKind::TotallyReflected);
    let dividing_nm = total.and_then(|total| {
        if total.lambda_high_nm < ray.lambda_high_nm {
            Some(total.lambda_high_nm)
        } else if total.lambda_low_nm > ray.lambda_low_nm {
            Some(total.lambda_low_nm)
        } else {
            None
        }
    });
    let subrays = offspring.iter().filter(|child| child.kind == RayKind::Refracted).count() as u32;
    InterfaceEvent {
        surface,
        incidence_degrees: cos_i.acos().to_degrees(),
        refraction_degrees: is_refracted.then(|| cos_t.min(1.0).acos().to_degrees()),
        n_before: index_of_refraction(scene, at.medium_from, central_nm),
        n_after: index_of_refraction(scene, at.medium_to, central_nm),
        reflectance,
        transmittance: 1.0 - reflectance,
        subrays,
        dividing_nm,
    }
}
