//! The pictures whose colours are compared.

use brilliance_renderer::camera::Camera;
use brilliance_renderer::cuts::RoundBrilliant;
use brilliance_renderer::light::{Lights, SkyLight};
use brilliance_renderer::material::{Dielectric, Dispersion, Material, find};
use brilliance_renderer::rigs::rigs;
use brilliance_renderer::scene::{Object, Scene, Shape, Transform};
use brilliance_renderer::solid::HalfSpace;
use glam::{DVec3, Quat, Vec3};

/// Distance of the cameras from what they look at, in mm.
const DISTANCE_MM: f32 = 40.0;

/// A small picture.
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) scene: Scene,
    pub(crate) camera: Camera,
    pub(crate) size: [u32; 2],
}

impl Case {
    /// The same picture with every body's index at 589 nm at all wavelengths.
    pub(crate) fn undispersed(mut self) -> Self {
        for object in &mut self.scene.objects {
            if let Material::Dielectric(dielectric) = &mut object.material {
                let n_d = dielectric.dispersion.n_d();
                dielectric.dispersion = Dispersion::Linear { n_d, dispersion_bg: 0.0 };
            }
        }
        self
    }
}

/// Every stone under every light.
pub(crate) fn all() -> Vec<Case> {
    let lights = [("nine lights", nine_lights()), ("sky", sky())];
    let stones = [brilliant(), step_cut(), fiery(), two()];
    let cases = stones.iter().flat_map(|stone| {
        lights.iter().map(|(light, lights)| Case {
            name: format!("{}, {light}", stone.name),
            scene: Scene { lights: lights.clone(), ..stone.scene.clone() },
            camera: stone.camera,
            size: stone.size,
        })
    });
    cases.collect()
}

/// Nine small discs in a dim hemisphere.
fn nine_lights() -> Lights {
    let rig = rigs().iter().find(|rig| rig.name == "Nine spots").expect("the rig ships");
    (rig.lights)()
}

/// A hemisphere with the observer's head before it.
fn sky() -> Lights {
    Lights {
        hemisphere: Some(SkyLight::daylight(0.8)),
        observer_shadow_radians: 15.0_f32.to_radians(),
        ..Lights::default()
    }
}

fn brilliant() -> Case {
    let shape = Shape::RoundBrilliant(RoundBrilliant::default());
    let stone = stone(shape, "Diamond", Transform::default());
    case("brilliant", vec![stone], camera([-71.0, 63.0], Vec3::new(0.0, 0.0, -0.3), 5.6))
}

fn step_cut() -> Case {
    let stone = stone(Shape::Polyhedron(steps()), "Diamond", Transform::default());
    case("step cut", vec![stone], camera([-58.0, 66.0], Vec3::new(0.0, 0.0, -0.3), 5.6))
}

fn fiery() -> Case {
    let shape = Shape::RoundBrilliant(RoundBrilliant::default());
    let stone = stone(shape, "Strontium titanate", Transform::default());
    case("strontium titanate", vec![stone], camera([-71.0, 63.0], Vec3::new(0.0, 0.0, -0.3), 5.6))
}

/// A stone seen beside, behind and through another.
fn two() -> Case {
    let placed = |x, y, turn: f32| Transform {
        translation: Vec3::new(x, y, 0.0),
        rotation: Quat::from_rotation_z(turn.to_radians()),
        scale: 1.0,
    };
    let shape = || Shape::RoundBrilliant(RoundBrilliant::default());
    let stones = vec![
        stone(shape(), "Diamond", placed(0.4, -2.6, 7.0)),
        stone(shape(), "Cubic zirconia", placed(-0.9, 4.1, 13.0)),
    ];
    case("two stones", stones, camera([-79.0, 33.0], Vec3::new(-0.3, 0.6, -0.2), 8.0))
}

fn case(name: &str, objects: Vec<Object>, camera: Camera) -> Case {
    let scene = Scene { objects, ..Scene::default() };
    Case { name: name.to_owned(), scene, camera, size: [40, 40] }
}

fn stone(shape: Shape, material: &str, transform: Transform) -> Object {
    let material = find(material).expect("the material ships");
    Object {
        name: material.name.clone(),
        shape,
        transform,
        material: Material::Dielectric(material.dielectric()),
        throws_light: false,
    }
}

/// A clear body of one index curve, as it stands.
pub(crate) fn clear_body(shape: Shape, dispersion: Dispersion) -> Object {
    Object {
        name: "body".to_owned(),
        shape,
        transform: Transform::default(),
        material: Material::Dielectric(Dielectric {
            name: "test".to_owned(),
            dispersion,
            absorption_per_mm: None,
        }),
        throws_light: false,
    }
}

/// A camera at an azimuth and elevation in degrees, whose picture is `width_mm` wide at `target`. No
/// ray of it should run along an edge: choose angles that are no symmetry's.
pub(crate) fn camera([azimuth, elevation]: [f32; 2], target: Vec3, width_mm: f32) -> Camera {
    let (sin_a, cos_a) = azimuth.to_radians().sin_cos();
    let (sin_e, cos_e) = elevation.to_radians().sin_cos();
    Camera {
        position: target + Vec3::new(cos_e * cos_a, cos_e * sin_a, sin_e) * DISTANCE_MM,
        target,
        up: Vec3::Z,
        fov_y_radians: 2.0 * (0.5 * width_mm / DISTANCE_MM).atan(),
    }
}

/// An octagonal step cut of 7.2 × 5.4 mm: a table, three steps of the crown, the girdle, and three
/// steps of the pavilion that end in a keel.
fn steps() -> Vec<HalfSpace> {
    // Angle from the girdle plane in degrees and height in mm, from the girdle outwards.
    const CROWN: [[f64; 2]; 3] = [[46.0, 0.35], [38.0, 0.30], [28.0, 0.25]];
    const PAVILION: [[f64; 2]; 3] = [[57.0, 0.9], [48.0, 0.9], [40.0, 9.0]];
    const GIRDLE_HALF_MM: f64 = 0.08;
    let mut planes = Vec::new();
    for side in 0..8 {
        let azimuth = f64::from(side) * std::f64::consts::FRAC_PI_4;
        let outward = DVec3::new(azimuth.cos(), azimuth.sin(), 0.0);
        let girdle_apothem = [3.6, 3.65, 2.7, 3.65][side as usize % 4];
        planes.push(plane(outward, girdle_apothem));
        for (up, steps) in [(DVec3::Z, CROWN), (DVec3::NEG_Z, PAVILION)] {
            let mut edge = outward * girdle_apothem + up * GIRDLE_HALF_MM;
            for [angle, height] in steps {
                let (sin, cos) = angle.to_radians().sin_cos();
                let normal = outward * sin + up * cos;
                planes.push(plane(normal, normal.dot(edge)));
                edge += up * height - outward * (height * cos / sin);
            }
        }
    }
    let table_z = GIRDLE_HALF_MM + CROWN.iter().map(|[_, height]| height).sum::<f64>();
    planes.push(plane(DVec3::Z, table_z));
    planes
}

pub(crate) fn plane(normal: DVec3, distance: f64) -> HalfSpace {
    HalfSpace { normal: normal.normalize(), distance, name: String::new() }
}
