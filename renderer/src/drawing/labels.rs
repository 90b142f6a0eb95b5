//! Names and angles of facets: inside a facet where there is room, else beside the figure with a
//! leader.

use glam::DVec2;

use super::facet_class::FacetClass;
use super::figure::{Figure, Spot};
use super::font;
use super::rect::Rect;
use super::sheet::{Anchor, Ink, Sheet};
use super::view::crossing;

/// Size of the letters, in mm.
pub(super) const EM_MM: f64 = 2.9;
/// From baseline to baseline, in mm.
const LINE_MM: f64 = 1.25 * EM_MM;
/// Least distance of a label from the edges of its facet, in mm.
const MARGIN_MM: f64 = 0.6;
/// Distance of a label outside from the outline, in mm.
const GAP_MM: f64 = 5.0;
/// Distance from one place outside that is tried to the next, in mm.
const STEP_MM: f64 = 0.5 * EM_MM;
/// Space between a leader and its label, in mm.
const LEADER_GAP_MM: f64 = 0.9;
/// Length that a leader may be longer to cross one edge less, in mm.
const DISTURBANCE_MM: f64 = 2.0;
const LEADER_PEN_MM: f64 = 0.15;
const DOT_MM: f64 = 0.4;

/// The labels of one figure.
pub(super) struct Labels<'a> {
    figure: &'a Figure<'a>,
    /// What labels outside and their leaders keep clear of.
    taken: Vec<Rect>,
    placed: Vec<Label>,
}

struct Label {
    lines: Vec<String>,
    room: Rect,
    /// From the label to the facet.
    leader: Option<[DVec2; 2]>,
}

/// A label outside that could be, and how bad it is.
struct Candidate {
    room: Rect,
    leader: [DVec2; 2],
    cost: f64,
}

impl<'a> Labels<'a> {
    /// No labels yet, in `figure`, none of which may lie on `taken`.
    pub(super) fn new(figure: &'a Figure<'a>, taken: Vec<Rect>) -> Self {
        Self { figure, taken, placed: Vec::new() }
    }

    /// Places a label for each of `classes`, the largest first; those outside within `room`. Where
    /// there is no room left, a class goes without.
    pub(super) fn place<'c>(
        &mut self,
        classes: impl IntoIterator<Item = &'c FacetClass>,
        room: Rect,
    ) {
        let mut classes: Vec<_> = classes.into_iter().collect();
        classes.sort_by(|a, b| b.area.total_cmp(&a.area));
        let (inside, outside): (Vec<_>, Vec<_>) = classes
            .into_iter()
            .map(|class| (class, self.inside(class)))
            .partition(|(_, l)| l.is_some());
        self.placed.extend(inside.into_iter().filter_map(|(_, label)| label));
        for (class, _) in outside {
            if let Some(label) = self.outside(class, room) {
                self.placed.push(label);
            }
        }
    }

    /// Draws what has been placed.
    pub(super) fn draw(&self, sheet: &mut Sheet) {
        for Label { lines, room, leader } in &self.placed {
            if let Some(leader) = leader {
                sheet.stroke(*leader, LEADER_PEN_MM, Ink::Fine);
                sheet.dot(leader[1], DOT_MM, Ink::Fine);
            }
            let middle = room.center().x;
            for (index, line) in lines.iter().enumerate() {
                let baseline = room.min.y + font::CAP_HEIGHT * EM_MM + LINE_MM * index as f64;
                sheet.write(line, DVec2::new(middle, baseline), Anchor::Middle, EM_MM, Ink::Main);
            }
        }
    }

    /// The label in that of the class's facets that has the most room for it, if any has enough.
    fn inside(&self, class: &FacetClass) -> Option<Label> {
        let angle = class.angle_text();
        let one_line = vec![format!("{} {angle}", class.name)];
        for lines in [vec![class.name.clone(), angle], one_line] {
            let size = size_of(&lines);
            if let Some(spot) = self.roomiest(class, size) {
                return Some(Label { lines, room: Rect::centered(spot.at, size), leader: None });
            }
        }
        None
    }

    fn roomiest(&self, class: &FacetClass, size: DVec2) -> Option<Spot> {
        let spots = class.facets.iter().filter_map(|&facet| self.figure.spot(facet, size));
        let roomy = spots.filter(|spot| spot.clearance >= MARGIN_MM);
        roomy.reduce(|best, spot| if better(&spot, &best) { spot } else { best })
    }

    /// The label beside the figure with the shortest leader that crosses nothing that it must not.
    fn outside(&self, class: &FacetClass, room: Rect) -> Option<Label> {
        let lines = vec![format!("{} {}", class.name, class.angle_text())];
        let size = size_of(&lines);
        let spots: Vec<DVec2> =
            class.facets.iter().flat_map(|&facet| self.figure.footholds(facet)).collect();
        let steps = (room.size().y / STEP_MM).floor() as u32;
        let mut best: Option<Candidate> = None;
        for step in 0..=steps {
            let y = room.min.y + 0.5 * size.y + STEP_MM * f64::from(step);
            for side in [1.0, -1.0] {
                let Some(place) = self.beside(y, side, size, room) else { continue };
                let from = place.center() - DVec2::new(side * (0.5 * size.x + LEADER_GAP_MM), 0.0);
                for &spot in &spots {
                    let leader = [from, spot];
                    let is_far = best.as_ref().is_some_and(|best| from.distance(spot) >= best.cost);
                    if is_far || place.is_crossed_by(leader) || self.is_blocked(leader) {
                        continue;
                    }
                    let disturbance = self.figure.disturbance(leader) as f64;
                    let cost = from.distance(spot) + DISTURBANCE_MM * disturbance;
                    if best.as_ref().is_none_or(|best| cost < best.cost - 1e-6) {
                        best = Some(Candidate { room: place, leader, cost });
                    }
                }
            }
        }
        let Candidate { room, leader, .. } = best?;
        Some(Label { lines, room, leader: Some(leader) })
    }

    /// The place for a label of `size` at the height `y`, right of the outline (`side` 1) or left
    /// (−1), if it is free.
    fn beside(&self, y: f64, side: f64, size: DVec2, room: Rect) -> Option<Rect> {
        let band = [y - 0.5 * size.y - 1.0, y + 0.5 * size.y + 1.0];
        let reach = self.figure.reach(side, band).unwrap_or(self.figure.bounds.center().x);
        let middle = reach + side * (GAP_MM + 0.5 * size.x);
        let place = Rect::centered(DVec2::new(middle, y), size);
        let near = place.grown(0.5);
        let free = !self
            .taken
            .iter()
            .chain(self.placed.iter().map(|label| &label.room))
            .any(|other| other.overlaps(&near));
        let clear = !self
            .placed
            .iter()
            .filter_map(|label| label.leader)
            .any(|leader| near.is_crossed_by(leader));
        (room.contains(&place) && free && clear).then_some(place)
    }

    /// True if a leader would cross a label, another leader or what is taken.
    fn is_blocked(&self, leader: [DVec2; 2]) -> bool {
        self.taken.iter().any(|rect| rect.is_crossed_by(leader))
            || self.placed.iter().any(|label| {
                label.room.grown(0.4).is_crossed_by(leader)
                    || label.leader.is_some_and(|other| crossing(leader, other).is_some())
            })
    }
}

/// Whether `spot` suits a label better: with more room, else higher up, else nearer the right.
fn better(spot: &Spot, than: &Spot) -> bool {
    const ALIKE_MM: f64 = 0.05;
    let order = |a: f64, b: f64| if (a - b).abs() < ALIKE_MM { None } else { Some(a > b) };
    order(spot.clearance, than.clearance)
        .or_else(|| order(than.at.y, spot.at.y))
        .or_else(|| order(spot.at.x, than.at.x))
        .unwrap_or(false)
}

/// The room that lines of text take.
fn size_of(lines: &[String]) -> DVec2 {
    let width = lines.iter().map(|line| font::width(line, EM_MM)).fold(0.0, f64::max);
    let height = font::CAP_HEIGHT + font::DESCENT;
    DVec2::new(width, EM_MM * height + LINE_MM * (lines.len() as f64 - 1.0))
}
