//! Small scenes and films for the tests.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use brilliance_renderer::camera::Camera;
use brilliance_renderer::cuts::RoundBrilliant;
use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::kernel::trace::trace;
use brilliance_renderer::kernel::walk::{RayStack, Tally, TraceRules, Walk};
use brilliance_renderer::light::{DiscLight, Lights, SkyLight};
use brilliance_renderer::material::{Dielectric, Dispersion, Material};
use brilliance_renderer::packed::PackedScene;
use brilliance_renderer::scene::{Object, Scene, Shape, Transform};
use brilliance_renderer::session::RenderRequest;
use brilliance_renderer::settings::{NoiseGoal, Splitting, TraceSettings};
use brilliance_renderer::solid::HalfSpace;
use brilliance_renderer::spectrum::{Bins, Spectrum};
use brilliance_renderer::still::{Still, StillLimits};
use brilliance_renderer::tracer::Backend;
use glam::{DVec3, Vec3};

/// Diamond by the paper's linear formula.
pub(crate) const DIAMOND: Dispersion = Dispersion::Linear { n_d: 2.417, dispersion_bg: 0.044 };
/// A strongly dispersive flint glass by the paper's linear formula.
pub(crate) const FLINT: Dispersion = Dispersion::Linear { n_d: 1.784, dispersion_bg: 0.055 };

/// The paper's splitting.
pub(crate) fn paper() -> TraceSettings {
    TraceSettings { splitting: Splitting::Paper, ..TraceSettings::default() }
}

/// Exact splitting of which next to nothing is left to chance.
pub(crate) fn exact() -> TraceSettings {
    let splitting = Splitting::Exact;
    TraceSettings { splitting, roulette_threshold: 1e-6, ..TraceSettings::default() }
}

pub(crate) fn flat_sky(radiance: f32) -> SkyLight {
    SkyLight { radiance, spectrum: Spectrum::Flat(1.0) }
}

pub(crate) fn flat_disc(direction: Vec3, radius_degrees: f32, radiance: f32) -> DiscLight {
    DiscLight {
        name: "disc".to_owned(),
        direction,
        angular_radius_radians: radius_degrees.to_radians(),
        radiance,
        spectrum: Spectrum::Flat(1.0),
    }
}

pub(crate) fn clear(dispersion: Dispersion) -> Material {
    Material::Dielectric(Dielectric {
        name: "test".to_owned(),
        dispersion,
        absorption_per_mm: None,
    })
}

pub(crate) fn object(shape: Shape, material: Material) -> Object {
    Object {
        name: "test".to_owned(),
        shape,
        transform: Transform::default(),
        material,
        throws_light: false,
    }
}

pub(crate) fn brilliant(dispersion: Dispersion) -> Object {
    object(Shape::RoundBrilliant(RoundBrilliant::default()), clear(dispersion))
}

pub(crate) fn half_space(normal: DVec3, distance: f64) -> HalfSpace {
    HalfSpace { normal: normal.normalize(), distance, name: String::new() }
}

/// A block with the given half extents.
pub(crate) fn block(half_extents: DVec3) -> Shape {
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    Shape::Polyhedron(
        axes.iter()
            .flat_map(|&axis| {
                let distance = axis.dot(half_extents);
                [half_space(axis, distance), half_space(-axis, distance)]
            })
            .collect(),
    )
}

/// A prism whose edges run along y, with its apex of `apex_degrees` up and its base down.
pub(crate) fn prism(apex_degrees: f64, size_mm: f64) -> Shape {
    let tilt = (0.5 * apex_degrees).to_radians();
    Shape::Polyhedron(vec![
        half_space(DVec3::new(tilt.cos(), 0.0, tilt.sin()), size_mm),
        half_space(DVec3::new(-tilt.cos(), 0.0, tilt.sin()), size_mm),
        half_space(DVec3::NEG_Z, size_mm),
        half_space(DVec3::Y, 20.0 * size_mm),
        half_space(DVec3::NEG_Y, 20.0 * size_mm),
    ])
}

pub(crate) fn scene(objects: Vec<Object>, lights: Lights) -> Scene {
    Scene { objects, lights, ..Scene::default() }
}

/// A brilliant diamond in an environment of radiance 1.
pub(crate) fn furnace() -> Scene {
    let lights = Lights { environment: Some(flat_sky(1.0)), ..Lights::default() };
    scene(vec![brilliant(DIAMOND)], lights)
}

pub(crate) fn request(
    scene: Scene,
    camera: Camera,
    size: [u32; 2],
    trace: TraceSettings,
) -> RenderRequest {
    RenderRequest {
        scene: Arc::new(scene),
        camera,
        size,
        trace,
        pass_limit: 1,
        noise: NoiseGoal::NONE,
        backend: Backend::Cpu,
    }
}

pub(crate) fn render(request: &RenderRequest, threads: usize) -> Still {
    let limits = StillLimits { time: None, threads };
    Still::render(request, limits, None, &AtomicBool::new(false), |_, _| {})
        .expect("the scene renders")
}

/// The default camera with a field of view that `width_mm` fills at the stone.
pub(crate) fn close_camera(width_mm: f32) -> Camera {
    let camera = Camera::default();
    let distance = camera.position.distance(camera.target);
    Camera { fov_y_radians: 2.0 * (0.5 * width_mm / distance).atan(), ..camera }
}

pub(crate) fn rules(settings: &TraceSettings) -> TraceRules {
    TraceRules {
        observer: Vec3::Z,
        split_count: settings.split_count,
        significance_threshold: settings.significance_threshold,
        max_depth: settings.max_depth,
        perturb: u32::from(settings.perturb),
        cut_threshold: 0.1 * settings.significance_threshold,
    }
}

/// Traces one ray; the radiance per bin and the tally.
pub(crate) fn trace_ray(scene: &Scene, settings: &TraceSettings, ray: &Ray) -> (Vec<f32>, Tally) {
    let bins = Bins::new(settings.bins);
    let packed = PackedScene::new(scene, bins).expect("the scene packs");
    let mut pixel = vec![0.0; bins.count()];
    let (rules, mut stack) = (rules(settings), RayStack::new());
    let mut walk = Walk::new(&packed, &rules, 0, 1, &mut stack, &mut pixel);
    trace(&mut walk, ray);
    let tally = walk.tally;
    (pixel, tally)
}

pub(crate) fn mean(values: &[f32]) -> f64 {
    values.iter().map(|&value| f64::from(value)).sum::<f64>() / values.len() as f64
}
