//! Fans and what they are made of, word by word.

use brilliance_renderer::kernel::fan::Fan;
use brilliance_renderer::kernel::nodes::Nodes;
use brilliance_renderer::kernel::parabola::Parabola;
use brilliance_renderer::kernel::walk::Walk;
use glam::Vec3A;

use super::{Case, Put, Take};

impl Case {
    pub(crate) fn vec2(self, [x, y]: [f32; 2]) -> Self {
        self.f32(x).f32(y)
    }

    /// A value at each node of a fan.
    pub(crate) fn each(self, values: Vec3A) -> Self {
        self.vec3(values.into())
    }

    pub(crate) fn nodes(self, nodes: &Nodes) -> Self {
        self.each(nodes.x).each(nodes.y).each(nodes.z)
    }

    pub(crate) fn parabola(self, parabola: &Parabola) -> Self {
        self.f32(parabola.a).f32(parabola.b).f32(parabola.c)
    }

    pub(crate) fn fan(self, fan: &Fan) -> Self {
        self.nodes(&fan.origin)
            .nodes(&fan.direction)
            .each(fan.weight)
            .each(fan.path_mm)
            .each(fan.axis)
            .u32(fan.instance)
            .u32(fan.facet)
            .u32(fan.medium)
            .u32(fan.enclosing)
            .u32(fan.depth)
            .u32(fan.absorber)
            .u32(fan.seed)
    }
}

impl Take<'_> {
    pub(crate) fn each(&mut self) -> Vec3A {
        self.vec3().into()
    }

    pub(crate) fn nodes(&mut self) -> Nodes {
        Nodes { x: self.each(), y: self.each(), z: self.each() }
    }

    pub(crate) fn parabola(&mut self) -> Parabola {
        Parabola { a: self.f32(), b: self.f32(), c: self.f32() }
    }

    pub(crate) fn fan(&mut self) -> Fan {
        // In the order of the words.
        Fan {
            origin: self.nodes(),
            direction: self.nodes(),
            weight: self.each(),
            path_mm: self.each(),
            axis: self.each(),
            instance: self.u32(),
            facet: self.u32(),
            medium: self.u32(),
            enclosing: self.u32(),
            depth: self.u32(),
            absorber: self.u32(),
            seed: self.u32(),
        }
    }
}

impl Put {
    /// A value at each node of a fan.
    pub(crate) fn each(&mut self, values: Vec3A) {
        self.vec3(values.into());
    }

    pub(crate) fn nodes(&mut self, nodes: &Nodes) {
        for values in [nodes.x, nodes.y, nodes.z] {
            self.each(values);
        }
    }

    pub(crate) fn parabola(&mut self, parabola: &Parabola) {
        for number in [parabola.a, parabola.b, parabola.c] {
            self.f32(number);
        }
    }

    pub(crate) fn fan(&mut self, fan: &Fan) {
        self.nodes(&fan.origin);
        self.nodes(&fan.direction);
        self.each(fan.weight);
        self.each(fan.path_mm);
        self.each(fan.axis);
        let Fan { instance, facet, medium, enclosing, depth, absorber, seed, .. } = *fan;
        for word in [instance, facet, medium, enclosing, depth, absorber, seed] {
            self.u32(word);
        }
    }

    /// The books, the radiance, and the fans that wait, the last one first.
    pub(crate) fn fan_walk(&mut self, walk: &mut Walk<'_, Fan>) {
        self.books(walk);
        self.u32(walk.waiting());
        while walk.has_rays() {
            self.fan(&walk.pop());
        }
    }
}
