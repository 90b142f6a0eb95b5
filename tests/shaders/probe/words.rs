//! The words that go into a probe, and the values that come out.

use std::fmt::{Display, Formatter, Result as FormatResult};

use brilliance_renderer::kernel::deposit::Reflectance;
use brilliance_renderer::kernel::interface::Interface;
use brilliance_renderer::kernel::lights::Cone;
use brilliance_renderer::kernel::mesh::Sides;
use brilliance_renderer::kernel::ray::{GROUND, Hit, Ray};
use brilliance_renderer::kernel::walk::Walk;
use brilliance_renderer::packed::{NONE, PackedMaterial};
use glam::{Vec3, Vec4};

use super::tolerance::Tolerance;

/// The inputs of one case.
#[derive(Clone, Debug, Default)]
pub(crate) struct Case(Vec<u32>);

impl Case {
    pub(crate) fn new() -> Self {
        Self::default()
    }

    pub(crate) fn words(&self) -> &[u32] {
        &self.0
    }

    pub(crate) fn u32(mut self, word: u32) -> Self {
        self.0.push(word);
        self
    }

    pub(crate) fn f32(self, value: f32) -> Self {
        self.u32(value.to_bits())
    }

    pub(crate) fn vec3(self, v: Vec3) -> Self {
        self.f32(v.x).f32(v.y).f32(v.z)
    }

    pub(crate) fn ray(self, ray: &Ray) -> Self {
        self.vec3(ray.origin)
            .f32(ray.lambda_low_nm)
            .vec3(ray.direction)
            .f32(ray.lambda_high_nm)
            .vec3(ray.spread)
            .f32(ray.significance)
            .u32(ray.instance)
            .u32(ray.facet)
            .u32(ray.medium)
            .u32(ray.enclosing)
            .u32(ray.depth)
            .u32(ray.absorber)
            .f32(ray.path_mm)
    }

    pub(crate) fn hit(self, hit: &Hit) -> Self {
        self.f32(hit.distance).u32(hit.instance).u32(hit.facet).vec3(hit.normal)
    }

    pub(crate) fn reflectance(self, reflectance: &Reflectance) -> Self {
        self.u32(reflectance.row).u32(reflectance.primaries).vec3(reflectance.weights)
    }

    pub(crate) fn interface(self, at: &Interface) -> Self {
        self.vec3(at.normal).u32(at.medium_from).u32(at.medium_to)
    }

    pub(crate) fn cone(self, cone: &Cone) -> Self {
        self.vec3(cone.center).f32(cone.cos_radius).f32(cone.sin_squared_radius)
    }
}

impl Display for Case {
    /// Each word as what it probably is.
    fn fmt(&self, f: &mut Formatter<'_>) -> FormatResult {
        for &word in &self.0 {
            match word {
                NONE => write!(f, "NONE ")?,
                GROUND => write!(f, "GROUND ")?,
                0x1_0000.. => write!(f, "{:?} ", f32::from_bits(word))?,
                _ => write!(f, "{word} ")?,
            }
        }
        Ok(())
    }
}

/// Reads a case from its beginning, as `take_…` does in WGSL.
pub(crate) struct Take<'a>(std::slice::Iter<'a, u32>);

impl<'a> Take<'a> {
    pub(super) fn new(case: &'a Case) -> Self {
        Self(case.0.iter())
    }

    pub(super) fn rest(&self) -> usize {
        self.0.len()
    }

    pub(crate) fn u32(&mut self) -> u32 {
        *self.0.next().expect("a probe takes no more than its cases have")
    }

    pub(crate) fn f32(&mut self) -> f32 {
        f32::from_bits(self.u32())
    }

    pub(crate) fn vec2(&mut self) -> [f32; 2] {
        [self.f32(), self.f32()]
    }

    pub(crate) fn vec3(&mut self) -> Vec3 {
        Vec3::new(self.f32(), self.f32(), self.f32())
    }

    pub(crate) fn sides(&mut self) -> Sides {
        let all = [Sides::Front, Sides::Back, Sides::Both];
        let number = self.u32();
        all.into_iter().find(|&sides| sides as u32 == number).expect("a case names sides")
    }

    pub(crate) fn ray(&mut self) -> Ray {
        // In the order of the words.
        Ray {
            origin: self.vec3(),
            lambda_low_nm: self.f32(),
            direction: self.vec3(),
            lambda_high_nm: self.f32(),
            spread: self.vec3(),
            significance: self.f32(),
            instance: self.u32(),
            facet: self.u32(),
            medium: self.u32(),
            enclosing: self.u32(),
            depth: self.u32(),
            absorber: self.u32(),
            path_mm: self.f32(),
        }
    }

    pub(crate) fn hit(&mut self) -> Hit {
        Hit { distance: self.f32(), instance: self.u32(), facet: self.u32(), normal: self.vec3() }
    }

    pub(crate) fn reflectance(&mut self) -> Reflectance {
        Reflectance { row: self.u32(), primaries: self.u32(), weights: self.vec3() }
    }

    pub(crate) fn interface(&mut self) -> Interface {
        Interface { normal: self.vec3(), medium_from: self.u32(), medium_to: self.u32() }
    }

    pub(crate) fn cone(&mut self) -> Cone {
        Cone { center: self.vec3(), cos_radius: self.f32(), sin_squared_radius: self.f32() }
    }
}

/// One output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Value {
    /// Compared exactly.
    Index(u32),
    /// Compared within the tolerance.
    Number(f32),
    /// Compared within the tolerance of its longest component.
    Vector(Vec3),
}

impl Display for Value {
    fn fmt(&self, f: &mut Formatter<'_>) -> FormatResult {
        match self {
            Self::Index(index) => write!(f, "{index}"),
            Self::Number(number) => write!(f, "{number:?}"),
            Self::Vector(v) => write!(f, "({:?}, {:?}, {:?})", v.x, v.y, v.z),
        }
    }
}

impl Value {
    /// The value of the same kind in the device's words.
    pub(super) fn alike(self, words: &mut std::slice::Iter<'_, u32>) -> Option<Self> {
        Some(match self {
            Self::Index(_) => Self::Index(*words.next()?),
            Self::Number(_) => Self::Number(f32::from_bits(*words.next()?)),
            Self::Vector(_) => {
                let [x, y, z] = [*words.next()?, *words.next()?, *words.next()?];
                Self::Vector(Vec3::new(f32::from_bits(x), f32::from_bits(y), f32::from_bits(z)))
            }
        })
    }

    pub(super) fn is_finite(self) -> bool {
        match self {
            Self::Index(_) => true,
            Self::Number(number) => number.is_finite(),
            Self::Vector(v) => v.is_finite(),
        }
    }

    /// Whether the device's value may stand for this one.
    pub(super) fn agrees(self, device: Self, tolerance: &Tolerance) -> bool {
        match (self, device) {
            (Self::Number(expected), Self::Number(found)) => {
                tolerance.allows(expected.abs(), expected - found)
            }
            (Self::Vector(expected), Self::Vector(found)) => tolerance
                .allows(expected.abs().max_element(), (expected - found).abs().max_element()),
            _ => self == device,
        }
    }
}

/// Collects what a Rust function gives, as `put_…` does in WGSL.
#[derive(Debug, Default)]
pub(crate) struct Put(Vec<Value>);

impl Put {
    pub(super) fn values(&self) -> &[Value] {
        &self.0
    }

    /// Words that the values take.
    pub(super) fn word_count(&self) -> usize {
        let words = |value: &Value| if matches!(value, Value::Vector(_)) { 3 } else { 1 };
        self.0.iter().map(words).sum()
    }

    pub(crate) fn u32(&mut self, word: u32) {
        self.0.push(Value::Index(word));
    }

    pub(crate) fn bool(&mut self, value: bool) {
        self.u32(u32::from(value));
    }

    pub(crate) fn f32(&mut self, value: f32) {
        self.0.push(Value::Number(value));
    }

    pub(crate) fn vec2(&mut self, [x, y]: [f32; 2]) {
        self.f32(x);
        self.f32(y);
    }

    pub(crate) fn vec3(&mut self, v: Vec3) {
        self.0.push(Value::Vector(v));
    }

    pub(crate) fn vec4(&mut self, v: Vec4) {
        self.vec3(v.truncate());
        self.f32(v.w);
    }

    pub(crate) fn ray(&mut self, ray: &Ray) {
        self.vec3(ray.origin);
        self.f32(ray.lambda_low_nm);
        self.vec3(ray.direction);
        self.f32(ray.lambda_high_nm);
        self.vec3(ray.spread);
        self.f32(ray.significance);
        self.u32(ray.instance);
        self.u32(ray.facet);
        self.u32(ray.medium);
        self.u32(ray.enclosing);
        self.u32(ray.depth);
        self.u32(ray.absorber);
        self.f32(ray.path_mm);
    }

    pub(crate) fn hit(&mut self, hit: &Hit) {
        self.f32(hit.distance);
        self.u32(hit.instance);
        self.u32(hit.facet);
        self.vec3(hit.normal);
    }

    pub(crate) fn interface(&mut self, at: &Interface) {
        self.vec3(at.normal);
        self.u32(at.medium_from);
        self.u32(at.medium_to);
    }

    pub(crate) fn cone(&mut self, cone: &Cone) {
        self.vec3(cone.center);
        self.f32(cone.cos_radius);
        self.f32(cone.sin_squared_radius);
    }

    pub(crate) fn material(&mut self, material: &PackedMaterial) {
        self.u32(material.index_table);
        self.u32(material.absorption);
        self.u32(material.reflectance);
        self.f32(material.least_absorption);
        let print = &material.print;
        self.vec3(print.front);
        self.f32(print.front_offset);
        self.vec3(print.tint);
        self.u32(print.primaries);
        for word in print.size.into_iter().chain(print.outside) {
            self.u32(word);
        }
        for word in [print.texels, print.levels, print.projection, print.projection_stride] {
            self.u32(word);
        }
    }

    pub(crate) fn reflectance(&mut self, reflectance: &Reflectance) {
        self.u32(reflectance.row);
        self.u32(reflectance.primaries);
        self.vec3(reflectance.weights);
    }

    /// The books, the radiance, and the rays that wait, the last one first.
    pub(crate) fn walk(&mut self, walk: &mut Walk<'_>) {
        self.books(walk);
        self.u32(walk.waiting());
        while walk.has_rays() {
            self.ray(&walk.pop());
        }
    }

    pub(super) fn books<R: Copy>(&mut self, walk: &Walk<'_, R>) {
        let tally = walk.tally;
        self.u32(tally.segments);
        self.u32(tally.depth);
        for energy in [tally.returned, tally.absorbed, tally.pruned, tally.cut_off, tally.lost] {
            self.f32(energy);
        }
        for &value in walk.radiance.iter() {
            self.f32(value);
        }
    }
}
