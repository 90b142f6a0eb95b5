//! The session and a device that fails when told to.

mod reading;

use std::sync::{Arc, Condvar, Mutex};
use std::time::{Duration, Instant};

use super::bell::Urgency;
use super::graphics::Refusal;
use super::shared::lock;
use super::threads::Threads;
use super::{Activity, GraphicsFailure, GraphicsState, Progress, Reading, RenderRequest};
use crate::film::Region;
use crate::scene::Scene;
use crate::scene_file::Document;
use crate::settings::NoiseGoal;
use crate::tracer::fake::{Call, FakeDevice, REASON};
use crate::tracer::{Backend, CpuTracer, TracerName};

/// Far beyond what any of this takes; only a hang reaches it.
const PATIENCE: Duration = Duration::from_mins(5);

const SIZE: [u32; 2] = [32, 20];
const PASSES: u32 = 6;

/// The threads of a session, and a bell that they ring with their names at every update.
struct Watched {
    threads: Threads<FakeDevice>,
    bell: Arc<(Mutex<Vec<String>>, Condvar)>,
    pass_limit: u32,
}

impl Watched {
    fn new() -> Self {
        let bell = Arc::new((Mutex::new(Vec::new()), Condvar::new()));
        let ringer = Arc::clone(&bell);
        let cpu = CpuTracer::new(1).expect("threads can be started");
        let threads = Threads::start(cpu, move || {
            // A test that fails while it looks must not take the threads along.
            let name = std::thread::current().name().unwrap_or_default().to_owned();
            lock(&ringer.0).push(name);
            ringer.1.notify_all();
        })
        .expect("threads can be started");
        Self { threads, bell, pass_limit: 0 }
    }

    /// Asked for a picture, with this device.
    fn tracing(backend: Backend, device: &FakeDevice) -> Self {
        Self::tracing_request(request(backend), device)
    }

    fn tracing_request(request: RenderRequest, device: &FakeDevice) -> Self {
        let mut watched = Self::new();
        watched.threads.offer(device.clone());
        watched.ask(request);
        watched
    }

    fn ask(&mut self, request: RenderRequest) {
        self.pass_limit = request.pass_limit;
        self.threads.ask(request, true);
    }

    fn wait(&self, is_there: impl Fn(&Self) -> bool) {
        let deadline = Instant::now() + PATIENCE;
        let mut rings = self.bell.0.lock().expect("nobody panics with the bell");
        while !is_there(self) {
            let left = deadline.saturating_duration_since(Instant::now());
            assert!(!left.is_zero(), "it never came: {:?}, {:?}", self.state(), self.progress());
            let (next, _) =
                self.bell.1.wait_timeout(rings, left).expect("nobody panics with the bell");
            rings = next;
        }
    }

    /// Waits until all passes are done by the processor, or by the device.
    fn wait_for_done(&self, on_device: bool) {
        self.wait(|watched| {
            let Progress { activity, pass_limit, .. } = watched.progress();
            activity == Activity::Done
                && pass_limit == watched.pass_limit
                && watched.is_on_device() == on_device
        });
        assert_eq!(self.progress().passes, self.pass_limit);
    }

    /// Whether what was traced last was by the device.
    fn is_on_device(&self) -> bool {
        matches!(self.progress().tracer, Some(TracerName::Gpu { .. }))
    }

    fn serial(&self) -> u64 {
        lock(&self.threads.shared.picture).as_ref().map_or(0, |picture| picture.serial)
    }

    fn reading(&self) -> Option<Arc<Reading>> {
        lock(&self.threads.shared.watch).reading().cloned()
    }

    fn progress(&self) -> Progress {
        lock(&self.threads.shared.progress).clone()
    }

    fn state(&self) -> GraphicsState {
        lock(&self.threads.shared.graphics).state()
    }

    fn failure(&self) -> Option<GraphicsFailure> {
        lock(&self.threads.shared.graphics).failure().cloned()
    }

    /// Asserts that `serial` failures were told, the last for the one reason there is.
    fn assert_told(&self, serial: u64) {
        assert_eq!(self.failure(), Some(GraphicsFailure { serial, reason: REASON.to_owned() }));
    }
}

fn request(backend: Backend) -> RenderRequest {
    let document = Document::default();
    RenderRequest {
        camera: document.scene.camera,
        scene: Arc::new(document.scene),
        size: SIZE,
        trace: document.trace,
        pass_limit: PASSES,
        noise: NoiseGoal::NONE,
        backend,
    }
}

/// The request from a little further to the right, and known by one pass more.
fn moved(request: &RenderRequest) -> RenderRequest {
    let mut moved = RenderRequest { pass_limit: request.pass_limit + 1, ..request.clone() };
    moved.camera.position.x += 1.0;
    moved
}

/// The request for a stone of another scale.
fn scaled(request: &RenderRequest, scale: f32) -> RenderRequest {
    let mut scene = Scene::clone(&request.scene);
    scene.objects[0].transform.scale = scale;
    RenderRequest { scene: Arc::new(scene), ..moved(request) }
}

#[test]
fn the_processor_traces_until_the_shaders_are_compiled() {
    let device = FakeDevice::hardware();
    device.plan().compiler_waits = true;
    let watched = Watched::tracing(Backend::Auto, &device);
    watched.wait_for_done(false);
    assert_eq!(watched.state(), GraphicsState::Preparing);
    device.let_compiler_finish();
    watched.wait_for_done(true);
    assert_eq!((watched.state(), watched.failure()), (GraphicsState::Ready, None));
}

#[test]
fn a_device_is_prepared_and_used_only_where_it_is_called_for() {
    let device = FakeDevice::software();
    let mut watched = Watched::tracing(Backend::Auto, &device);
    watched.wait_for_done(false);
    assert_eq!((watched.state(), device.count(Call::Prepare)), (GraphicsState::Offered, 0));
    watched.ask(request(Backend::Gpu));
    watched.wait_for_done(true);
    watched.ask(request(Backend::Cpu));
    watched.wait_for_done(false);
    watched.ask(request(Backend::Gpu));
    watched.wait_for_done(true);
    assert_eq!((watched.state(), device.count(Call::Prepare)), (GraphicsState::Ready, 1));
}

#[test]
fn wherever_the_device_fails_the_processor_takes_over_and_a_retry_works() {
    let calls = [
        (Call::Prepare, 0),
        (Call::Film, 0),
        (Call::Trace, 0),
        (Call::Trace, 1),
        (Call::Expose, 0),
        (Call::Expose, 1),
        (Call::Mean, 0),
        (Call::Mean, 1),
    ];
    for (call, panics) in calls.into_iter().flat_map(|call| [(call, false), (call, true)]) {
        let device = FakeDevice::failing_at(call.0, call.1);
        device.plan().panics = panics;
        let mut watched = Watched::tracing(Backend::Auto, &device);
        watched.threads.watch(Some(Region::WHOLE));
        if call == (Call::Mean, 1) {
            watched.wait(|_| device.count(Call::Mean) > 0);
            watched.threads.watch(Some(Region::between([0.0; 2], [0.5; 2])));
        }
        watched.wait_for_done(false);
        watched.wait(|watched| matches!(watched.state(), GraphicsState::Failed(_)));
        let reason = watched.failure().expect("it is told").reason;
        assert_eq!(reason.contains(REASON), !panics, "{reason}");
        assert_eq!(watched.state(), GraphicsState::Failed(reason), "{call:?}");

        let calls = device.plan().calls.len();
        watched.ask(moved(&request(Backend::Gpu)));
        watched.wait_for_done(false);
        watched.threads.offer(device.clone());
        assert_eq!(device.plan().calls.len(), calls, "a failed device is left alone");
        assert_eq!(watched.failure().map(|failure| failure.serial), Some(1), "told once");

        device.plan().fails_at = None;
        watched.threads.retry();
        watched.wait_for_done(true);
        assert_eq!(watched.state(), GraphicsState::Ready, "{call:?}");
    }
}

#[test]
fn a_retry_that_fails_is_told_anew() {
    let device = FakeDevice::failing_at(Call::Trace, 0);
    let mut watched = Watched::tracing(Backend::Auto, &device);
    watched.wait(|watched| watched.failure().is_some());
    watched.assert_told(1);
    watched.threads.retry();
    watched.wait(|watched| watched.failure().is_some_and(|failure| failure.serial > 1));
    watched.assert_told(2);
    watched.wait_for_done(false);
}

#[test]
fn another_device_is_used_after_one_that_failed() {
    let broken = FakeDevice::failing_at(Call::Trace, 1);
    let mut watched = Watched::tracing(Backend::Auto, &broken);
    watched.wait_for_done(false);
    watched.threads.offer(FakeDevice::hardware());
    watched.wait_for_done(true);
    assert_eq!(watched.state(), GraphicsState::Ready);
}

#[test]
fn late_shaders_of_a_device_that_was_replaced_are_not_used() {
    let (slow, fast) = (FakeDevice::hardware(), FakeDevice::hardware());
    slow.plan().compiler_waits = true;
    let mut watched = Watched::tracing(Backend::Auto, &slow);
    watched.threads.offer(fast.clone());
    watched.wait_for_done(true);
    slow.let_compiler_finish();
    watched.ask(moved(&request(Backend::Auto)));
    watched.wait_for_done(true);
    assert!(fast.count(Call::Trace) > 0);
    assert_eq!(slow.count(Call::Load), 0);
}

#[test]
fn a_scene_that_is_too_much_for_the_device_leaves_it_to_others() {
    let device = FakeDevice::failing_at(Call::Load, 0);
    let mut watched = Watched::tracing(Backend::Auto, &device);
    watched.wait_for_done(false);
    watched.assert_told(1);
    assert_eq!(watched.state(), GraphicsState::Ready, "the device works");

    let large = request(Backend::Auto);
    watched.ask(moved(&large));
    watched.wait_for_done(false);
    assert_eq!(device.count(Call::Load), 1, "it is not tried again at every turn");
    watched.ask(scaled(&moved(&large), 1.1));
    watched.wait_for_done(false);
    assert_eq!(device.count(Call::Load), 2);
    watched.assert_told(1);

    device.plan().fails_at = None;
    watched.ask(large);
    watched.wait_for_done(true);
}

#[test]
fn a_film_that_is_too_large_for_the_device_leaves_it_to_smaller_ones() {
    let device = FakeDevice::hardware();
    device.plan().most_pixels = Some(SIZE[0] * SIZE[1] - 1);
    let mut watched = Watched::tracing(Backend::Auto, &device);
    watched.wait_for_done(false);
    watched.assert_told(1);
    watched.ask(RenderRequest { size: [16, 10], ..moved(&request(Backend::Auto)) });
    watched.wait_for_done(true);

    device.plan().most_pixels = None;
    watched.ask(request(Backend::Auto));
    watched.wait_for_done(false);
    watched.threads.retry();
    watched.wait_for_done(true);
}

#[test]
fn an_impossible_scene_is_no_fault_of_the_device() {
    let device = FakeDevice::hardware();
    let mut watched = Watched::tracing(Backend::Auto, &device);
    watched.wait_for_done(true);
    watched.ask(scaled(&request(Backend::Auto), 0.0));
    watched.wait(|watched| watched.progress().activity == Activity::Failed);
    assert_eq!((watched.state(), watched.failure()), (GraphicsState::Ready, None));
    watched.ask(request(Backend::Auto));
    watched.wait_for_done(true);
}

#[test]
fn a_compiler_that_does_not_end_holds_nobody_up_for_long() {
    let device = FakeDevice::hardware();
    device.plan().compiler_waits = true;
    let watched = Watched::tracing(Backend::Auto, &device);
    watched.wait_for_done(false);
    let started = Instant::now();
    drop(watched);
    let seconds = started.elapsed().as_secs_f64();
    // Without an end to its patience it would wait for ever.
    assert!(seconds < 60.0, "{seconds}");
    device.let_compiler_finish();
}

#[test]
fn an_image_that_is_too_large_for_the_device_leaves_it_to_smaller_ones() {
    let device = FakeDevice::hardware();
    device.plan().most_exposed_pixels = Some(SIZE[0] * SIZE[1] - 1);
    let mut watched = Watched::tracing(Backend::Auto, &device);
    watched.wait_for_done(false);
    watched.assert_told(1);
    assert_eq!(watched.state(), GraphicsState::Ready, "the device works");
    watched.ask(RenderRequest { size: [16, 10], ..moved(&request(Backend::Auto)) });
    watched.wait_for_done(true);
}

#[test]
fn what_is_refused_is_refused_to_what_is_no_smaller_either_way() {
    let refusal = Refusal::Film([400, 20], request(Backend::Auto).trace.bins);
    let covers = |size| refusal.covers(&RenderRequest { size, ..request(Backend::Auto) });
    assert!(covers([400, 20]) && covers([401, 30]));
    assert!(!covers([399, 300]) && !covers([1000, 19]));
}

#[test]
fn what_a_device_traces_is_developed_before_its_next_round() {
    let device = FakeDevice::hardware();
    // A picture of no passes, so that none is on its way when the device is ready.
    let mut watched =
        Watched::tracing_request(RenderRequest { pass_limit: 0, ..request(Backend::Gpu) }, &device);
    watched.wait(|watched| watched.state() == GraphicsState::Ready);
    watched.ask(request(Backend::Gpu));
    watched.wait_for_done(true);
    let rung_by = lock(&watched.bell.0).clone();
    assert!(!rung_by.iter().any(|name| name == "develop"), "{rung_by:?}");

    let serial = watched.serial();
    assert!(serial > 0, "it is shown when it is said to be done");
    let shared = &watched.threads.shared;
    lock(&shared.display).exposure_ev = 1.0;
    shared.to_develop.ring(Urgency::None);
    watched.wait(|watched| watched.serial() > serial);
}

#[test]
fn pictures_keep_coming_while_a_hand_drags() {
    let pixels = f64::from(SIZE[0] * SIZE[1]);
    // Longer than the time between two requests; longer than any patience.
    for full_picture_seconds in [0.03, 0.3] {
        let device = FakeDevice::hardware();
        device.plan().seconds_per_pixel = Some(full_picture_seconds / pixels);
        let mut watched = Watched::tracing(Backend::Gpu, &device);
        watched.wait_for_done(true);
        let mut serial = watched.serial();
        let mut pictures = 0;
        let mut request = request(Backend::Gpu);
        let started = Instant::now();
        while started.elapsed() < Duration::from_millis(1500) {
            request = moved(&request);
            watched.ask(request.clone());
            std::thread::sleep(Duration::from_millis(10));
            let newest = watched.serial();
            pictures += u32::from(newest > serial);
            serial = newest;
        }
        // An idle machine shows 50; one is enough to tell from none at all, but not to see by.
        assert!(pictures >= 15, "{pictures} pictures of {full_picture_seconds} s");
    }
}

#[test]
fn a_device_that_is_far_slower_than_guessed_shows_pictures_soon() {
    let device = FakeDevice::hardware();
    device.plan().seconds_per_pixel = Some(0.3 / f64::from(SIZE[0] * SIZE[1]));
    let unasked = RenderRequest { pass_limit: 0, ..request(Backend::Gpu) };
    let mut watched = Watched::tracing_request(unasked, &device);
    watched.wait(|watched| watched.state() == GraphicsState::Ready);
    let mut request = request(Backend::Gpu);
    let mut requests = 0;
    while watched.serial() == 0 {
        request = moved(&request);
        watched.ask(request.clone());
        std::thread::sleep(Duration::from_millis(10));
        requests += 1;
        assert!(requests < 300, "no picture for {requests} requests");
    }
}
