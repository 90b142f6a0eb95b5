//! Checks of single values, with the words for what is allowed.

use std::fmt::Display;
use std::ops::RangeInclusive;

use glam::{DVec3, Vec3};

use super::fault::{Fault, quoted, suggestion};

/// `value`, if it lies in `range`.
pub(super) fn in_range<T: PartialOrd + Display>(
    key: &str,
    value: T,
    range: &RangeInclusive<T>,
) -> Result<T, Fault> {
    if range.contains(&value) {
        Ok(value)
    } else {
        let (low, high) = (range.start(), range.end());
        Err(Fault::at(key, format!("found {value}; allowed is {low} to {high}")))
    }
}

/// `value`, if it is greater than zero.
pub(super) fn positive(key: &str, value: f32) -> Result<f32, Fault> {
    if value > 0.0 {
        Ok(value)
    } else {
        Err(Fault::at(key, format!("found {value}; it must be greater than 0")))
    }
}

/// `value`, if it is zero or greater.
pub(super) fn not_negative(key: &str, value: f32) -> Result<f32, Fault> {
    if value >= 0.0 {
        Ok(value)
    } else {
        Err(Fault::at(key, format!("found {value}; it must be 0 or greater")))
    }
}

/// The choice whose name is `text`, in upper or lower case.
pub(super) fn choose<T: Copy>(text: &str, choices: &[(&str, T)]) -> Result<T, Fault> {
    choices
        .iter()
        .find(|(name, _)| name.eq_ignore_ascii_case(text.trim()))
        .map(|(_, choice)| *choice)
        .ok_or_else(|| {
            let names: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
            Fault::new(format!("there is no {}; {}", quoted(text), suggestion(text, &names)))
        })
}

/// Fails unless exactly one of the keys is there.
pub(super) fn exactly_one(keys: &[(&str, bool)]) -> Result<(), Fault> {
    let present: Vec<&str> =
        keys.iter().filter(|(_, is_there)| *is_there).map(|(key, _)| *key).collect();
    let all = || keys.iter().map(|(key, _)| format!("`{key}`")).collect::<Vec<_>>().join(", ");
    match present.as_slice() {
        [_] => Ok(()),
        [] => Err(Fault::new(format!("one of the keys {} is missing", all()))),
        [first, second, ..] => {
            Err(Fault::at(second, format!("`{first}` is there too; give only one of {}", all())))
        }
    }
}

/// The unit vector along `value`; the same bits if its length is already 1.
pub(super) fn unit_vector(key: &str, value: [f32; 3]) -> Result<Vec3, Fault> {
    let vector = Vec3::from_array(value);
    if vector.is_normalized() {
        return Ok(vector);
    }
    vector.as_dvec3().try_normalize().map(DVec3::as_vec3).ok_or_else(|| {
        Fault::at(key, format!("found {value:?}; it must point somewhere, such as [0, 0, 1]"))
    })
}
