//! What a walk follows, a ray of the paper or a fan, as the record sees both.

use glam::Vec3;

use super::end::{RayEnd, SeenLight};
use super::names::Names;
use super::tree::{RayEdge, RayKind};
use crate::kernel::lights::Cone;
use crate::kernel::ray::{Hit, Ray};
use crate::kernel::walk::{Fate, RayStack, TraceRules, Walk};
use crate::packed::PackedScene;

/// A ray of the paper or a fan. Whatever comes of it is asked of the kernel.
pub(super) trait Branch: Copy {
    /// A stack for a walk.
    fn stack() -> RayStack<Self>;

    /// What the walk of a camera ray begins with; `seed` is the pixel's own random word.
    fn of_camera_ray(camera_ray: &Ray, seed: u32) -> Self;

    /// Sends it on in a walk as the picture's walk does. From then on it carries what it carries where
    /// it goes on.
    fn send(&mut self, kind: RayKind, walk: &mut Walk<'_, Self>) -> Sent;

    /// Follows what waits next in a walk.
    fn follow(walk: &mut Walk<'_, Self>);

    /// What is known of it before it is followed.
    fn start(&self, scene: &PackedScene) -> Start;

    /// What it meets, and how far about its middle. Makes use of `walk`.
    fn meet(&self, walk: &mut Walk<'_, Self>) -> Meeting<Self>;

    /// What it sees where it meets nothing.
    fn sky_view(&self, scene: &PackedScene, rules: &TraceRules, names: &Names) -> SkyView;

    /// How those that an interface has made of it came to be.
    fn kinds(&self, children: &[Self]) -> Vec<RayKind>;
}

/// What becomes of a branch that is sent on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sent {
    /// It waits to be followed.
    Waits,
    /// It can only meet lights, and has.
    HasSeenLights,
    /// It goes into the books.
    Ends(Fate),
}

/// Where a branch starts, and what it carries.
#[derive(Clone, Copy, Debug)]
pub(super) struct Start {
    /// Interfaces met so far.
    pub(super) depth: u32,
    /// The surface that it leaves and the body that it runs in, as rays name them.
    pub(super) instance: u32,
    pub(super) facet: u32,
    pub(super) medium: u32,
    pub(super) origin_mm: Vec3,
    pub(super) direction: Vec3,
    pub(super) spread: Vec3,
    pub(super) edges: [RayEdge; 2],
    pub(super) lambda_low_nm: f32,
    pub(super) lambda_high_nm: f32,
    pub(super) central_nm: f32,
    pub(super) significance: f32,
    pub(super) energy: f32,
}

/// A branch and what it meets.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meeting<B> {
    /// The part of it that meets that.
    pub(super) part: B,
    /// What is met.
    pub(super) hit: Hit,
    /// The part's middle ray, moved to the surface if there is one. It carries the whole interval.
    pub(super) ray: Ray,
    /// How far the surface is along that ray; 0 if there is none.
    pub(super) path_mm: f32,
    /// Where the part's shortest and its longest wavelength meet the surface.
    pub(super) edge_ends_mm: [Vec3; 2],
}

/// What is seen beyond all surfaces.
#[derive(Debug)]
pub(super) struct SkyView {
    /// Lights, lamps first.
    pub(super) lights: Vec<SeenLight>,
    /// The part, in 0..=1, that the observer's shadow takes from the sky.
    pub(super) observer_shadow: f32,
}

impl SkyView {
    /// What that means for who sees it.
    pub(super) fn into_end(self) -> RayEnd {
        let Self { lights, observer_shadow } = self;
        if lights.is_empty() {
            RayEnd::Dark { observer_shadow }
        } else {
            RayEnd::Lights { lights, observer_shadow }
        }
    }
}

/// The cone that the observer hides from the sky.
pub(super) fn observer_cone(scene: &PackedScene, rules: &TraceRules) -> Cone {
    Cone {
        center: rules.observer,
        cos_radius: scene.sky.cos_observer_shadow,
        sin_squared_radius: scene.sky.sin_squared_observer_shadow,
    }
}
