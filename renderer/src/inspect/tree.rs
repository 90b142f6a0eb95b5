//! The tree of rays of one pixel.

use glam::Vec3;
use serde::Serialize;

use super::end::RayEnd;
use super::names::{Name, Surface};
use super::recorder;
use super::request::RayTreeRequest;
use crate::error::RendererError;
use crate::packed::PackedScene;
use crate::settings::Splitting;
use crate::spectrum::Bins;
use crate::statistics::Ledger;

/// How a ray came to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum RayKind {
    /// It left the camera.
    Camera,
    /// It went through an interface.
    Refracted,
    /// It is the weak part that an interface threw back.
    Reflected,
    /// It met an interface beyond the critical angle.
    TotallyReflected,
}

/// A ray at one end of its interval of wavelengths.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RayEdge {
    /// Where it starts, in mm.
    pub origin_mm: Vec3,
    /// Where it ends, in mm; none where it meets no surface or was not followed.
    pub end_mm: Option<Vec3>,
    /// Unit vector.
    pub direction: Vec3,
}

/// One ray of the tree. Of what differs between its wavelengths, like place and direction, it tells that
/// of the central one.
///
/// By exact splitting it is a part of a fan whose wavelengths all meet the same: where they part at the
/// edge of a facet, the parts stand side by side, each as if the interface before had made it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RecordedRay {
    /// Its place in [`RayTree::rays`].
    pub id: u32,
    /// The ray that it came of; none for the camera ray.
    pub parent: Option<u32>,
    /// Interfaces met before it.
    pub depth: u32,
    /// How it came to be.
    pub kind: RayKind,
    /// The surface that it leaves; none for the camera ray.
    pub from: Option<Surface>,
    /// The object that it runs in; none for air.
    pub medium: Option<Name>,
    /// Where it starts, in mm.
    pub origin_mm: Vec3,
    /// Where it ends, in mm; none where it meets no surface or was not followed.
    pub end_mm: Option<Vec3>,
    /// How far that is.
    pub path_mm: Option<f32>,
    /// Unit vector.
    pub direction: Vec3,
    /// What leads from `direction` to about that of its longest wavelength, and backwards to that of
    /// its shortest.
    pub spread: Vec3,
    /// The angle between the directions of its shortest and its longest wavelength, in degrees.
    pub spread_degrees: f32,
    /// The same at its shortest and at its longest wavelength; by the paper's splitting, as its spread
    /// has them.
    pub edges: [RayEdge; 2],
    /// Its shortest wavelength, in nm.
    pub lambda_low_nm: f32,
    /// Its longest wavelength, in nm.
    pub lambda_high_nm: f32,
    /// The wavelength, in nm, of its middle ray. By the paper's splitting that is halfway; by exact
    /// splitting as refraction spaces them, or nearer to where total reflection begins.
    pub central_nm: f32,
    /// What its radiance counts in the pixel: the Fresnel factors so far, before the absorption that
    /// its path has still to pay for.
    pub significance: f32,
    /// The part of the camera ray's energy that it starts with: the significance of its wavelengths
    /// times its part of the spectrum.
    pub energy: f32,
    /// The part of that which was not its own: by exact splitting a weak ray is ended or lives on by
    /// chance, and one that lives carries the energy of those that do not. It is taken from what is
    /// booked as pruned.
    pub energy_gained: f32,
    /// What ended it.
    pub end: RayEnd,
    /// The part of the camera ray's energy that it ended with, which goes into the account that `end`
    /// names; 0 where other rays carry it on.
    pub energy_at_end: f32,
    /// The part of the camera ray's energy that is taken as absorbed at its end.
    pub energy_absorbed: f32,
    /// What it added to the pixel's radiance, bin by bin; empty where it added nothing.
    pub radiance_per_bin: Vec<f64>,
    /// Rays that came of it at its end but that the record had no place for: they, and all that
    /// came of them, are in the totals only.
    pub unrecorded_children: u32,
}

impl RecordedRay {
    /// Mean over the spectrum of what the ray added to the pixel's radiance.
    pub fn mean_radiance(&self) -> f64 {
        let sum: f64 = self.radiance_per_bin.iter().sum();
        sum / self.radiance_per_bin.len().max(1) as f64
    }
}

/// All that came of the camera ray of one pixel in one pass.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RayTree {
    /// Column and row of the pixel, counted from 0 at the upper left corner.
    pub pixel: [u32; 2],
    /// Width and height of the picture in pixels.
    pub size_px: [u32; 2],
    /// The pass, counted from 0.
    pub pass_index: u32,
    /// How rays are divided.
    pub splitting: Splitting,
    /// Ends of the film's bins, in nm: one more than there are bins.
    pub bin_edges_nm: Vec<f32>,
    /// What the pass adds to the pixel's film, bin by bin.
    pub radiance_per_bin: Vec<f32>,
    /// Where the camera ray's energy went.
    pub ledger: Ledger,
    /// Ray segments traced: the rays that were followed and the shadow rays of matte surfaces.
    pub segments: u32,
    /// Whether there were more rays than the record takes. All totals are whole nevertheless.
    pub is_truncated: bool,
    /// Rays that the record does not show.
    pub unrecorded_rays: u64,
    /// The rays, each before those that came of it, which follow in the order in which the
    /// interface made them: low wavelengths first, and as a rule reflected before refracted.
    pub rays: Vec<RecordedRay>,
}

impl RayTree {
    /// Most rays that a tree shows: some hundred megabytes.
    pub const MAX_RAYS: usize = 200_000;

    /// Traces the tree with at most `max_rays` recorded rays (at least one).
    ///
    /// # Errors
    /// The pixel is outside of the picture, or the scene can't be traced.
    pub fn trace(request: &RayTreeRequest, max_rays: usize) -> Result<Self, RendererError> {
        let packed = PackedScene::new(&request.scene, Bins::new(request.trace.bins))?;
        Self::trace_packed(request, &packed, max_rays, &|| false)
    }

    /// [`trace`](Self::trace) in a scene that is packed already: the request's, with its bins.
    /// `is_cancelled` is asked before each ray.
    ///
    /// # Errors
    /// As for `trace`; [`RendererError::Cancelled`] as soon as `is_cancelled` says so.
    pub fn trace_packed(
        request: &RayTreeRequest,
        packed: &PackedScene,
        max_rays: usize,
        is_cancelled: &dyn Fn() -> bool,
    ) -> Result<Self, RendererError> {
        recorder::trace(request, packed, max_rays.max(1), is_cancelled)
    }

    /// The ray and those that it came of, up to the camera ray.
    pub fn path_to_camera(&self, id: u32) -> impl Iterator<Item = &RecordedRay> {
        std::iter::successors(self.rays.get(id as usize), |ray| {
            ray.parent.and_then(|parent| self.rays.get(parent as usize))
        })
    }
}
