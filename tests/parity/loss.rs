//! A device that goes away in the middle of it.

use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use brilliance_renderer::error::RendererError;
use brilliance_renderer::tracer::{GpuTracer, Tracer};

use super::{cases, graphics, trace};

#[test]
fn a_device_lost_in_the_middle_is_an_error_and_soon() {
    let graphics = graphics();
    let tracer = GpuTracer::new(&graphics).unwrap();
    let case = cases::furnace();
    // Software compiles the kernel now, and not in the time that counts.
    let (mut film, _) = trace(&tracer, &case);
    let scene = tracer.load(case.packed()).unwrap();
    let is_under_way = AtomicBool::new(false);
    let lost_at = thread::scope(|scope| {
        let tracing = scope.spawn(|| {
            let is_cancelled = || {
                is_under_way.store(true, Ordering::Relaxed);
                false
            };
            let (view, settings) = (case.view(), case.settings());
            tracer.trace(&scene, &view, settings, &mut film, 100_000, &is_cancelled)
        });
        while !is_under_way.load(Ordering::Relaxed) {
            thread::sleep(Duration::from_millis(1));
        }
        thread::sleep(Duration::from_millis(100));
        let lost_at = Instant::now();
        graphics.device().destroy();
        let result = tracing.join().expect("it did not panic");
        let Err(RendererError::Graphics(text)) = result else { panic!("{result:?}") };
        assert!(text.contains("is lost"), "{text}");
        lost_at
    });
    // A tenth of a second, but not where other tests take all of the processor.
    assert!(lost_at.elapsed() < Duration::from_secs(20), "{:?}", lost_at.elapsed());
    // From then on everything is an error at once.
    for text in [
        tracer.load(case.packed()).map(|_| ()).unwrap_err().to_string(),
        tracer.film(case.size, case.bins(), None).map(|_| ()).unwrap_err().to_string(),
        tracer.expose(&film).map(|_| ()).unwrap_err().to_string(),
        tracer.sibling().map(|_| ()).unwrap_err().to_string(),
        tracer.read(film).map(|_| ()).unwrap_err().to_string(),
    ] {
        assert!(text.contains("is lost"), "{text}");
    }
}
