//! Straight lines between samples over wavelength.

/// A function of wavelength: straight lines between samples, constant beyond the ends.
#[derive(Clone, Debug)]
pub(super) struct Polyline {
    /// Wavelengths in nm, increasing.
    lambda_nm: Vec<f64>,
    /// One value per wavelength.
    value: Vec<f64>,
}

impl Polyline {
    /// Joins samples of increasing wavelength, each a wavelength in nm and a value.
    pub(super) fn new(samples: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let (lambda_nm, value) = samples.into_iter().unzip();
        Self { lambda_nm, value }
    }

    /// Reads an embedded table: lines of comma-separated numbers, the wavelength in nm first, then
    /// one column per polyline. Lines of anything else are headings.
    pub(super) fn from_csv<const COLUMNS: usize>(table: &str) -> [Self; COLUMNS] {
        let rows: Vec<Vec<f64>> = table
            .lines()
            .map(|line| line.split(',').map_while(|number| number.parse().ok()).collect())
            .filter(|row: &Vec<f64>| row.len() == COLUMNS + 1)
            .collect();
        std::array::from_fn(|column| Self::new(rows.iter().map(|row| (row[0], row[column + 1]))))
    }

    /// The value at a wavelength in nm; 0 if there are no samples.
    pub(super) fn at(&self, lambda_nm: f64) -> f64 {
        let above = self.lambda_nm.partition_point(|&knot| knot <= lambda_nm);
        if above == 0 {
            return self.value.first().copied().unwrap_or(0.0);
        }
        if above == self.lambda_nm.len() {
            return self.value[above - 1];
        }
        let (left, right) = (self.lambda_nm[above - 1], self.lambda_nm[above]);
        let t = (lambda_nm - left) / (right - left);
        self.value[above - 1] + t * (self.value[above] - self.value[above - 1])
    }

    /// The exact integral from `low` to `high`, in value · nm.
    pub(super) fn integral(&self, low: f64, high: f64) -> f64 {
        let first = self.lambda_nm.partition_point(|&knot| knot <= low);
        let last = self.lambda_nm.partition_point(|&knot| knot < high).max(first);
        let inner = self.lambda_nm[first..last].iter().copied();
        let inner = inner.zip(self.value[first..last].iter().copied());
        let mut left = (low, self.at(low));
        let mut area = 0.0;
        for right in inner.chain([(high, self.at(high))]) {
            area += 0.5 * (right.0 - left.0) * (left.1 + right.1);
            left = right;
        }
        area
    }

    /// The sum of lines of the same wavelengths, each multiplied by its weight.
    pub(super) fn mixture(lines: &[Self; 3], weights: [f64; 3]) -> Self {
        let value = |i: usize| lines.iter().zip(weights).map(|(line, w)| w * line.value[i]).sum();
        let lambda_nm = lines[0].lambda_nm.clone();
        Self { value: (0..lambda_nm.len()).map(value).collect(), lambda_nm }
    }

    /// The same line with every value multiplied by `factor`.
    pub(super) fn scaled(mut self, factor: f64) -> Self {
        for value in &mut self.value {
            *value *= factor;
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_loses_no_row_and_no_column() {
        let [a, b] = Polyline::from_csv("# of two\nnm,a,b\n400,1,-2\n410,3e-1,4\n420,5,6\n");
        assert_eq!(a.lambda_nm, [400.0, 410.0, 420.0]);
        assert_eq!(a.value, [1.0, 0.3, 5.0]);
        assert_eq!(b.value, [-2.0, 4.0, 6.0]);
    }

    #[test]
    fn lines_are_straight_between_samples_and_constant_beyond() {
        let line = Polyline::new([(400.0, 1.0), (500.0, 3.0), (600.0, 3.0)]);
        assert_eq!(line.at(300.0), 1.0);
        assert_eq!(line.at(450.0), 2.0);
        assert_eq!(line.at(500.0), 3.0);
        assert_eq!(line.at(900.0), 3.0);
    }

    #[test]
    fn a_mixture_has_a_part_of_each() {
        let line = |low, high| Polyline::new([(400.0, low), (500.0, high)]);
        let mixture = Polyline::mixture(
            &[line(1.0, 0.0), line(0.0, 1.0), line(2.0, 2.0)],
            [0.5, 0.25, 0.125],
        );
        assert_eq!(mixture.lambda_nm, [400.0, 500.0]);
        assert_eq!(mixture.value, [0.75, 0.5]);
    }

    #[test]
    fn the_integral_is_the_area_under_the_lines() {
        let line = Polyline::new([(400.0, 0.0), (500.0, 2.0), (600.0, 0.0)]);
        assert_eq!(line.integral(400.0, 600.0), 200.0);
        // A quarter of the way up the left flank: ½ · 25 · ½.
        assert_eq!(line.integral(390.0, 425.0), 6.25);
        assert_eq!(line.integral(450.0, 550.0), 150.0);
        assert_eq!(line.integral(450.0, 450.0), 0.0);
        assert_eq!(Polyline::new([]).integral(400.0, 500.0), 0.0);
    }
}
