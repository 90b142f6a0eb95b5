//! The window on the desktop, and its end.
//!
//! Neither eframe nor egui-wgpu can replace a graphics device that is lost: because its driver was
//! reset or updated, because the machine has slept, because a shader ran for too long. So the
//! [`App`] does not belong to its window. When the device is lost the event loop ends, and a new
//! window with a new device opens where the old one was and shows the same app.

mod fate;
mod geometry;
mod shell;
mod watched;

use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use anyhow::{anyhow, bail};
use brilliance_renderer::error::RendererError;
use brilliance_renderer::tracer::Backend;
use eframe::egui_wgpu::{WgpuConfiguration, WgpuSetup, WgpuSetupCreateNew};
use eframe::{NativeOptions, Renderer, UserEvent};
use winit::event_loop::EventLoop;
use winit::platform::run_on_demand::EventLoopExtRunOnDemand as _;

use crate::app::{App, Services};
use crate::live::Live;
use crate::opening::Opening;
use crate::orbit::Orbit;
use fate::{Ending, Fate};
use shell::Shell;
use watched::Watched;

/// Size of the picture in a new window, where a point is a pixel. In any other window the first
/// picture is made anew.
const LIKELY_PICTURE: [u32; 2] = [1128, 860];

/// A window that took the place of another and loses its device in less than this is not replaced.
const SHORTEST_LIFE: Duration = Duration::from_secs(10);

/// Opens the window on `opening`, traced by `backend`, and stays until it is closed; the process
/// `started` then.
///
/// # Errors
/// There is no display, no graphics driver that can draw a window, or no thread; or one graphics
/// device is lost after the other.
pub fn open(opening: Opening, backend: Backend, started: Instant) -> anyhow::Result<()> {
    let live = begin_tracing(&opening, backend)?;
    let services = Services { started, ..Services::default() };
    let app = Rc::new(RefCell::new(App::new(opening, live, services)));
    let event_loop = EventLoop::<UserEvent>::with_user_event().build();
    let mut event_loop = event_loop.map_err(|fault| cannot_open(&fault))?;
    let mut is_first = true;
    loop {
        let opened = Instant::now();
        match show(&mut event_loop, &app)? {
            Ending::Closed => return Ok(()),
            Ending::NotOpened if is_first => {
                bail!("the window can't be opened: no graphics driver here can draw it")
            }
            Ending::NotOpened => bail!(
                "the graphics device was lost, and none is left that can draw the window{}",
                rescue(&app.borrow())
            ),
            Ending::DeviceLost(reason) if !is_first && opened.elapsed() < SHORTEST_LIFE => bail!(
                "the graphics device was lost twice in a row, so the window is given up \
                 ({reason}){}",
                rescue(&app.borrow())
            ),
            Ending::DeviceLost(reason) => {
                log::warn!("the graphics device is lost ({reason}); the window opens again");
                app.borrow_mut().graphics_lost(&reason);
            }
        }
        is_first = false;
    }
}

/// Shows `app` in a window until that ends.
fn show(event_loop: &mut EventLoop<UserEvent>, app: &Rc<RefCell<App>>) -> anyhow::Result<Ending> {
    let fate = Rc::<Fate>::default();
    let (shown, told) = (Rc::clone(app), Rc::clone(&fate));
    let options = options(&app.borrow(), Arc::clone(fate.surface_moved()));
    let creator: eframe::AppCreator<'_> =
        Box::new(move |creation| Ok(Box::new(Shell::open(creation, shown, told)?)));
    let window = eframe::create_native("Brilliance", options, creator, event_loop);
    event_loop
        .run_app_on_demand(&mut Watched::new(window, Rc::clone(&fate)))
        .map_err(|fault| cannot_open(&fault))?;
    Ok(fate.ending())
}

fn cannot_open(fault: &winit::error::EventLoopError) -> anyhow::Error {
    anyhow!("the window can't be opened: {fault}")
}

/// Saves what is not saved yet, and says so.
fn rescue(app: &App) -> String {
    match app.rescue() {
        None => String::new(),
        Some(Ok(path)) => format!("; what was not saved is in {}", path.display()),
        Some(Err(fault)) => format!("; what was not saved is lost: {fault}"),
    }
}

/// Traces what is at hand while the system makes the window.
fn begin_tracing(opening: &Opening, backend: Backend) -> Result<Live, RendererError> {
    let mut live = Live::new(backend)?;
    if let Opening::Read { document, .. } = opening {
        let scene = Arc::new(document.scene.clone());
        let camera = Orbit::from_camera(&scene.camera).camera();
        live.ask(document, &scene, camera, LIKELY_PICTURE);
    }
    Ok(live)
}

fn options(app: &App, surface_moved: Arc<AtomicBool>) -> NativeOptions {
    NativeOptions {
        viewport: geometry::viewport(app.window().as_ref()),
        renderer: Renderer::Wgpu,
        wgpu_options: graphics(surface_moved),
        // The picture's pixels are shown as they are.
        dithering: false,
        ..NativeOptions::default()
    }
}

/// Asks the graphics driver for no more than it has, so that small and software ones do, and for
/// all of that, so that the device can trace too. What happens to the window's surface is noted.
fn graphics(surface_moved: Arc<AtomicBool>) -> WgpuConfiguration {
    let setup = WgpuSetupCreateNew {
        device_descriptor: Arc::new(|adapter| wgpu::DeviceDescriptor {
            label: Some("window"),
            required_limits: adapter.limits(),
            ..wgpu::DeviceDescriptor::default()
        }),
        ..WgpuSetupCreateNew::without_display_handle()
    };
    let default = WgpuConfiguration::default();
    let answer = default.on_surface_status;
    WgpuConfiguration {
        wgpu_setup: WgpuSetup::CreateNew(setup),
        on_surface_status: Arc::new(move |status| {
            surface_moved.store(true, Ordering::Relaxed);
            answer(status)
        }),
        ..default
    }
}
