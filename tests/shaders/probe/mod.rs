//! Probes: one function of the kernel, run on both sides on the same inputs.

mod device;
mod dice;
mod fan_dice;
mod fan_words;
mod fans;
mod tolerance;
mod words;
mod world;

use std::fmt::Write as _;

use brilliance_renderer::shaders::{KERNEL, ShaderModule};

pub(crate) use dice::{Dice, throw};
pub(crate) use fans::{Meeting, see_lights};
pub(crate) use tolerance::{EXACT, ROUNDING, Tolerance};
pub(crate) use words::{Case, Put, Take};
pub(crate) use world::World;

use device::Shader;

/// One function on both sides. Where both take and put the same, the two texts read alike.
pub(crate) struct Probe {
    /// The function's name.
    pub(crate) name: &'static str,
    /// What the device does: WGSL statements that take inputs and put outputs.
    pub(crate) wgsl: &'static str,
    /// The same in Rust.
    pub(crate) rust: fn(&World, &mut Take<'_>, &mut Put),
    /// What it is tried on.
    pub(crate) cases: fn(&World) -> Vec<Case>,
    /// How far the outputs may be apart, and why.
    pub(crate) tolerance: Tolerance,
}

/// The probes of one module, to be run in each of some worlds.
pub(crate) struct Table {
    pub(crate) worlds: Vec<World>,
    pub(crate) probes: Vec<Probe>,
}

impl Table {
    /// Holds the shaders that ship to the kernel.
    pub(crate) fn check(&self) {
        let faults = self.faults(KERNEL);
        assert!(faults.is_empty(), "{}", faults.join("\n"));
    }

    /// What differs where `modules` stand for the kernel's shaders.
    pub(crate) fn faults(&self, modules: &[ShaderModule]) -> Vec<String> {
        let shader = Shader::new(modules, &self.probes);
        let mut faults = Vec::new();
        for world in &self.worlds {
            let loaded = shader.load(world);
            for probe in &self.probes {
                let cases = (probe.cases)(world);
                if cases.is_empty() {
                    continue;
                }
                let expected: Vec<_> = cases.iter().map(|case| probe.expect(world, case)).collect();
                let output_len = expected.iter().map(Put::word_count).max().unwrap_or(0);
                let found = loaded.run(probe, &cases, output_len);
                let fault = probe.compare(world, &cases, &expected, &found);
                faults.extend(fault);
            }
        }
        faults
    }
}

impl Probe {
    fn expect(&self, world: &World, case: &Case) -> Put {
        let (mut take, mut put) = (Take::new(case), Put::default());
        (self.rust)(world, &mut take, &mut put);
        assert_eq!(take.rest(), 0, "{}: takes all that a case has", self.name);
        let is_finite = put.values().iter().all(|value| value.is_finite());
        assert!(is_finite, "{}: {case:?} is outside of what it is made for: {put:?}", self.name);
        put
    }

    /// In words, where more than the permitted share of the cases differ.
    fn compare(
        &self,
        world: &World,
        cases: &[Case],
        expected: &[Put],
        found: &[Vec<u32>],
    ) -> Option<String> {
        let mut strays = 0;
        let mut text = String::new();
        for ((case, expected), found) in cases.iter().zip(expected).zip(found) {
            let Some(difference) = self.difference(expected, found) else { continue };
            strays += 1;
            if strays <= 3 {
                let _ = write!(text, "\n  {difference}\n    of {case}");
            }
        }
        (!self.tolerance.allows_strays(strays, cases.len())).then(|| {
            format!("{} in {}: {strays} of {} cases{text}", self.name, world.name, cases.len())
        })
    }

    fn difference(&self, expected: &Put, found: &[u32]) -> Option<String> {
        let words = expected.word_count();
        if found[0] as usize != words {
            return Some(format!("{words} words expected, {} found", found[0]));
        }
        let mut rest = found[1..].iter();
        for (i, value) in expected.values().iter().enumerate() {
            let device = value.alike(&mut rest)?;
            if !value.agrees(device, &self.tolerance) {
                return Some(format!("output {i}: {value} expected, {device} found"));
            }
        }
        None
    }
}
