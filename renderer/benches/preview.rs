//! Preview pictures per second while the camera orbits the default stone, on the processor and on the
//! graphics device, if there is one: each picture that arrives is answered by the next camera, as the
//! window does while the mouse is dragged.
#![expect(clippy::print_stdout, reason = "a benchmark prints what it measured")]

use std::sync::{Arc, mpsc};
use std::time::{Duration, Instant};

use brilliance_renderer::camera::Camera;
use brilliance_renderer::error::RendererError;
use brilliance_renderer::gpu::Graphics;
use brilliance_renderer::scene::Scene;
use brilliance_renderer::scene_file::Document;
use brilliance_renderer::session::{Picture, RenderRequest, Session};
use brilliance_renderer::settings::TraceSettings;
use brilliance_renderer::tracer::{Backend, TracerName};
use glam::Quat;

const SIZES: [[u32; 2]; 2] = [[1280, 800], [1920, 1080]];
const WARM_UP: Duration = Duration::from_secs(1);
const TIME: Duration = Duration::from_secs(5);
const STEP_DEGREES: f32 = 1.0;
/// A session that shows nothing for so long will never; software compiles its shaders in a minute.
const PATIENCE: Duration = Duration::from_mins(2);

fn main() -> Result<(), RendererError> {
    let graphics = Graphics::open(true);
    for size in SIZES {
        Orbit::start(size, None)?.measure();
        match &graphics {
            Ok(graphics) => Orbit::start(size, Some(graphics))?.measure(),
            Err(reason) => println!("preview, GPU: {reason}"),
        }
    }
    Ok(())
}

/// A session and the camera that goes round in it.
struct Orbit {
    session: Session,
    updates: mpsc::Receiver<()>,
    scene: Arc<Scene>,
    size: [u32; 2],
    trace: TraceSettings,
    camera: Camera,
    pass_limit: u32,
    backend: Backend,
    last_serial: Option<u64>,
}

impl Orbit {
    /// Pictures of `size`, by `graphics` or else by the processor.
    fn start(size: [u32; 2], graphics: Option<&Graphics>) -> Result<Self, RendererError> {
        let document = Document::default();
        let (sender, updates) = mpsc::channel();
        let mut session = Session::new(move || {
            // Nobody listens any more when the benchmark is over.
            let _ = sender.send(());
        })?;
        session.display(document.display);
        let backend = if graphics.is_some() { Backend::Gpu } else { Backend::Cpu };
        if let Some(graphics) = graphics {
            session.offer_graphics(graphics.clone());
        }
        Ok(Self {
            session,
            updates,
            size,
            camera: document.scene.camera,
            scene: Arc::new(document.scene),
            trace: document.trace,
            pass_limit: document.still.passes,
            backend,
            last_serial: None,
        })
    }

    /// Orbits, and prints what was seen.
    fn measure(mut self) {
        self.turn();
        let frames = self.wait_for_tracer().and_then(|()| {
            self.run(WARM_UP)?;
            self.run(TIME)
        });
        match (frames, self.session.progress().tracer) {
            (Some(frames), Some(tracer)) => frames.print(self.size, &tracer),
            _ => println!("preview: no picture came within {} s", PATIENCE.as_secs()),
        }
        if let Some(failure) = self.session.graphics_failure() {
            println!("preview, GPU: {}", failure.reason);
        }
    }

    /// Waits while the shaders are compiled; `None` if that takes too long.
    fn wait_for_tracer(&self) -> Option<()> {
        let is_device = |tracer| matches!(tracer, Some(TracerName::Gpu { .. }));
        while self.backend == Backend::Gpu
            && !is_device(self.session.progress().tracer)
            && self.session.graphics_failure().is_none()
        {
            self.updates.recv_timeout(PATIENCE).ok()?;
        }
        Some(())
    }

    /// Orbits for this long; `None` if a picture fails to come.
    fn run(&mut self, time: Duration) -> Option<Frames> {
        let mut frames = Frames::default();
        let start = Instant::now();
        while start.elapsed() < time {
            let asked = Instant::now();
            self.turn();
            let picture = self.wait_for_picture()?;
            frames.latencies.push(asked.elapsed());
            frames.pixels += u64::from(picture.size[0]) * u64::from(picture.size[1]);
        }
        frames.time = start.elapsed();
        Some(frames)
    }

    /// Asks for the stone from the next direction.
    fn turn(&mut self) {
        let step = Quat::from_rotation_z(STEP_DEGREES.to_radians());
        let Camera { position, target, .. } = self.camera;
        self.camera.position = target + step * (position - target);
        self.session.request(RenderRequest {
            scene: Arc::clone(&self.scene),
            camera: self.camera,
            size: self.size,
            trace: self.trace.clone(),
            pass_limit: self.pass_limit,
            backend: self.backend,
        });
    }

    /// The next picture that was not seen before.
    fn wait_for_picture(&mut self) -> Option<Arc<Picture>> {
        loop {
            self.updates.recv_timeout(PATIENCE).ok()?;
            if let Some(picture) = self.session.picture()
                && self.last_serial != Some(picture.serial)
            {
                self.last_serial = Some(picture.serial);
                return Some(picture);
            }
        }
    }
}

/// The pictures that came.
#[derive(Default)]
struct Frames {
    time: Duration,
    latencies: Vec<Duration>,
    pixels: u64,
}

impl Frames {
    fn print(mut self, size: [u32; 2], tracer: &TracerName) {
        let count = self.latencies.len();
        if count == 0 {
            return;
        }
        self.latencies.sort_unstable();
        let milliseconds =
            |part: usize| 1000.0 * self.latencies[(count - 1) * part / 100].as_secs_f64();
        let share = self.pixels as f64 / count as f64 / f64::from(size[0] * size[1]);
        println!(
            "preview, {tracer}, orbiting at {}x{}: {:.1} frames/s, each of {:.0}x{:.0} traced pixels in the \
             mean; from request to picture {:.1} ms (median), {:.1} ms (95th percentile)",
            size[0],
            size[1],
            count as f64 / self.time.as_secs_f64(),
            f64::from(size[0]) * share.sqrt(),
            f64::from(size[1]) * share.sqrt(),
            milliseconds(50),
            milliseconds(95),
        );
    }
}
