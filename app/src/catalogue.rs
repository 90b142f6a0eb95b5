//! What the menus offer: the one place where the window meets the renderer's libraries.

use brilliance_renderer::cuts::RoundBrilliant;
use brilliance_renderer::error::RendererError;
use brilliance_renderer::light::{DiscLight, Lights, SkyLight};
use brilliance_renderer::material::{Dielectric, Dispersion};
use brilliance_renderer::scene_file::Document;
use brilliance_renderer::spectrum::{Illuminant, LAMBDA_B_NM, LAMBDA_G_NM, Spectrum};
use glam::Vec3;

/// Something that can be chosen from a menu.
#[derive(Clone, Debug)]
pub struct Choice<T> {
    /// What the menu says.
    pub name: String,
    /// One sentence for the tooltip.
    pub description: String,
    /// What is chosen.
    pub value: T,
}

impl<T> Choice<T> {
    fn new(name: impl Into<String>, description: impl Into<String>, value: T) -> Self {
        Self { name: name.into(), description: description.into(), value }
    }
}

/// The gem materials.
pub fn materials() -> Vec<Choice<Dielectric>> {
    [("Diamond", 2.417, 0.044), ("Cubic zirconia", 2.158, 0.060), ("Quartz", 1.544, 0.013)]
        .into_iter()
        .map(|(name, n_d, dispersion_bg)| {
            let dispersion = Dispersion::Linear { n_d, dispersion_bg };
            let material =
                Dielectric { name: name.to_owned(), dispersion, absorption_per_mm: None };
            let figures = format!("n {n_d:.3}, dispersion (B\u{2013}G) {dispersion_bg:.3}");
            Choice::new(name, figures, material)
        })
        .collect()
}

/// The numbers by which gemologists know a material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IndexFigures {
    /// Index of refraction at the D line.
    pub n_d: f64,
    /// Index at the G line minus index at the B line.
    pub dispersion_bg: f64,
    /// `(n_d − 1)/(n_F − n_C)`.
    pub abbe_number: f64,
}

/// The figures of a dispersion curve.
pub fn index_figures(dispersion: &Dispersion) -> IndexFigures {
    let (n_d, dispersion_bg) = match dispersion {
        Dispersion::Linear { n_d, dispersion_bg } => (*n_d, *dispersion_bg),
        _ => (1.5, 0.0),
    };
    let mean_dispersion = dispersion_bg * (656.3 - 486.1) / (LAMBDA_B_NM - LAMBDA_G_NM);
    IndexFigures { n_d, dispersion_bg, abbe_number: (n_d - 1.0) / mean_dispersion }
}

/// The curve moved to an index and stretched to a dispersion.
pub fn with_index(_dispersion: &Dispersion, n_d: f64, dispersion_bg: f64) -> Dispersion {
    Dispersion::Linear { n_d, dispersion_bg }
}

/// The lights a stone can be put under.
pub fn rigs() -> Vec<Choice<Lights>> {
    let spot = |index: usize| {
        let azimuth = index as f32 * std::f32::consts::TAU / 8.0;
        let tilt: f32 = if index == 8 { 0.0 } else { 0.9 };
        DiscLight {
            name: format!("Spot {}", index + 1),
            direction: Vec3::new(
                tilt.sin() * azimuth.cos(),
                tilt.sin() * azimuth.sin(),
                tilt.cos(),
            ),
            angular_radius_radians: 0.02,
            radiance: 60.0,
            spectrum: Spectrum::Illuminant(Illuminant::D65),
        }
    };
    let spots = Lights {
        discs: (0..9).map(spot).collect(),
        hemisphere: Some(SkyLight::daylight(0.1)),
        ..Lights::default()
    };
    let dome = Lights { hemisphere: Some(SkyLight::daylight(1.0)), ..Lights::default() };
    vec![
        Choice::new("Nine spots", "Nine small lights over a dim sky: shows fire.", spots),
        Choice::new("White dome", "An even sky: shows light return and windows.", dome),
    ]
}

/// The lights with their angular radii and radiances multiplied.
pub fn scaled(lights: &Lights, size: f32, brightness: f32) -> Lights {
    let mut lights = lights.clone();
    for disc in &mut lights.discs {
        disc.angular_radius_radians =
            (disc.angular_radius_radians * size).clamp(1e-4, std::f32::consts::FRAC_PI_2);
        disc.radiance *= brightness;
    }
    lights
}

/// The proportions that the sliders go back to.
pub fn default_brilliant() -> RoundBrilliant {
    brilliants()[1].value
}

/// Named sets of proportions, all for a stone of 6.5 mm.
pub fn brilliants() -> [Choice<RoundBrilliant>; 5] {
    let set = |name: &str, source: &str, [t, c, p, s, l, g]: [f32; 6]| {
        let proportions = RoundBrilliant {
            diameter_mm: 6.5,
            table: t,
            crown_angle_degrees: c,
            pavilion_angle_degrees: p,
            star_length: s,
            lower_half_length: l,
            girdle_thickness: g,
            culet: 0.0,
        };
        Choice::new(name, source, proportions)
    };
    [
        set("Tolkowsky", "Tolkowsky 1919.", [0.53, 34.5, 40.75, 0.50, 0.60, 0.007]),
        set("Modern ideal", "The American ideal of today.", [0.56, 34.5, 40.75, 0.50, 0.77, 0.03]),
        set("GIA excellent", "Middle of the GIA chart.", [0.57, 34.5, 41.0, 0.55, 0.80, 0.03]),
        set("Scandinavian", "Scandinavian standard.", [0.575, 34.5, 40.75, 0.50, 0.75, 0.02]),
        set("Practical fine cut", "Eppler 1939.", [0.56, 33.2, 40.8, 0.50, 0.75, 0.025]),
    ]
}

/// Reads a scene inside the program.
pub type OpenScene = fn() -> Result<Document, RendererError>;

/// The scenes inside the program.
pub fn scenes() -> Vec<Choice<OpenScene>> {
    let diamond: OpenScene = || Ok(Document::default());
    vec![Choice::new("Round brilliant", "A diamond under nine spots.", diamond)]
}
