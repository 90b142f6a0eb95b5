//! Scenes to probe the kernel in.

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Arc;

use brilliance_renderer::camera::{Camera, CameraFrame};
use brilliance_renderer::cuts::RoundBrilliant;
use brilliance_renderer::import::gltf;
use brilliance_renderer::kernel::camera::{camera_ray, pixel_seed};
use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::kernel::trace::follow;
use brilliance_renderer::kernel::walk::{RayStack, TraceRules, Walk};
use brilliance_renderer::light::{DiscLight, Lights, SkyLight};
use brilliance_renderer::material::{
    Dielectric, Diffuse, Dispersion, Image, ImageOrigin, Layout, Material, Outside, Planar, Print,
};
use brilliance_renderer::mesh::Mesh;
use brilliance_renderer::packed::{NONE, PackedScene, PackedSky};
use brilliance_renderer::scene::{Ground, MeshSource, Object, Scene, Shape, Transform};
use brilliance_renderer::solid::{HalfSpace, Solid};
use brilliance_renderer::spectrum::{Bins, Illuminant, Spectrum};
use glam::{DVec3, Quat, Vec2, Vec3};

use super::{Dice, Put, Take};

const OCTAHEDRON: &[u8] = include_bytes!("../../../assets/gems/spinel_octahedron.glb");

/// All that both sides are told.
pub(crate) struct World {
    pub(crate) name: &'static str,
    pub(crate) scene: PackedScene,
    pub(crate) camera: CameraFrame,
    pub(crate) size: [u32; 2],
    pub(crate) rules: TraceRules,
}

impl World {
    /// One of everything: a coloured block with another inside and a third beside it, face to
    /// face; a brilliant; a matte brilliant and a coloured octahedron as meshes; a block and a cube
    /// of triangles that are printed on; a checkered ground and all lights. The first material and the last absorb, so that to mistake nothing for
    /// either is noticed.
    pub(crate) fn full() -> Self {
        let lights = Lights {
            discs: vec![
                disc(Vec3::new(0.3, -0.4, 0.8), 0.3),
                disc(Vec3::new(-0.5, 0.2, 0.6), 12.0),
                // A light may fill half the sky.
                disc(Vec3::new(0.1, 0.9, 0.2), 90.0),
            ],
            hemisphere: Some(SkyLight::daylight(0.4)),
            environment: Some(SkyLight { radiance: 0.2, spectrum: falling() }),
            observer_shadow_radians: 0.15,
            backdrop: None,
        };
        let ground = Ground {
            height: -2.5,
            square: 1.3,
            reflectance: [Spectrum::Flat(0.7), Spectrum::Rgb([0.2, 0.5, 0.3])],
        };
        let objects = vec![
            object(block(DVec3::splat(1.5)), FLINT, Some(absorption(0.9))).at(6.0, 0.0, -1.0),
            object(Shape::RoundBrilliant(RoundBrilliant::default()), DIAMOND, None).turned(),
            Object { material: matte(), ..meshed(brilliant_mesh()) }.at(0.0, 8.0, 0.0).turned(),
            Object { material: printed(projected()), ..block_of_paper() }
                .at(-4.0, -5.0, 0.0)
                .turned(),
            Object { material: printed(unwrapped()), ..meshed(Arc::new(unwrapped_cube())) }
                .at(2.0, -6.0, 0.0)
                .turned(),
            object(block(DVec3::splat(0.6)), DIAMOND, Some(absorption(0.1))).at(6.0, 0.2, -1.0),
            object(block(DVec3::splat(1.5)), DIAMOND, Some(absorption(0.5))).at(6.0, 3.0, -1.0),
            Object { material: dielectric(FLINT, Some(falling())), ..octahedron() }
                .at(-6.0, 1.0, 0.0)
                .turned(),
        ];
        Self::new(
            "the full scene",
            &Scene { objects, ground: Some(ground), lights, ..Scene::default() },
        )
    }

    /// The full scene where every wavelength arrives from one direction, pruned and cut off early.
    pub(crate) fn curt() -> Self {
        let full = Self::full();
        let rules =
            TraceRules { perturb: 0, significance_threshold: 0.05, max_depth: 3, ..full.rules };
        Self { name: "the curt scene", rules, ..full }
    }

    /// A coloured prism that throws the light of two lamps, a small one and a large one, on the
    /// ground and on a matte block, with a second block in the way of some of it. There is no more,
    /// since software devices end loops early (`tracer/gpu/pace`).
    pub(crate) fn throwing() -> Self {
        let lights = Lights {
            discs: vec![disc(Vec3::new(0.5, -0.4, 0.7), 0.5), disc(Vec3::new(-0.6, 0.1, 0.4), 8.0)],
            ..Lights::default()
        };
        let ground = Ground {
            height: -3.0,
            square: 1.3,
            reflectance: [Spectrum::Flat(0.7), Spectrum::Rgb([0.2, 0.5, 0.3])],
        };
        let prism = object(wedge(), FLINT, Some(absorption(0.4)));
        let objects = vec![
            Object { throws_light: true, ..prism }.turned(),
            Object { material: matte(), ..object(block(DVec3::splat(1.0)), FLINT, None) }
                .at(2.5, 2.5, -2.0),
            Object { material: matte(), ..object(block(DVec3::splat(0.5)), FLINT, None) }
                .at(1.5, -1.5, 2.5),
        ];
        Self::new(
            "the throwing scene",
            &Scene { objects, ground: Some(ground), lights, ..Scene::default() },
        )
    }

    /// The full scene under another sky.
    pub(crate) fn under_sky(name: &'static str, change: fn(&mut PackedSky)) -> Self {
        let mut world = Self { name, ..Self::full() };
        change(&mut world.scene.sky);
        world
    }

    /// A single brilliant, whose interior is clear, before a backdrop, which hides the environment
    /// from the camera.
    pub(crate) fn single() -> Self {
        let lights = Lights {
            environment: Some(SkyLight { radiance: 0.3, spectrum: falling() }),
            backdrop: Some(SkyLight::daylight(0.7)),
            ..Lights::default()
        };
        let objects = vec![object(Shape::RoundBrilliant(RoundBrilliant::default()), DIAMOND, None)];
        Self::new("the single stone", &Scene { objects, lights, ..Scene::default() })
    }

    /// A cube as a mesh of which one edge is split on one side, closed by a triangle without area.
    pub(crate) fn sliver() -> Self {
        let object = meshed(Arc::new(split_cube()));
        let lights = Lights { hemisphere: Some(SkyLight::daylight(1.0)), ..Lights::default() };
        Self::new(
            "the cube with a sliver",
            &Scene { objects: vec![object], lights, ..Scene::default() },
        )
    }

    /// Nothing at all.
    pub(crate) fn empty() -> Self {
        Self::new("the empty scene", &Scene::default())
    }

    fn new(name: &'static str, scene: &Scene) -> Self {
        let size = [61, 47];
        let camera = Camera { fov_y_radians: 0.6, ..Camera::default() }.frame(size[0], size[1]);
        let rules = TraceRules {
            observer: -camera.forward,
            split_count: 1.0,
            significance_threshold: 1e-3,
            max_depth: 40,
            perturb: 1,
            cut_threshold: 2e-4,
        };
        let scene = PackedScene::new(scene, Bins::new(9)).expect("the scene packs");
        Self { name, scene, camera, size, rules }
    }

    /// The index tables, and air.
    pub(crate) fn media(&self) -> Vec<u32> {
        let tables: BTreeSet<_> = self.scene.materials.iter().map(|it| it.index_table).collect();
        tables.into_iter().filter(|table| *table != NONE).chain([NONE]).collect()
    }

    /// The number of rows of spectra.
    pub(crate) fn rows(&self) -> usize {
        let end = self.media()[0].min(self.scene.axis);
        end as usize / self.scene.bins.count()
    }

    /// The materials that absorb.
    pub(crate) fn absorbers(&self) -> Vec<u32> {
        let absorbs = |i: &u32| self.scene.materials[*i as usize].absorption != NONE;
        (0..self.scene.materials.len() as u32).filter(absorbs).collect()
    }

    /// The bodies that are printed on.
    pub(crate) fn printed(&self) -> Vec<u32> {
        let is_printed = |i: &u32| self.scene.material_of(*i).print.texels != NONE;
        (0..self.scene.instances.len() as u32).filter(is_printed).collect()
    }

    /// A walk that takes its seed and its pass, does `work` and puts what has come of it.
    pub(crate) fn walk(
        &self,
        take: &mut Take<'_>,
        put: &mut Put,
        work: impl FnOnce(&mut Walk<'_>, &mut Take<'_>, &mut Put),
    ) {
        let (seed, pass_index) = (take.u32(), take.u32());
        self.begin_walk(seed, pass_index, |walk| {
            work(walk, take, put);
            put.walk(walk);
        });
    }

    /// What `work` makes of a walk that has not begun.
    pub(crate) fn begin_walk<T>(
        &self,
        seed: u32,
        pass_index: u32,
        work: impl FnOnce(&mut Walk<'_>) -> T,
    ) -> T {
        let mut stack = RayStack::new();
        let mut radiance = vec![0.0; self.scene.bins.count()];
        let mut walk =
            Walk::new(&self.scene, &self.rules, pass_index, seed, &mut stack, &mut radiance);
        work(&mut walk)
    }

    /// Rays as they come about: descendants of camera rays, from all generations.
    pub(crate) fn rays(&self, count: usize) -> Vec<Ray> {
        let mut dice = Dice::new(7);
        let mut rays = Vec::with_capacity(count);
        // In some scenes most camera rays meet nothing.
        for _ in 0..20 * count {
            if rays.len() == count {
                break;
            }
            let [x, y] = self.size.map(|size| dice.below(size as usize) as u32);
            self.begin_walk(pixel_seed(x, y), 0, |walk| {
                walk.send(&camera_ray(&self.camera, self.size, x, y, dice.word()));
                for _ in 0..dice.below(12) {
                    if walk.has_rays() {
                        follow(walk);
                    }
                }
                if walk.has_rays() {
                    rays.push(walk.pop());
                }
            });
        }
        rays
    }
}

const DIAMOND: Dispersion = Dispersion::Linear { n_d: 2.417, dispersion_bg: 0.044 };
const FLINT: Dispersion = Dispersion::Linear { n_d: 1.784, dispersion_bg: 0.055 };

fn disc(direction: Vec3, radius_degrees: f32) -> DiscLight {
    DiscLight {
        name: "disc".to_owned(),
        direction,
        angular_radius_radians: radius_degrees.to_radians(),
        radiance: 3.0,
        spectrum: Spectrum::Illuminant(Illuminant::A),
    }
}

fn falling() -> Spectrum {
    Spectrum::Tabulated { lambda_nm: vec![380.0, 730.0], value: vec![0.9, 0.1] }
}

/// α per mm with a band in the middle.
fn absorption(peak: f32) -> Spectrum {
    Spectrum::Tabulated {
        lambda_nm: vec![380.0, 500.0, 560.0, 620.0, 730.0],
        value: vec![0.02, 0.05, peak, 0.1, 0.01],
    }
}

fn dielectric(dispersion: Dispersion, absorption_per_mm: Option<Spectrum>) -> Material {
    Material::Dielectric(Dielectric { name: "clear".to_owned(), dispersion, absorption_per_mm })
}

fn matte() -> Material {
    Material::Diffuse(Diffuse { reflectance: falling(), print: None })
}

fn printed(print: Print) -> Material {
    Material::Diffuse(Diffuse { reflectance: falling(), print: Some(print) })
}

/// A few texels of any colours.
fn image(size: [u32; 2]) -> Arc<Image> {
    let mut dice = Dice::new(size[0]);
    let texels = (0..size[0] * size[1]).map(|_| dice.word() & 0xff_ff_ff).collect();
    Arc::new(Image { origin: ImageOrigin::Mesh("noise".to_owned()), size, texels })
}

/// On a part of what faces the camera, and again and again beside it.
fn projected() -> Print {
    let planar = Planar { facing: Vec3::Z, up: Vec3::Y, size_mm: [1.7, 2.2] };
    Print {
        image: image([7, 5]),
        layout: Layout::Planar(planar),
        outside: [Outside::Repeat, Outside::Bare],
        tint: [1.0; 3],
    }
}

fn unwrapped() -> Print {
    Print {
        image: image([4, 9]),
        layout: Layout::Coordinates,
        outside: [Outside::Mirror, Outside::Edge],
        tint: [0.9, 0.5, 0.2],
    }
}

fn block_of_paper() -> Object {
    object(block(DVec3::splat(1.5)), DIAMOND, None)
}

/// A cube whose triangles have coordinates of their own, some beyond the image.
fn unwrapped_cube() -> Mesh {
    let cube = split_cube();
    let mut dice = Dice::new(47);
    let mut corner = || Vec2::new(dice.between(-1.0, 2.0), dice.between(-1.0, 2.0));
    let coordinates = cube.triangles.iter().map(|_| [corner(), corner(), corner()]).collect();
    Mesh::with_coordinates(cube.positions, cube.triangles, coordinates).expect("a mesh")
}

fn object(shape: Shape, dispersion: Dispersion, absorption_per_mm: Option<Spectrum>) -> Object {
    let material = dielectric(dispersion, absorption_per_mm);
    Object {
        name: "body".to_owned(),
        shape,
        transform: Transform::default(),
        material,
        throws_light: false,
    }
}

/// Where and how a body stands.
trait Placed {
    fn at(self, x: f32, y: f32, z: f32) -> Self;
    fn turned(self) -> Self;
}

impl Placed for Object {
    fn at(mut self, x: f32, y: f32, z: f32) -> Self {
        self.transform.translation = Vec3::new(x, y, z);
        self
    }

    fn turned(mut self) -> Self {
        self.transform.scale = 1.2;
        self.transform.rotation = Quat::from_axis_angle(Vec3::new(0.6, 0.0, 0.8), 0.7);
        self
    }
}

fn block(half_extents: DVec3) -> Shape {
    let half_space = |normal: DVec3| HalfSpace {
        normal,
        distance: normal.abs().dot(half_extents),
        name: String::new(),
    };
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    Shape::Polyhedron(
        axes.into_iter().flat_map(|axis| [half_space(axis), half_space(-axis)]).collect(),
    )
}

/// A prism of three sides.
fn wedge() -> Shape {
    let half_space = |x, y, z| HalfSpace {
        normal: DVec3::new(x, y, z).normalize(),
        distance: 1.2,
        name: String::new(),
    };
    Shape::Polyhedron(vec![
        half_space(1.0, 0.0, 0.6),
        half_space(-1.0, 0.0, 0.6),
        half_space(0.0, 0.0, -1.0),
        half_space(0.0, 1.0, 0.0),
        half_space(0.0, -1.0, 0.0),
    ])
}

/// A real mesh, as users open them.
fn octahedron() -> Object {
    let file = gltf::load_from_memory(Path::new("octahedron.glb"), OCTAHEDRON).expect("it loads");
    meshed(Arc::clone(&file.objects[0].mesh))
}

/// A mesh of many facets, in boxes of one triangle and of several.
fn brilliant_mesh() -> Arc<Mesh> {
    let half_spaces = RoundBrilliant::default().half_spaces().expect("the default cut is a solid");
    let solid = Solid::from_half_spaces(&half_spaces).expect("the default cut closes");
    Arc::new(Mesh::from_solid(&solid).expect("a solid is a mesh"))
}

fn meshed(mesh: Arc<Mesh>) -> Object {
    let source = MeshSource { path: "mesh".into(), index: 0, mesh };
    object(Shape::Mesh(source), DIAMOND, None)
}

fn split_cube() -> Mesh {
    let corner = |i: u32| {
        Vec3::new((i & 1) as f32, (i >> 1 & 1) as f32, (i >> 2) as f32) * 4.0 - Vec3::splat(2.0)
    };
    let mut positions: Vec<_> = (0..8).map(corner).collect();
    // The middle of the edge from corner 0 to corner 1.
    positions.push(Vec3::new(0.0, -2.0, -2.0));
    let triangles = vec![
        [0, 2, 8],
        [8, 2, 3],
        [8, 3, 1], // z = −2, with the edge split
        [0, 8, 1], // without area
        [0, 1, 5],
        [0, 5, 4], // y = −2
        [4, 5, 7],
        [4, 7, 6],
        [2, 6, 7],
        [2, 7, 3],
        [0, 4, 6],
        [0, 6, 2],
        [1, 3, 7],
        [1, 7, 5],
    ];
    let mesh = Mesh::new(positions, triangles).expect("a mesh");
    assert_eq!(mesh.closed(), Ok(()));
    mesh
}
