//! The inspector: what is picked in the picture, and the panel that explains it.

mod pick;
mod rays;
mod spectrum;

use std::sync::Arc;

use brilliance_renderer::camera::Camera;
use brilliance_renderer::film::{PixelRect, Region};
use brilliance_renderer::inspect::RayTree;
use brilliance_renderer::scene::Scene;
use brilliance_renderer::session::Reading;
use brilliance_renderer::settings::{DisplaySettings, TraceSettings};
use eframe::egui::{Frame, Margin, Painter, Panel, Response, RichText, ScrollArea, Ui};

use crate::theme;
use crate::waker::Waker;
use pick::paint_pick;
pub use pick::{Pick, pixels_between};
use rays::Rays;
use spectrum::SpectrumTab;

/// What of a pixel is explained.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tab {
    /// The tree of its rays.
    #[default]
    Rays,
    /// Its spectrum.
    Spectrum,
}

/// The panel at the left edge, and what is drawn over the picture for it.
#[derive(Debug, Default)]
pub struct Inspector {
    shown: bool,
    tab: Tab,
    pick: Option<Pick>,
    rays: Rays,
    spectrum: SpectrumTab,
}

impl Inspector {
    /// Whether the panel is open, so that a click on the picture picks.
    pub fn is_shown(&self) -> bool {
        self.shown
    }

    /// Opens the panel, or closes it.
    pub fn toggle(&mut self) {
        self.shown = !self.shown;
    }

    /// What of the picture is picked.
    pub fn pick(&self) -> Option<&Pick> {
        self.pick.as_ref()
    }

    /// Picks pixels of the picture that `camera` sees.
    pub fn set_pick(&mut self, pixels: PixelRect, size: [u32; 2], camera: Camera) {
        self.pick = Some(Pick { pixels, size, camera });
    }

    /// The part of a picture of `size` whose spectrum is shown, or else all of it, so that the session
    /// is ready for one that will be.
    pub fn watched(&self, size: [u32; 2]) -> Option<Region> {
        let pick = self.pick.filter(|_| self.tab == Tab::Spectrum);
        let region = pick.and_then(|pick| pick.region(size));
        self.shown.then(|| region.unwrap_or(Region::WHOLE))
    }

    /// Forgets what belongs to a document that is no longer open.
    pub fn clear(&mut self) {
        self.pick = None;
        self.rays.clear();
    }

    /// The tree of rays that is shown.
    pub fn ray_tree(&self) -> Option<&RayTree> {
        self.rays.tree()
    }

    /// The ray of the tree that is pointed at or selected.
    pub fn looked_at_ray(&self) -> Option<u32> {
        self.rays.looked_at()
    }

    /// Has the rays of what is picked followed, where that is shown and not done yet; no others.
    pub fn follow_rays(&mut self, scene: &Arc<Scene>, trace: &TraceSettings, waker: &Waker) {
        if let Some(pick) = self.pick.filter(|_| self.shown && self.tab == Tab::Rays) {
            self.rays.update(&pick, scene, trace, waker);
        } else {
            self.rays.rest();
        }
    }

    /// Shows the panel, if it is open: the newest `reading` of what is watched, and what the display
    /// settings make of it.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        size: [u32; 2],
        reading: Option<&Arc<Reading>>,
        display: &DisplaySettings,
    ) {
        if !self.shown {
            return;
        }
        let frame = Frame::new().fill(theme::PANEL).inner_margin(Margin::symmetric(14, 6));
        Panel::left("inspector").frame(frame).default_size(400.0).size_range(320.0..=640.0).show(
            ui,
            |ui| {
                ui.horizontal(|ui| {
                    for (tab, name) in [(Tab::Rays, "Rays"), (Tab::Spectrum, "Spectrum")] {
                        ui.selectable_value(&mut self.tab, tab, RichText::new(name).strong());
                    }
                    let text = self.pick.map_or(String::new(), |pick| pick.pixels.to_string());
                    ui.label(RichText::new(text).color(theme::TEXT_WEAK));
                });
                ui.separator();
                match (self.tab, self.pick) {
                    (_, None) => empty_ui(ui, self.tab),
                    (Tab::Rays, Some(_)) => self.rays.show(ui),
                    (Tab::Spectrum, Some(pick)) => match pick.region(size) {
                        None => {
                            ui.label("What was picked is beside the picture now.");
                        }
                        Some(region) => {
                            ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
                                self.spectrum.show(ui, region, reading, display);
                            });
                        }
                    },
                }
            },
        );
    }

    /// Selects the ray under the pointer, where rays are drawn; false where none is there.
    pub fn select_pointed(&mut self) -> bool {
        self.shown && self.tab == Tab::Rays && self.rays.select_pointed()
    }

    /// Selects no ray; false where none was selected.
    pub fn deselect(&mut self) -> bool {
        self.shown && self.tab == Tab::Rays && self.rays.deselect()
    }

    /// Draws over the `picture`, which shows `size` pixels of what `camera` sees.
    pub fn overlay(
        &mut self,
        painter: &Painter,
        picture: &Response,
        size: [u32; 2],
        camera: &Camera,
    ) {
        let Some(pick) = self.pick.filter(|_| self.shown) else { return };
        if self.tab == Tab::Rays {
            self.rays.overlay(painter, picture, size, camera);
        }
        // The tree of a ray stays in the scene when the view turns; a spectrum is that of the place
        // in the picture.
        if self.tab == Tab::Spectrum || pick.camera == *camera {
            paint_pick(&pick, painter, picture.rect, size);
        }
    }
}

/// What is said while nothing is picked.
fn empty_ui(ui: &mut Ui, tab: Tab) {
    let (gain, how) = match tab {
        Tab::Rays => (
            "See where the light of a pixel comes from: every ray, every facet, every colour.",
            "Click on the picture.",
        ),
        Tab::Spectrum => (
            "See of which wavelengths the light of a pixel or a region is made.",
            "Click on the picture, or drag a region while you hold Ctrl.",
        ),
    };
    ui.add_space(24.0);
    ui.vertical_centered(|ui| {
        ui.label(gain);
        ui.add_space(6.0);
        ui.label(RichText::new(how).color(theme::TEXT_WEAK));
    });
}
