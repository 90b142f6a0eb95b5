//! The window on the desktop.

use std::sync::Arc;
use std::time::Instant;

use anyhow::anyhow;
use eframe::egui::ViewportBuilder;
use eframe::egui_wgpu::{WgpuConfiguration, WgpuSetup, WgpuSetupCreateNew};
use eframe::{NativeOptions, Renderer};

use crate::app::{App, Services};
use crate::opening::Opening;

/// Opens the window on `opening` and stays until it is closed; the process `started` then.
///
/// # Errors
/// There is no display, or no graphics driver that can draw a window.
pub fn open(opening: Opening, started: Instant) -> anyhow::Result<()> {
    let options = NativeOptions {
        viewport: ViewportBuilder::default()
            .with_title("Brilliance")
            .with_app_id("brilliance")
            .with_inner_size([1480.0, 920.0])
            .with_min_inner_size([760.0, 480.0])
            .with_drag_and_drop(true),
        renderer: Renderer::Wgpu,
        wgpu_options: graphics(),
        ..NativeOptions::default()
    };
    eframe::run_native(
        "Brilliance",
        options,
        Box::new(move |creation| {
            let services = Services { started, ..Services::default() };
            Ok(Box::new(App::new(&creation.egui_ctx, opening, services)?))
        }),
    )
    .map_err(|fault| anyhow!("the window can't be opened: {fault}"))
}

/// Asks the graphics driver for no more than it has, so that small and software ones do.
fn graphics() -> WgpuConfiguration {
    let setup = WgpuSetupCreateNew {
        device_descriptor: Arc::new(|adapter| wgpu::DeviceDescriptor {
            label: Some("window"),
            required_limits: adapter.limits(),
            ..wgpu::DeviceDescriptor::default()
        }),
        ..WgpuSetupCreateNew::without_display_handle()
    };
    WgpuConfiguration { wgpu_setup: WgpuSetup::CreateNew(setup), ..WgpuConfiguration::default() }
}
