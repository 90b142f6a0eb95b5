//! A fault in a scene file: the key, and what is wrong with it.

use std::fmt::Display;

use serde::de::{Error, Expected, Unexpected};

/// Most characters of a wrong text that an error repeats.
const QUOTED_CHARACTERS: usize = 40;

/// What is wrong, and with which key. The path grows outwards as the fault is passed up.
#[derive(Debug)]
pub(super) struct Fault {
    /// Keys and array indices, innermost first.
    path: Vec<String>,
    message: String,
}

impl Fault {
    pub(super) fn new(message: impl Into<String>) -> Self {
        Self { path: Vec::new(), message: message.into() }
    }

    /// The fault of the value at `key`.
    pub(super) fn at(key: impl Display, message: impl Into<String>) -> Self {
        Self { path: vec![key.to_string()], message: message.into() }
    }

    /// The same fault, seen from the table or array that holds the faulty value at `key`.
    pub(super) fn under(mut self, key: impl Display) -> Self {
        self.path.push(key.to_string());
        self
    }

    /// Keys and array indices from the outermost to the faulty one.
    pub(super) fn path(&self) -> Vec<&str> {
        self.path.iter().rev().map(String::as_str).collect()
    }

    pub(super) fn message(&self) -> &str {
        &self.message
    }
}

/// Adds a key to the path of a fault on its way up.
pub(super) trait Under {
    fn under(self, key: impl Display) -> Self;
}

impl<T> Under for Result<T, Fault> {
    fn under(self, key: impl Display) -> Self {
        self.map_err(|fault| fault.under(key))
    }
}

impl std::error::Error for Fault {}

impl Display for Fault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if self.path.is_empty() {
            f.write_str(&self.message)
        } else {
            write!(f, "`{}`: {}", self.path().join("."), self.message)
        }
    }
}

impl Error for Fault {
    fn custom<T: Display>(message: T) -> Self {
        Self::new(message.to_string())
    }

    fn invalid_type(found: Unexpected, expected: &dyn Expected) -> Self {
        Self::new(format!("found {}, expected {}", in_words(found), wanted(expected)))
    }

    fn invalid_value(found: Unexpected, expected: &dyn Expected) -> Self {
        Self::invalid_type(found, expected)
    }

    fn invalid_length(length: usize, expected: &dyn Expected) -> Self {
        Self::new(format!("found {length} values, expected {}", wanted(expected)))
    }

    fn unknown_field(field: &str, allowed: &'static [&'static str]) -> Self {
        Self::at(field, format!("there is no such key; {}", suggestion(field, allowed)))
    }

    fn missing_field(field: &'static str) -> Self {
        Self::at(field, "this key is missing")
    }
}

/// "did you mean …" for the nearest of `allowed`, and all of them.
pub(super) fn suggestion(found: &str, allowed: &[&str]) -> String {
    let all = allowed.join(", ");
    let nearest = allowed
        .iter()
        .map(|candidate| {
            (edit_distance(&found.to_lowercase(), &candidate.to_lowercase()), candidate)
        })
        .min();
    match nearest {
        Some((distance, candidate)) if distance <= 1 + candidate.chars().count() / 3 => {
            format!("did you mean `{candidate}`? Allowed: {all}")
        }
        _ => format!("allowed: {all}"),
    }
}

/// The text in quotation marks, shortened.
pub(super) fn quoted(text: &str) -> String {
    let mut short: String = text.chars().take(QUOTED_CHARACTERS).collect();
    if short.len() < text.len() {
        short.push('…');
    }
    format!("\"{}\"", short.escape_debug())
}

fn in_words(found: Unexpected) -> String {
    match found {
        Unexpected::Bool(value) => value.to_string(),
        Unexpected::Unsigned(value) => format!("the number {value}"),
        Unexpected::Signed(value) => format!("the number {value}"),
        Unexpected::Float(value) => format!("the number {value:?}"),
        Unexpected::Str(text) => format!("the text {}", quoted(text)),
        Unexpected::Seq => "an array".to_owned(),
        Unexpected::Map => "a table".to_owned(),
        other => other.to_string(),
    }
}

/// What serde expects, without the words of Rust.
fn wanted(expected: &dyn Expected) -> String {
    let text = expected.to_string();
    match text.as_str() {
        "f32" | "f64" => "a number".to_owned(),
        "u32" | "usize" => "a whole number from 0".to_owned(),
        "a boolean" => "true or false".to_owned(),
        "a string" => "a text in quotation marks".to_owned(),
        "a sequence" => "an array".to_owned(),
        _ if text.starts_with("struct ") => "a table of keys".to_owned(),
        _ => text,
    }
}

/// Levenshtein's distance between two keys.
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().take(QUOTED_CHARACTERS).collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, from) in a.chars().take(QUOTED_CHARACTERS).enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, to) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(from != *to);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edit_distances() {
        for (a, b, distance) in
            [("", "", 0), ("n_d", "n_d", 0), ("kitten", "sitting", 3), ("abc", "", 3)]
        {
            assert_eq!(edit_distance(a, b), distance, "{a} {b}");
        }
    }
}
