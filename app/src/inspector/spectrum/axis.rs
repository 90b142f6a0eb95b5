//! The axes of a plot.

use std::ops::RangeInclusive;

/// Values along a line on the screen.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axis {
    /// The values at the two ends.
    pub(super) values: [f64; 2],
    /// Where the ends are, in points.
    pub(super) ends: [f32; 2],
    /// Whether equal distances are equal ratios, of positive values then.
    pub(super) is_logarithmic: bool,
}

impl Axis {
    pub(super) fn linear(values: RangeInclusive<f64>, ends: [f32; 2]) -> Self {
        Self { values: [*values.start(), *values.end()], ends, is_logarithmic: false }
    }

    /// Where a value is, at an end where it lies beyond.
    pub(super) fn at(&self, value: f64) -> f32 {
        let [low, high] = self.values;
        let share = if self.is_logarithmic {
            (value.max(low) / low).ln() / (high / low).ln()
        } else {
            (value - low) / (high - low)
        };
        self.ends[0] + share.clamp(0.0, 1.0) as f32 * (self.ends[1] - self.ends[0])
    }

    /// The value at a place, for a linear axis.
    pub(super) fn value_at(&self, place: f32) -> f64 {
        let share = (place - self.ends[0]) / (self.ends[1] - self.ends[0]);
        self.values[0] + f64::from(share) * (self.values[1] - self.values[0])
    }

    /// Round values along the axis and how they are written: about `count`, or each power of ten.
    pub(super) fn ticks(&self, count: u32) -> Vec<(f64, String)> {
        let [low, high] = self.values;
        if self.is_logarithmic {
            let powers = low.log10().ceil() as i32..=high.log10().floor() as i32;
            return powers.map(|power| (10_f64.powi(power), power_of_ten(power))).collect();
        }
        let step = round_up((high - low) / f64::from(count));
        let decimals = (-step.log10() + 1e-9).ceil().max(0.0) as usize;
        let first = (low / step).ceil() as i64;
        let last = (high / step + 1e-9).floor() as i64;
        let ticks = (first..=last).map(|number| number as f64 * step);
        ticks.map(|value| (value, written(value, decimals))).collect()
    }
}

/// The smallest of 1, 2 or 5 times a power of ten that is not below `value` > 0.
fn round_up(value: f64) -> f64 {
    round_up_to(&[1.0, 2.0, 5.0], value)
}

/// The smallest of `factors` in 1..10, in order, times a power of ten that is not below `value` > 0.
pub(super) fn round_up_to(factors: &[f64], value: f64) -> f64 {
    let power = 10_f64.powf(value.log10().floor());
    let factor = factors.iter().copied().find(|factor| factor * power >= value * (1.0 - 1e-9));
    factor.unwrap_or(10.0) * power
}

fn power_of_ten(power: i32) -> String {
    if (-2..=3).contains(&power) { format!("{}", 10_f64.powi(power)) } else { format!("1e{power}") }
}

/// As many decimals as the step needs; in powers of ten where these are many.
fn written(value: f64, decimals: usize) -> String {
    match decimals {
        0..=4 => format!("{value:.decimals$}"),
        _ if value == 0.0 => "0".to_owned(),
        _ => format!("{value:.0e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(axis: &Axis, count: u32) -> Vec<String> {
        axis.ticks(count).into_iter().map(|(_, text)| text).collect()
    }

    #[test]
    fn ticks_are_round_and_lie_on_the_axis() {
        let axis = Axis::linear(0.0..=0.1, [100.0, 0.0]);
        assert_eq!(texts(&axis, 5), ["0.00", "0.02", "0.04", "0.06", "0.08", "0.10"]);
        assert_eq!(axis.at(0.025), 75.0);
        assert_eq!((axis.at(-3.0), axis.at(7.0)), (100.0, 0.0));
        let wavelengths = Axis::linear(380.0..=730.0, [0.0, 350.0]);
        assert_eq!(texts(&wavelengths, 8), ["400", "450", "500", "550", "600", "650", "700"]);
        assert!((wavelengths.value_at(wavelengths.at(589.0)) - 589.0).abs() < 1e-4);
        assert_eq!(texts(&Axis::linear(0.0..=2e-6, [0.0, 1.0]), 2), ["0", "1e-6", "2e-6"]);
    }

    #[test]
    fn a_logarithmic_axis_has_its_powers_of_ten() {
        let axis = Axis { is_logarithmic: true, ..Axis::linear(5e-4..=5.0, [40.0, 0.0]) };
        assert_eq!(texts(&axis, 3), ["1e-3", "0.01", "0.1", "1"]);
        assert_eq!((axis.at(0.05), axis.at(0.0)), (20.0, 40.0));
    }

    #[test]
    fn numbers_are_rounded_up_to_one_two_or_five() {
        for (value, rounded) in [(0.3, 0.5), (1.0, 1.0), (1.1, 2.0), (60.0, 100.0), (2e-9, 2e-9)] {
            assert!((round_up(value) / rounded - 1.0).abs() < 1e-9, "{value}");
        }
    }
}
