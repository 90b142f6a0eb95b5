//! Walks with fans, and fans as they come about.

use brilliance_renderer::kernel::camera::{camera_ray, pixel_seed};
use brilliance_renderer::kernel::divide::can_only_meet_lights;
use brilliance_renderer::kernel::fan::{Fan, ray_in_fan, segment_count, white_fan};
use brilliance_renderer::kernel::fan_lights::end_at_lights;
use brilliance_renderer::kernel::fan_trace::{follow_fan, send_rest};
use brilliance_renderer::kernel::fan_walk::send_fan;
use brilliance_renderer::kernel::ray::{Hit, Ray};
use brilliance_renderer::kernel::reach::{arrive, reach};
use brilliance_renderer::kernel::trace::next_surface;
use brilliance_renderer::kernel::walk::{RayStack, Walk};
use brilliance_renderer::packed::NONE;

use super::{Dice, Put, Take, World};

/// Lets the fans that wait for nothing but the lights see them, as a device does at once with all.
pub(crate) fn see_lights(walk: &mut Walk<'_, Fan>) {
    let mut others = Vec::new();
    let mut leaves = Vec::new();
    while walk.has_rays() {
        let fan = walk.pop();
        let is_leaf = can_only_meet_lights(walk.scene, &fan);
        if is_leaf { leaves.push(fan) } else { others.push(fan) }
    }
    others.iter().rev().for_each(|fan| walk.push(fan));
    for fan in leaves {
        walk.tally.segments += segment_count(&fan);
        walk.tally.depth = walk.tally.depth.max(fan.depth);
        end_at_lights(walk, &fan);
    }
}

/// A fan, its middle ray, and the surface that this meets.
pub(crate) struct Meeting {
    pub(crate) fan: Fan,
    pub(crate) ray: Ray,
    pub(crate) hit: Hit,
}

impl World {
    /// A walk with fans that takes its seed and its pass, does `work` and puts what has come of it.
    pub(crate) fn fan_walk(
        &self,
        take: &mut Take<'_>,
        put: &mut Put,
        work: impl FnOnce(&mut Walk<'_, Fan>, &mut Take<'_>, &mut Put),
    ) {
        let (seed, pass_index) = (take.u32(), take.u32());
        self.begin_fan_walk(seed, pass_index, |walk| {
            work(walk, take, put);
            put.fan_walk(walk);
        });
    }

    /// What `work` makes of a walk with fans that has not begun.
    pub(crate) fn begin_fan_walk<T>(
        &self,
        seed: u32,
        pass_index: u32,
        work: impl FnOnce(&mut Walk<'_, Fan>) -> T,
    ) -> T {
        let mut stack = RayStack::of_fans();
        let mut radiance = vec![0.0; self.scene.bins.count()];
        let mut walk =
            Walk::new(&self.scene, &self.rules, pass_index, seed, &mut stack, &mut radiance);
        work(&mut walk)
    }

    /// Fans as they come about: descendants of camera rays, from all generations.
    pub(crate) fn fans(&self, count: usize) -> Vec<Fan> {
        let mut dice = Dice::new(11);
        let mut fans = Vec::with_capacity(count);
        // In some scenes most camera rays meet nothing.
        for _ in 0..20 * count {
            if fans.len() == count {
                break;
            }
            let [x, y] = self.size.map(|size| dice.below(size as usize) as u32);
            self.begin_fan_walk(pixel_seed(x, y), 0, |walk| {
                let ray = camera_ray(&self.camera, self.size, x, y, dice.word());
                send_fan(walk, white_fan(ray.origin, ray.direction, walk.seed));
                for _ in 0..dice.below(12) {
                    if walk.has_rays() {
                        follow_fan(walk);
                    }
                }
                if walk.has_rays() {
                    fans.push(walk.pop());
                }
            });
        }
        fans
    }

    /// What the fans meet, if it is nothing.
    pub(crate) fn meetings(&self, count: usize) -> Vec<Meeting> {
        let meeting = |fan: Fan| {
            let mut ray = ray_in_fan(&fan, 0.0);
            let hit = next_surface(&self.scene, &mut ray);
            Meeting { fan, ray, hit }
        };
        self.fans(count).into_iter().map(meeting).collect()
    }

    /// The fans that meet a surface, as far as they meet it and moved to there.
    pub(crate) fn arrivals(&self, count: usize) -> Vec<Meeting> {
        let arrival = |Meeting { mut fan, ray, hit }: Meeting| {
            let height = (ray.origin + ray.direction * hit.distance).dot(hit.normal);
            self.begin_fan_walk(0, 0, |walk| {
                let reached = reach(walk, &fan, &ray, &hit);
                send_rest(walk, &mut fan, reached);
            });
            arrive(&self.scene, &mut fan, &hit, height);
            Meeting { fan, ray, hit }
        };
        let meetings = self.meetings(count).into_iter();
        meetings.filter(|meeting| meeting.hit.instance != NONE).map(arrival).collect()
    }
}
