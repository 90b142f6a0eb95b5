//! The window on the desktop.

use std::sync::Arc;
use std::time::Instant;

use anyhow::anyhow;
use brilliance_renderer::error::RendererError;
use eframe::egui::ViewportBuilder;
use eframe::egui_wgpu::{WgpuConfiguration, WgpuSetup, WgpuSetupCreateNew};
use eframe::{NativeOptions, Renderer};

use crate::app::{App, Services};
use crate::live::Live;
use crate::opening::Opening;
use crate::orbit::Orbit;
use crate::picture_painter;

const WINDOW_POINTS: [f32; 2] = [1480.0, 920.0];
/// Size of the picture in a window of this size, where a point is a pixel. In any other window the
/// first picture is made anew.
const LIKELY_PICTURE: [u32; 2] = [1128, 860];

/// Opens the window on `opening` and stays until it is closed; the process `started` then.
///
/// # Errors
/// There is no display, no graphics driver that can draw a window, or no thread.
pub fn open(opening: Opening, started: Instant) -> anyhow::Result<()> {
    let live = begin_tracing(&opening)?;
    let options = NativeOptions {
        viewport: ViewportBuilder::default()
            .with_title("Brilliance")
            .with_app_id("brilliance")
            .with_inner_size(WINDOW_POINTS)
            .with_min_inner_size([760.0, 480.0])
            .with_drag_and_drop(true),
        renderer: Renderer::Wgpu,
        wgpu_options: graphics(),
        // The picture's pixels are shown as they are.
        dithering: false,
        ..NativeOptions::default()
    };
    eframe::run_native(
        "Brilliance",
        options,
        Box::new(move |creation| {
            if let Some(graphics) = &creation.wgpu_render_state {
                picture_painter::install(graphics);
            }
            let services = Services { started, ..Services::default() };
            Ok(Box::new(App::new(&creation.egui_ctx, opening, live, services)))
        }),
    )
    .map_err(|fault| anyhow!("the window can't be opened: {fault}"))
}

/// Traces what is at hand while the system makes the window.
fn begin_tracing(opening: &Opening) -> Result<Live, RendererError> {
    let mut live = Live::new()?;
    if let Opening::Read { document, .. } = opening {
        let scene = Arc::new(document.scene.clone());
        let camera = Orbit::from_camera(&scene.camera).camera();
        live.ask(document, &scene, camera, LIKELY_PICTURE);
    }
    Ok(live)
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
