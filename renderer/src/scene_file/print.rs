//! Prints in a scene file: images on matte surfaces.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use glam::Vec3;
use serde::{Deserialize, Serialize};

use super::check::{choose, exactly_one, in_range, unit_vector};
use super::fault::{Fault, Under, quoted, suggestion};
use super::path::relative;
use crate::material::{Image, ImageOrigin, Layout, Outside, Planar, Print, TexelBudget};

/// A print as written: the image by `file` or `library`, its size and how it lies on the body.
#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PrintEntry {
    /// A PNG or JPEG file, relative to the scene file.
    file: Option<String>,
    /// Name of an image that ships.
    library: Option<String>,
    /// At least one of the two; the other then keeps the image's proportions.
    width_mm: Option<f32>,
    height_mm: Option<f32>,
    facing: Option<[f32; 3]>,
    up: Option<[f32; 3]>,
    /// `bare`, `edge`, `repeat` or `mirror`.
    outside: Option<String>,
    /// Above and below the image, where that differs from its sides.
    outside_above: Option<String>,
    tint: Option<[f32; 3]>,
}

const OUTSIDES: [(&str, Outside); 4] = [
    ("bare", Outside::Bare),
    ("edge", Outside::Edge),
    ("repeat", Outside::Repeat),
    ("mirror", Outside::Mirror),
];

/// Allowed width and height, in millimetres.
const SIDE_MM: RangeInclusive<f32> = 1e-3..=1e6;

/// The image files of one scene, each read once.
pub(super) struct ImageFiles<'a> {
    base: &'a Path,
    /// By their canonical paths.
    files: BTreeMap<PathBuf, Arc<Image>>,
    /// Of all images of the scene, those of its meshes too.
    pub(super) budget: TexelBudget,
}

impl<'a> ImageFiles<'a> {
    /// Paths start from the folder `base`.
    pub(super) fn new(base: &'a Path) -> Self {
        Self { base, files: BTreeMap::new(), budget: TexelBudget::default() }
    }

    fn read(&mut self, file: &str) -> Result<Arc<Image>, Fault> {
        let path = self.base.join(file);
        let key = path.canonicalize().unwrap_or_else(|_| path.clone());
        if let Some(image) = self.files.get(&key) {
            return Ok(Arc::clone(image));
        }
        let image =
            Image::open(&path, &mut self.budget).map_err(|error| Fault::new(error.to_string()))?;
        let image = Arc::new(image);
        self.files.insert(key, Arc::clone(&image));
        Ok(image)
    }
}

impl PrintEntry {
    pub(super) fn read(self, images: &mut ImageFiles) -> Result<Print, Fault> {
        exactly_one(&[("file", self.file.is_some()), ("library", self.library.is_some())])?;
        let image = match (&self.file, &self.library) {
            (Some(file), _) => images.read(file).under("file")?,
            (None, Some(name)) => of_library(name).under("library")?,
            (None, None) => return Err(Fault::new("the print has no image")),
        };
        let outside = match &self.outside {
            Some(name) => choose(name, &OUTSIDES).under("outside")?,
            None => Outside::Bare,
        };
        let outside_above = match &self.outside_above {
            Some(name) => choose(name, &OUTSIDES).under("outside_above")?,
            None => outside,
        };
        let tint = self.tint.unwrap_or([1.0; 3]);
        if let Some(channel) = tint.iter().find(|channel| !(0.0..=1.0).contains(*channel)) {
            return Err(Fault::at("tint", format!("found {channel}; each channel is 0 to 1")));
        }
        let layout = Layout::Planar(self.planar(image.size)?);
        Ok(Print { image, layout, outside: [outside, outside_above], tint })
    }

    fn planar(&self, [columns, rows]: [u32; 2]) -> Result<Planar, Fault> {
        let proportion = columns as f32 / rows as f32;
        let size_mm = match (self.width_mm, self.height_mm) {
            (Some(width), Some(height)) => [width, height],
            (Some(width), None) => [width, width / proportion],
            (None, Some(height)) => [height * proportion, height],
            (None, None) => {
                return Err(Fault::at("width_mm", "this key is missing; or give `height_mm`"));
            }
        };
        in_range("width_mm", size_mm[0], &SIDE_MM)?;
        in_range("height_mm", size_mm[1], &SIDE_MM)?;
        let facing = unit_vector("facing", self.facing.unwrap_or([0.0, 0.0, 1.0]))?;
        // Upwards like +z; seen from above or below, like +y.
        let upright = if facing.z.abs() > 0.999 { Vec3::Y } else { Vec3::Z };
        let up = self.up.map_or(Ok(upright), |up| unit_vector("up", up))?;
        if facing.dot(up).abs() < 1e-6 {
            // At right angles already: the bits stay.
            return Ok(Planar { facing, up, size_mm });
        }
        let Some(up) = up.as_dvec3().reject_from(facing.as_dvec3()).try_normalize() else {
            return Err(Fault::at("up", "it is parallel to `facing`; turn one of them"));
        };
        Ok(Planar { facing, up: up.as_vec3(), size_mm })
    }

    /// Paths are written relative to `base`; nothing stands for a print that a mesh brings along.
    pub(super) fn write(print: &Print, base: &Path) -> Option<Self> {
        let Print { image, layout: Layout::Planar(planar), outside, tint } = print else {
            return None;
        };
        let (file, library) = match &image.origin {
            ImageOrigin::File(path) => (Some(relative(path, base)), None),
            ImageOrigin::Library(name) => (None, Some((*name).to_owned())),
            ImageOrigin::Mesh(_) => return None,
        };
        let [width, height] = planar.size_mm;
        let name = |outside: Outside| {
            let named = OUTSIDES.iter().find(|(_, known)| *known == outside);
            named.map(|(name, _)| (*name).to_owned())
        };
        Some(Self {
            file,
            library,
            width_mm: Some(width),
            height_mm: Some(height),
            facing: Some(planar.facing.to_array()),
            up: Some(planar.up.to_array()),
            outside: name(outside[0]),
            outside_above: (outside[1] != outside[0]).then(|| name(outside[1])).flatten(),
            tint: (*tint != [1.0; 3]).then_some(*tint),
        })
    }
}

fn of_library(name: &str) -> Result<Arc<Image>, Fault> {
    Image::of_library(name).ok_or_else(|| {
        let names: Vec<&str> = Image::library_names().collect();
        Fault::new(format!("no image {} ships; {}", quoted(name), suggestion(name, &names)))
    })
}
