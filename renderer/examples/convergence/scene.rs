//! What the methods are compared on.

use std::path::Path;

use brilliance_renderer::error::RendererError;
use brilliance_renderer::scene_file::Document;

/// Width and height of each picture in pixels.
const SIZE: [u32; 2] = [128, 96];
/// Vertical field of view in degrees that the stone fills.
const WHOLE_FOV_DEGREES: f32 = 6.5;
/// The same for a part of the stone with the pixels of a still of 960 × 640, 8.5° high.
const DETAIL_FOV_DEGREES: f32 = 8.5 * SIZE[1] as f32 / 640.0;

/// One clear stone in lights without a place: what all methods can do, and without matte surfaces, whose
/// sampled light would be the same noise for all.
pub(crate) struct ReferenceScene {
    pub(crate) name: &'static str,
    pub(crate) file_name: &'static str,
    pub(crate) document: Document,
    pub(crate) size: [u32; 2],
}

/// A diamond under nine small lamps, whole and near; the same in the showroom's lights and sky; and
/// strontium titanate, which has four times its dispersion.
pub(crate) fn all() -> Result<Vec<ReferenceScene>, RendererError> {
    let scene = |name, file_name, material, rig, fov_degrees| {
        let text = text(material, rig, fov_degrees);
        let document = Document::from_toml(&text, Path::new(""))?;
        Ok(ReferenceScene { name, file_name, document, size: SIZE })
    };
    [
        ("Diamond under nine spots", "spots", "Diamond", "Nine spots", WHOLE_FOV_DEGREES),
        ("The same, near", "spots-near", "Diamond", "Nine spots", DETAIL_FOV_DEGREES),
        ("Diamond in the showroom, near", "showroom", "Diamond", "Showroom", DETAIL_FOV_DEGREES),
        (
            "Strontium titanate under nine spots, near",
            "strontium-titanate",
            "Strontium titanate",
            "Nine spots",
            DETAIL_FOV_DEGREES,
        ),
    ]
    .into_iter()
    .map(|(name, file_name, material, rig, fov)| scene(name, file_name, material, rig, fov))
    .collect()
}

/// The scene in the format of scene files.
fn text(material: &str, rig: &str, fov_degrees: f32) -> String {
    let target_mm =
        if fov_degrees < WHOLE_FOV_DEGREES { [0.6, -0.9, 0.0] } else { [0.0, -0.3, 0.0] };
    format!(
        r#"
format = 1

[display]
exposure_ev = 0.5

[camera]
position_mm = [2, -28, 36]
target_mm = {target_mm:?}
fov_y_degrees = {fov_degrees}

[lights]
rig = "{rig}"

[[objects]]
name = "Brilliant"
round_brilliant = {{ proportions = "Practical Fine Cut", diameter_mm = 6.5 }}
material = {{ library = "{material}" }}
"#
    )
}
