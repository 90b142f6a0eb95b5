//! The light that falls on a matte surface, asked for with the kernel's own functions.

use std::f32::consts::PI;

use glam::Vec3;
use serde::Serialize;

use super::end::LightKind;
use super::names::{Name, Names};
use crate::kernel::deposit::{Reflectance, deposit};
use crate::kernel::diffuse::{direction_by_cosine, direction_on_disc, is_shadowed};
use crate::kernel::passage::shine_through;
use crate::kernel::ray::{Hit, Ray};
use crate::kernel::rng::light_sample;
use crate::kernel::walk::{RayStack, TraceRules, Walk};
use crate::packed::{NONE, PackedDisc, PackedScene};

/// Points of a light that are asked for. The picture asks for one in each pass.
const LAMP_SAMPLES: u32 = 4;
const SKY_SAMPLES: u32 = 16;

/// What a matte surface receives of one light.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReceivedLight {
    /// What it is.
    pub light: LightKind,
    /// Its name.
    pub name: Name,
    /// The part of the light, in 0..=1, that reaches the surface in straight lines, by a few samples;
    /// of the sky as it counts for the surface, by the cosine.
    pub visible: f32,
    /// What reaches the surface through clear bodies, as a part of what the light throws on a surface
    /// that faces it.
    pub through_bodies: f32,
}

/// What the surface at `hit` receives of each light.
pub(super) fn received_lights(
    scene: &PackedScene,
    rules: &TraceRules,
    names: &Names,
    ray: &Ray,
    hit: &Hit,
) -> Vec<ReceivedLight> {
    let (mut stack, mut radiance) = (RayStack::new(), vec![0.0; scene.bins.count()]);
    let mut surface =
        Lit { ray, hit, walk: Walk::new(scene, rules, 0, 0, &mut stack, &mut radiance) };
    let lamps = scene.discs.iter().enumerate().map(|(number, disc)| ReceivedLight {
        light: LightKind::Lamp,
        name: names.lamp(number),
        visible: surface.visible_of_lamp(number as u32, disc),
        through_bodies: surface.through_bodies(number as u32, disc),
    });
    let mut lights: Vec<_> = lamps.collect();
    let sky = &scene.sky;
    for (row, light, name) in [
        (sky.environment, LightKind::Environment, &names.environment),
        (sky.hemisphere, LightKind::Hemisphere, &names.hemisphere),
    ] {
        if row != NONE {
            let visible = surface.visible_of_sky(light);
            lights.push(ReceivedLight { light, name: name.clone(), visible, through_bodies: 0.0 });
        }
    }
    lights
}

/// A place on a matte surface that a ray came to.
struct Lit<'a> {
    ray: &'a Ray,
    hit: &'a Hit,
    walk: Walk<'a>,
}

impl Lit<'_> {
    /// The surface's normal on the side that the ray came from.
    fn normal(&self) -> Vec3 {
        let normal = self.hit.normal;
        if self.ray.direction.dot(normal) > 0.0 { -normal } else { normal }
    }

    fn is_reached(&mut self, direction: Vec3) -> bool {
        direction.dot(self.normal()) > 0.0
            && !is_shadowed(&mut self.walk, self.ray, self.hit, direction)
    }

    fn visible_of_lamp(&mut self, number: u32, disc: &PackedDisc) -> f32 {
        let reached = (0..LAMP_SAMPLES)
            .filter(|&pass| self.is_reached(direction_on_disc(disc, light_sample(number, pass))));
        reached.count() as f32 / LAMP_SAMPLES as f32
    }

    fn visible_of_sky(&mut self, light: LightKind) -> f32 {
        let seed = self.walk.scene.discs.len() as u32;
        let reached = (0..SKY_SAMPLES).filter(|&pass| {
            let direction = direction_by_cosine(self.normal(), light_sample(seed, pass));
            // The hemisphere is above the horizon only.
            (light == LightKind::Environment || direction.z > 0.0) && self.is_reached(direction)
        });
        reached.count() as f32 / SKY_SAMPLES as f32
    }

    fn through_bodies(&mut self, number: u32, disc: &PackedDisc) -> f32 {
        // White light that has nothing behind it yet, on a surface that sends back all.
        let mut white = Ray::white(self.ray.origin, self.ray.direction);
        (white.lambda_low_nm, white.lambda_high_nm) =
            (self.ray.lambda_low_nm, self.ray.lambda_high_nm);
        let (normal, whole) = (self.normal(), Reflectance::WHOLE);
        self.walk.radiance.fill(0.0);
        for pass in 0..LAMP_SAMPLES {
            self.walk.pass_index = pass;
            let direction = direction_on_disc(disc, light_sample(number, pass));
            shine_through(&mut self.walk, &white, self.hit, normal, number, direction, &whole);
        }
        let through: f32 = self.walk.radiance.iter().sum();
        if through == 0.0 {
            return 0.0;
        }
        self.walk.radiance.fill(0.0);
        let scale = LAMP_SAMPLES as f32 * disc.solid_angle / PI;
        deposit(&mut self.walk, &white, disc.spectrum, &whole, scale);
        through / self.walk.radiance.iter().sum::<f32>()
    }
}
