//! A graphics device for tests: the processor, which fails when told to.

use std::sync::{Arc, Condvar, Mutex, MutexGuard};
use std::time::{Duration, Instant};

use super::{CpuTracer, Device, Tracer, TracerName, View};
use crate::develop::LatentImage;
use crate::error::RendererError;
use crate::film::{Film, PixelRect};
use crate::packed::PackedScene;
use crate::settings::{NoiseGoal, TraceSettings};
use crate::spectrum::Bins;
use crate::statistics::Statistics;

/// What every failure of the device says.
pub(crate) const REASON: &str = "the device caught fire";

/// What can be asked of a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Call {
    Prepare,
    Load,
    Film,
    Trace,
    Expose,
    Mean,
    Noise,
    Read,
}

/// How the device behaves, and what it was asked.
#[derive(Default)]
pub(crate) struct Plan {
    /// The call that fails, after so many that succeed.
    pub(crate) fails_at: Option<(Call, usize)>,
    /// Whether failing means a panic.
    pub(crate) panics: bool,
    /// Largest film; none for any.
    pub(crate) most_pixels: Option<u32>,
    /// Largest film that can be exposed; none for any.
    pub(crate) most_exposed_pixels: Option<u32>,
    /// What tracing costs; passes that have a cost leave the film black.
    pub(crate) seconds_per_pixel: Option<f64>,
    /// Whether the compiler is kept from finishing.
    pub(crate) compiler_waits: bool,
    pub(crate) calls: Vec<Call>,
}

/// A device whose behaviour a test changes while it is in use.
#[derive(Clone, Default)]
pub(crate) struct FakeDevice {
    is_software: bool,
    shared: Arc<(Mutex<Plan>, Condvar)>,
}

impl FakeDevice {
    pub(crate) fn hardware() -> Self {
        Self::default()
    }

    pub(crate) fn software() -> Self {
        Self { is_software: true, ..Self::default() }
    }

    pub(crate) fn failing_at(call: Call, successes: usize) -> Self {
        let device = Self::hardware();
        device.plan().fails_at = Some((call, successes));
        device
    }

    pub(crate) fn plan(&self) -> MutexGuard<'_, Plan> {
        self.shared.0.lock().expect("nobody panics with the plan")
    }

    pub(crate) fn let_compiler_finish(&self) {
        self.plan().compiler_waits = false;
        self.shared.1.notify_all();
    }

    /// Number of times that the device was asked for this.
    pub(crate) fn count(&self, call: Call) -> usize {
        self.plan().calls.iter().filter(|&&asked| asked == call).count()
    }

    fn call(&self, call: Call) -> Result<(), RendererError> {
        let count = self.count(call);
        let mut plan = self.plan();
        plan.calls.push(call);
        let fails = plan.fails_at.is_some_and(|(at, successes)| at == call && count >= successes);
        let panics = plan.panics;
        drop(plan);
        match (fails, panics) {
            (false, _) => Ok(()),
            (true, false) => Err(RendererError::Graphics(REASON.to_owned())),
            (true, true) => panic!("{REASON}"),
        }
    }
}

impl Device for FakeDevice {
    type Tracer = FakeTracer;

    fn is_software(&self) -> bool {
        self.is_software
    }

    fn is_same(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.shared, &other.shared)
    }

    fn prepare(&self) -> Result<FakeTracer, RendererError> {
        self.call(Call::Prepare)?;
        let waits = |plan: &mut Plan| plan.compiler_waits;
        drop(self.shared.1.wait_while(self.plan(), waits).expect("nobody panics with the plan"));
        Ok(FakeTracer { device: self.clone(), cpu: CpuTracer::new(1)? })
    }
}

/// The processor in the role of a device.
pub(crate) struct FakeTracer {
    device: FakeDevice,
    cpu: CpuTracer,
}

impl Tracer for FakeTracer {
    type Scene = PackedScene;
    type Film = Film;

    fn name(&self) -> TracerName {
        TracerName::Gpu { device: "fake".to_owned(), is_software: self.device.is_software }
    }

    fn load(&self, scene: PackedScene) -> Result<PackedScene, RendererError> {
        self.device.call(Call::Load)?;
        self.cpu.load(scene)
    }

    fn film(&self, size: [u32; 2], bins: Bins, used: Option<Film>) -> Result<Film, RendererError> {
        self.device.call(Call::Film)?;
        if self.device.plan().most_pixels.is_some_and(|most| size[0] * size[1] > most) {
            return Err(RendererError::Graphics(REASON.to_owned()));
        }
        self.cpu.film(size, bins, used)
    }

    fn trace(
        &self,
        scene: &PackedScene,
        view: &View,
        settings: &TraceSettings,
        film: &mut Film,
        passes: u32,
        is_cancelled: &(dyn Fn() -> bool + Sync),
    ) -> Result<Statistics, RendererError> {
        self.device.call(Call::Trace)?;
        let cost = self.device.plan().seconds_per_pixel;
        if let Some(cost) = cost {
            return pass_time(cost, film, passes, is_cancelled);
        }
        self.cpu.trace(scene, view, settings, film, passes, is_cancelled)
    }

    fn expose(&self, film: &Film) -> Result<LatentImage, RendererError> {
        self.device.call(Call::Expose)?;
        let pixels = film.size()[0] * film.size()[1];
        if self.device.plan().most_exposed_pixels.is_some_and(|most| pixels > most) {
            return Err(RendererError::Graphics(REASON.to_owned()));
        }
        self.cpu.expose(film)
    }

    fn mean_spectrum(&self, film: &Film, rect: PixelRect) -> Result<Vec<f32>, RendererError> {
        self.device.call(Call::Mean)?;
        self.cpu.mean_spectrum(film, rect)
    }

    fn measure_noise(&self, film: &mut Film, goal: NoiseGoal) -> Result<f32, RendererError> {
        self.device.call(Call::Noise)?;
        self.cpu.measure_noise(film, goal)
    }

    fn copy_means(&self, film: &Film) -> Option<Vec<f32>> {
        self.cpu.copy_means(film)
    }

    fn read(&self, film: Film) -> Result<Film, RendererError> {
        self.device.call(Call::Read)?;
        self.cpu.read(film)
    }
}

/// Takes the time of `passes` passes at `cost` seconds per pixel.
fn pass_time(
    cost: f64,
    film: &mut Film,
    passes: u32,
    is_cancelled: &(dyn Fn() -> bool + Sync),
) -> Result<Statistics, RendererError> {
    let [width, height] = film.size().map(f64::from);
    let time = Duration::from_secs_f64(cost * width * height * f64::from(passes));
    let started = Instant::now();
    while started.elapsed() < time {
        if is_cancelled() {
            return Err(RendererError::Cancelled);
        }
        std::thread::sleep(Duration::from_millis(1));
    }
    for _ in 0..passes {
        film.complete_pass();
    }
    Ok(Statistics::default())
}
