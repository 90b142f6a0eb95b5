//! On any graphics device there is, software included: the request is traced there, and on the
//! processor once the device is gone.

use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use brilliance_renderer::develop::{HeatMap, Pixels, Shown};
use brilliance_renderer::gpu::Graphics;
use brilliance_renderer::session::{Activity, GraphicsState, RenderRequest, Session};
use brilliance_renderer::settings::DisplaySettings;
use brilliance_renderer::still::{Still, StillLimits};
use brilliance_renderer::tracer::{Backend, TracerName, TracingDevice};

use crate::watched::{Watched, request};

/// What the fallback is given where other tests keep all processors busy. An idle machine needs a
/// hundredth of it; a device that is waited for in vain is given minutes.
const SOON: Duration = Duration::from_mins(1);

/// A device of the test's own. A machine without any fails the test rather than passing it unseen.
fn graphics() -> Graphics {
    Graphics::open(true).unwrap_or_else(|error| {
        panic!("these tests need a graphics device, be it software (mesa-vulkan-drivers): {error}")
    })
}

fn gpu_request(size: [u32; 2], passes: u32) -> RenderRequest {
    RenderRequest { backend: Backend::Gpu, ..request(size, passes) }
}

/// A session that was offered `graphics` and asked for `request`.
fn tracing(graphics: &Graphics, request: RenderRequest) -> Watched {
    let mut watched = Watched::new();
    watched.session.offer_graphics(graphics.clone());
    watched.session.request(request);
    watched
}

fn is_on_device(session: &Session) -> bool {
    matches!(session.progress().tracer, Some(TracerName::Gpu { .. }))
}

fn shows_texture(session: &Session) -> bool {
    session.picture().is_some_and(|picture| matches!(picture.pixels, Pixels::Texture(_)))
}

/// Waits until what the device has traced is shown and `is_there` holds.
fn wait_for_device(watched: &Watched, is_there: impl Fn(&Session) -> bool) {
    watched.wait(|session| {
        if let GraphicsState::Failed(reason) = session.graphics_state() {
            panic!("{reason}");
        }
        is_on_device(session) && shows_texture(session) && is_there(session)
    });
}

fn is_done(session: &Session) -> bool {
    session.progress().activity == Activity::Done
}

/// Waits until the processor has traced a picture and it is shown, which must be soon.
fn wait_for_processor(watched: &Watched) {
    let started = Instant::now();
    watched.wait(|session| !is_on_device(session) && !shows_texture(session));
    assert!(started.elapsed() < SOON, "{:?}", started.elapsed());
    assert!(matches!(watched.session.graphics_state(), GraphicsState::Failed(_)));
    assert_eq!(watched.session.graphics_failure().map(|failure| failure.serial), Some(1));
}

#[test]
fn a_request_is_traced_on_the_device_and_never_read_back() {
    let graphics = graphics();
    let mut watched = tracing(&graphics, gpu_request([48, 32], 7));
    wait_for_device(&watched, is_done);
    let progress = watched.session.progress();
    assert_eq!((progress.passes, progress.statistics.camera_rays), (7, 7 * 48 * 32));
    assert!(progress.statistics.ledger.imbalance().abs() < 1e-5 * 7.0 * 48.0 * 32.0);
    assert_eq!(watched.session.graphics_state(), GraphicsState::Ready);
    let picture = watched.session.picture().expect("it is there");

    let brighter = DisplaySettings { exposure_ev: 2.0, ..DisplaySettings::default() };
    watched.session.display(brighter);
    watched.wait(|session| session.picture().is_some_and(|next| next.serial > picture.serial));
    assert!(shows_texture(&watched.session));
    for shown in HeatMap::ALL.map(Shown::Heat) {
        watched.session.show(shown);
        watched.wait(|session| session.picture().is_some_and(|next| next.shown == shown));
        assert!(shows_texture(&watched.session));
    }
    assert_eq!(watched.session.progress(), progress, "nothing was traced");
}

#[test]
fn a_device_that_is_lost_while_it_traces_is_replaced_by_the_processor() {
    let graphics = graphics();
    let mut watched = tracing(&graphics, gpu_request([64, 40], 1_000_000));
    wait_for_device(&watched, |_| true);
    graphics.device().destroy();
    wait_for_processor(&watched);

    watched.session.offer_graphics(self::graphics());
    wait_for_device(&watched, |_| true);
    assert_eq!(watched.session.graphics_state(), GraphicsState::Ready);
}

#[test]
fn a_device_that_is_lost_with_a_finished_picture_is_found_out_by_developing() {
    let graphics = graphics();
    let mut watched = tracing(&graphics, gpu_request([48, 32], 2));
    wait_for_device(&watched, is_done);
    graphics.device().destroy();
    watched.session.display(DisplaySettings { exposure_ev: 1.0, ..DisplaySettings::default() });
    wait_for_processor(&watched);
    watched.wait(is_done);
}

#[test]
fn a_still_is_traced_on_the_device_or_with_a_warning_on_the_processor() {
    let graphics = graphics();
    let request = gpu_request([24, 16], 3);
    let render = || {
        let limits = StillLimits::default();
        let cancel = AtomicBool::new(false);
        let device = TracingDevice::from(graphics.clone());
        Still::render(&request, limits, Some(&device), &cancel, |_, _| {}).expect("renders")
    };
    let still = render();
    assert!(matches!(still.tracer, TracerName::Gpu { .. }), "{:?}", still.warning);
    assert_eq!((still.passes, still.film.passes(), still.warning), (3, 3, None));
    assert_eq!(still.statistics.camera_rays, 3 * 24 * 16);

    graphics.device().destroy();
    let still = render();
    assert!(matches!(still.tracer, TracerName::Cpu { .. }));
    assert!(still.warning.is_some_and(|warning| !warning.is_empty()));
    assert_eq!((still.passes, still.film.passes()), (3, 3));
}

#[test]
fn a_still_shares_the_shaders_of_the_session() {
    let graphics = graphics();
    let mut watched = Watched::new();
    assert!(watched.session.tracing_device().is_none());
    watched.session.offer_graphics(graphics.clone());
    let unprepared = watched.session.tracing_device();
    assert!(unprepared.is_some_and(|device| !device.is_ready()));

    watched.session.request(gpu_request([48, 32], 1_000_000));
    wait_for_device(&watched, |_| true);
    let device = watched.session.tracing_device().expect("it works");
    assert!(device.is_ready());
    // While the session goes on tracing.
    let cancel = AtomicBool::new(false);
    let request = gpu_request([24, 16], 3);
    let still = Still::render(&request, StillLimits::default(), Some(&device), &cancel, |_, _| {})
        .expect("renders");
    assert!(matches!(still.tracer, TracerName::Gpu { .. }), "{:?}", still.warning);
    assert_eq!(still.statistics.camera_rays, 3 * 24 * 16);

    graphics.device().destroy();
    wait_for_processor(&watched);
    assert!(watched.session.tracing_device().is_none());
}
