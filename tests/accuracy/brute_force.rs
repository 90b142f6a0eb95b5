//! The whole tree of one camera ray at one wavelength.

use brilliance_renderer::scene::Scene;
use glam::DVec3;

use crate::bodies::{Body, Meeting};
use crate::emitters::{Emitters, Shares};
use crate::interface::Interface;

/// Part of the camera ray's weight below which a ray ends.
const LEAST_SIGNIFICANCE: f64 = 1e-6;
/// Part of the camera ray's weight from which an end counts among [`Seen::ends`].
const LEAF_SIGNIFICANCE: f64 = 3e-5;
/// Interfaces after which a ray that never weakens ends.
const MAX_DEPTH: u32 = 2000;

/// A scene for rays of one wavelength. Bodies are clear and stand apart; the ground is matte and far
/// enough below them to lie in no shadow.
pub(crate) struct World {
    bodies: Vec<Body>,
    ground: Option<Checker>,
    pub(crate) emitters: Emitters,
}

struct Checker {
    height: f64,
    square: f64,
    reflectance: [f64; 2],
}

/// What one wavelength's tree comes to.
#[derive(Clone, Debug, Default)]
pub(crate) struct Seen {
    pub(crate) shares: Shares,
    /// The rays that end at the lights and count, by their paths.
    pub(crate) ends: Vec<Leaf>,
    /// Rays followed.
    pub(crate) segments: u64,
}

/// A ray that ends at the lights.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Leaf {
    /// A word for the facets that its path has met, and for what it did there.
    pub(crate) path: u64,
    pub(crate) direction: DVec3,
    pub(crate) significance: f64,
}

struct Ray {
    origin: DVec3,
    direction: DVec3,
    significance: f64,
    /// The body that it runs in.
    medium: Option<usize>,
    depth: u32,
    path: u64,
}

enum End {
    Body(usize, Meeting),
    Ground(DVec3),
    Nothing,
}

impl World {
    /// `observer` points from the scene towards the camera.
    pub(crate) fn new(scene: &Scene, observer: DVec3) -> Self {
        let ground = scene.ground.as_ref().map(|ground| Checker {
            height: ground.height.into(),
            square: ground.square.into(),
            reflectance: ground.reflectance.each_ref().map(|color| color.at(550.0).into()),
        });
        Self {
            bodies: scene.objects.iter().map(Body::new).collect(),
            ground,
            emitters: Emitters::new(&scene.lights, observer),
        }
    }

    /// Whether a camera ray meets a body.
    pub(crate) fn shows_body(&self, origin: DVec3, direction: DVec3) -> bool {
        self.bodies.iter().any(|body| body.enter(origin, direction).is_some())
    }

    /// Follows a camera ray and all that comes of it at one wavelength.
    pub(crate) fn look(&self, origin: DVec3, direction: DVec3, lambda_nm: f64) -> Seen {
        let indices: Vec<f64> =
            self.bodies.iter().map(|body| body.dispersion.n(lambda_nm)).collect();
        let mut seen = Seen::default();
        let camera_ray =
            Ray { origin, direction, significance: 1.0, medium: None, depth: 0, path: 0 };
        let mut waiting = vec![camera_ray];
        while let Some(ray) = waiting.pop() {
            seen.segments += 1;
            match self.end_of(&ray) {
                End::Body(body, meeting) => {
                    for part in fork(&ray, body, &meeting, &indices) {
                        if part.significance >= LEAST_SIGNIFICANCE && part.depth <= MAX_DEPTH {
                            waiting.push(part);
                        }
                    }
                }
                End::Ground(point) => {
                    let reflectance = self.ground_reflectance(point);
                    self.emitters.add_matte(reflectance, ray.significance, &mut seen.shares);
                }
                End::Nothing if ray.depth == 0 => {
                    self.emitters.add_background(ray.direction, &mut seen.shares);
                }
                End::Nothing => {
                    self.emitters.add_seen(ray.direction, ray.significance, &mut seen.shares);
                    let Ray { path, direction, significance, .. } = ray;
                    if significance >= LEAF_SIGNIFICANCE {
                        seen.ends.push(Leaf { path, direction, significance });
                    }
                }
            }
        }
        seen.ends.sort_unstable_by_key(|leaf| leaf.path);
        seen
    }

    /// The next surface along a ray. Inside a body that is always the body's own.
    fn end_of(&self, ray: &Ray) -> End {
        if let Some(medium) = ray.medium {
            let meeting = self.bodies[medium].leave(ray.origin, ray.direction);
            return End::Body(medium, meeting.expect("a body is closed"));
        }
        let meetings = self.bodies.iter().enumerate().filter_map(|(i, body)| {
            body.enter(ray.origin, ray.direction).map(|meeting| (i, meeting))
        });
        if let Some((body, meeting)) = meetings.min_by(|a, b| a.1.distance.total_cmp(&b.1.distance))
        {
            return End::Body(body, meeting);
        }
        match &self.ground {
            Some(ground) if ray.direction.z < 0.0 => {
                let distance = (ground.height - ray.origin.z) / ray.direction.z;
                End::Ground(ray.origin + ray.direction * distance)
            }
            _ => End::Nothing,
        }
    }

    fn ground_reflectance(&self, point: DVec3) -> f64 {
        self.ground.as_ref().map_or(0.0, |ground| {
            let square = (point / ground.square).floor();
            ground.reflectance[(square.x + square.y).rem_euclid(2.0) as usize]
        })
    }
}

/// The reflected and the refracted part of a ray.
fn fork(ray: &Ray, body: usize, meeting: &Meeting, indices: &[f64]) -> [Ray; 2] {
    let is_inside = ray.medium == Some(body);
    let index_of = |medium: Option<usize>| medium.map_or(1.0, |body| indices[body]);
    let medium_beyond = if is_inside { None } else { Some(body) };
    let normal = if is_inside { -meeting.normal } else { meeting.normal };
    let at = Interface::new(ray.direction, normal, index_of(ray.medium), index_of(medium_beyond));
    let part = |direction, weight: f64, medium| Ray {
        origin: ray.origin + ray.direction * meeting.distance,
        direction,
        significance: ray.significance * weight,
        medium,
        depth: ray.depth + 1,
        path: path_beyond(ray.path, body, meeting.facet, medium == ray.medium),
    };
    [
        part(at.reflected, at.reflectance, ray.medium),
        part(at.refracted, 1.0 - at.reflectance, medium_beyond),
    ]
}

/// The word for a path that has met one more facet.
fn path_beyond(path: u64, body: usize, facet: usize, is_reflected: bool) -> u64 {
    let step = ((body as u64) << 32 | facet as u64) << 1 | u64::from(is_reflected);
    // A bijection, whose high bits depend on all of the step's (Knuth's multiplicative hashing).
    (path.rotate_left(23) ^ step).wrapping_mul(0x9e37_79b9_7f4a_7c15)
}
