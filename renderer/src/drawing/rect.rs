//! Upright rectangles on a sheet.

use glam::DVec2;

/// An upright rectangle, in millimetres of the sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    /// Its upper left corner.
    pub min: DVec2,
    /// Its lower right corner.
    pub max: DVec2,
}

impl Rect {
    /// The rectangle of this centre and size.
    pub fn centered(center: DVec2, size: DVec2) -> Self {
        Self { min: center - 0.5 * size, max: center + 0.5 * size }
    }

    /// The smallest rectangle about `points`; `None` without any.
    pub fn about(points: impl IntoIterator<Item = DVec2>) -> Option<Self> {
        points.into_iter().fold(None, |rect: Option<Self>, point| {
            let Self { min, max } = rect.unwrap_or(Self { min: point, max: point });
            Some(Self { min: min.min(point), max: max.max(point) })
        })
    }

    /// Its middle.
    pub fn center(&self) -> DVec2 {
        0.5 * (self.min + self.max)
    }

    /// Width and height.
    pub fn size(&self) -> DVec2 {
        self.max - self.min
    }

    /// The rectangle with `margin` more on every side.
    #[must_use]
    pub fn grown(&self, margin: f64) -> Self {
        Self { min: self.min - margin, max: self.max + margin }
    }

    /// Its corners, in turn.
    pub fn corners(&self) -> [DVec2; 4] {
        let Self { min, max } = *self;
        [min, DVec2::new(max.x, min.y), max, DVec2::new(min.x, max.y)]
    }

    /// True if `other` lies wholly inside.
    pub fn contains(&self, other: &Self) -> bool {
        self.min.cmple(other.min).all() && self.max.cmpge(other.max).all()
    }

    /// True if the two have more in common than a rim.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.min.cmplt(other.max).all() && self.max.cmpgt(other.min).all()
    }

    /// True if the line passes through the inside.
    pub fn is_crossed_by(&self, ends: [DVec2; 2]) -> bool {
        self.clipped(ends).is_some()
    }

    /// The part of the line that passes through the inside, if any does.
    ///
    /// Y.-D. Liang and B. A. Barsky, "A New Concept and Method for Line Clipping", ACM TOG 3(1),
    /// 1984.
    pub fn clipped(&self, [a, b]: [DVec2; 2]) -> Option<[DVec2; 2]> {
        let along = b - a;
        let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
        for axis in 0..2 {
            if along[axis] == 0.0 {
                if a[axis] <= self.min[axis] || a[axis] >= self.max[axis] {
                    return None;
                }
            } else {
                let (t, u) = (
                    (self.min[axis] - a[axis]) / along[axis],
                    (self.max[axis] - a[axis]) / along[axis],
                );
                enters = enters.max(t.min(u));
                leaves = leaves.min(t.max(u));
            }
        }
        (enters < leaves).then_some([a.lerp(b, enters), a.lerp(b, leaves)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rim_is_not_crossed_and_not_shared() {
        let rect = Rect::centered(DVec2::ZERO, DVec2::splat(2.0));
        let line = |ax, ay, bx, by| rect.is_crossed_by([DVec2::new(ax, ay), DVec2::new(bx, by)]);
        assert!(line(-5.0, 0.0, 5.0, 0.5));
        assert!(line(0.0, 0.0, 0.1, 0.0), "a line inside");
        assert!(!line(-5.0, 1.0, 5.0, 1.0), "along the rim");
        assert!(!line(-5.0, 0.0, -2.0, 0.0), "ends before it");
        assert!(!line(0.0, 3.0, 3.0, 0.0), "passes a corner");
        assert!(!rect.overlaps(&Rect::centered(DVec2::new(2.0, 0.0), DVec2::splat(2.0))));
        assert!(rect.overlaps(&Rect::centered(DVec2::new(1.9, 0.0), DVec2::splat(2.0))));
    }
}
