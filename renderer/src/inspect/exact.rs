//! The fans of exact splitting, as the record sees them.

use glam::Vec3;

use super::branch::{Branch, Meeting, Sent, SkyView, Start, observer_cone};
use super::end::{LightKind, SeenLight};
use super::names::{Name, Names};
use super::tree::{RayEdge, RayKind};
use crate::kernel::axis::wavelength_at;
use crate::kernel::band::fan_energy;
use crate::kernel::divide::{LEAF_SHARE, can_only_meet_lights};
use crate::kernel::fan::{Fan, axis_position_in, ray_in_fan, white_fan};
use crate::kernel::fan_lights::{end_at_lights, is_fan_far_off, part_in_cone};
use crate::kernel::fan_trace::{follow_fan, send_rest};
use crate::kernel::fan_walk::fate_of_fan;
use crate::kernel::lights::{Cone, disc_cone};
use crate::kernel::nodes::{Nodes, high_node, low_node, middle_node};
use crate::kernel::parabola::{crossings, parabola_at, parabola_through};
use crate::kernel::ray::Ray;
use crate::kernel::reach::{arrive, reach};
use crate::kernel::spread::spread_between;
use crate::kernel::trace::next_surface;
use crate::kernel::walk::{Fate, RayStack, TraceRules, Walk};
use crate::packed::{NONE, PackedScene};

/// The whole of a fan, from its shortest wavelength to its longest, as positions in it.
const WHOLE: [f32; 2] = [-1.0, 1.0];

impl Branch for Fan {
    fn stack() -> RayStack<Self> {
        RayStack::of_fans()
    }

    fn of_camera_ray(camera_ray: &Ray, seed: u32) -> Self {
        white_fan(camera_ray.origin, camera_ray.direction, seed)
    }

    /// As `send_fan`, and with what is refracted as `send_refracted`.
    fn send(&mut self, kind: RayKind, walk: &mut Walk<'_, Self>) -> Sent {
        let is_leaf = kind == RayKind::Refracted && can_only_meet_lights(walk.scene, self);
        let share = if is_leaf { LEAF_SHARE } else { 1.0 };
        match fate_of_fan(walk, self, share * walk.rules.significance_threshold) {
            Fate::Kept if is_leaf => {
                end_at_lights(walk, self);
                Sent::HasSeenLights
            }
            Fate::Kept => {
                walk.push(self);
                Sent::Waits
            }
            fate => Sent::Ends(fate),
        }
    }

    fn follow(walk: &mut Walk<'_, Self>) {
        follow_fan(walk);
    }

    fn start(&self, scene: &PackedScene) -> Start {
        let [low, high] = ends_of(&self.direction);
        let [low_origin, high_origin] = ends_of(&self.origin);
        let edge = |origin_mm, direction| RayEdge { origin_mm, end_mm: None, direction };
        Start {
            depth: self.depth,
            instance: self.instance,
            facet: self.facet,
            medium: self.medium,
            origin_mm: middle_node(&self.origin),
            direction: middle_node(&self.direction),
            spread: spread_between(low, high),
            edges: [edge(low_origin, low), edge(high_origin, high)],
            lambda_low_nm: wavelength_at(scene, self.axis.x),
            lambda_high_nm: wavelength_at(scene, self.axis.z),
            central_nm: wavelength_at(scene, self.axis.y),
            significance: self.weight.y,
            energy: fan_energy(scene, self),
        }
    }

    fn meet(&self, walk: &mut Walk<'_, Self>) -> Meeting<Self> {
        let scene = walk.scene;
        let mut middle = ray_in_fan(self, 0.0);
        let hit = next_surface(scene, &mut middle);
        let reached = reach(walk, self, &middle, &hit);
        let mut part = *self;
        send_rest(walk, &mut part, reached);
        let mut arrived = part;
        if hit.instance != NONE {
            let height = (middle.origin + middle.direction * hit.distance).dot(hit.normal);
            arrive(scene, &mut arrived, &hit, height);
        }
        let mut ray = ray_in_fan(&arrived, 0.0);
        let path_mm = (ray.origin - middle_node(&part.origin)).length();
        ray.lambda_low_nm = wavelength_at(scene, part.axis.x);
        ray.lambda_high_nm = wavelength_at(scene, part.axis.z);
        Meeting { part, hit, ray, path_mm, edge_ends_mm: ends_of(&arrived.origin) }
    }

    /// What the kernel's `fan_light` shows the fan.
    fn sky_view(&self, scene: &PackedScene, rules: &TraceRules, names: &Names) -> SkyView {
        let sky = &scene.sky;
        let part_of = |cone: &Cone| {
            let is_missed = is_fan_far_off(self, cone);
            if is_missed { [1.0, 1.0] } else { part_in_cone(self, cone) }
        };
        let mut shadow = [1.0, 1.0];
        if sky.sin_squared_observer_shadow > 0.0 {
            shadow = part_of(&observer_cone(scene, rules));
        }
        let mut lights = Vec::new();
        let mut see = |light, name: &Name, parts: &[[f32; 2]]| {
            let bands_nm = bands(scene, self, parts);
            let overlap = share(scene, self, &bands_nm);
            if overlap > 0.0 {
                lights.push(SeenLight { light, name: name.clone(), overlap, bands_nm });
            }
        };
        for (number, disc) in scene.discs.iter().enumerate() {
            see(LightKind::Lamp, &names.lamp(number), &[part_of(&disc_cone(disc))]);
        }
        if sky.environment != NONE {
            see(LightKind::Environment, &names.environment, &beside(WHOLE, shadow));
        }
        if sky.hemisphere != NONE {
            let parts = above_horizon(self).into_iter().flat_map(|part| beside(part, shadow));
            see(LightKind::Hemisphere, &names.hemisphere, &parts.collect::<Vec<_>>());
        }
        let observer_shadow = share(scene, self, &bands(scene, self, &[shadow]));
        SkyView { lights, observer_shadow }
    }

    /// What is reflected without that anything of its middle wavelength is refracted is so totally.
    fn kinds(&self, children: &[Self]) -> Vec<RayKind> {
        let is_refracted = |fan: &&Self| fan.medium != self.medium;
        let kind = |child: &Self| {
            let has_middle = |other: &Self| (other.axis.x..=other.axis.z).contains(&child.axis.y);
            if is_refracted(&child) {
                RayKind::Refracted
            } else if children.iter().filter(is_refracted).any(has_middle) {
                RayKind::Reflected
            } else {
                RayKind::TotallyReflected
            }
        };
        children.iter().map(kind).collect()
    }
}

/// The vectors of the shortest and of the longest wavelength.
fn ends_of(nodes: &Nodes) -> [Vec3; 2] {
    [low_node(nodes), high_node(nodes)]
}

/// What of a part is outside of the shadow, below it and above.
fn beside(part: [f32; 2], shadow: [f32; 2]) -> [[f32; 2]; 2] {
    [[part[0], part[1].min(shadow[0])], [part[0].max(shadow[1]), part[1]]]
}

/// The parts of a fan that point into the upper half space.
fn above_horizon(fan: &Fan) -> Vec<[f32; 2]> {
    let height = parabola_through(fan.direction.z);
    let [first, second] = crossings(&height);
    let parts = [[-1.0, first], [first, second], [second, 1.0]];
    let is_above = |part: &[f32; 2]| parabola_at(&height, 0.5 * (part[0] + part[1])) > 0.0;
    parts.into_iter().filter(is_above).collect()
}

/// The wavelengths, in nm, of those of the parts that have a width; neighbours are joined.
fn bands(scene: &PackedScene, fan: &Fan, parts: &[[f32; 2]]) -> Vec<[f32; 2]> {
    let mut bands: Vec<[f32; 2]> = Vec::new();
    // The fan's own ends as they are, without the rounding of positions.
    let at = |position: f32| match position {
        -1.0 => fan.axis.x,
        1.0 => fan.axis.z,
        _ => axis_position_in(fan, position),
    };
    for part in parts.iter().filter(|part| part[0] < part[1]) {
        let [low, high] = part.map(|position| wavelength_at(scene, at(position)));
        match bands.last_mut() {
            Some(last) if last[1] >= low => last[1] = high,
            _ => bands.push([low, high]),
        }
    }
    bands
}

/// The part of a fan's interval that the bands are, 0..=1.
fn share(scene: &PackedScene, fan: &Fan, bands_nm: &[[f32; 2]]) -> f32 {
    if bands_nm.is_empty() {
        return 0.0;
    }
    let width_nm = wavelength_at(scene, fan.axis.z) - wavelength_at(scene, fan.axis.x);
    let covered_nm: f32 = bands_nm.iter().map(|[low, high]| high - low).sum();
    if width_nm > 0.0 { (covered_nm / width_nm).min(1.0) } else { 0.0 }
}
