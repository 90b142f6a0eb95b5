//! The prism diagram: how rays leave a prism without and with `perturb`, as in Fig. 3 of Thomas
//! 1986, and how `perturb` divides a ray, as in its Fig. 4.

use glam::DVec2;

use super::perturb_figure;
use super::prism_rays::{PrismRay, PrismRays, PrismSetup};
use super::rect::Rect;
use super::sheet::{Anchor, Ink, Sheet};
use crate::develop::interval_srgb8;
use crate::error::RendererError;

/// A4, lying.
const SIZE_MM: DVec2 = DVec2::new(297.0, 210.0);
const TITLE_EM_MM: f64 = 5.2;
const EM_MM: f64 = 3.1;
const SMALL_EM_MM: f64 = 2.8;
const LINE_MM: f64 = 4.4;
/// Left edge and upper edge of the pictures, the width of all of them and the height of each.
const LEFT: f64 = 12.0;
const TOP: f64 = 30.0;
const WIDTH: f64 = 273.0;
const HEIGHT: f64 = 76.0;
/// Distance between two pictures.
const GUTTER: f64 = 7.0;
/// Where the ray meets the prism, over the size of the picture.
const ENTRY: DVec2 = DVec2::new(0.36, 0.46);
/// Millimetres of paper per millimetre of the prism.
const SCALE: f64 = 2.2;
/// Height of the strip that shows the directions of the leaving rays, and its distance.
const STRIP_HEIGHT: f64 = 9.0;
const STRIP_GAP: f64 = 3.0;
const RAY_PEN_MM: f64 = 0.28;
const GLASS_PEN_MM: f64 = 0.35;
/// How far leaving rays are looked at for crossings, in mm of the prism.
const REACH_MM: f64 = 40.0;

/// Which pictures a prism diagram has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PerturbShown {
    /// Without `perturb`.
    Off,
    /// With it.
    On,
    /// Both, side by side.
    #[default]
    Both,
}

impl PerturbShown {
    fn values(self) -> &'static [bool] {
        match self {
            Self::Off => &[false],
            Self::On => &[true],
            Self::Both => &[false, true],
        }
    }
}

/// The diagram of `setup`: what leaves the prism without `perturb` or with it, and below how
/// `perturb` divides a ray.
///
/// # Errors
/// As [`PrismRays::trace`].
pub fn prism_diagram(setup: &PrismSetup, shown: PerturbShown) -> Result<Sheet, RendererError> {
    let rays = [PrismRays::trace(setup, false)?, PrismRays::trace(setup, true)?];
    let mut sheet = Sheet::new("How rays are divided in a prism", SIZE_MM);
    let title = DVec2::new(LEFT, 16.0);
    sheet.write(sheet.title.clone(), title, Anchor::Start, TITLE_EM_MM, Ink::Main);
    let values = format!(
        "Apex {:.0}°, n(D) = {:.3}, dispersion B–G {:.3}, incidence {}°; K = {:.1}, smallest lamp {:.1}°",
        setup.apex_degrees,
        setup.n_d,
        setup.dispersion_bg,
        format!("{:.0}", setup.incidence_degrees).replace('-', "\u{2212}"),
        setup.split_count,
        setup.lamp_degrees
    );
    sheet.write(values, title + DVec2::new(0.0, 6.4), Anchor::Start, EM_MM, Ink::Fine);
    let degrees = deviations(&rays);
    let values = shown.values();
    let width = (WIDTH + GUTTER) / values.len() as f64 - GUTTER;
    for (index, &perturb) in values.iter().enumerate() {
        let rays = &rays[usize::from(perturb)];
        let corner = DVec2::new(LEFT + (width + GUTTER) * index as f64, TOP);
        let room = Rect { min: corner, max: corner + DVec2::new(width, HEIGHT) };
        picture(&mut sheet, room, setup, rays, degrees);
        let strip = Rect {
            min: DVec2::new(room.min.x, room.max.y + STRIP_GAP),
            max: room.max + DVec2::new(0.0, STRIP_GAP + STRIP_HEIGHT),
        };
        directions(&mut sheet, strip, rays, degrees);
        words(&mut sheet, strip, rays, perturb, degrees);
    }
    perturb_figure::draw(&mut sheet, DVec2::new(LEFT, 146.0));
    Ok(sheet)
}

/// The prism and its rays, in the dark.
fn picture(
    sheet: &mut Sheet,
    room: Rect,
    setup: &PrismSetup,
    rays: &PrismRays,
    [least, most]: [f64; 2],
) {
    sheet.fill(room.corners(), Ink::Dark);
    let entry = setup.entry();
    // Turned so that what arrives and what leaves make equal angles with the horizontal.
    let upright = DVec2::from_angle((0.25 * (least + most)).to_radians());
    let turn = upright.rotate(rays.arrival * DVec2::new(1.0, -1.0));
    let place = |point: DVec2| {
        let turned = turn.rotate(point - entry);
        room.min + ENTRY * room.size() + SCALE * DVec2::new(turned.x, -turned.y)
    };
    let white = [rays.white.from, rays.white.to.unwrap_or(rays.white.from)].map(place);
    if let Some(ends) = room.clipped(white) {
        sheet.stroke(ends, RAY_PEN_MM, light(&rays.white));
    }
    for ray in rays.inside.iter().chain(&rays.leaving) {
        // What goes on for ever ends at the picture's rim.
        let to = ray.to.unwrap_or(ray.from + 1e3 * ray.direction);
        if let Some(ends) = room.clipped([ray.from, to].map(place)) {
            sheet.stroke(ends, RAY_PEN_MM, light(ray));
        }
    }
    let corners: Vec<DVec2> = setup.corners().into_iter().map(place).collect();
    for (index, corner) in corners.iter().enumerate() {
        if let Some(ends) = room.clipped([*corner, corners[(index + 1) % corners.len()]]) {
            sheet.stroke(ends, GLASS_PEN_MM, Ink::Pale);
        }
    }
}

/// Each leaving ray at its deviation, as wide as its spread: those of one parent in one row, so that
/// what overlaps is seen.
fn directions(sheet: &mut Sheet, strip: Rect, rays: &PrismRays, [from, to]: [f64; 2]) {
    const THINNEST_MM: f64 = 0.25;
    const MOST_ROWS: usize = 8;
    sheet.fill(strip.corners(), Ink::Dark);
    let mut parents: Vec<u32> = rays.leaving.iter().map(|ray| ray.parent).collect();
    parents.dedup();
    let rows = parents.len().clamp(1, MOST_ROWS);
    let row_height = (strip.size().y - 1.0) / rows as f64;
    for ray in &rays.leaving {
        let place = |degrees: f64| {
            strip.min.x + 2.0 + (strip.size().x - 4.0) * (degrees - from) / (to - from)
        };
        let [a, b] = ray.deviation_interval(rays.arrival).map(place);
        let (middle, half) = (0.5 * (a + b), (0.5 * (b - a).abs() - 0.06).max(0.5 * THINNEST_MM));
        let row = parents.iter().position(|parent| *parent == ray.parent).unwrap_or(0) % rows;
        let top = strip.min.y + 0.5 + row_height * row as f64;
        let bar = Rect {
            min: DVec2::new(middle - half, top + 0.1),
            max: DVec2::new(middle + half, top + row_height - 0.1),
        };
        sheet.fill(bar.corners(), light(ray));
    }
}

/// What one sees, in words and numbers.
fn words(sheet: &mut Sheet, strip: Rect, rays: &PrismRays, perturb: bool, degrees: [f64; 2]) {
    let (caption, reason) = if perturb {
        ("perturb on", "Each sub-ray arrives from the direction of its own wavelengths.")
    } else {
        ("perturb off", "All sub-rays of a ray arrive from the direction of its middle.")
    };
    let count = rays.leaving.len();
    let numbers = if count == 0 {
        "No ray leaves: all light is totally reflected.".to_owned()
    } else {
        format!(
            "{count} {} leave, {:.0} % of the fan lies in gaps, {} pairs cross.",
            if count == 1 { "ray" } else { "rays" },
            100.0 * rays.uncovered(),
            rays.crossings(REACH_MM)
        )
    };
    let mut at = DVec2::new(strip.min.x, strip.max.y + 5.2);
    sheet.write(caption, at, Anchor::Start, EM_MM, Ink::Main);
    let range = format!("turned by {:.1}° to {:.1}°", degrees[0], degrees[1]);
    let right = DVec2::new(strip.max.x, at.y);
    sheet.write(range, right, Anchor::End, SMALL_EM_MM, Ink::Fine);
    for line in [reason.to_owned(), numbers] {
        at.y += LINE_MM;
        sheet.write(line, at, Anchor::Start, SMALL_EM_MM, Ink::Fine);
    }
}

/// The least and the greatest deviation of any leaving ray, in degrees.
fn deviations(pictures: &[PrismRays; 2]) -> [f64; 2] {
    let spans = pictures.iter().filter_map(PrismRays::deviations);
    let all = spans.reduce(|[a, b], [low, high]| [a.min(low), b.max(high)]);
    let [low, high] = all.unwrap_or([0.0, 1.0]);
    [low, high.max(low + 1e-3)]
}

fn light(ray: &PrismRay) -> Ink {
    Ink::Light(interval_srgb8(ray.interval_nm))
}
