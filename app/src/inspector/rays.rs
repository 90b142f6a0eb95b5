//! The tree of a pixel's rays: its table, and the rays in the picture.

mod brush;
mod detail;
mod filter;
mod legend;
mod outline;
mod overlay;
mod palette;
mod projection;
mod recording;
mod table;
mod totals;
mod traced;

use std::sync::Arc;

use brilliance_renderer::camera::Camera;
use brilliance_renderer::inspect::RayTree;
use brilliance_renderer::scene::Scene;
use brilliance_renderer::settings::TraceSettings;
use eframe::egui::{CollapsingHeader, Painter, Pos2, Response, RichText, Ui};

use super::Pick;
use crate::row::{SliderRow, choice};
use crate::theme;
use crate::waker::Waker;
use filter::Filter;
use overlay::Drawing;
use projection::Projection;
use recording::Recording;
use table::Table;
use traced::Traced;

/// A pointer that has moved less than this since it was pressed, in points, still means the pixel that
/// it has picked, and none of the rays that begin there.
const STILL: f32 = 12.0;

/// In which order the rays are listed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Order {
    /// Each before those that came of it.
    #[default]
    Tree,
    /// The most significant first.
    Strongest,
}

/// What is looked at.
#[derive(Clone, Debug, Default)]
struct Focus {
    /// The row under the pointer.
    row: Option<u32>,
    /// The ray under the pointer, in the picture.
    in_picture: Option<u32>,
    /// What was clicked on.
    selected: Option<u32>,
    /// The rows that can be seen.
    in_sight: Vec<u32>,
}

impl Focus {
    /// The ray whose path is shown.
    fn looked_at(&self) -> Option<u32> {
        self.row.or(self.in_picture).or(self.selected)
    }
}

/// The tab and its picture.
#[derive(Debug)]
pub(super) struct Rays {
    recording: Recording,
    filter: Filter,
    order: Order,
    focus: Focus,
    /// How much of the picture the rays cover, 0..=1.
    veil: f32,
    /// A ray that was pointed at in the picture, to be brought into sight in the table.
    bring: Option<u32>,
    /// Where the pointer was pressed last.
    pressed_at: Option<Pos2>,
}

impl Default for Rays {
    fn default() -> Self {
        Self {
            recording: Recording::default(),
            filter: Filter::default(),
            order: Order::default(),
            focus: Focus::default(),
            veil: Self::VEIL,
            bring: None,
            pressed_at: None,
        }
    }
}

impl Rays {
    /// The veil that leaves the picture to be guessed.
    const VEIL: f32 = 0.8;

    /// Sees to it that the tree is that of `pick`, as it would be in `scene` now.
    pub(super) fn update(
        &mut self,
        pick: &Pick,
        scene: &Arc<Scene>,
        trace: &TraceSettings,
        waker: &Waker,
    ) {
        if self.recording.update(pick, scene, trace, waker) {
            self.focus = Focus::default();
        }
    }

    /// Leaves a tree undone that is not shown any more.
    pub(super) fn rest(&self) {
        self.recording.cancel();
    }

    /// Forgets what was recorded.
    pub(super) fn clear(&mut self) {
        self.recording.clear();
        self.focus = Focus::default();
        self.pressed_at = None;
    }

    /// The tree that is shown.
    pub(super) fn tree(&self) -> Option<&RayTree> {
        self.recording.tree().map(|traced| &traced.tree)
    }

    /// Shows the tab.
    pub(super) fn show(&mut self, ui: &mut Ui) {
        if let Some(fault) = self.recording.fault() {
            ui.label(RichText::new("The rays can't be followed").strong().color(theme::ERROR));
            ui.label(fault);
        }
        let Some(traced) = self.recording.tree() else {
            if self.recording.is_running() {
                ui.horizontal(|ui| {
                    ui.spinner();
                    ui.label("Following the rays\u{2026}");
                });
            }
            return;
        };
        totals::show(ui, &traced.tree);
        CollapsingHeader::new("Show").default_open(false).show(ui, |ui| {
            self.filter.show(ui, traced.deepest);
            SliderRow::new("Veil", "Covers the picture under the rays.", 0.0..=1.0, Self::VEIL)
                .percent()
                .decimals(0)
                .show_f32(ui, &mut self.veil);
        });
        let orders = [(Order::Tree, "along the tree"), (Order::Strongest, "strongest first")];
        choice(ui, "Order", "The order of the rays below.", &mut self.order, &orders);
        ui.separator();
        let rows = rows(traced, &self.filter, self.order);
        detail::show(ui, traced, &mut self.focus);
        table::heading_ui(ui);
        if rows.is_empty() {
            ui.label(RichText::new("No ray is like this.").color(theme::TEXT_WEAK));
        }
        let table = Table { traced, rows: &rows, is_indented: self.order == Order::Tree };
        table.show(ui, &mut self.focus, self.bring.take());
    }

    /// Selects the ray under the pointer; false where there is none.
    pub(super) fn select_pointed(&mut self) -> bool {
        let pointed = self.focus.in_picture;
        self.focus.selected = pointed.or(self.focus.selected);
        pointed.is_some()
    }

    /// Selects nothing; false where nothing was selected.
    pub(super) fn deselect(&mut self) -> bool {
        self.focus.selected.take().is_some()
    }

    /// Draws the tree over the `picture`, which shows `size` pixels of what `camera` sees.
    pub(super) fn overlay(
        &mut self,
        painter: &Painter,
        picture: &Response,
        size: [u32; 2],
        camera: &Camera,
    ) {
        let room = picture.rect;
        let Some(traced) = self.recording.tree() else { return };
        let rays = rows(traced, &self.filter, Order::Strongest);
        let drawing = Drawing {
            traced,
            rays: &rays,
            focus: self.focus.clone(),
            veil: self.veil,
            projection: Projection::new(camera, size, room),
            room,
        };
        // Another window may lie between the pointer and the picture.
        let pointer = picture.hover_pos();
        let (is_pressed, is_down) =
            painter.ctx().input(|input| (input.pointer.any_pressed(), input.pointer.any_down()));
        if is_pressed || is_down {
            // A quick click is pressed and released within one frame.
            self.pressed_at = pointer;
        }
        let has_moved =
            |at: &Pos2| self.pressed_at.is_none_or(|pressed| pressed.distance(*at) > STILL);
        let pointed = drawing.paint(painter, pointer.filter(has_moved));
        // Until the button is released, a click still means what was pointed at.
        let clicks = (is_pressed || is_down) && !picture.dragged();
        let in_picture = if clicks { self.focus.in_picture } else { pointed };
        if in_picture != self.focus.in_picture {
            self.focus.in_picture = in_picture;
            self.bring = in_picture.filter(|id| !self.focus.in_sight.contains(id));
            painter.ctx().request_repaint();
        }
    }
}

/// The rays that the filter lets through.
fn rows(traced: &Traced, filter: &Filter, order: Order) -> Vec<u32> {
    let all: &mut dyn Iterator<Item = u32> = match order {
        Order::Tree => &mut (0..traced.tree.rays.len() as u32),
        Order::Strongest => &mut traced.strongest.iter().copied(),
    };
    all.filter(|&id| filter.admits(traced, id)).collect()
}
