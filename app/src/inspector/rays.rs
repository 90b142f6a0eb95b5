//! The tree of a pixel's rays: its table, and the rays in the picture.

mod brush;
mod detail;
mod fan_shape;
mod filter;
mod legend;
mod outline;
mod overlay;
mod palette;
mod projection;
mod recording;
mod rows;
mod table;
mod totals;
mod traced;
mod trail;

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
use rows::{Order, Rows};
use table::Table;
use trail::Trail;

/// A pointer that has moved less than this since it was pressed, in points, still means the pixel that
/// it has picked, and none of the rays that begin there.
const STILL: f32 = 12.0;

/// What the table is scrolled to.
#[derive(Clone, Copy, Debug)]
enum Bring {
    /// Its first row.
    Top,
    /// A ray that was pointed at in the picture.
    Ray(u32),
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
    /// What is to be brought into sight in the table.
    bring: Option<Bring>,
    /// The rows of the table.
    listed: Rows,
    /// The rays in the picture.
    drawn: Rows,
    /// What the tree is of.
    pick: Option<Pick>,
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
            listed: Rows::default(),
            drawn: Rows::default(),
            pick: None,
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
        let trail = self.trail();
        if !self.recording.update(pick, scene, trace, waker) {
            return;
        }
        self.listed = Rows::default();
        self.drawn = Rows::default();
        self.focus = Focus::default();
        if self.pick.replace(*pick) == Some(*pick) {
            // The stone or the settings have changed.
            let found = trail.zip(self.tree()).map(|(trail, tree)| trail.follow(tree));
            self.focus.selected = found;
        } else {
            self.bring = Some(Bring::Top);
        }
    }

    /// Leaves a tree undone that is not shown any more.
    pub(super) fn rest(&self) {
        self.recording.cancel();
    }

    /// The way to what is selected, when another tree may come.
    fn trail(&self) -> Option<Trail> {
        let selected = self.focus.selected.filter(|_| self.recording.is_running())?;
        self.tree().map(|tree| Trail::to(tree, selected))
    }

    /// Forgets what was recorded and what of it was shown.
    pub(super) fn clear(&mut self) {
        self.recording.clear();
        // A filter for one tree would hide who knows what of another.
        *self = Self {
            recording: std::mem::take(&mut self.recording),
            order: self.order,
            veil: self.veil,
            ..Self::default()
        };
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
        totals::show(ui, traced);
        let shown = self.listed.choose(traced, self.filter, self.order).len();
        self.filter.hint_ui(ui, shown, traced.tree.rays.len());
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
        detail::show(ui, traced, &mut self.focus);
        table::heading_ui(ui);
        let rows = self.listed.choose(traced, self.filter, self.order);
        if rows.is_empty() {
            self.filter.hint_ui(ui, 0, traced.tree.rays.len());
        }
        let bring = self.bring.take().and_then(|bring| match bring {
            Bring::Top => rows.first().copied(),
            Bring::Ray(id) => Some(id),
        });
        let table = Table { traced, rows, is_indented: self.order == Order::Tree };
        table.show(ui, &mut self.focus, bring);
    }

    /// The ray whose path is shown.
    pub(super) fn looked_at(&self) -> Option<u32> {
        self.focus.looked_at()
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
        let rays = self.drawn.choose(traced, self.filter, Order::Strongest);
        let drawing = Drawing {
            traced,
            rays,
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
            // A quick click is pressed and released within one frame, and hovers nothing in it.
            self.pressed_at = painter.ctx().input(|input| input.pointer.latest_pos());
        }
        let has_moved =
            |at: &Pos2| self.pressed_at.is_none_or(|pressed| pressed.distance(*at) > STILL);
        let pointed = drawing.paint(painter, pointer.filter(has_moved));
        // Until the button is released, a click still means what was pointed at.
        let clicks = (is_pressed || is_down) && !picture.dragged();
        let in_picture = if clicks { self.focus.in_picture } else { pointed };
        if in_picture != self.focus.in_picture {
            self.focus.in_picture = in_picture;
            let hidden = in_picture.filter(|id| !self.focus.in_sight.contains(id));
            self.bring = hidden.map(Bring::Ray).or(self.bring);
            painter.ctx().request_repaint();
        }
    }
}
