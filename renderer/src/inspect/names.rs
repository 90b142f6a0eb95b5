//! What the user calls the surfaces and lights that the tracers know by number.

use std::collections::HashMap;
use std::fmt::{self, Display, Formatter};
use std::ops::Deref;
use std::sync::Arc;

use serde::{Serialize, Serializer};

use crate::error::RendererError;
use crate::kernel::ray::GROUND;
use crate::packed::NONE;
use crate::scene::{Object, Scene, Shape};

/// A name that many rays share.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name(Arc<str>);

impl Name {
    pub(super) fn new(text: &str) -> Self {
        Self(text.into())
    }
}

impl Deref for Name {
    type Target = str;

    fn deref(&self) -> &str {
        &self.0
    }
}

impl Display for Name {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(self)
    }
}

impl Serialize for Name {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self)
    }
}

/// A flat part of the scene's surface.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Surface {
    /// Name of the object, or "ground".
    pub object: Name,
    /// Name of its facet: as the cut calls it, or a number; none for the ground.
    pub facet: Option<Name>,
}

impl Display for Surface {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match &self.facet {
            Some(facet) => write!(f, "{}: {facet}", self.object),
            None => write!(f, "{}", self.object),
        }
    }
}

struct Body {
    name: Name,
    /// Names of a convex solid's facets; empty for a mesh.
    facets: Vec<Name>,
}

/// The names of a scene.
pub(super) struct Names {
    bodies: Vec<Body>,
    lamps: Vec<Name>,
    ground: Name,
    pub(super) hemisphere: Name,
    pub(super) environment: Name,
    numbered: HashMap<u32, Name>,
}

impl Names {
    /// The names in `scene`, in the order in which it is packed.
    ///
    /// # Errors
    /// An object is no closed body; the text names it.
    pub(super) fn new(scene: &Scene) -> Result<Self, RendererError> {
        let bodies = scene
            .objects
            .iter()
            .map(|object| Ok(Body { name: Name::new(&object.name), facets: facet_names(object)? }))
            .collect::<Result<_, RendererError>>()?;
        Ok(Self {
            bodies,
            lamps: scene.lights.discs.iter().map(|disc| Name::new(&disc.name)).collect(),
            ground: Name::new("ground"),
            hemisphere: Name::new("hemisphere"),
            environment: Name::new("environment"),
            numbered: HashMap::new(),
        })
    }

    /// The facet of an instance, as rays and hits name it.
    pub(super) fn surface(&mut self, instance: u32, facet: u32) -> Option<Surface> {
        if instance == GROUND {
            return Some(Surface { object: self.ground.clone(), facet: None });
        }
        let body = self.bodies.get(instance as usize)?;
        let facet = (facet != NONE).then(|| match body.facets.get(facet as usize) {
            Some(name) if !name.is_empty() => name.clone(),
            _ => self
                .numbered
                .entry(facet)
                .or_insert_with(|| Name::new(&format!("facet {}", facet + 1)))
                .clone(),
        });
        Some(Surface { object: body.name.clone(), facet })
    }

    /// The object that a ray runs in; none for air.
    pub(super) fn object(&self, instance: u32) -> Option<Name> {
        self.bodies.get(instance as usize).map(|body| body.name.clone())
    }

    /// The lamp of a disc.
    pub(super) fn lamp(&self, disc: usize) -> Name {
        self.lamps[disc].clone()
    }
}

/// Names of the facets that are left of an object's half-spaces, in the order in which they are
/// packed.
fn facet_names(object: &Object) -> Result<Vec<Name>, RendererError> {
    if matches!(object.shape, Shape::Mesh(_)) {
        return Ok(Vec::new());
    }
    let solid = object.solid()?;
    Ok(solid.facets.iter().map(|facet| Name::new(&facet.half_space.name)).collect())
}
