//! Where the scene is, for the camera.

use brilliance_renderer::scene::{Object, Scene, Shape};
use glam::Vec3;

/// A ball that holds every object of a scene; the eye stays outside it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Centre, in millimetres.
    pub centre: Vec3,
    /// Radius, in millimetres; positive.
    pub radius: f32,
}

/// Room for a scene without objects: that of a one-carat diamond.
const EMPTY: Bounds = Bounds { centre: Vec3::ZERO, radius: 3.5 };

impl Bounds {
    /// The ball about all objects of `scene`; not the smallest one, but never too small.
    pub fn of(scene: &Scene) -> Self {
        scene.objects.iter().map(object).reduce(Self::joined).unwrap_or(EMPTY)
    }

    /// The smallest ball that holds both.
    fn joined(self, other: Self) -> Self {
        let offset = other.centre - self.centre;
        let distance = offset.length();
        if distance + other.radius <= self.radius {
            return self;
        }
        if distance + self.radius <= other.radius {
            return other;
        }
        let radius = 0.5 * (distance + self.radius + other.radius);
        let centre = self.centre + offset * ((radius - self.radius) / distance);
        Self { centre, radius }
    }
}

fn object(object: &Object) -> Bounds {
    let own = shape(&object.shape);
    Bounds {
        centre: object.transform.point(own.centre),
        radius: (own.radius * object.transform.scale).max(1e-3),
    }
}

fn shape(shape: &Shape) -> Bounds {
    match shape {
        // Crown, girdle and pavilion together are lower than the stone is wide.
        Shape::RoundBrilliant(cut) => Bounds { centre: Vec3::ZERO, radius: 0.55 * cut.diameter_mm },
        // Corners lie farther out than their facets; a cube's by √3.
        Shape::Polyhedron(facets) => {
            let farthest = facets.iter().map(|facet| facet.distance.abs()).fold(0.0, f64::max);
            Bounds { centre: Vec3::ZERO, radius: 1.75 * farthest as f32 }
        }
        Shape::Mesh(source) => {
            let positions = &source.mesh.positions;
            let (low, high) =
                positions.iter().fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), p| {
                    (low.min(*p), high.max(*p))
                });
            if !(low.is_finite() && high.is_finite()) {
                return EMPTY;
            }
            Bounds { centre: 0.5 * (low + high), radius: 0.5 * (high - low).length() }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joined_balls_hold_both() {
        let a = Bounds { centre: Vec3::ZERO, radius: 1.0 };
        let b = Bounds { centre: Vec3::new(4.0, 0.0, 0.0), radius: 2.0 };
        let both = a.joined(b);
        assert_eq!(both, Bounds { centre: Vec3::new(2.5, 0.0, 0.0), radius: 3.5 });
        let inside = Bounds { centre: Vec3::new(2.0, 0.5, 0.0), radius: 0.1 };
        assert_eq!(both.joined(inside), both);
        assert_eq!(inside.joined(both), both);
    }
}
