//! Scenes that both tracers trace.

use std::path::Path;

use brilliance_renderer::packed::PackedScene;
use brilliance_renderer::scene_file::Document;
use brilliance_renderer::settings::{Splitting, TraceSettings};
use brilliance_renderer::spectrum::Bins;
use brilliance_renderer::tracer::View;

/// A diamond within a block of green glass, beside an orange one and a matte block, on a cloth.
const NESTED: &str = r#"
format = 1
camera = { position_mm = [0, -32, 30], target_mm = [0, 0, -1], fov_y_degrees = 20 }
ground = { height_mm = -4 }
lights.hemisphere = { radiance = 0.4 }
lights.backdrop = { radiance = 0.1 }
lights.observer_shadow_degrees = 8

[[lights.discs]]
name = "Lamp"
direction = [-1, -0.5, 1]
radius_degrees = 6
radiance = 12

[[objects]]
name = "Diamond in glass"
translation_mm = [-3, 0, 0]
round_brilliant = { diameter_mm = 3 }
material = { library = "Diamond" }

[[objects]]
name = "Green glass"
translation_mm = [-3, 0, 0]
material = { curve = "cauchy", n_d = 1.62, dispersion_bg = 0.03, absorption_per_mm = { lambda_nm = [400, 530, 650], value = [0.3, 0.02, 0.25] } }
polyhedron.half_spaces = [
    { normal = [0, 0, 1], distance_mm = 2 },
    { normal = [0, 0.1, -1], distance_mm = 2.5 },
    { normal = [1, 0, 0], distance_mm = 2.5 },
    { normal = [-1, 0, 0.2], distance_mm = 2.5 },
    { normal = [0, 1, 0], distance_mm = 2.5 },
    { normal = [0, -1, 0], distance_mm = 2.5 },
]

[[objects]]
name = "Orange brilliant"
translation_mm = [3, -1, -1]
rotation = { axis = [1, 0, 0], degrees = 25 }
round_brilliant = { diameter_mm = 5 }
material = { curve = "linear", n_d = 2.2, dispersion_bg = 0.06, absorption_per_mm = { lambda_nm = [420, 600], value = [0.2, 0] } }

[[objects]]
name = "Matte block"
translation_mm = [2, 4, -2]
material = { diffuse = { linear_srgb = [0.7, 0.2, 0.1] } }
polyhedron.half_spaces = [
    { normal = [0, 0, 1], distance_mm = 2 },
    { normal = [0, 0, -1], distance_mm = 2 },
    { normal = [1, 0, 0], distance_mm = 2 },
    { normal = [-1, 0, 0], distance_mm = 2 },
    { normal = [0, 1, 0], distance_mm = 1 },
    { normal = [0, -1, 0], distance_mm = 1 },
]
"#;

/// A scene and how it is traced.
pub(crate) struct Case {
    pub(crate) name: &'static str,
    pub(crate) document: Document,
    pub(crate) size: [u32; 2],
    pub(crate) passes: u32,
}

impl Case {
    /// By the paper's splitting.
    pub(crate) fn new(name: &'static str, mut document: Document) -> Self {
        document.trace.splitting = Splitting::Paper;
        Self { name, document, size: [48, 48], passes: 2 }
    }

    pub(crate) fn settings(&self) -> &TraceSettings {
        &self.document.trace
    }

    pub(crate) fn bins(&self) -> Bins {
        Bins::new(self.settings().bins)
    }

    pub(crate) fn packed(&self) -> PackedScene {
        PackedScene::new(&self.document.scene, self.bins()).expect("the scene packs")
    }

    pub(crate) fn view(&self) -> View {
        View::new(&self.document.scene.camera, self.size)
    }
}

fn asset(path: &str) -> Document {
    let assets = Path::new(env!("CARGO_MANIFEST_DIR")).join("../assets");
    Document::open(&assets.join(path)).expect("the scene opens")
}

pub(crate) fn diamond() -> Case {
    Case::new("diamond", Document::default())
}

pub(crate) fn seven_diamonds() -> Case {
    let case = Case::new("seven-diamonds", asset("scenes/seven-diamonds.toml"));
    Case { passes: 1, ..case }
}

pub(crate) fn mesh() -> Case {
    Case::new("mesh", asset("gems/spinel_octahedron.glb"))
}

pub(crate) fn prism() -> Case {
    let mut document = asset("scenes/prism.toml");
    document.trace.split_count = 1.5;
    Case::new("prism", document)
}

pub(crate) fn nested() -> Case {
    Case::new("nested", Document::from_toml(NESTED, Path::new("")).expect("the scene is right"))
}

/// The scene of the beam, near to where its light falls, and seen through the prism.
pub(crate) fn beam() -> Case {
    let mut document = asset("scenes/beam.toml");
    // No camera ray may have so many descendants that the one which goes another way counts.
    document.trace =
        TraceSettings { bins: 6, split_count: 0.1, significance_threshold: 0.02, ..document.trace };
    document.scene.camera.fov_y_radians *= 0.6;
    Case::new("beam", document)
}

/// The word, and its image through a prism.
pub(crate) fn print() -> Case {
    let mut document = asset("scenes/prism-word.toml");
    document.trace.split_count = 1.0;
    document.trace.significance_threshold = 0.05;
    Case::new("print", document)
}

pub(crate) fn furnace() -> Case {
    Case::new("furnace", asset("scenes/furnace.toml"))
}

/// A small diamond of little effort, unlike in all rows and bins; each pass differs too.
pub(crate) fn small_diamond() -> Case {
    let mut document = Document::default();
    document.trace = document.trace.draft();
    Case { size: [40, 32], passes: 3, ..Case::new("small-diamond", document) }
}

/// A diamond of little effort on a film of many bytes.
pub(crate) fn banded() -> Case {
    let mut document = Document::default();
    document.trace = TraceSettings { bins: 64, ..document.trace.draft() };
    Case { size: [128, 72], ..Case::new("banded", document) }
}
