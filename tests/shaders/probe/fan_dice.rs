//! Random fans.

use brilliance_renderer::kernel::fan::{Fan, white_fan};
use brilliance_renderer::kernel::nodes::{Nodes, nodes_of};
use glam::{Vec3, Vec3A};

use super::Dice;

impl Dice {
    /// Numbers for the three nodes.
    pub(crate) fn each(&mut self, low: f32, high: f32) -> Vec3A {
        Vec3A::new(self.between(low, high), self.between(low, high), self.between(low, high))
    }

    /// Points up to `reach` from the origin.
    pub(crate) fn nodes(&mut self, reach: f32) -> Nodes {
        nodes_of(self.point(reach), self.point(reach), self.point(reach))
    }

    /// A position in a fan: one in four at a node.
    pub(crate) fn position(&mut self) -> f32 {
        let any = self.between(-1.0, 1.0);
        match self.below(4) {
            0 => self.pick(&[-1.0, 0.0, 1.0]),
            _ => any,
        }
    }

    /// A part of a fan: one in eight the whole, one in eight without width.
    pub(crate) fn part(&mut self) -> [f32; 2] {
        let (a, b) = (self.position(), self.position());
        match self.below(8) {
            0 => [-1.0, 1.0],
            1 => [a, a],
            _ => [a.min(b), a.max(b)],
        }
    }

    /// A fan in air from near the origin, of any interval, one in eight of one direction.
    pub(crate) fn fan(&mut self) -> Fan {
        let (origin, direction) = (self.point(10.0), self.direction());
        let spread = match self.below(8) {
            0 => Vec3::ZERO,
            _ => self.spread(direction, 1e-6, 0.1),
        };
        let bend = self.point(0.2) * spread.length();
        let [low, middle, high] = [bend - spread, Vec3::ZERO, bend + spread]
            .map(|apart| (direction + apart).normalize_or_zero());
        let [low_origin, high_origin] = [-2.0, 3.0].map(|along| origin + spread * along);
        let [low_end, high_end] = self.part().map(|position| 0.5 + 0.5 * position);
        // The middle node may have been drawn to either end.
        let drawn = self.pick(&[0.5, 0.5, 0.3, 0.7]);
        let strong = self.magnitude(1e-4, 1.0);
        let weight = Vec3A::new(strong, self.between(0.0, 1.0), self.pick(&[0.0, strong]));
        Fan {
            origin: nodes_of(low_origin, origin, high_origin),
            direction: nodes_of(low, middle, high),
            weight,
            path_mm: self.each(0.0, 5.0),
            axis: Vec3A::new(low_end, low_end + (high_end - low_end) * drawn, high_end),
            depth: self.pick(&[0, 1, 5]),
            ..white_fan(origin, direction, self.word())
        }
    }
}
