//! The rays of the paper, as the record sees them.

use super::branch::{Branch, Meeting, Sent, SkyView, Start, observer_cone};
use super::end::{LightKind, SeenLight};
use super::names::Names;
use super::tree::{RayEdge, RayKind};
use crate::kernel::lights::{Cone, disc_cone, is_far_off, overlap_amount, overlap_hemisphere};
use crate::kernel::ray::Ray;
use crate::kernel::spread::fan_at;
use crate::kernel::trace::{follow, next_surface};
use crate::kernel::walk::{Fate, RayStack, TraceRules, Walk, fate_of};
use crate::packed::{NONE, PackedScene};

impl Branch for Ray {
    fn stack() -> RayStack {
        RayStack::new()
    }

    fn of_camera_ray(camera_ray: &Ray, _: u32) -> Self {
        *camera_ray
    }

    fn send(&mut self, _: RayKind, walk: &mut Walk<'_>) -> Sent {
        let fate = fate_of(walk.scene, walk.rules, self, walk.waiting());
        walk.send(self);
        if fate == Fate::Kept { Sent::Waits } else { Sent::Ends(fate) }
    }

    fn follow(walk: &mut Walk<'_>) {
        follow(walk);
    }

    fn start(&self, _: &PackedScene) -> Start {
        let edge = |lambda_nm| RayEdge {
            origin_mm: self.origin,
            end_mm: None,
            direction: fan_at(self, lambda_nm).normalize_or_zero(),
        };
        Start {
            depth: self.depth,
            instance: self.instance,
            facet: self.facet,
            medium: self.medium,
            origin_mm: self.origin,
            direction: self.direction,
            spread: self.spread,
            edges: [edge(self.lambda_low_nm), edge(self.lambda_high_nm)],
            lambda_low_nm: self.lambda_low_nm,
            lambda_high_nm: self.lambda_high_nm,
            central_nm: 0.5 * (self.lambda_low_nm + self.lambda_high_nm),
            significance: self.significance,
            energy: self.significance * self.bandwidth(),
        }
    }

    fn meet(&self, walk: &mut Walk<'_>) -> Meeting<Self> {
        let mut ray = *self;
        let hit = next_surface(walk.scene, &mut ray);
        let start = ray.origin;
        let path_mm = if hit.instance == NONE { 0.0 } else { hit.distance };
        ray.origin += ray.direction * path_mm;
        let edge_ends_mm =
            [-1.0, 1.0].map(|position| start + (ray.direction + ray.spread * position) * path_mm);
        Meeting { part: *self, hit, ray, path_mm, edge_ends_mm }
    }

    /// What the kernel's `ray_light` shows the ray.
    fn sky_view(&self, scene: &PackedScene, rules: &TraceRules, names: &Names) -> SkyView {
        let sky = &scene.sky;
        let part_of = |cone: &Cone| {
            let is_missed = is_far_off(self, self.spread.length(), cone);
            if is_missed { 0.0 } else { overlap_amount(self, cone) }
        };
        let mut observer_shadow = 0.0;
        if sky.sin_squared_observer_shadow > 0.0 {
            observer_shadow = part_of(&observer_cone(scene, rules));
        }
        let visible = 1.0 - observer_shadow;
        let seen = |light, name, overlap| SeenLight { light, name, overlap, bands_nm: Vec::new() };
        let lamps = scene.discs.iter().enumerate().map(|(number, disc)| {
            seen(LightKind::Lamp, names.lamp(number), part_of(&disc_cone(disc)))
        });
        let environment = (sky.environment != NONE)
            .then(|| seen(LightKind::Environment, names.environment.clone(), visible));
        let hemisphere = (sky.hemisphere != NONE).then(|| {
            let overlap = visible * overlap_hemisphere(self);
            seen(LightKind::Hemisphere, names.hemisphere.clone(), overlap)
        });
        let all = lamps.chain(environment).chain(hemisphere);
        SkyView { lights: all.filter(|seen| seen.overlap > 0.0).collect(), observer_shadow }
    }

    /// What is totally reflected is sent first, and alone keeps all of its significance.
    fn kinds(&self, children: &[Self]) -> Vec<RayKind> {
        let kind = |(number, child): (usize, &Self)| {
            if child.medium != self.medium {
                RayKind::Refracted
            } else if number == 0 && child.significance == self.significance {
                RayKind::TotallyReflected
            } else {
                RayKind::Reflected
            }
        };
        children.iter().enumerate().map(kind).collect()
    }
}
