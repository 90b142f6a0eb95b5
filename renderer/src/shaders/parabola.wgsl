// The quadratic function through the three nodes of a fan, and where it changes its sign.

// The function a·s² + 2·b·s + c of the position s.
struct Parabola {
    a: f32,
    b: f32,
    c: f32,
}

// The parabola through the values at the three nodes.
fn parabola_through(values: vec3f) -> Parabola {
    return Parabola(
        0.5 * (values.x + values.z) - values.y,
        0.25 * (values.z - values.x),
        values.y,
    );
}

// Its value at `position`.
fn parabola_at(parabola: Parabola, position: f32) -> f32 {
    return (parabola.a * position + 2.0 * parabola.b) * position + parabola.c;
}

// Half of its slope at `position`.
fn half_slope_at(parabola: Parabola, position: f32) -> f32 {
    return parabola.a * position + parabola.b;
}

// Where a parabola that rises from −1 to 1 has the given value.
fn position_where(rising: Parabola, value: f32) -> f32 {
    let above = value - rising.c;
    let root = sqrt(max(rising.b * rising.b + rising.a * above, 0.0));
    let slope = rising.b + root;
    return select(0.0, clamp(above / max(slope, 1e-30), -1.0, 1.0), slope > 0.0);
}

// Where between −1 and 1 the parabola crosses 0: the lower place and the higher. One that is not
// there is at an end.
fn crossings(parabola: Parabola) -> vec2f {
    let a = parabola.a;
    let b = parabola.b;
    let c = parabola.c;
    let root = sqrt(max(b * b - a * c, 0.0));
    let q = select(-root - b, root - b, b < 0.0);
    let first = cut_at(q, a);
    let second = cut_at(c, q);
    return vec2f(min(first, second), max(first, second));
}

// The quotient, brought into −1..=1 without dividing by what is too small for it.
fn cut_at(numerator: f32, denominator: f32) -> f32 {
    if abs(numerator) < abs(denominator) {
        return numerator / denominator;
    }
    return select(-1.0, 1.0, (numerator < 0.0) == (denominator < 0.0));
}
