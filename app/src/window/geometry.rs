//! Where the window is and how large.

use eframe::egui::{self, ViewportBuilder};

const WINDOW_POINTS: [f32; 2] = [1480.0, 920.0];
const LEAST_POINTS: [f32; 2] = [760.0, 480.0];

/// A new window, or one in the place of that of `before`.
pub(super) fn viewport(before: Option<&egui::Context>) -> ViewportBuilder {
    let window = ViewportBuilder::default()
        .with_title("Brilliance")
        .with_app_id("brilliance")
        .with_min_inner_size(LEAST_POINTS)
        .with_drag_and_drop(true);
    let Some(before) = before else { return window.with_inner_size(WINDOW_POINTS) };
    // The new window begins without the user's zoom, so that its points are of another size.
    let zoom = before.zoom_factor();
    let info = before.input(|input| input.viewport().clone());
    let window = window
        .with_inner_size(before.viewport_rect().size() * zoom)
        .with_maximized(info.maximized == Some(true))
        .with_fullscreen(info.fullscreen == Some(true));
    match info.outer_rect {
        Some(rect) => window.with_position(rect.min * zoom),
        // There are systems that tell no program where its window is.
        None => window,
    }
}
