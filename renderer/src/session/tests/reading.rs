//! What is watched is read, by the device or from a copy of its film.

use super::*;

#[test]
fn a_device_reads_what_is_watched_and_nothing_where_nothing_is() {
    let device = FakeDevice::hardware();
    let mut watched = Watched::tracing(Backend::Gpu, &device);
    watched.wait_for_done(true);
    assert_eq!((device.count(Call::Mean), watched.reading()), (0, None));
    let passes = device.count(Call::Trace);
    for (serial, region) in
        [(1, Region::WHOLE), (2, Region::of_pixel_at([0.5; 2], SIZE)), (3, Region::WHOLE)]
    {
        watched.threads.watch(Some(region));
        watched.wait(|watched| watched.reading().is_some_and(|it| it.serial == serial));
        assert_eq!(watched.reading().map(|it| it.region), Some(region));
    }
    watched.threads.watch(Some(Region::WHOLE));
    watched.threads.watch(None);
    assert_eq!(watched.reading(), None);
    assert_eq!((device.count(Call::Mean), device.count(Call::Trace)), (3, passes));
}

#[test]
fn another_region_is_read_while_a_long_round_goes_on() {
    let device = FakeDevice::hardware();
    device.plan().seconds_per_pixel = Some(3e-4);
    let endless = RenderRequest { pass_limit: 1_000_000, ..request(Backend::Gpu) };
    let mut watched = Watched::tracing_request(endless, &device);
    watched.threads.watch(Some(Region::WHOLE));
    // The processor reads it too, until the device is ready.
    watched.wait(|watched| watched.is_on_device() && watched.reading().is_some());
    device.plan().seconds_per_pixel = Some(1e6);
    let rounds = device.count(Call::Trace);
    while device.count(Call::Trace) == rounds {
        std::thread::sleep(Duration::from_millis(1));
    }
    let readings = device.count(Call::Mean);
    let region = Region::of_pixel_at([0.5; 2], SIZE);
    watched.threads.watch(Some(region));
    watched.wait(|watched| watched.reading().is_some_and(|it| it.region == region));
    assert_eq!((device.count(Call::Trace), device.count(Call::Mean)), (rounds + 1, readings));
}
