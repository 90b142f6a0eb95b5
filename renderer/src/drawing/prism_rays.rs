//! A white ray through a prism, as the program's own tracer divides it.

use std::ops::RangeInclusive;
use std::sync::Arc;

use glam::{DVec2, DVec3, Vec3};

use crate::camera::Camera;
use crate::error::RendererError;
use crate::inspect::{RayKind, RayTree, RayTreeRequest, RecordedRay};
use crate::light::{DiscLight, Lights};
use crate::material::{Dielectric, Dispersion, Material};
use crate::scene::{Object, Scene, Shape, Transform};
use crate::settings::{Splitting, TraceSettings};
use crate::solid::HalfSpace;
use crate::spectrum::{Illuminant, Spectrum};

/// Height of the top and of the base over the origin, in mm; a wide prism ends below the top.
const TOP_MM: f64 = 10.0;
const BASE_MM: f64 = -10.0;
/// Half the distance between the sides at the height of the origin, in mm.
const HALF_WIDTH_MM: f64 = 6.0;
/// Half the length of the prism, in mm.
const HALF_LENGTH_MM: f64 = 10.0;
/// How far from the prism the ray starts, in mm.
const START_MM: f64 = 60.0;
/// Rays weaker than this are not followed: the diagram leaves reflections out.
const SIGNIFICANCE: f32 = 0.1;
/// Interfaces that a ray is followed over: in, two total reflections, out.
const MAX_DEPTH: u32 = 4;
const MAX_RAYS: usize = 40_000;

/// A prism with its apex up, cut off where that is far up, the ray that meets its left side, and how
/// rays are divided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrismSetup {
    /// Angle between the two sides, in degrees.
    pub apex_degrees: f64,
    /// Index at the D line.
    pub n_d: f64,
    /// Index at the G line less that at the B line. No glass has as much as makes a good picture.
    pub dispersion_bg: f64,
    /// Angle of incidence in degrees, positive from the side of the base.
    pub incidence_degrees: f64,
    /// Diameter of the smallest lamp, in degrees: what the sub-rays must be fine enough for.
    pub lamp_degrees: f64,
    /// K of the paper: sub-rays that should hit that lamp.
    pub split_count: f64,
}

impl PrismSetup {
    /// Allowed [`apex_degrees`](Self::apex_degrees).
    pub const APEX_DEGREES: RangeInclusive<f64> = 1.0..=75.0;
    /// Allowed [`n_d`](Self::n_d).
    pub const N_D: RangeInclusive<f64> = 1.3..=2.6;
    /// Allowed [`dispersion_bg`](Self::dispersion_bg).
    pub const DISPERSION_BG: RangeInclusive<f64> = 0.0..=0.4;
    /// Allowed [`incidence_degrees`](Self::incidence_degrees).
    pub const INCIDENCE_DEGREES: RangeInclusive<f64> = -80.0..=80.0;
    /// Allowed [`lamp_degrees`](Self::lamp_degrees).
    pub const LAMP_DEGREES: RangeInclusive<f64> = 0.5..=20.0;
    /// Allowed [`split_count`](Self::split_count).
    pub const SPLIT_COUNT: RangeInclusive<f64> = 0.5..=8.0;

    /// An equilateral prism near minimum deviation, where sub-rays that all keep their parent's
    /// direction leave in clumps with gaps between them.
    pub const CLUMPING: Self = Self {
        apex_degrees: 60.0,
        n_d: 1.5,
        dispersion_bg: 0.14,
        incidence_degrees: 52.0,
        lamp_degrees: 6.0,
        split_count: 3.0,
    };
    /// A wedge that is nearly a plate, which would send all wavelengths on in one direction: the
    /// second side undoes what the first one does, but not for sub-rays that all keep their parent's
    /// direction. Each fan is turned round and crosses its neighbours.
    pub const CROSSING: Self = Self {
        apex_degrees: 4.0,
        n_d: 1.5,
        dispersion_bg: 0.3,
        incidence_degrees: 65.0,
        lamp_degrees: 6.0,
        split_count: 3.5,
    };

    /// Corners of the cross-section, in turn; x to the right, y up, in mm. The apex is cut off where
    /// it lies far up.
    pub fn corners(&self) -> Vec<DVec2> {
        let half_width = |y: f64| HALF_WIDTH_MM - y * self.half_apex().tan();
        let apex_y = HALF_WIDTH_MM / self.half_apex().tan();
        let base = half_width(BASE_MM);
        let mut corners = vec![DVec2::new(-base, BASE_MM), DVec2::new(base, BASE_MM)];
        if apex_y > TOP_MM {
            let top = half_width(TOP_MM);
            corners.extend([DVec2::new(top, TOP_MM), DVec2::new(-top, TOP_MM)]);
        } else {
            corners.push(DVec2::new(0.0, apex_y));
        }
        corners
    }

    /// The unit vector along which the ray arrives.
    pub fn arrival(&self) -> DVec2 {
        let inward = DVec2::from_angle(-self.half_apex());
        let (sin, cos) = self.incidence_degrees.to_radians().sin_cos();
        inward * cos + inward.perp() * sin
    }

    /// Where the ray meets the prism: the farther down, the more it rises inside.
    pub fn entry(&self) -> DVec2 {
        let y = -4.0 * self.incidence_degrees.to_radians().sin();
        DVec2::new(y * self.half_apex().tan() - HALF_WIDTH_MM, y)
    }

    fn half_apex(&self) -> f64 {
        0.5 * self.apex_degrees.to_radians()
    }

    fn scene(&self) -> Scene {
        let (sin, cos) = self.half_apex().sin_cos();
        let plane = |x: f64, y: f64, z: f64, distance: f64, name: &str| HalfSpace {
            normal: DVec3::new(x, y, z),
            distance,
            name: name.to_owned(),
        };
        let prism = Object {
            name: "Prism".to_owned(),
            shape: Shape::Polyhedron(vec![
                plane(-cos, 0.0, sin, HALF_WIDTH_MM * cos, "left"),
                plane(cos, 0.0, sin, HALF_WIDTH_MM * cos, "right"),
                plane(0.0, 0.0, 1.0, TOP_MM, "top"),
                plane(0.0, 0.0, -1.0, -BASE_MM, "base"),
                plane(0.0, -1.0, 0.0, HALF_LENGTH_MM, "front"),
                plane(0.0, 1.0, 0.0, HALF_LENGTH_MM, "back"),
            ]),
            transform: Transform::default(),
            material: Material::Dielectric(Dielectric {
                name: "Glass".to_owned(),
                dispersion: Dispersion::Linear { n_d: self.n_d, dispersion_bg: self.dispersion_bg },
                absorption_per_mm: None,
            }),
            throws_light: false,
        };
        let lamp = DiscLight {
            name: "Lamp".to_owned(),
            // Only its size matters, so it stands where no ray of the diagram goes.
            direction: Vec3::Y,
            angular_radius_radians: (0.5 * self.lamp_degrees).to_radians() as f32,
            radiance: 1.0,
            spectrum: Spectrum::Illuminant(Illuminant::E),
        };
        let lights = Lights { discs: vec![lamp], ..Lights::default() };
        Scene { objects: vec![prism], lights, ..Scene::default() }
    }
}

/// A part of the white ray, in the plane of the cross-section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrismRay {
    /// Where it starts, in mm.
    pub from: DVec2,
    /// Where it ends; none where it goes on for ever.
    pub to: Option<DVec2>,
    /// Unit vector along it.
    pub direction: DVec2,
    /// From `direction` to that of its longest wavelength.
    pub spread: DVec2,
    /// Its shortest and longest wavelength in nm.
    pub interval_nm: [f64; 2],
    /// Which of the rays before it it is a part of; those of one parent leave from one point.
    pub parent: u32,
}

impl PrismRay {
    /// How far it is turned from `arrival`, clockwise, in degrees.
    pub fn deviation_degrees(&self, arrival: DVec2) -> f64 {
        self.direction.angle_to(arrival).to_degrees()
    }

    /// The deviations of its shortest and longest wavelength.
    pub fn deviation_interval(&self, arrival: DVec2) -> [f64; 2] {
        [-1.0, 1.0].map(|end| (self.direction + end * self.spread).angle_to(arrival).to_degrees())
    }
}

/// What becomes of the white ray, but for the weak reflections.
#[derive(Clone, Debug, PartialEq)]
pub struct PrismRays {
    /// The unit vector along which the white ray arrives.
    pub arrival: DVec2,
    /// The white ray.
    pub white: PrismRay,
    /// Rays inside of the prism.
    pub inside: Vec<PrismRay>,
    /// Rays that have left it, in the order of their wavelengths.
    pub leaving: Vec<PrismRay>,
}

impl PrismRays {
    /// Traces the ray with or without `perturb`.
    ///
    /// # Errors
    /// Values that make no prism or no glass.
    pub fn trace(setup: &PrismSetup, perturb: bool) -> Result<Self, RendererError> {
        let (arrival, entry) = (setup.arrival(), setup.entry());
        let in_space = |point: DVec2| Vec3::new(point.x as f32, 0.0, point.y as f32);
        // The ray of the middle pixel runs from the eye to the target.
        let camera = Camera {
            position: in_space(entry - START_MM * arrival),
            target: in_space(entry),
            up: Vec3::Y,
            ..Camera::default()
        };
        let request = RayTreeRequest {
            scene: Arc::new(setup.scene()),
            camera,
            size: [1, 1],
            pixel: [0, 0],
            pass_index: 0,
            trace: TraceSettings {
                splitting: Splitting::Paper,
                split_count: setup.split_count as f32,
                significance_threshold: SIGNIFICANCE,
                max_depth: MAX_DEPTH,
                perturb,
                ..TraceSettings::default()
            },
        };
        Ok(Self::of_tree(&RayTree::trace(&request, MAX_RAYS)?, arrival))
    }

    fn of_tree(tree: &RayTree, arrival: DVec2) -> Self {
        let mut is_drawn = vec![false; tree.rays.len()];
        let mut rays =
            Self { arrival, white: flat(&tree.rays[0]), inside: vec![], leaving: vec![] };
        is_drawn[0] = true;
        for ray in &tree.rays[1..] {
            let comes_of_drawn = ray.parent.is_some_and(|parent| is_drawn[parent as usize]);
            if !comes_of_drawn || ray.kind == RayKind::Reflected {
                continue;
            }
            is_drawn[ray.id as usize] = true;
            if ray.medium.is_none() {
                rays.leaving.push(flat(ray));
            } else if ray.end_mm.is_some() {
                rays.inside.push(flat(ray));
            }
        }
        rays.leaving.sort_by(|a, b| a.interval_nm[0].total_cmp(&b.interval_nm[0]));
        rays
    }

    /// The least and the greatest deviation of what leaves, in degrees; `None` if nothing does.
    pub fn deviations(&self) -> Option<[f64; 2]> {
        let ends = self.leaving.iter().flat_map(|ray| ray.deviation_interval(self.arrival));
        ends.fold(None, |span: Option<[f64; 2]>, degrees| {
            let [low, high] = span.unwrap_or([degrees, degrees]);
            Some([low.min(degrees), high.max(degrees)])
        })
    }

    /// The part of the leaving fan, in 0..=1, that no ray covers with its own spread: the gaps
    /// between the clumps.
    pub fn uncovered(&self) -> f64 {
        let mut intervals: Vec<[f64; 2]> = self
            .leaving
            .iter()
            .map(|ray| ray.deviation_interval(self.arrival))
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        intervals.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let Some(&[first, mut reached]) = intervals.first() else { return 0.0 };
        let mut gaps = 0.0;
        for [low, high] in intervals {
            gaps += (low - reached).max(0.0);
            reached = reached.max(high);
        }
        if reached > first { gaps / (reached - first) } else { 0.0 }
    }

    /// Pairs of leaving rays that cross within `reach_mm` of where they leave.
    pub fn crossings(&self, reach_mm: f64) -> usize {
        let rays = &self.leaving;
        let crosses = |a: &PrismRay, b: &PrismRay| {
            let turn = a.direction.perp_dot(b.direction);
            let offset = b.from - a.from;
            // Rays that leave from one point part there.
            if turn.abs() < 1e-9 || offset.length() < 1e-4 {
                return false;
            }
            let (t, u) = (offset.perp_dot(b.direction) / turn, offset.perp_dot(a.direction) / turn);
            t > 0.0 && t < reach_mm && u > 0.0 && u < reach_mm
        };
        let pairs = rays.iter().enumerate();
        pairs.map(|(i, a)| rays[..i].iter().filter(|b| crosses(a, b)).count()).sum()
    }
}

/// A ray of the tree in the plane.
fn flat(ray: &RecordedRay) -> PrismRay {
    let plane = |point: Vec3| DVec2::new(f64::from(point.x), f64::from(point.z));
    PrismRay {
        from: plane(ray.origin_mm),
        to: ray.end_mm.map(plane),
        direction: plane(ray.direction),
        spread: plane(ray.spread),
        interval_nm: [f64::from(ray.lambda_low_nm), f64::from(ray.lambda_high_nm)],
        parent: ray.parent.unwrap_or_default(),
    }
}
