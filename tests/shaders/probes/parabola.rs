//! The quadratic function through three nodes.

use brilliance_renderer::kernel::parabola::{
    Parabola, crossings, cut_at, half_slope_at, parabola_at, parabola_through, position_where,
};
use glam::Vec3A;

use crate::probe::{Case, Probe, ROUNDING, Table, Tolerance, World, throw};

#[test]
fn parabolas() {
    table().check();
}

pub(super) fn table() -> Table {
    Table {
        worlds: vec![World::empty()],
        probes: vec![
            Probe {
                name: "parabola_through",
                wgsl: "put_parabola(parabola_through(take_vec3()));",
                rust: |_, take, put| put.parabola(&parabola_through(take.each())),
                cases: |_| throw(400, |dice| Case::new().each(dice.each(-2.0, 2.0))),
                tolerance: ROUNDING,
            },
            Probe {
                name: "parabola_at",
                wgsl: "put_f32(parabola_at(take_parabola(), take_f32()));",
                rust: |_, take, put| put.f32(parabola_at(&take.parabola(), take.f32())),
                cases: |_| {
                    throw(400, |dice| {
                        let parabola = parabola_through(dice.each(-2.0, 2.0));
                        Case::new().parabola(&parabola).f32(dice.position())
                    })
                },
                tolerance: ROUNDING,
            },
            Probe {
                name: "half_slope_at",
                wgsl: "put_f32(half_slope_at(take_parabola(), take_f32()));",
                rust: |_, take, put| put.f32(half_slope_at(&take.parabola(), take.f32())),
                cases: |_| {
                    throw(400, |dice| {
                        let parabola = parabola_through(dice.each(-2.0, 2.0));
                        Case::new().parabola(&parabola).f32(dice.position())
                    })
                },
                tolerance: ROUNDING,
            },
            Probe {
                name: "position_where",
                wgsl: "put_f32(position_where(take_parabola(), take_f32()));",
                rust: |_, take, put| put.f32(position_where(&take.parabola(), take.f32())),
                cases: |_| rising_parabolas(),
                // Where it begins level the place is the root of a small difference.
                tolerance: Tolerance::relative(1e-4).or(1e-4).but(0.01),
            },
            Probe {
                name: "crossings",
                wgsl: "put_vec2(crossings(take_parabola()));",
                rust: |_, take, put| put.vec2(crossings(&take.parabola())),
                cases: |_| parabolas_about_zero(),
                // Where the parabola only touches 0 the root is one of a small difference.
                tolerance: Tolerance::relative(1e-5).or(1e-5).but(0.01),
            },
            Probe {
                name: "cut_at",
                wgsl: "put_f32(cut_at(take_f32(), take_f32()));",
                rust: |_, take, put| put.f32(cut_at(take.f32(), take.f32())),
                cases: |_| quotients(),
                tolerance: ROUNDING.or(0.0),
            },
        ],
    }
}

/// With two crossings, one or none, straight ones, level ones, and 0 itself.
fn parabolas_about_zero() -> Vec<Case> {
    let mut cases = throw(1000, |dice| {
        let values = dice.each(-1.0, 1.0);
        let (b, c) = (dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
        let any = parabola_through(values);
        let parabola = match dice.below(5) {
            0 => Parabola { a: 0.0, b, c },
            1 => parabola_through(Vec3A::new(values.x, values.y, values.x)),
            2 => Parabola { a: dice.magnitude(1e-9, 1e-2), b, c },
            _ => any,
        };
        Case::new().parabola(&parabola)
    });
    for [a, b, c] in [[0.0; 3], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
    {
        cases.push(Case::new().parabola(&Parabola { a, b, c }));
    }
    cases
}

/// Values on parabolas that rise, beyond their ends, and on those that do not rise at all.
fn rising_parabolas() -> Vec<Case> {
    throw(600, |dice| {
        let (low, width) = (dice.between(0.0, 1.0), dice.magnitude(1e-3, 1.0));
        let drawn = dice.pick(&[0.5, 0.3, 0.7, 0.25]);
        let rising = parabola_through(Vec3A::new(low, low + drawn * width, low + width));
        let level = Parabola { a: 0.0, b: 0.0, c: low };
        let value = low + width * dice.between(-0.1, 1.1);
        let parabola = dice.pick(&[rising, rising, rising, level]);
        Case::new().parabola(&parabola).f32(value)
    })
}

/// Quotients on both sides of ±1, and of zeros of both signs.
fn quotients() -> Vec<Case> {
    let mut cases = throw(500, |dice| {
        let signs = [1.0, -1.0];
        let [numerator, denominator] =
            [0; 2].map(|_| dice.magnitude(1e-12, 1e3) * dice.pick(&signs));
        Case::new().f32(numerator).f32(denominator)
    });
    for numerator in [0.0, -0.0, 1.0, -1.0] {
        for denominator in [0.0, -0.0, 1.0, -1.0] {
            cases.push(Case::new().f32(numerator).f32(denominator));
        }
    }
    cases
}
