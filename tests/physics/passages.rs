//! Light that goes straight through clear bodies onto matte surfaces.

use std::f32::consts::FRAC_PI_2;
use std::f64::consts::{FRAC_PI_4, PI};
use std::time::{Duration, Instant};

use brilliance_renderer::cuts::RoundBrilliant;
use brilliance_renderer::error::RendererError;
use brilliance_renderer::kernel::interface::fresnel;
use brilliance_renderer::kernel::passage::facet_gain;
use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::kernel::rng::{hash, unit_float};
use brilliance_renderer::kernel::trace::trace;
use brilliance_renderer::kernel::walk::{RayStack, Walk};
use brilliance_renderer::light::{DiscLight, Lights};
use brilliance_renderer::material::{Dielectric, Diffuse, Dispersion, Material};
use brilliance_renderer::packed::{MAX_PASSAGES, MAX_THROWER_FACETS, PackedScene};
use brilliance_renderer::scene::{Ground, Object, Scene, Shape};
use brilliance_renderer::settings::TraceSettings;
use brilliance_renderer::solid::HalfSpace;
use brilliance_renderer::spectrum::{Bins, Spectrum};
use glam::{DVec3, Quat, Vec3};

use crate::scenes::{
    FLINT, block, brilliant, clear, flat_disc, half_space, object, prism, rules, scene,
};

const BINS: u32 = 8;
const LIGHT_RADIUS_DEGREES: f32 = 0.02;

/// Without dispersion.
fn plain(n: f64) -> Dispersion {
    Dispersion::Linear { n_d: n, dispersion_bg: 0.0 }
}

fn thrower(object: Object) -> Object {
    Object { throws_light: true, ..object }
}

/// A small disc of irradiance 1.
fn lamp(towards: DVec3) -> DiscLight {
    let disc = flat_disc(towards.normalize().as_vec3(), LIGHT_RADIUS_DEGREES, 1.0);
    let radiance = 1.0 / disc.solid_angle_steradians();
    DiscLight { radiance, ..disc }
}

/// Over a ground that reflects all, so that its radiance is the irradiance by π.
fn over_ground(height: f64, objects: Vec<Object>, disc: DiscLight) -> Scene {
    let white = Spectrum::Flat(1.0);
    let ground = Ground { height: height as f32, square: 1e6, reflectance: [white.clone(), white] };
    let lights = Lights { discs: vec![disc], ..Lights::default() };
    Scene { ground: Some(ground), ..scene(objects, lights) }
}

/// The irradiance of points of the ground, per bin.
struct Meter {
    packed: PackedScene,
    height: f32,
    stack: RayStack,
    seed: u32,
}

impl Meter {
    fn new(scene: &Scene) -> Self {
        let packed = PackedScene::new(scene, Bins::new(BINS)).expect("the scene packs");
        let height = packed.ground.height;
        Self { packed, height, stack: RayStack::new(), seed: 0 }
    }

    fn read(&mut self, x: f64, y: f64, pass_index: u32) -> Vec<f64> {
        let above = Vec3::new(x as f32, y as f32, self.height + 1e-3);
        self.read_along(&Ray::white(above, Vec3::NEG_Z), pass_index)
    }

    /// Of what the ray meets.
    fn read_along(&mut self, ray: &Ray, pass_index: u32) -> Vec<f64> {
        let rules = rules(&TraceSettings::default());
        let mut pixel = vec![0.0; BINS as usize];
        self.seed += 1;
        let seed = hash(self.seed);
        let mut walk =
            Walk::new(&self.packed, &rules, pass_index, seed, &mut self.stack, &mut pixel);
        trace(&mut walk, ray);
        pixel.iter().map(|&radiance| PI * f64::from(radiance)).collect()
    }
}

/// What a scene's bodies throw on the ground: with what they throw, less without.
struct Thrown {
    with: Meter,
    without: Meter,
}

impl Thrown {
    fn new(scene: &Scene) -> Self {
        let mut dark = scene.clone();
        for object in &mut dark.objects {
            object.throws_light = false;
        }
        Self { with: Meter::new(scene), without: Meter::new(&dark) }
    }

    fn read(&mut self, x: f64, y: f64, pass_index: u32) -> Vec<f64> {
        let with = self.with.read(x, y, pass_index);
        let without = self.without.read(x, y, pass_index);
        with.iter().zip(without).map(|(with, without)| with - without).collect()
    }
}

/// Transmittance of an interface by Fresnel's formulae in their trigonometric form (Born & Wolf,
/// §1.5.2, eq. 21a), for angles above 0.
fn transmittance(incidence: f64, refraction: f64) -> f64 {
    let (difference, sum) = (incidence - refraction, incidence + refraction);
    let perpendicular = (difference.sin() / sum.sin()).powi(2);
    let parallel = (difference.tan() / sum.tan()).powi(2);
    1.0 - 0.5 * (perpendicular + parallel)
}

/// The wavelength in the middle of a bin, at which the first pass looks.
fn middle_nm(bin: usize) -> f64 {
    let (low_nm, high_nm) = Bins::new(BINS).range_nm(bin);
    0.5 * f64::from(low_nm + high_nm)
}

#[test]
fn a_facet_multiplies_irradiance_by_its_transmittance_and_the_widths_of_the_beam() {
    for eta in [0.4_f32, 1.0 / 1.5, 1.0, 1.5, 2.4] {
        let critical = if eta > 1.0 { (1.0 / eta).asin() } else { FRAC_PI_2 };
        for step in 1..100 {
            let incidence = critical * step as f32 / 100.0;
            let (cos_i, cos_t) = (incidence.cos(), (eta * incidence.sin()).asin().cos());
            let expected = (1.0 - fresnel(cos_i, cos_t, eta)) * cos_i / cos_t;
            let found = facet_gain(cos_i, eta);
            assert!((found / expected - 1.0).abs() < 1e-4, "{eta} {incidence}: {found} {expected}");
        }
    }
}

#[test]
fn the_shadow_of_a_slab_is_fresnels_transmittance_without_a_colour() {
    let incidence: f64 = 0.6;
    let towards = DVec3::new(incidence.sin(), 0.0, incidence.cos());
    for n in [1.5, 2.4] {
        let slab = object(block(DVec3::new(40.0, 40.0, 2.0)), clear(plain(n)));
        let mut slab = thrower(slab);
        slab.transform.translation = Vec3::new(0.0, 0.0, 10.0);
        let mut meter = Meter::new(&over_ground(0.0, vec![slab], lamp(towards)));
        let refraction = (incidence.sin() / n).asin();
        let expected = transmittance(incidence, refraction).powi(2) * incidence.cos();
        for pass in 0..8 {
            for found in meter.read(-3.0, 5.0, pass) {
                assert!((found / expected - 1.0).abs() < 1e-3, "{n}: {found} {expected}");
            }
        }
        let open = meter.read(500.0, 0.0, 0)[0];
        assert!((open / incidence.cos() - 1.0).abs() < 1e-3, "beside it: {open}");
    }
}

/// Light falls on a wall by the sine of what it has to the vertical, and by the cosine of a turn about
/// it.
#[test]
fn a_wall_is_lit_by_the_cosine_to_its_own_normal() {
    let (incidence, n): (f64, f64) = (0.7, 1.6);
    let towards = DVec3::new(incidence.sin(), 0.0, incidence.cos());
    let refraction = (incidence.sin() / n).asin();
    let through = transmittance(incidence, refraction).powi(2);
    let matte = Material::Diffuse(Diffuse { reflectance: Spectrum::Flat(1.0), print: None });
    for turn in [0.0_f32, 0.5, -1.2] {
        let mut slab = thrower(object(block(DVec3::new(40.0, 40.0, 2.0)), clear(plain(n))));
        slab.transform.translation.z = 20.0;
        let mut wall = object(block(DVec3::new(1.0, 5.0, 5.0)), matte.clone());
        wall.transform.rotation = Quat::from_rotation_z(turn);
        let normal = wall.transform.rotation * Vec3::X;
        let mut meter = Meter::new(&over_ground(-10.0, vec![slab, wall], lamp(towards)));
        let cos = incidence.sin() * f64::from(turn).cos();
        let expected = through * cos;
        // Each pass looks at one point of the lamp: the part by which the cosine changes over it.
        let within_lamp = f64::from(LIGHT_RADIUS_DEGREES).to_radians() * cos.acos().tan();
        for pass in 0..8 {
            let at = Vec3::new(0.0, 0.0, 0.3 * pass as f32 - 1.0);
            let ray = Ray::white(at + 4.0 * normal, -normal);
            for found in meter.read_along(&ray, pass) {
                let error = (found / expected - 1.0).abs();
                assert!(error < 1e-3 + within_lamp, "{turn}: {found} {expected}");
            }
        }
    }
}

#[test]
fn a_coloured_slab_absorbs_along_the_refracted_path() {
    let incidence: f64 = 0.9;
    let towards = DVec3::new(0.0, incidence.sin(), incidence.cos());
    let (n, thickness) = (1.7, 4.0);
    let absorption = Spectrum::Tabulated { lambda_nm: vec![380.0, 730.0], value: vec![0.5, 0.01] };
    let material = Material::Dielectric(Dielectric {
        name: "filter".to_owned(),
        dispersion: plain(n),
        absorption_per_mm: Some(absorption.clone()),
    });
    // It rests on the ground.
    let lying = thrower(object(block(DVec3::new(40.0, 40.0, 0.5 * thickness)), material.clone()));
    // Turned onto its side, by a rounding error less or more than a right angle.
    let turned = |axis: Vec3, half: DVec3| {
        let mut slab = thrower(object(block(half), material.clone()));
        slab.transform.rotation = Quat::from_axis_angle(axis, FRAC_PI_2);
        slab
    };
    let slabs = [
        lying,
        turned(Vec3::X, DVec3::new(40.0, 0.5 * thickness, 40.0)),
        turned(Vec3::NEG_X, DVec3::new(40.0, 0.5 * thickness, 40.0)),
        turned(Vec3::Y, DVec3::new(0.5 * thickness, 40.0, 40.0)),
    ];
    let refraction = (incidence.sin() / n).asin();
    let clear = transmittance(incidence, refraction).powi(2) * incidence.cos();
    let means = absorption.bin_means(Bins::new(BINS));
    for (number, mut slab) in slabs.into_iter().enumerate() {
        slab.transform.translation = Vec3::new(0.0, 0.0, 0.5 * thickness as f32);
        let mut meter = Meter::new(&over_ground(0.0, vec![slab], lamp(towards)));
        for place in 0..200 {
            let (x, y) = (0.1 * f64::from(place) - 10.0, 0.07 * f64::from(place) - 7.0);
            for (found, alpha) in meter.read(x, y, 0).into_iter().zip(&means) {
                let expected = clear * (-f64::from(*alpha) * thickness / refraction.cos()).exp();
                let error = (found / expected - 1.0).abs();
                assert!(error < 1e-3, "slab {number} at {x} {y}: {found} {expected}");
            }
        }
    }
}

/// A prism with its edges along y that the light from the left, 30° above the horizon, meets at
/// minimum deviation for 589 nm: it then goes nearly straight down.
fn deviating_prism() -> (Object, DVec3, f64) {
    let apex = 60.0_f64.to_radians();
    let deviation = 2.0 * (FLINT.n(589.0) * (0.5 * apex).sin()).asin() - apex;
    let mut prism = thrower(object(prism(60.0, 5.0), clear(FLINT)));
    // Upright, light at minimum deviation rises by half the deviation on its left.
    let turn = 30.0_f64.to_radians() + 0.5 * deviation;
    prism.transform.rotation = Quat::from_rotation_y(turn as f32);
    (prism, DVec3::new(-30.0_f64.to_radians().cos(), 0.0, 0.5), turn)
}

#[test]
fn a_prism_throws_every_wavelength_at_the_textbook_angle() {
    let (prism, towards, turn) = deviating_prism();
    let mut centroids = Vec::new();
    for height in [-1000.0, -3000.0] {
        let mut thrown = Thrown::new(&over_ground(height, vec![prism.clone()], lamp(towards)));
        let mut moments = [[0.0; 2]; BINS as usize];
        for step in 0..6000 {
            let x = -1500.0 + 0.5 * f64::from(step);
            for (moment, value) in moments.iter_mut().zip(thrown.read(x, 0.0, 0)) {
                moment[0] += value;
                moment[1] += value * x;
            }
        }
        centroids.push(moments.map(|[sum, moment]| moment / sum));
    }
    // The left face's normal rises by 150°, less the turn, and the lamp stands at 150°: the angle of
    // incidence is the turn.
    let apex = 60.0_f64.to_radians();
    for (bin, (near, far)) in centroids[0].iter().zip(&centroids[1]).enumerate() {
        let n = FLINT.n(middle_nm(bin));
        let inside = (turn.sin() / n).asin();
        let exit = (n * (apex - inside).sin()).asin();
        let deviation = turn + exit - apex;
        let expected = -30.0_f64.to_radians() - deviation;
        let found = (-2000.0_f64).atan2(far - near);
        let error = (found - expected).to_degrees();
        assert!(error.abs() < 0.02, "bin {bin}: {} off by {error}°", expected.to_degrees());
    }
    let spread = (centroids[1][0] - centroids[1][BINS as usize - 1]).abs();
    assert!(spread > 300.0, "violet and red lie apart: {spread} mm");
}

#[test]
fn a_beam_through_a_slit_and_a_wedge_keeps_its_energy() {
    let (width, tilt, n) = (2.0, 15.0_f64.to_radians(), 1.6);
    let wedge = thrower(object(
        Shape::Polyhedron(vec![
            half_space(DVec3::new(tilt.sin(), 0.0, tilt.cos()), 6.0),
            half_space(DVec3::NEG_Z, 0.0),
            half_space(DVec3::X, 8.0),
            half_space(DVec3::NEG_X, 8.0),
            half_space(DVec3::Y, 50.0),
            half_space(DVec3::NEG_Y, 50.0),
        ]),
        clear(plain(n)),
    ));
    let matte = Material::Diffuse(Diffuse { reflectance: Spectrum::Flat(0.0), print: None });
    let jaw = |side: f32| {
        let mut jaw = object(block(DVec3::new(50.0, 50.0, 0.5)), matte.clone());
        jaw.transform.translation = Vec3::new(side * (50.0 + 0.5 * width as f32), 0.0, 30.0);
        jaw
    };
    let objects = vec![wedge, jaw(1.0), jaw(-1.0)];
    let mut meter = Meter::new(&over_ground(-20.0, objects, lamp(DVec3::Z)));
    let inside = (tilt.sin() / n).asin();
    let at_exit = tilt - inside;
    let behind = (n * at_exit.sin()).asin();
    let expected = width * transmittance(tilt, inside) * transmittance(at_exit, behind);
    let step = 0.005;
    let mut total = 0.0;
    let mut lit = 0;
    for i in -3000..3000 {
        let irradiance = meter.read(step * f64::from(i), 0.0, 0)[3];
        total += irradiance * step;
        lit += usize::from(irradiance > 0.0);
    }
    assert!((total / expected - 1.0).abs() < 3e-3, "{total} {expected}");
    // All else lies in the shadow of the jaws.
    assert!((lit as f64 * step) < 1.2 * width, "{lit}");
}

#[test]
fn what_stands_behind_the_body_shades_too() {
    let slab = |z: f32| {
        let mut slab = object(block(DVec3::new(20.0, 20.0, 1.0)), clear(plain(1.5)));
        slab.transform.translation = Vec3::new(0.0, 0.0, z);
        slab
    };
    let matte = Material::Diffuse(Diffuse { reflectance: Spectrum::Flat(0.5), print: None });
    let screen = Object { material: matte, ..slab(5.0) };
    for other in [screen, slab(5.0)] {
        let objects = vec![thrower(slab(10.0)), other];
        let mut meter = Meter::new(&over_ground(0.0, objects, lamp(DVec3::Z)));
        assert_eq!(meter.read(0.0, 0.0, 0), vec![0.0; BINS as usize]);
    }
}

#[test]
fn where_nothing_is_thrown_nothing_changes() {
    let towards = DVec3::new(0.3, 0.2, 0.9);
    let mut stone = brilliant(plain(1.3));
    stone.transform.translation.z = 6.0;
    let dark = over_ground(0.0, vec![stone], lamp(towards));
    let mut lit = dark.clone();
    lit.objects[0].throws_light = true;
    let (mut dark, mut lit) = (Meter::new(&dark), Meter::new(&lit));
    assert!(dark.packed.passages.is_empty());
    assert!(!lit.packed.passages.is_empty());
    let mut brighter = 0;
    for i in 0..40 {
        for j in 0..40 {
            let (x, y) = (0.5 * f64::from(i) - 10.0, 0.5 * f64::from(j) - 10.0);
            let (before, after) = (dark.read(x, y, i), lit.read(x, y, i));
            assert!(before.iter().zip(&after).all(|(before, after)| after >= before));
            brighter += usize::from(before != after);
        }
    }
    // Elsewhere it is the same bit for bit.
    assert!((20..1500).contains(&brighter), "{brighter}");
}

/// A convex solid in f64, and light followed through it from the lamp.
struct Forward {
    planes: Vec<HalfSpace>,
    n: f64,
}

impl Forward {
    /// Where light that enters at `point` of facet `entry` along `direction` goes straight through:
    /// the point that it leaves from, its direction there, and what is left of its energy.
    fn through(&self, point: DVec3, direction: DVec3, entry: usize) -> Option<(DVec3, DVec3, f64)> {
        let (inside, entered) = refracted(direction, self.planes[entry].normal, 1.0 / self.n)?;
        let crossings = self.planes.iter().enumerate().filter(|(facet, _)| *facet != entry);
        let (distance, exit) = crossings
            .filter(|(_, plane)| plane.normal.dot(inside) > 1e-12)
            .map(|(_, plane)| {
                let gap = plane.distance - plane.normal.dot(point);
                (gap / plane.normal.dot(inside), plane)
            })
            .min_by(|a, b| a.0.total_cmp(&b.0))?;
        let (behind, left) = refracted(inside, -exit.normal, self.n)?;
        Some((point + inside * distance, behind, entered * left))
    }

    /// The facet by which a line enters, and where.
    fn entry(&self, origin: DVec3, direction: DVec3) -> Option<(usize, DVec3)> {
        let (mut near, mut far, mut facet) = (f64::MIN, f64::MAX, 0);
        for (i, plane) in self.planes.iter().enumerate() {
            let towards = plane.normal.dot(direction);
            let distance = (plane.distance - plane.normal.dot(origin)) / towards;
            if towards < 0.0 && distance > near {
                (near, facet) = (distance, i);
            } else if towards > 0.0 {
                far = far.min(distance);
            }
        }
        (near < far).then(|| (facet, origin + direction * near))
    }
}

/// Direction and transmittance; nothing where reflection is total.
fn refracted(direction: DVec3, normal: DVec3, eta: f64) -> Option<(DVec3, f64)> {
    let cos_i = -direction.dot(normal);
    let cos_t_squared = 1.0 - eta * eta * (1.0 - cos_i * cos_i);
    if cos_i <= 0.0 || cos_t_squared <= 0.0 {
        return None;
    }
    let cos_t = cos_t_squared.sqrt();
    let (incidence, refraction) = (cos_i.min(1.0).acos(), cos_t.min(1.0).acos());
    let kept = if incidence < 1e-4 {
        4.0 * eta / (1.0 + eta).powi(2)
    } else {
        transmittance(incidence, refraction)
    };
    Some((direction * eta + normal * (eta * cos_i - cos_t), kept))
}

/// Cells of the ground on either side of its middle, of 1 mm.
const REACH: i32 = 20;

fn cell_of(point: DVec3) -> Option<usize> {
    let (x, y) = (point.x.floor() as i32 + REACH, point.y.floor() as i32 + REACH);
    let is_in = |i: i32| (0..2 * REACH).contains(&i);
    (is_in(x) && is_in(y)).then_some((y * 2 * REACH + x) as usize)
}

/// Irradiance of the ground's cells by following light of irradiance 1 from a lamp.
fn forward_map(solid: &Forward, height: f64, towards: DVec3, radius_radians: f64) -> Vec<f64> {
    let mut map = vec![0.0; (4 * REACH * REACH) as usize];
    let mut state = 1;
    let mut random = || {
        state += 1;
        f64::from(unit_float(hash(state)))
    };
    let (u, v) = towards.any_orthonormal_pair();
    let (count, half) = (1_500_000, 6.0);
    let weight = (2.0 * half) * (2.0 * half) / f64::from(count);
    for _ in 0..count {
        let (fall, azimuth) = (random().sqrt() * radius_radians.sin(), 2.0 * PI * random());
        let light = (towards + (u * azimuth.cos() + v * azimuth.sin()) * fall).normalize();
        let across = u * (half * (2.0 * random() - 1.0)) + v * (half * (2.0 * random() - 1.0));
        let Some((facet, point)) = solid.entry(across + light * 50.0, -light) else { continue };
        let Some((point, behind, kept)) = solid.through(point, -light, facet) else { continue };
        if behind.z < 0.0
            && let Some(cell) = cell_of(point + behind * ((height - point.z) / behind.z))
        {
            map[cell] += weight * kept;
        }
    }
    map
}

#[test]
fn a_brilliant_throws_what_light_followed_from_the_lamp_finds() {
    let cut = RoundBrilliant { diameter_mm: 8.0, ..RoundBrilliant::default() };
    let (n, height, radius_degrees) = (1.54, -5.0, 1.5);
    let towards = DVec3::new(0.35, -0.2, 1.0).normalize();
    let disc = flat_disc(towards.as_vec3(), radius_degrees, 1.0);
    let disc = DiscLight { radiance: 1.0 / disc.solid_angle_steradians(), ..disc };
    let stone = thrower(object(Shape::RoundBrilliant(cut), clear(plain(n))));
    let mut thrown = Thrown::new(&over_ground(height, vec![stone], disc));
    let solid = Forward { planes: cut.half_spaces().expect("a solid"), n };
    let expected = forward_map(&solid, height, towards, f64::from(radius_degrees).to_radians());
    let (mut apart, mut total, mut flux) = (0.0, 0.0, 0.0);
    for (cell, expected) in expected.iter().enumerate() {
        let (x, y) = (cell as i32 % (2 * REACH) - REACH, cell as i32 / (2 * REACH) - REACH);
        let mut found = 0.0;
        // Twenty times twenty points, each at its own point of the lamp.
        for i in 0..400 {
            let place = |at: i32, i: u32| f64::from(at) + (f64::from(i) + 0.5) / 20.0;
            found += thrown.read(place(x, i % 20), place(y, i / 20), i)[2] / 400.0;
        }
        apart += (found - expected).abs();
        total += found;
        flux += expected;
    }
    assert!(flux > 5.0, "much of the light of {} mm² gets through: {flux}", FRAC_PI_4 * 64.0);
    assert!((total / flux - 1.0).abs() < 0.01, "{total} {flux}");
    assert!(apart < 0.08 * flux, "{apart} of {flux}");
}

#[test]
fn what_cannot_throw_light_is_refused_by_name() {
    let packing = |objects: Vec<Object>, discs: usize| -> Result<PackedScene, RendererError> {
        let disc = |i: usize| {
            let azimuth = 0.1 * i as f64;
            let discs = DVec3::new(0.6 * azimuth.cos(), 0.6 * azimuth.sin(), 0.8);
            flat_disc(discs.as_vec3(), 3.0, 1.0)
        };
        let discs = (0..discs).map(disc).collect();
        PackedScene::new(&scene(objects, Lights { discs, ..Lights::default() }), Bins::new(BINS))
    };
    let matte = Material::Diffuse(Diffuse { reflectance: Spectrum::Flat(0.5), print: None });
    let block = thrower(object(block(DVec3::ONE), matte));
    let fault = packing(vec![block], 1).expect_err("matte").to_string();
    assert!(fault.contains("test") && fault.contains("matte"), "{fault}");
    let quartz = thrower(brilliant(plain(1.54)));
    let count = packing(vec![quartz.clone()], 1).expect("it packs").passages.len();
    assert!((100..1500).contains(&count), "{count}");
    let fault = packing(vec![quartz], 1 + MAX_PASSAGES / 100).expect_err("many").to_string();
    assert!(fault.contains("8192"), "{fault}");
}

/// A ball of facets, by the golden angle.
fn ball(facets: usize) -> Object {
    let normal = |i: usize| {
        let z = 1.0 - 2.0 * (i as f64 + 0.5) / facets as f64;
        let azimuth = 2.399_963 * i as f64;
        let radius = (1.0 - z * z).sqrt();
        DVec3::new(radius * azimuth.cos(), radius * azimuth.sin(), z)
    };
    let half_spaces = (0..facets).map(|i| half_space(normal(i), 5.0)).collect();
    thrower(object(Shape::Polyhedron(half_spaces), clear(plain(1.0))))
}

/// Light goes straight through nothing else in as many ways as through a ball of air under a sky
/// of one lamp; a body with more facets is not even tried.
#[test]
fn too_many_facets_are_refused_at_once() {
    let sky = flat_disc(Vec3::Z, 90.0, 1.0);
    for (facets, limit) in
        [(MAX_THROWER_FACETS, MAX_PASSAGES), (MAX_THROWER_FACETS + 1, MAX_THROWER_FACETS)]
    {
        let scene = over_ground(-20.0, vec![ball(facets)], sky.clone());
        let start = Instant::now();
        let fault = PackedScene::new(&scene, Bins::new(BINS)).expect_err("too many").to_string();
        assert!(start.elapsed() < Duration::from_secs(1), "{:?}", start.elapsed());
        assert!(fault.contains("test") && fault.contains(&limit.to_string()), "{fault}");
    }
}
