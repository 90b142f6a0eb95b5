//! How far the two sides may be apart.

/// How far a device's numbers may be from those of the processor. Whole numbers must be the same.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tolerance {
    absolute: f32,
    relative: f32,
    stray: f64,
}

/// No rounding at all, or the same on both sides.
pub(crate) const EXACT: Tolerance = Tolerance::relative(0.0);

/// A few roundings, which a device may fuse or reorder; WGSL lets a division be off by 2.5 ulp.
pub(crate) const ROUNDING: Tolerance = Tolerance::relative(1e-6).or(1e-6);

impl Tolerance {
    /// So much of the expected value.
    pub(crate) const fn relative(relative: f32) -> Self {
        // Devices may take numbers below the normal ones for 0.
        Self { absolute: f32::MIN_POSITIVE, relative, stray: 0.0 }
    }

    /// Or at least `absolute`.
    pub(crate) const fn or(self, absolute: f32) -> Self {
        Self { absolute, ..self }
    }

    /// A share of the cases may differ altogether: those where rounding decides between two
    /// results that lie apart.
    pub(crate) const fn but(self, stray: f64) -> Self {
        Self { stray, ..self }
    }

    pub(super) fn allows(&self, magnitude: f32, difference: f32) -> bool {
        difference.abs() <= self.absolute.max(self.relative * magnitude)
    }

    pub(super) fn allows_strays(&self, strays: usize, cases: usize) -> bool {
        strays as f64 <= self.stray * cases as f64
    }
}
