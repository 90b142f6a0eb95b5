//! Published proportions of the round brilliant.

use super::RoundBrilliant;

/// A published set of proportions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum StandardProportions {
    /// Tolkowsky 1919: the small table and high crown of the first calculated brilliant.
    Tolkowsky,
    /// What the trade calls ideal today.
    ModernIdeal,
    /// The rounded values drawn on GIA grading reports of well-cut stones.
    GiaChart,
    /// The Scandinavian standard (Scan. D.N.).
    Scandinavian,
    /// Eppler 1939, *Feinschliff der Praxis*: the German trade's standard.
    #[default]
    PracticalFineCut,
}

impl StandardProportions {
    /// All sets, oldest first.
    pub const ALL: [Self; 5] = [
        Self::Tolkowsky,
        Self::PracticalFineCut,
        Self::Scandinavian,
        Self::ModernIdeal,
        Self::GiaChart,
    ];

    /// Name for the user.
    pub fn name(self) -> &'static str {
        match self {
            Self::Tolkowsky => "Tolkowsky (1919)",
            Self::ModernIdeal => "Modern ideal",
            Self::GiaChart => "GIA chart",
            Self::Scandinavian => "Scandinavian standard",
            Self::PracticalFineCut => "Practical Fine Cut (Eppler 1939)",
        }
    }

    /// Where the numbers come from.
    ///
    /// Sources that state only table, crown and pavilion are completed with the star length, lower
    /// halves and girdle usual for their time.
    pub fn source(self) -> &'static str {
        match self {
            Self::Tolkowsky => "M. Tolkowsky, Diamond Design, 1919",
            Self::ModernIdeal => "the trade's ideal cut: Tolkowsky's angles, wider table",
            Self::GiaChart => "GIA Diamond Cut Grading System, rounded chart proportions",
            Self::Scandinavian => "Scandinavian Diamond Nomenclature, 1969",
            Self::PracticalFineCut => "W. F. Eppler, Feinschliff der Praxis, 1939",
        }
    }

    /// The proportions, for a stone of `diameter_mm`, with a pointed culet.
    pub fn of_diameter(self, diameter_mm: f32) -> RoundBrilliant {
        let [table, crown, pavilion, star, lower_half, girdle] = match self {
            Self::Tolkowsky => [0.53, 34.5, 40.75, 0.50, 0.60, 0.007],
            Self::ModernIdeal => [0.56, 34.5, 40.75, 0.50, 0.77, 0.03],
            Self::GiaChart => [0.57, 34.5, 41.0, 0.55, 0.80, 0.03],
            Self::Scandinavian => [0.575, 34.5, 40.75, 0.50, 0.75, 0.02],
            Self::PracticalFineCut => [0.56, 33.2, 40.8, 0.50, 0.75, 0.025],
        };
        RoundBrilliant {
            diameter_mm,
            table,
            crown_angle_degrees: crown,
            pavilion_angle_degrees: pavilion,
            star_length: star,
            lower_half_length: lower_half,
            girdle_thickness: girdle,
            culet: 0.0,
        }
    }
}
