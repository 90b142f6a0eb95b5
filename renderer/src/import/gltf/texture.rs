//! Base colour textures: images, how they are continued, and by which coordinates they lie.

use std::borrow::Cow;
use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

use glam::{Affine2, Mat2, Vec2};
use gltf::json;
use json::texture::{Info, WrappingMode};
use json::validation::Checked;

use super::accessor::Accessors;
use super::buffers::{data_uri, file_uri};
use crate::material::{Alpha, Image, ImageOrigin, Layout, Outside, Print, TexelBudget};

/// Which of a mesh's texture coordinates a texture lies by, and what becomes of them first.
#[derive(Clone, Copy, Debug)]
pub(super) struct CoordinateSet {
    /// The number n of `TEXCOORD_n`.
    pub(super) number: u32,
    transform: Affine2,
}

impl CoordinateSet {
    /// The set that `texture` asks for, moved as `KHR_texture_transform` says.
    pub(super) fn of(texture: &Info) -> Self {
        let extensions = texture.extensions.as_ref();
        let transform = extensions.and_then(|all| all.texture_transform.as_ref());
        let Some(transform) = transform else {
            return Self { number: texture.tex_coord, transform: Affine2::IDENTITY };
        };
        // Counter-clockwise where v points down.
        let turn = Mat2::from_angle(-transform.rotation.0);
        let scale = Mat2::from_diagonal(transform.scale.0.into());
        Self {
            number: transform.tex_coord.unwrap_or(texture.tex_coord),
            transform: Affine2::from_mat2_translation(turn * scale, transform.offset.0.into()),
        }
    }

    /// Where in the texture a vertex with these coordinates lies.
    pub(super) fn place(&self, coordinates: Vec2) -> Vec2 {
        self.transform.transform_point2(coordinates)
    }
}

/// The images of a document, each decoded when it is first asked for.
pub(super) struct Images<'a> {
    root: &'a json::Root,
    accessors: &'a Accessors<'a>,
    folder: &'a Path,
    budget: &'a mut TexelBudget,
    decoded: HashMap<(usize, Alpha), Arc<Image>>,
}

impl<'a> Images<'a> {
    /// Files are looked for relative to `folder`.
    pub(super) fn new(
        root: &'a json::Root,
        accessors: &'a Accessors<'a>,
        folder: &'a Path,
        budget: &'a mut TexelBudget,
    ) -> Self {
        Self { root, accessors, folder, budget, decoded: HashMap::new() }
    }

    /// The texture as a print, each texel multiplied by `tint`.
    pub(super) fn print(
        &mut self,
        texture: &Info,
        alpha: Alpha,
        tint: [f32; 3],
    ) -> Result<Print, String> {
        let index = texture.index.value();
        let missing = |what: &str| format!("texture {index} {what}; export again");
        let texture =
            self.root.textures.get(index).ok_or_else(|| missing("is named but does not exist"))?;
        let outside = match texture.sampler {
            None => [Outside::Repeat; 2],
            Some(sampler) => {
                let sampler = self.root.samplers.get(sampler.value());
                let sampler =
                    sampler.ok_or_else(|| missing("has a sampler that does not exist"))?;
                [outside(sampler.wrap_s), outside(sampler.wrap_t)]
            }
        };
        let image = self.image(texture.source.value(), alpha)?;
        Ok(Print { image, layout: Layout::Coordinates, outside, tint })
    }

    fn image(&mut self, index: usize, alpha: Alpha) -> Result<Arc<Image>, String> {
        if let Some(image) = self.decoded.get(&(index, alpha)) {
            return Ok(Arc::clone(image));
        }
        let json = self.root.images.get(index).ok_or_else(|| {
            "its texture has no PNG or JPEG image; export textures as one of them".to_owned()
        })?;
        let named = json.name.clone().filter(|name| !name.is_empty());
        let name = named.or_else(|| json.uri.clone().filter(|uri| !uri.starts_with("data:")));
        let name = name.unwrap_or_else(|| format!("image {index}"));
        let origin = ImageOrigin::Mesh(name.clone());
        let image = self
            .bytes(json)
            .and_then(|bytes| Image::decode(origin, &bytes, alpha, self.budget))
            .map_err(|fault| format!("image '{name}': {fault}"))?;
        let image = Arc::new(image);
        self.decoded.insert((index, alpha), Arc::clone(&image));
        Ok(image)
    }

    /// The image's file.
    fn bytes(&self, image: &json::Image) -> Result<Cow<'a, [u8]>, String> {
        match (&image.uri, image.buffer_view) {
            (Some(uri), _) if uri.starts_with("data:") => data_uri(uri).map(Cow::Owned),
            (Some(uri), _) => file_uri(uri, self.folder, Image::MAX_FILE_BYTES).map(Cow::Owned),
            (None, Some(view)) => self.accessors.view(view.value()).map(Cow::Borrowed),
            (None, None) => Err("it has neither URI nor buffer view; export again".to_owned()),
        }
    }
}

fn outside(wrapping: Checked<WrappingMode>) -> Outside {
    match wrapping {
        Checked::Valid(WrappingMode::ClampToEdge) => Outside::Edge,
        Checked::Valid(WrappingMode::MirroredRepeat) => Outside::Mirror,
        Checked::Valid(WrappingMode::Repeat) | Checked::Invalid => Outside::Repeat,
    }
}
