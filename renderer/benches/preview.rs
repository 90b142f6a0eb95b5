//! How soon the picture follows a change, on the processor and on the graphics device, if there is
//! one; and what is seen while a hand drags, which asks for another picture at every frame of the
//! screen, whether or not one has come.
#![expect(clippy::print_stdout, reason = "a benchmark prints what it measured")]

use std::sync::{Arc, mpsc};
use std::thread;
use std::time::{Duration, Instant};

use brilliance_renderer::camera::Camera;
use brilliance_renderer::develop::Pixels;
use brilliance_renderer::error::RendererError;
use brilliance_renderer::gpu::Graphics;
use brilliance_renderer::material::{Dispersion, Material};
use brilliance_renderer::scene::{Scene, Shape};
use brilliance_renderer::scene_file::Document;
use brilliance_renderer::session::{Activity, Picture, RenderRequest, Session};
use brilliance_renderer::settings::{DisplaySettings, NoiseGoal, TraceSettings};
use brilliance_renderer::tracer::{Backend, TracerName};
use glam::Quat;

const SIZES: [[u32; 2]; 2] = [[1280, 800], [1920, 1080]];
const WARM_UP: Duration = Duration::from_secs(1);
const TIME: Duration = Duration::from_secs(3);
/// Time between two frames of most screens.
const FRAME: Duration = Duration::from_micros(16_667);
/// A session that says nothing for so long has nothing left to say.
const QUIET: Duration = Duration::from_millis(300);
/// A session that shows nothing for so long will never; software compiles its shaders in a minute.
const PATIENCE: Duration = Duration::from_mins(2);
/// Limit on the passes of the first request of a drag, far beyond what is traced of it.
const FIRST_LIMIT: u32 = 1_000_000;
/// Time between two looks at the graphics device.
const LOOK_INTERVAL: Duration = Duration::from_micros(200);

/// What a hand changes.
#[derive(Clone, Copy, PartialEq)]
enum Change {
    Camera,
    Index,
    Cut,
    Exposure,
}

const CHANGES: [(Change, &str); 4] = [
    (Change::Camera, "camera"),
    (Change::Index, "index of refraction"),
    (Change::Cut, "pavilion angle"),
    (Change::Exposure, "exposure"),
];

fn main() -> Result<(), RendererError> {
    let graphics = Graphics::open(true);
    if let Err(reason) = &graphics {
        println!("no GPU: {reason}");
    }
    let graphics = graphics.ok();
    for [width, height] in SIZES {
        let mut hands = vec![Hand::new([width, height], None)?];
        if let Some(graphics) = &graphics {
            hands.push(Hand::new([width, height], Some(graphics))?);
        }
        println!(
            "\npreview at {width}x{height}: ms from change to picture, median (95th percentile)"
        );
        let names: Vec<_> = hands.iter_mut().map(Hand::tracer).collect();
        print_row("", &names);
        for (change, name) in CHANGES {
            let cells: Vec<_> = hands.iter_mut().map(|hand| hand.change_for_each(change)).collect();
            print_row(name, &cells);
        }
        let cells: Vec<_> = hands.iter_mut().map(Hand::drag).collect();
        print_row("dragging at 60 Hz", &cells);
    }
    Ok(())
}

fn print_row(name: &str, cells: &[String]) {
    let cells: Vec<_> = cells.iter().map(|cell| format!("{cell:<52}")).collect();
    println!("{name:<20} {}", cells.join(" ").trim_end());
}

/// A session, and what is asked of it.
struct Hand {
    session: Session,
    updates: mpsc::Receiver<()>,
    request: RenderRequest,
    trace: TraceSettings,
    display: DisplaySettings,
    step: u32,
    last_serial: u64,
}

impl Hand {
    /// Pictures of `size`, by `graphics` or else by the processor.
    fn new(size: [u32; 2], graphics: Option<&Graphics>) -> Result<Self, RendererError> {
        let document = Document::default();
        let (sender, updates) = mpsc::channel();
        let mut session = Session::new(move || {
            // Nobody listens any more when the benchmark is over.
            let _ = sender.send(());
        })?;
        if let Some(graphics) = graphics {
            session.offer_graphics(graphics.clone());
        }
        let request = RenderRequest {
            camera: document.scene.camera,
            scene: Arc::new(document.scene),
            size,
            trace: document.trace.clone(),
            pass_limit: document.still.passes,
            noise: NoiseGoal::NONE,
            backend: if graphics.is_some() { Backend::Gpu } else { Backend::Cpu },
        };
        let (trace, display) = (document.trace, document.display);
        Ok(Self { session, updates, request, trace, display, step: 0, last_serial: 0 })
    }

    /// What traces, once its shaders are compiled.
    fn tracer(&mut self) -> String {
        self.change(Change::Camera);
        let is_wanted = |tracer: &TracerName| {
            self.request.backend == Backend::Cpu || matches!(tracer, TracerName::Gpu { .. })
        };
        loop {
            if let Some(failure) = self.session.graphics_failure() {
                return failure.reason;
            }
            if let Some(tracer) = self.session.progress().tracer.filter(is_wanted) {
                return tracer.to_string();
            }
            if self.updates.recv_timeout(PATIENCE).is_err() {
                return "no picture".to_owned();
            }
        }
    }

    /// Waits for the picture after each change before the next.
    fn change_for_each(&mut self, change: Change) -> String {
        let latencies = self.prepare(change).and_then(|()| {
            self.latencies(change, WARM_UP)?;
            self.latencies(change, TIME)
        });
        let Some(mut latencies) = latencies else { return "no picture".to_owned() };
        format!("{:.1} ({:.1})", percentile(&mut latencies, 50), percentile(&mut latencies, 95))
    }

    /// For what needs no tracing, lets all tracing end, soon: what is traced is of no matter.
    fn prepare(&mut self, change: Change) -> Option<()> {
        if change != Change::Exposure {
            return Some(());
        }
        self.request.pass_limit = 1;
        self.request.trace.max_depth = 1;
        self.change(Change::Camera);
        let started = Instant::now();
        while self.updates.recv_timeout(QUIET).is_ok()
            || self.session.progress().activity != Activity::Done
        {
            if started.elapsed() > PATIENCE {
                return None;
            }
        }
        self.last_serial = self.session.picture()?.serial;
        Some(())
    }

    fn latencies(&mut self, change: Change, time: Duration) -> Option<Vec<Duration>> {
        let mut latencies = Vec::new();
        let started = Instant::now();
        while started.elapsed() < time {
            let asked = Instant::now();
            self.change(change);
            while !self.new_picture(PATIENCE)? {}
            latencies.push(asked.elapsed());
        }
        Some(latencies)
    }

    /// Turns the camera at every frame, and says what was seen.
    fn drag(&mut self) -> String {
        self.request.trace = self.trace.clone();
        // A limit that is not reached says which request is shown.
        self.request.pass_limit = FIRST_LIMIT;
        let seen = self.drag_for(WARM_UP).and_then(|_| self.drag_for(TIME));
        let Some(mut ages) = seen else { return "no picture".to_owned() };
        format!(
            "{:.1} pictures/s, {:.1} ms old when they come",
            ages.len() as f64 / TIME.as_secs_f64(),
            percentile(&mut ages, 50),
        )
    }

    /// The age of every picture that comes.
    fn drag_for(&mut self, time: Duration) -> Option<Vec<Duration>> {
        let (mut asked, mut ages) = (Vec::new(), Vec::new());
        let first_limit = self.request.pass_limit + 1;
        let started = Instant::now();
        while started.elapsed() < time {
            self.request.pass_limit += 1;
            self.change(Change::Camera);
            let now = Instant::now();
            asked.push(now);
            while let Some(left) = FRAME.checked_sub(now.elapsed()) {
                if !self.new_picture(left)? {
                    continue;
                }
                let shown = self.session.progress().pass_limit.checked_sub(first_limit);
                // The first may be of what was asked for before.
                ages.extend(shown.and_then(|i| asked.get(i as usize)).map(Instant::elapsed));
            }
        }
        Some(ages)
    }

    /// Makes the next change.
    fn change(&mut self, change: Change) {
        self.step += 1;
        // Back and forth, so that the stone stays one.
        let swing = f64::from(self.step % 40).mul_add(-0.05, 1.0).abs();
        match change {
            Change::Camera => {
                let step = Quat::from_rotation_z(1_f32.to_radians());
                let Camera { position, target, .. } = self.request.camera;
                self.request.camera.position = target + step * (position - target);
            }
            Change::Index => self.change_scene(|scene| {
                if let Material::Dielectric(stone) = &mut scene.objects[0].material {
                    let n_d = 2.4 + 0.01 * swing;
                    stone.dispersion = Dispersion::Linear { n_d, dispersion_bg: 0.044 };
                }
            }),
            Change::Cut => self.change_scene(|scene| {
                if let Shape::RoundBrilliant(cut) = &mut scene.objects[0].shape {
                    cut.pavilion_angle_degrees = 40.5 + swing as f32;
                }
            }),
            Change::Exposure => self.display.exposure_ev = swing as f32,
        }
        self.session.request(self.request.clone());
        self.session.display(self.display.clone());
    }

    fn change_scene(&mut self, change: impl FnOnce(&mut Scene)) {
        let mut scene = Scene::clone(&self.request.scene);
        change(&mut scene);
        self.request.scene = Arc::new(scene);
    }

    /// Waits so long for an update; whether it brought a picture, which is then finished. `None`
    /// where nothing came in all patience.
    fn new_picture(&mut self, longest: Duration) -> Option<bool> {
        if self.updates.recv_timeout(longest).is_err() {
            return (longest < PATIENCE).then_some(false);
        }
        let picture = self.session.picture().filter(|picture| picture.serial != self.last_serial);
        if let Some(picture) = &picture {
            self.last_serial = picture.serial;
            self.finish(picture)?;
        }
        Some(picture.is_some())
    }

    /// Waits until the device has made the picture that it was told to make.
    fn finish(&self, picture: &Picture) -> Option<()> {
        let (Pixels::Texture(_), Some(graphics)) = (&picture.pixels, self.session.graphics())
        else {
            return Some(());
        };
        let (sender, finished) = mpsc::channel();
        graphics.queue().on_submitted_work_done(move || {
            // Nobody listens any more when patience is over.
            let _ = sender.send(());
        });
        let started = Instant::now();
        while finished.try_recv().is_err() {
            graphics.device().poll(wgpu::PollType::Poll).ok()?;
            if started.elapsed() > PATIENCE {
                return None;
            }
            thread::sleep(LOOK_INTERVAL);
        }
        Some(())
    }
}

/// The value that so many percent are not above, in milliseconds.
fn percentile(times: &mut [Duration], percent: usize) -> f64 {
    times.sort_unstable();
    let i = times.len().saturating_sub(1) * percent / 100;
    times.get(i).map_or(f64::NAN, |time| 1e3 * time.as_secs_f64())
}
