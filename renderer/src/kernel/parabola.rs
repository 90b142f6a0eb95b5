//! The quadratic function through the three nodes of a fan, and where it changes its sign.

use glam::Vec3A;

/// The function a·s² + 2·b·s + c of the position s.
#[derive(Clone, Copy, Debug)]
pub struct Parabola {
    /// Half of its second derivative.
    pub a: f32,
    /// Half of its slope at the middle node.
    pub b: f32,
    /// Its value at the middle node.
    pub c: f32,
}

/// The parabola through the values at the three nodes.
#[inline]
pub fn parabola_through(values: Vec3A) -> Parabola {
    Parabola {
        a: 0.5 * (values.x + values.z) - values.y,
        b: 0.25 * (values.z - values.x),
        c: values.y,
    }
}

/// Its value at `position`.
#[inline]
pub fn parabola_at(parabola: &Parabola, position: f32) -> f32 {
    (parabola.a * position + 2.0 * parabola.b) * position + parabola.c
}

/// Half of its slope at `position`.
#[inline]
pub fn half_slope_at(parabola: &Parabola, position: f32) -> f32 {
    parabola.a * position + parabola.b
}

/// Where a parabola that rises from −1 to 1 has the given value.
#[inline]
pub fn position_where(rising: &Parabola, value: f32) -> f32 {
    let above = value - rising.c;
    let root = (rising.b * rising.b + rising.a * above).max(0.0).sqrt();
    let slope = rising.b + root;
    if slope > 0.0 { (above / slope).clamp(-1.0, 1.0) } else { 0.0 }
}

/// Where between −1 and 1 the parabola crosses 0: the lower place and the higher. One that is not
/// there is at an end.
#[inline]
pub fn crossings(parabola: &Parabola) -> [f32; 2] {
    let (a, b, c) = (parabola.a, parabola.b, parabola.c);
    let root = (b * b - a * c).max(0.0).sqrt();
    let q = if b < 0.0 { root - b } else { -root - b };
    let (first, second) = (cut_at(q, a), cut_at(c, q));
    [first.min(second), first.max(second)]
}

/// The quotient, brought into −1..=1 without dividing by what is too small for it.
#[inline]
pub fn cut_at(numerator: f32, denominator: f32) -> f32 {
    if numerator.abs() < denominator.abs() {
        numerator / denominator
    } else if (numerator < 0.0) == (denominator < 0.0) {
        1.0
    } else {
        -1.0
    }
}
