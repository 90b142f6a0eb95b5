//! How `perturb` divides a ray (Fig. 4 of Thomas 1986), computed by the kernel's own function.

use glam::{DVec2, Vec3};

use super::rect::Rect;
use super::sheet::{Anchor, Ink, Sheet};
use crate::develop::interval_srgb8;
use crate::kernel::interface::refract;
use crate::kernel::ray::Ray;
use crate::kernel::spread::{direction_at, perturb};
use crate::material::Dispersion;
use crate::spectrum::{LAMBDA_MAX_NM, LAMBDA_MIN_NM};

/// Size of each of the two pictures.
const SIZE: DVec2 = DVec2::new(92.0, 50.0);
/// Distance from the left edge of one to that of the other.
const PITCH: f64 = 100.0;
/// Where the ray meets the surface in a picture.
const MEETING: DVec2 = DVec2::new(46.0, 32.0);
/// Length of the rays above the surface and below it.
const ABOVE: f64 = 28.0;
const BELOW: f64 = 16.0;
const PEN_MM: f64 = 0.35;
const THIN_PEN_MM: f64 = 0.18;
const EM_MM: f64 = 3.1;
const SMALL_EM_MM: f64 = 2.8;
const LINE_MM: f64 = 4.4;

/// Angle of incidence, and half the angle of the fan, in degrees: far more than any glass makes.
const INCIDENCE_DEGREES: f32 = 38.0;
const HALF_FAN_DEGREES: f32 = 22.0;
/// The medium below the surface, exaggerated as well.
const GLASS: Dispersion = Dispersion::Linear { n_d: 1.5, dispersion_bg: 0.12 };

/// Draws both pictures and what they show, from `corner` on.
pub(super) fn draw(sheet: &mut Sheet, corner: DVec2) {
    let parent = incident();
    let middle_nm = 0.5 * (parent.lambda_low_nm + parent.lambda_high_nm);
    let parts = [
        perturb(&parent, parent.lambda_low_nm, middle_nm),
        perturb(&parent, middle_nm, parent.lambda_high_nm),
    ];
    surface(sheet, corner);
    fan(sheet, corner, &parent, Ink::Main, "");
    for (part, name) in parts.iter().zip(["1", "2"]) {
        arriving(sheet, corner, part.direction, &Line::dashed(part), name);
    }
    let second = corner + DVec2::new(PITCH, 0.0);
    surface(sheet, second);
    for (part, name) in parts.iter().zip(["1", "2"]) {
        fan(sheet, second, part, light(part), name);
        refracted(sheet, second, part);
    }
    words(sheet, corner + DVec2::new(2.0 * PITCH, 0.0));
}

/// A ray over all of the spectrum with a wide fan, in the plane of x and z.
fn incident() -> Ray {
    let (sin, cos) = INCIDENCE_DEGREES.to_radians().sin_cos();
    let direction = Vec3::new(sin, 0.0, -cos);
    let aside = Vec3::new(cos, 0.0, sin);
    let spread = aside * HALF_FAN_DEGREES.to_radians().tan();
    Ray { spread, ..Ray::white(Vec3::ZERO, direction) }
}

/// How an arriving ray is drawn.
struct Line {
    ink: Ink,
    width_mm: f64,
    is_dashed: bool,
}

impl Line {
    fn dashed(ray: &Ray) -> Self {
        Self { ink: light(ray), width_mm: PEN_MM, is_dashed: true }
    }
}

/// The surface with its normal, glass below.
fn surface(sheet: &mut Sheet, corner: DVec2) {
    let level = corner.y + MEETING.y;
    let glass = Rect { min: DVec2::new(corner.x, level), max: corner + SIZE };
    sheet.fill(glass.corners(), Ink::Tint);
    sheet.stroke([glass.min, DVec2::new(glass.max.x, level)], PEN_MM, Ink::Main);
    let meeting = corner + MEETING;
    let normal = [meeting - DVec2::new(0.0, ABOVE), meeting + DVec2::new(0.0, BELOW)];
    sheet.dashes(normal, THIN_PEN_MM, Ink::Fine);
}

/// A ray and the two that bound its spread.
fn fan(sheet: &mut Sheet, corner: DVec2, ray: &Ray, ink: Ink, name: &str) {
    for lambda_nm in [ray.lambda_low_nm, ray.lambda_high_nm] {
        let color = interval_srgb8([f64::from(lambda_nm); 2]);
        let thin = Line { ink: Ink::Light(color), width_mm: THIN_PEN_MM, is_dashed: false };
        arriving(sheet, corner, direction_at(ray, lambda_nm), &thin, "");
    }
    let line = Line { ink, width_mm: PEN_MM, is_dashed: false };
    arriving(sheet, corner, ray.direction, &line, name);
}

/// A ray that arrives along `direction`, with its name where it comes from.
fn arriving(sheet: &mut Sheet, corner: DVec2, direction: Vec3, line: &Line, name: &str) {
    let meeting = corner + MEETING;
    let along = on_paper(direction);
    let start = meeting - ABOVE * along;
    if line.is_dashed {
        sheet.dashes([start, meeting], line.width_mm, line.ink);
    } else {
        sheet.stroke([start, meeting], line.width_mm, line.ink);
    }
    if !name.is_empty() {
        let at = start - 2.6 * along + DVec2::new(0.0, 1.1);
        sheet.write(name, at, Anchor::Middle, EM_MM, Ink::Main);
    }
}

/// What becomes of a part in the glass, at its central wavelength.
fn refracted(sheet: &mut Sheet, corner: DVec2, part: &Ray) {
    let central_nm = f64::from(0.5 * (part.lambda_low_nm + part.lambda_high_nm));
    let eta = (1.0 / GLASS.n(central_nm)) as f32;
    let along = on_paper(refract(part.direction, Vec3::Z, eta));
    let meeting = corner + MEETING;
    let tip = meeting + BELOW * along;
    sheet.stroke([meeting, tip], PEN_MM, light(part));
    sheet.arrow_head(tip, along, light(part));
}

fn words(sheet: &mut Sheet, corner: DVec2) {
    let lines = [
        "A ray with its spread (left)",
        "is divided in two. Each part",
        "takes the mean of the ray's",
        "direction and that of one end,",
        "and half of the spread (right).",
        "Both meet the surface at the",
        "same point, so that it need not",
        "be found again.",
    ];
    let heading = corner + DVec2::new(0.0, 2.4);
    sheet.write("How perturb divides a ray", heading, Anchor::Start, EM_MM, Ink::Main);
    for (index, line) in lines.into_iter().enumerate() {
        let at = heading + DVec2::new(0.0, 1.4 + LINE_MM * (index as f64 + 1.0));
        sheet.write(line, at, Anchor::Start, SMALL_EM_MM, Ink::Fine);
    }
}

/// A direction in the plane of x and z, with y down.
fn on_paper(direction: Vec3) -> DVec2 {
    DVec2::new(f64::from(direction.x), -f64::from(direction.z))
}

fn light(ray: &Ray) -> Ink {
    let ends = [ray.lambda_low_nm, ray.lambda_high_nm];
    if ends == [LAMBDA_MIN_NM, LAMBDA_MAX_NM] {
        return Ink::Main;
    }
    Ink::Light(interval_srgb8(ends.map(f64::from)))
}
