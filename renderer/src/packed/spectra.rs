//! Packing of everything spectral: materials, lights and the ground's colours.

use std::f32::consts::PI;

use super::axis::Axis;
use super::prints::PrintWords;
use super::{
    INDEX_TABLE_LEN, NONE, PackedDisc, PackedGround, PackedMaterial, PackedPrint, PackedSky,
};
use crate::error::RendererError;
use crate::light::{Lights, SkyLight};
use crate::material::{Dielectric, Material};
use crate::scene::{Ground, Object, Scene, Shape};
use crate::spectrum::{Bins, LAMBDA_MIN_NM, Spectrum};

/// Rows of bin means, built up one spectrum at a time.
pub(super) struct SpectrumRows {
    bins: Bins,
    values: Vec<f32>,
}

impl SpectrumRows {
    pub(super) fn new(bins: Bins) -> Self {
        Self { bins, values: Vec::new() }
    }

    pub(super) fn into_values(self) -> Vec<f32> {
        self.values
    }

    /// Appends `spectrum` times `scale` and returns its row. `what` names it in errors.
    pub(super) fn push(
        &mut self,
        what: &str,
        spectrum: &Spectrum,
        scale: f32,
    ) -> Result<u32, RendererError> {
        spectrum
            .validate()
            .map_err(|fault| RendererError::Invalid(format!("spectrum of {what}: {fault}")))?;
        if !(scale.is_finite() && scale >= 0.0) {
            return Err(RendererError::Invalid(format!(
                "{what}: radiance {scale} must be a finite number of 0 or more"
            )));
        }
        let row = self.values.len() / self.bins.count();
        self.values.extend(spectrum.bin_means(self.bins).iter().map(|mean| mean * scale));
        Ok(row as u32)
    }

    /// The values of a row; none for [`NONE`].
    fn row(&self, row: u32) -> &[f32] {
        if row == NONE {
            return &[];
        }
        let start = row as usize * self.bins.count();
        &self.values[start..start + self.bins.count()]
    }

    fn push_sky(&mut self, what: &str, sky: Option<&SkyLight>) -> Result<u32, RendererError> {
        sky.map_or(Ok(NONE), |light| self.push(what, &light.spectrum, light.radiance))
    }
}

/// The different materials of a scene; their index tables are still apart from the spectra.
pub(super) struct PackedMaterials {
    pub(super) materials: Vec<PackedMaterial>,
    pub(super) index_tables: Vec<f32>,
    /// Index into `materials` per object.
    pub(super) of_object: Vec<u32>,
}

impl PackedMaterials {
    /// n(λ) of a clear material at every nm.
    pub(super) fn indices_of(&self, material: u32) -> &[f32] {
        let start = self.materials[material as usize].index_table as usize;
        &self.index_tables[start..start + INDEX_TABLE_LEN]
    }

    /// The materials, with their index tables behind `rows`: at every nm, then along the axis.
    pub(super) fn behind(
        mut self,
        mut rows: Vec<f32>,
        axis: &Axis,
    ) -> (Vec<PackedMaterial>, Vec<f32>) {
        for material in self.materials.iter_mut().filter(|material| !material.is_opaque()) {
            let start = material.index_table as usize;
            material.index_table = rows.len() as u32;
            let table = &self.index_tables[start..start + INDEX_TABLE_LEN];
            rows.extend(table);
            rows.extend(axis.indices(table));
        }
        (self.materials, rows)
    }
}

/// Packs every material once, however many objects are made of it.
pub(super) fn pack_materials(
    scene: &Scene,
    spectra: &mut SpectrumRows,
    prints: &mut PrintWords,
) -> Result<PackedMaterials, RendererError> {
    let (mut materials, mut index_tables, mut of_object) = (Vec::new(), Vec::new(), Vec::new());
    for (i, object) in scene.objects.iter().enumerate() {
        let twin = scene.objects[..i].iter().position(|other| share_material(other, object));
        if let Some(twin) = twin {
            of_object.push(of_object[twin]);
            continue;
        }
        of_object.push(materials.len() as u32);
        materials.push(match &object.material {
            Material::Dielectric(dielectric) => {
                pack_dielectric(&object.name, dielectric, spectra, &mut index_tables)?
            }
            Material::Diffuse(diffuse) => PackedMaterial {
                index_table: NONE,
                absorption: NONE,
                reflectance: spectra.push(&object.name, &diffuse.reflectance, 1.0)?,
                least_absorption: 0.0,
                print: match &diffuse.print {
                    Some(print) => prints.push(object, print, spectra)?,
                    None => PackedPrint::none(),
                },
            },
        });
    }
    Ok(PackedMaterials { materials, index_tables, of_object })
}

/// Whether one packed material does for both objects: what is printed by a mesh's own coordinates
/// is as different as the meshes.
fn share_material(one: &Object, other: &Object) -> bool {
    if !one.is_printed_by_coordinates() {
        return one.material == other.material;
    }
    match (&one.shape, &other.shape) {
        (Shape::Mesh(source), Shape::Mesh(other_source)) => {
            source == other_source && one.material == other.material
        }
        _ => false,
    }
}

fn pack_dielectric(
    object: &str,
    dielectric: &Dielectric,
    spectra: &mut SpectrumRows,
    index_tables: &mut Vec<f32>,
) -> Result<PackedMaterial, RendererError> {
    dielectric.dispersion.validate().map_err(|fault| {
        RendererError::Invalid(format!("{object}: material {}: {fault}", dielectric.name))
    })?;
    let index_table = index_tables.len() as u32;
    index_tables.extend((0..INDEX_TABLE_LEN).map(|i| {
        let lambda_nm = f64::from(LAMBDA_MIN_NM) + i as f64;
        dielectric.dispersion.n(lambda_nm) as f32
    }));
    let absorption = match &dielectric.absorption_per_mm {
        Some(absorption) => spectra.push(&format!("absorption of {object}"), absorption, 1.0)?,
        None => NONE,
    };
    let least_absorption = spectra.row(absorption).iter().copied().fold(f32::INFINITY, f32::min);
    Ok(PackedMaterial {
        index_table,
        absorption,
        reflectance: NONE,
        least_absorption: if absorption == NONE { 0.0 } else { least_absorption },
        print: PackedPrint::none(),
    })
}

pub(super) fn pack_discs(
    lights: &Lights,
    spectra: &mut SpectrumRows,
) -> Result<Vec<PackedDisc>, RendererError> {
    lights
        .discs
        .iter()
        .map(|disc| {
            let invalid =
                |fault: &str| RendererError::Invalid(format!("light {:?}: {fault}", disc.name));
            let direction = disc
                .direction
                .try_normalize()
                .ok_or_else(|| invalid("the direction must be a vector of some length"))?;
            if !(disc.angular_radius_radians > 0.0 && disc.angular_radius_radians <= 0.5 * PI) {
                return Err(invalid("the angular radius must be above 0° and at most 90°"));
            }
            Ok(PackedDisc {
                direction,
                cos_radius: disc.angular_radius_radians.cos(),
                sin_squared_radius: disc.angular_radius_radians.sin().powi(2),
                solid_angle: disc.solid_angle_steradians(),
                spectrum: spectra.push(&disc.name, &disc.spectrum, disc.radiance)?,
                first_passage: 0,
                passage_count: 0,
                padding: [0; 3],
            })
        })
        .collect()
}

pub(super) fn pack_sky(
    lights: &Lights,
    spectra: &mut SpectrumRows,
) -> Result<PackedSky, RendererError> {
    let smallest_radius =
        lights.discs.iter().map(|disc| disc.angular_radius_radians).fold(0.5 * PI, f32::min);
    let shadow = lights.observer_shadow_radians.clamp(0.0, 0.5 * PI);
    Ok(PackedSky {
        hemisphere: spectra.push_sky("the hemisphere", lights.hemisphere.as_ref())?,
        environment: spectra.push_sky("the environment", lights.environment.as_ref())?,
        backdrop: spectra.push_sky("the backdrop", lights.backdrop.as_ref())?,
        light_spread: 2.0 * smallest_radius,
        cos_observer_shadow: shadow.cos(),
        sin_squared_observer_shadow: shadow.sin().powi(2),
        padding: [0; 2],
    })
}

pub(super) fn pack_ground(
    ground: Option<&Ground>,
    spectra: &mut SpectrumRows,
) -> Result<PackedGround, RendererError> {
    let Some(ground) = ground else {
        return Ok(PackedGround { height: 0.0, square: 1.0, reflectance: [NONE; 2] });
    };
    if !(ground.square > 0.0 && ground.square.is_finite() && ground.height.is_finite()) {
        return Err(RendererError::Invalid(
            "ground: the square must be longer than 0 mm and the height finite".to_owned(),
        ));
    }
    let mut row = |i: usize| spectra.push("the ground", &ground.reflectance[i], 1.0);
    Ok(PackedGround {
        height: ground.height,
        square: ground.square,
        reflectance: [row(0)?, row(1)?],
    })
}
