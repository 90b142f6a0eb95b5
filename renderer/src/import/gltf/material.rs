//! Materials: the KHR extensions of clear solids, and base colours of everything else.

use gltf::json;
use json::material::AlphaMode;
use json::texture::Info;
use json::validation::Checked;

use super::texture::Images;
use crate::material::{Alpha, Dielectric, Diffuse, Dispersion, Material};
use crate::spectrum::{Bins, Spectrum};

/// The Fraunhofer lines of the Abbe number, in nm.
const LAMBDA_F_NM: f64 = 486.1327;
const LAMBDA_D_NM: f64 = 587.5618;
const LAMBDA_C_NM: f64 = 656.2725;

/// Index of refraction where a file states none (`KHR_materials_ior`).
const DEFAULT_IOR: f32 = 1.5;
/// Largest index taken as meant: above every transparent solid.
const MAX_IOR: f32 = 5.0;
/// Longest wavelength at which the index must still be 1 or more.
const LAMBDA_MAX_NM: f64 = crate::spectrum::LAMBDA_MAX_NM as f64;

/// Material `index` of the document; without an index, glTF's default: white and opaque.
///
/// A clear solid is one with a transmission above 0 or, where the file states no transmission, with
/// a volume. Its base colour, roughness and textures are not used.
pub(super) fn material(
    root: &json::Root,
    images: &mut Images,
    index: Option<usize>,
) -> Result<Material, String> {
    let Some(index) = index else {
        return Ok(Material::Diffuse(Diffuse {
            reflectance: Spectrum::Rgb([1.0; 3]),
            print: None,
        }));
    };
    let material = root
        .materials
        .get(index)
        .ok_or_else(|| format!("material {index} does not exist; export again"))?;
    let name = material.name.clone().unwrap_or_else(|| format!("material {index}"));
    let place = |fault: String| format!("material '{name}': {fault}");
    if !is_clear(material) {
        return diffuse(images, material).map(Material::Diffuse).map_err(place);
    }
    let extensions = material.extensions.as_ref();
    let volume = extensions.and_then(|all| all.volume.as_ref());
    let ior = extensions.and_then(|all| all.ior.as_ref()).map_or(DEFAULT_IOR, |ior| ior.ior.0);
    let strength = extensions
        .and_then(|all| all.others.get("KHR_materials_dispersion"))
        .and_then(|extension| extension.get("dispersion"))
        .map_or(Some(0.0), json::Value::as_f64)
        .ok_or_else(|| place("its dispersion is not a number; export again".to_owned()))?;
    let absorption_per_mm = match volume {
        None => None,
        Some(volume) => {
            let color = color(volume.attenuation_color.0).map_err(place)?;
            absorption(color, volume.attenuation_distance.0).map_err(place)?
        }
    };
    let dispersion = dispersion(f64::from(ior), strength).map_err(place)?;
    Ok(Material::Dielectric(Dielectric { name, dispersion, absorption_per_mm }))
}

/// The texture of the base colour of material `index`, if it is opaque and has one.
pub(super) fn base_texture(root: &json::Root, index: Option<usize>) -> Option<&Info> {
    let material = root.materials.get(index?)?;
    let texture = material.pbr_metallic_roughness.base_color_texture.as_ref();
    texture.filter(|_| !is_clear(material))
}

fn is_clear(material: &json::Material) -> bool {
    let extensions = material.extensions.as_ref();
    let transmission = extensions.and_then(|all| all.transmission.as_ref());
    let volume = extensions.and_then(|all| all.volume.as_ref());
    transmission.map_or(volume.is_some(), |transmission| transmission.transmission_factor.0 > 0.0)
}

/// The base colour, or the texture that it is multiplied with, as a print on white.
fn diffuse(images: &mut Images, material: &json::Material) -> Result<Diffuse, String> {
    let base = &material.pbr_metallic_roughness;
    let [r, g, b, _] = base.base_color_factor.0;
    let factor = color([r, g, b])?;
    let Some(texture) = &base.base_color_texture else {
        return Ok(Diffuse { reflectance: Spectrum::Rgb(factor), print: None });
    };
    let alpha = match material.alpha_mode {
        Checked::Valid(AlphaMode::Mask | AlphaMode::Blend) => Alpha::OverWhite,
        Checked::Valid(AlphaMode::Opaque) | Checked::Invalid => Alpha::Ignored,
    };
    let print = images.print(texture, alpha, factor)?;
    Ok(Diffuse { reflectance: Spectrum::Flat(1.0), print: Some(print) })
}

fn color(rgb: [f32; 3]) -> Result<[f32; 3], String> {
    if rgb.iter().all(|channel| (0.0..=1.0).contains(channel)) {
        Ok(rgb)
    } else {
        Err(format!("the colour {rgb:?} is out of range; choose channels of 0 to 1"))
    }
}

/// Cauchy's n = A + B/λ² through `ior` at the d line with Abbe number 20/`strength`
/// (`KHR_materials_dispersion`).
fn dispersion(ior: f64, strength: f64) -> Result<Dispersion, String> {
    if !(1.0..=f64::from(MAX_IOR)).contains(&ior) {
        return Err(format!("the index of refraction {ior} is impossible; choose 1 to {MAX_IOR}"));
    }
    // V_d = (n_d − 1)/(n_F − n_C), and n_F − n_C = B·(1/λ_F² − 1/λ_C²).
    let n_f_minus_n_c = (ior - 1.0) * strength / 20.0;
    let b_nm2 = n_f_minus_n_c / (LAMBDA_F_NM.powi(-2) - LAMBDA_C_NM.powi(-2));
    let a = ior - b_nm2 / LAMBDA_D_NM.powi(2);
    let reddest = a + b_nm2 / LAMBDA_MAX_NM.powi(2);
    // Written so that a NaN fails.
    if strength >= 0.0 && reddest >= 1.0 {
        Ok(Dispersion::Cauchy { a, b_nm2 })
    } else {
        Err(format!(
            "a dispersion of {strength} is impossible at the index {ior}; choose 0 to 2 \
             (20 over the Abbe number: diamond has 0.36)"
        ))
    }
}

/// α(λ) = −ln T(λ)/distance (Beer–Lambert, `KHR_materials_volume`), per millimetre, where T is the
/// smooth transmittance that has the attenuation colour: white light is left with exactly that
/// colour after the attenuation distance.
fn absorption(color: [f32; 3], distance: f32) -> Result<Option<Spectrum>, String> {
    /// Least transmittance told from black, whose logarithm is infinite.
    const BLACK: f32 = 1e-4;
    if distance.is_nan() || distance <= 0.0 {
        return Err(format!(
            "the attenuation distance {distance} is impossible; choose one above 0"
        ));
    }
    if color == [1.0; 3] || distance.is_infinite() {
        return Ok(None);
    }
    // Every 5 nm, where a smooth spectrum is as good as straight lines.
    let samples = Bins::new(70);
    let transmittance = Spectrum::Rgb(color).bin_means(samples);
    Ok(Some(Spectrum::Tabulated {
        lambda_nm: (0..samples.count()).map(|i| samples.center_nm(i) as f32).collect(),
        value: transmittance.iter().map(|t| -t.clamp(BLACK, 1.0).ln() / distance).collect(),
    }))
}
