//! Tracers: they add one pass after the other to a film.

mod cpu;

pub use cpu::CpuTracer;

use glam::Vec3;

use crate::camera::{Camera, CameraFrame};
use crate::kernel::trace::Pass;
use crate::settings::TraceSettings;

/// The camera as a tracer sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Axes of the image plane.
    pub frame: CameraFrame,
    /// Unit vector from the scene towards the observer.
    pub observer: Vec3,
}

impl View {
    /// The view for pictures of the proportions of `size`, whatever their resolution.
    pub fn new(camera: &Camera, size: [u32; 2]) -> Self {
        let frame = camera.frame(size[0], size[1]);
        Self { frame, observer: -frame.forward }
    }
}

/// The constants of pass `index`.
fn pass(view: &View, settings: &TraceSettings, index: u32) -> Pass {
    Pass {
        index,
        split_count: settings.split_count,
        significance_threshold: settings.significance_threshold,
        max_depth: settings.max_depth,
        perturb: settings.perturb,
        observer: view.observer,
    }
}
