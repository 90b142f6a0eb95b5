//! A spectrum as comma-separated values.

use brilliance_renderer::spectrum::Bins;

/// A column of a table of spectra: its name, and a mean radiance per bin.
pub struct Column<'a> {
    /// What it is called in the first row; without commas.
    pub name: &'a str,
    /// The division of the spectrum.
    pub bins: Bins,
    /// One value per bin.
    pub spectrum: &'a [f32],
}

/// A table with a row per bin, in nm, and a column for each of the spectra, which stand below each
/// other where their bins differ. `notes` come first, as comments.
pub fn spectrum_csv(notes: &[String], columns: &[Column<'_>]) -> String {
    let mut csv = String::new();
    for note in notes {
        csv.push_str("# ");
        csv.push_str(note);
        csv.push('\n');
    }
    for same in columns.chunk_by(|a, b| a.bins == b.bins) {
        let names = same.iter().map(|column| column.name);
        let heading: Vec<_> = ["low_nm", "high_nm"].into_iter().chain(names).collect();
        csv.push_str(&heading.join(","));
        csv.push('\n');
        for bin in 0..same[0].bins.count() {
            let (low, high) = same[0].bins.range_nm(bin);
            let values = same.iter().map(|column| column.spectrum[bin]);
            let row: Vec<_> =
                [low, high].into_iter().chain(values).map(|it| it.to_string()).collect();
            csv.push_str(&row.join(","));
            csv.push('\n');
        }
    }
    csv
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spectra_of_the_same_bins_stand_side_by_side() {
        let bins = Bins::new(2);
        let picked = Column { name: "picked", bins, spectrum: &[0.25, 1.5] };
        let kept = Column { name: "kept", bins, spectrum: &[0.0, 3e-7] };
        let csv = spectrum_csv(&["two".to_owned()], &[picked, kept]);
        assert_eq!(
            csv,
            "# two\nlow_nm,high_nm,picked,kept\n380,555,0.25,0\n555,730,1.5,0.0000003\n"
        );
    }

    #[test]
    fn spectra_of_other_bins_stand_below_each_other() {
        let one = Column { name: "a", bins: Bins::new(1), spectrum: &[1.0] };
        let two = Column { name: "b", bins: Bins::new(2), spectrum: &[2.0, 3.0] };
        let csv = spectrum_csv(&[], &[one, two]);
        assert_eq!(csv, "low_nm,high_nm,a\n380,730,1\nlow_nm,high_nm,b\n380,555,2\n555,730,3\n");
    }
}
