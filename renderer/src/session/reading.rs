//! The spectrum of a region that somebody watches.

use std::sync::Arc;

use crate::film::{PixelRect, Region, mean_in};
use crate::spectrum::Bins;

/// What the film has in a region.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// What is watched.
    pub region: Region,
    /// The film's pixels that this was read from.
    pub pixels: PixelRect,
    /// Width and height of the film in pixels.
    pub film_size: [u32; 2],
    /// The film's division of the spectrum.
    pub bins: Bins,
    /// Mean spectral radiance over the pixels and passes, one value per bin; 1 is the radiance
    /// whose luminance is 1 if it is the same at every wavelength.
    pub spectrum: Vec<f32>,
    /// Passes in the film.
    pub passes: u32,
    /// Whether the film is coarser, or traced with less effort, than was asked for.
    pub is_draft: bool,
    /// Counts up with every reading of the session.
    pub serial: u64,
}

/// What a film is, without what is in it.
#[derive(Clone, Copy)]
pub(super) struct FilmState {
    pub(super) size: [u32; 2],
    pub(super) bins: Bins,
    pub(super) passes: u32,
    pub(super) is_draft: bool,
}

impl Reading {
    /// What a film has in `region`: its mean there is `spectrum`.
    pub(super) fn new(region: Region, film: FilmState, spectrum: Vec<f32>) -> Self {
        let FilmState { size, bins, passes, is_draft } = film;
        let pixels = region.pixels(size);
        Self { region, pixels, film_size: size, bins, spectrum, passes, is_draft, serial: 0 }
    }
}

/// A copy of a film's means, to be read while the film itself is worked on.
pub(super) struct FilmCopy {
    pub(super) means: Vec<f32>,
    pub(super) state: FilmState,
}

impl FilmCopy {
    /// Reads a region.
    pub(super) fn read(&self, region: Region) -> Reading {
        let FilmState { size, bins, .. } = self.state;
        let spectrum = mean_in(&self.means, |_| 1.0, size, bins, region.pixels(size));
        Reading::new(region, self.state, spectrum)
    }
}

/// The region that is watched, and what was last read there.
#[derive(Default)]
pub(super) struct Watch {
    region: Option<Region>,
    /// Changes with the region, so that what is late from an earlier one is known as such.
    number: u64,
    /// The newest reading, and the number of the region that it is of.
    reading: Option<(Arc<Reading>, u64)>,
    last_serial: u64,
    /// The film as it was handed on last, while it takes long until that happens again.
    copy: Option<Arc<FilmCopy>>,
}

impl Watch {
    /// Watches another region, or none; false where it is the one that was watched before.
    pub(super) fn set(&mut self, region: Option<Region>) -> bool {
        if self.region == region {
            return false;
        }
        self.region = region;
        self.number += 1;
        if region.is_none() {
            self.reading = None;
        }
        true
    }

    /// What is watched, and the number that its readings are known by.
    pub(super) fn watched(&self) -> Option<(Region, u64)> {
        self.region.map(|region| (region, self.number))
    }

    pub(super) fn reading(&self) -> Option<&Arc<Reading>> {
        self.reading.as_ref().map(|(reading, _)| reading)
    }

    /// Takes note of a reading of that number, unless another region is watched by now.
    pub(super) fn take(&mut self, number: u64, reading: Reading) {
        if self.number == number {
            self.last_serial += 1;
            let reading = Reading { serial: self.last_serial, ..reading };
            self.reading = Some((Arc::new(reading), number));
        }
    }

    /// [`take`](Self::take) for what was read from a copy: only until there is a reading of that
    /// number, which is no older.
    pub(super) fn take_first(&mut self, number: u64, reading: Reading) {
        if self.reading.as_ref().is_none_or(|&(_, read)| read != number) {
            self.take(number, reading);
        }
    }

    /// Keeps a copy of the film where one is watched, or none. Gives the one before, which is too
    /// large to be dropped while others wait for this.
    #[must_use]
    pub(super) fn keep(&mut self, copy: Option<FilmCopy>) -> Option<Arc<FilmCopy>> {
        std::mem::replace(&mut self.copy, copy.filter(|_| self.region.is_some()).map(Arc::new))
    }

    pub(super) fn copy(&self) -> Option<&Arc<FilmCopy>> {
        self.copy.as_ref()
    }
}
