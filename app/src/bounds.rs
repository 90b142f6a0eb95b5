//! Where the scene is, for the camera.

use brilliance_renderer::scene::{Object, Scene, Shape};
use brilliance_renderer::solid::Solid;
use glam::Vec3;

/// A ball that holds every object of a scene; the eye stays outside it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Centre, in millimetres.
    pub center: Vec3,
    /// Radius, in millimetres; positive.
    pub radius: f32,
}

/// Room for a scene without objects: that of a one-carat diamond.
const EMPTY: Bounds = Bounds { center: Vec3::ZERO, radius: 3.5 };

impl Bounds {
    /// The ball about all objects of `scene`; not the smallest one, but never too small.
    pub fn of(scene: &Scene) -> Self {
        scene.objects.iter().map(object).reduce(Self::joined).unwrap_or(EMPTY)
    }

    /// The smallest ball that holds both.
    fn joined(self, other: Self) -> Self {
        let offset = other.center - self.center;
        let distance = offset.length();
        if distance + other.radius <= self.radius {
            return self;
        }
        if distance + self.radius <= other.radius {
            return other;
        }
        let radius = 0.5 * (distance + self.radius + other.radius);
        let center = self.center + offset * ((radius - self.radius) / distance);
        Self { center, radius }
    }
}

fn object(object: &Object) -> Bounds {
    let own = shape(&object.shape);
    Bounds {
        center: object.transform.point(own.center),
        radius: (own.radius * object.transform.scale).max(1e-3),
    }
}

fn shape(shape: &Shape) -> Bounds {
    match shape {
        // Crown, girdle and pavilion together are lower than the stone is wide.
        Shape::RoundBrilliant(cut) => Bounds { center: Vec3::ZERO, radius: 0.55 * cut.diameter_mm },
        Shape::Polyhedron(facets) => match Solid::from_half_spaces(facets) {
            Ok(solid) => ball(solid.bounds().0.as_vec3(), solid.bounds().1.as_vec3()),
            // The session says what is wrong with it.
            Err(_) => EMPTY,
        },
        Shape::Mesh(source) => {
            let (low, high) = source.mesh.bounds();
            ball(low, high)
        }
    }
}

/// The ball about a box.
fn ball(low: Vec3, high: Vec3) -> Bounds {
    if !(low.is_finite() && high.is_finite()) {
        return EMPTY;
    }
    Bounds { center: 0.5 * (low + high), radius: 0.5 * (high - low).length() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joined_balls_hold_both() {
        let a = Bounds { center: Vec3::ZERO, radius: 1.0 };
        let b = Bounds { center: Vec3::new(4.0, 0.0, 0.0), radius: 2.0 };
        let both = a.joined(b);
        assert_eq!(both, Bounds { center: Vec3::new(2.5, 0.0, 0.0), radius: 3.5 });
        let inside = Bounds { center: Vec3::new(2.0, 0.5, 0.0), radius: 0.1 };
        assert_eq!(both.joined(inside), both);
        assert_eq!(inside.joined(both), both);
    }
}
