//! Packing of what is printed on matte surfaces.

use std::collections::HashMap;
use std::sync::Arc;

use bytemuck::Zeroable;
use glam::{Vec3, Vec4};

use super::spectra::SpectrumRows;
use super::unwrapped::UnwrappedMesh;
use super::{NONE, PackedPrint};
use crate::color::srgb_decode;
use crate::error::RendererError;
use crate::material::{Image, Layout, Planar, Print, TexelBudget};
use crate::mesh::Mesh;
use crate::scene::{Object, Shape};
use crate::spectrum::Spectrum;

/// Words of the projection of one facet: two rows of four numbers.
const PROJECTION_LEN: u32 = 8;

/// Least cosine to the direction in which a projected image faces: what is seen edge on is bare.
const LEAST_FACING: f32 = 1e-3;

/// The images of a scene and how they lie on its bodies, as words behind the order of the bodies.
pub(super) struct PrintWords {
    /// Words before these.
    before: usize,
    words: Vec<u32>,
    /// First word of the table of levels, and row of the reflectance of red; none before the first
    /// print.
    shared: Option<(u32, u32)>,
    images: HashMap<*const Image, u32>,
    /// Of meshes with an image on them: the first word of the projections, and the facet that each
    /// triangle belongs to.
    unwrapped: HashMap<*const Mesh, (u32, Vec<u32>)>,
    budget: TexelBudget,
}

impl PrintWords {
    /// Nothing yet, behind the order of so many bodies.
    pub(super) fn new(body_count: usize) -> Self {
        Self {
            before: body_count,
            words: Vec::new(),
            shared: None,
            images: HashMap::new(),
            unwrapped: HashMap::new(),
            budget: TexelBudget::default(),
        }
    }

    /// The words behind the order of the bodies.
    pub(super) fn behind(self, mut order: Vec<u32>) -> Vec<u32> {
        debug_assert_eq!(order.len(), self.before);
        order.extend(self.words);
        order
    }

    /// The facet of each triangle in leaf order, for a mesh that has an image on it by its
    /// coordinates.
    pub(super) fn facets(&self, mesh: &Arc<Mesh>) -> Option<&[u32]> {
        self.unwrapped.get(&Arc::as_ptr(mesh)).map(|(_, facets)| facets.as_slice())
    }

    /// The number of the word that is pushed next.
    fn next(&self) -> u32 {
        (self.before + self.words.len()) as u32
    }

    /// Packs what is printed on an object.
    pub(super) fn push(
        &mut self,
        object: &Object,
        print: &Print,
        spectra: &mut SpectrumRows,
    ) -> Result<PackedPrint, RendererError> {
        let in_words =
            |fault: String| RendererError::Invalid(format!("print on {}: {fault}", object.name));
        if !print.tint.iter().all(|channel| (0.0..=1.0).contains(channel)) {
            return Err(in_words(format!("the tint {:?} must lie between 0 and 1", print.tint)));
        }
        let (levels, primaries) = self.shared(spectra)?;
        let packed = match print.layout {
            Layout::Planar(planar) => self.push_planar(&planar).map_err(in_words)?,
            Layout::Coordinates => self.push_coordinates(&object.shape).map_err(in_words)?,
        };
        Ok(PackedPrint {
            texels: self.push_image(&print.image).map_err(in_words)?,
            levels,
            primaries,
            tint: Vec3::from_array(print.tint),
            size: print.image.size,
            outside: print.outside.map(|outside| outside as u32),
            ..packed
        })
    }

    /// What all prints need: the linear values of the sRGB codes, and the reflectances of red,
    /// green and blue.
    fn shared(&mut self, spectra: &mut SpectrumRows) -> Result<(u32, u32), RendererError> {
        if let Some(shared) = self.shared {
            return Ok(shared);
        }
        let levels = self.next();
        let level = |code: u32| srgb_decode(f64::from(code) / 255.0) as f32;
        self.words.extend((0..256).map(|code| level(code).to_bits()));
        let mut row = |rgb| spectra.push("the primaries", &Spectrum::Rgb(rgb), 1.0);
        let red = row([1.0, 0.0, 0.0])?;
        row([0.0, 1.0, 0.0])?;
        row([0.0, 0.0, 1.0])?;
        Ok(*self.shared.insert((levels, red)))
    }

    fn push_image(&mut self, image: &Arc<Image>) -> Result<u32, String> {
        if let Some(&first) = self.images.get(&Arc::as_ptr(image)) {
            return Ok(first);
        }
        let [width, height] = image.size;
        if image.texels.is_empty()
            || image.texels.len() as u64 != u64::from(width) * u64::from(height)
        {
            return Err(format!(
                "the image {} does not have {width} × {height} texels",
                image.name()
            ));
        }
        self.budget.take(image.size)?;
        let first = self.next();
        self.words.extend_from_slice(&image.texels);
        self.images.insert(Arc::as_ptr(image), first);
        Ok(first)
    }

    fn push_planar(&mut self, planar: &Planar) -> Result<PackedPrint, String> {
        let Planar { facing, up, size_mm: [width, height] } = *planar;
        let is_length = |length: f32| length.is_finite() && length > 0.0;
        if !(is_length(width) && is_length(height)) {
            return Err(format!("its size {width} × {height} mm must be greater than 0"));
        }
        if !(facing.is_normalized() && up.is_normalized() && facing.dot(up).abs() < 1e-3) {
            return Err("`facing` and `up` must be unit vectors at right angles".to_owned());
        }
        let projection = self.next();
        self.push_row((up.cross(facing) / width).extend(0.5));
        self.push_row((-up / height).extend(0.5));
        Ok(PackedPrint {
            front: facing,
            front_offset: -LEAST_FACING,
            projection,
            projection_stride: 0,
            ..PackedPrint::zeroed()
        })
    }

    fn push_coordinates(&mut self, shape: &Shape) -> Result<PackedPrint, String> {
        let missing = || "its mesh has no texture coordinates; unwrap it".to_owned();
        let Shape::Mesh(source) = shape else { return Err(missing()) };
        if source.mesh.coordinates.is_empty() {
            return Err(missing());
        }
        let known = self.unwrapped.get(&Arc::as_ptr(&source.mesh)).map(|(first, _)| *first);
        let projection = known.unwrap_or_else(|| self.push_unwrapped(&source.mesh));
        // All of the mesh is printed on, whichever way it faces.
        Ok(PackedPrint {
            front: Vec3::ZERO,
            front_offset: 1.0,
            projection,
            projection_stride: PROJECTION_LEN,
            ..PackedPrint::zeroed()
        })
    }

    fn push_unwrapped(&mut self, mesh: &Arc<Mesh>) -> u32 {
        let first = self.next();
        let UnwrappedMesh { facets, projections } = UnwrappedMesh::new(mesh);
        for row in projections.into_iter().flatten() {
            self.push_row(row);
        }
        self.unwrapped.insert(Arc::as_ptr(mesh), (first, facets));
        first
    }

    fn push_row(&mut self, row: Vec4) {
        self.words.extend(row.to_array().map(f32::to_bits));
    }
}

impl PackedPrint {
    /// Nothing is printed.
    pub(super) fn none() -> Self {
        Self { texels: NONE, ..Self::zeroed() }
    }
}
