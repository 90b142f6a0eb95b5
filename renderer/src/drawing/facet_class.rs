//! Facets that go by one name.

use super::body::FacetedBody;

/// Facets count as vertical within this of 90° from the girdle plane, in degrees.
const VERTICAL_DEGREES: f64 = 0.005;
/// Facets of one class differ by no more than this, in degrees.
const SAME_DEGREES: f64 = 0.01;

/// Which part of a stone a facet belongs to, from the top down.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Zone {
    /// It faces upwards.
    Crown,
    /// It is vertical.
    Girdle,
    /// It faces downwards.
    Pavilion,
}

/// Facets of the same name, side and angle: what a cutter works at one setting.
#[derive(Clone, Debug, PartialEq)]
pub struct FacetClass {
    /// The name without its number, as "upper half".
    pub name: String,
    /// Where its facets are.
    pub zone: Zone,
    /// Angle from the girdle plane, in 0..=90 degrees.
    pub angle_degrees: f64,
    /// Its facets, as indices of the body's.
    pub facets: Vec<usize>,
    /// Their surface together, in mm².
    pub area: f64,
}

impl FacetClass {
    /// The classes of `body`, from the table down to the culet.
    pub fn all(body: &FacetedBody) -> Vec<Self> {
        let mut classes: Vec<Self> = Vec::new();
        for (index, facet) in body.facets.iter().enumerate() {
            let normal = facet.normal;
            if facet.rim.is_empty() || normal.length_squared() == 0.0 {
                continue;
            }
            let angle = normal.truncate().length().atan2(normal.z.abs()).to_degrees();
            let zone = match normal.z {
                _ if angle > 90.0 - VERTICAL_DEGREES => Zone::Girdle,
                z if z > 0.0 => Zone::Crown,
                _ => Zone::Pavilion,
            };
            let name = class_name(&facet.name, zone, angle);
            let same = classes.iter_mut().find(|class| {
                class.name == name
                    && class.zone == zone
                    && (class.angle_degrees - angle).abs() <= SAME_DEGREES
            });
            if let Some(class) = same {
                class.facets.push(index);
                class.area += facet.area;
            } else {
                let (facets, area) = (vec![index], facet.area);
                classes.push(Self { name, zone, angle_degrees: angle, facets, area });
            }
        }
        classes.sort_by(|a, b| {
            // On the crown the flattest is the highest, on the pavilion the steepest.
            let height = |class: &Self| match class.zone {
                Zone::Pavilion => class.angle_degrees,
                _ => -class.angle_degrees,
            };
            a.zone.cmp(&b.zone).then(height(b).total_cmp(&height(a)))
        });
        classes
    }

    /// The angle as the trade writes it: "34.5°".
    pub fn angle_text(&self) -> String {
        format!("{}°", trimmed(self.angle_degrees))
    }
}

/// A number to two decimals, without zeros that say nothing.
pub(super) fn trimmed(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// The name without the number at its end; one by the zone for a facet without a name.
fn class_name(name: &str, zone: Zone, angle_degrees: f64) -> String {
    let stem = name.trim_end_matches(|letter: char| letter.is_ascii_digit());
    let numbered = stem.len() < name.len() && stem.ends_with([' ', '-', '_', '#', '.']);
    let stem = if numbered { stem } else { name };
    let stem = stem.trim_end_matches([' ', '-', '_', '#', '.']).trim();
    if !stem.is_empty() {
        return stem.to_owned();
    }
    let name = match zone {
        Zone::Crown if angle_degrees < SAME_DEGREES => "table",
        Zone::Crown => "crown",
        Zone::Girdle => "girdle",
        Zone::Pavilion => "pavilion",
    };
    name.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_class_is_named_without_the_number_of_the_facet() {
        let name = |name| class_name(name, Zone::Crown, 30.0);
        assert_eq!(name("upper half 12"), "upper half");
        assert_eq!(name("facet-3"), "facet");
        // Here the number is the name of the tier.
        assert_eq!(name("P1"), "P1");
        assert_eq!(name("7"), "7");
        assert_eq!(name(""), "crown");
        assert_eq!(class_name("", Zone::Crown, 0.0), "table");
        assert_eq!(class_name(" 3", Zone::Girdle, 90.0), "girdle");
    }

    #[test]
    fn angles_are_short() {
        assert_eq!(trimmed(34.5), "34.5");
        assert_eq!(trimmed(40.750_000_1), "40.75");
        assert_eq!(trimmed(0.0), "0");
        assert_eq!(trimmed(-0.001), "0");
        assert_eq!(trimmed(90.0), "90");
    }
}
