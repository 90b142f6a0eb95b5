//! The TOML tree of a scene file, with the place of every value.

use std::collections::BTreeMap;

use toml::de::{DeTable, DeValue};

use super::fault::{Fault, quoted};

/// Where a value was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// Byte offset in the text of the file.
    Text(usize),
    /// Index of the override that set it.
    Override(usize),
}

/// A value and its place.
#[derive(Debug)]
pub(super) struct Node {
    pub(super) value: Value,
    pub(super) place: Place,
}

#[derive(Debug)]
pub(super) enum Value {
    Text(String),
    Integer(i64),
    Float(f64),
    Boolean(bool),
    Date(String),
    Array(Vec<Node>),
    Table(BTreeMap<String, Node>),
}

/// A fault found before the tree was complete, with its place where that is known.
pub(super) type Misplaced = (Option<Place>, Fault);

impl Node {
    /// The tree of a whole file.
    pub(super) fn parse(text: &str) -> Result<Self, Misplaced> {
        match DeTable::parse(text) {
            Ok(table) => {
                let root = DeValue::Table(table.into_inner());
                grow(root, &|span: std::ops::Range<usize>| Place::Text(span.start), Place::Text(0))
            }
            Err(error) => {
                let place = error.span().map(|span| Place::Text(span.start));
                Err((place, Fault::new(error.message().trim())))
            }
        }
    }

    /// Applies `key.path=value`, the override number `index`. A value that is not TOML is a text.
    pub(super) fn apply_override(&mut self, index: usize, text: &str) -> Result<(), Fault> {
        let Some((path, value)) = text.split_once('=') else {
            return Err(Fault::new("write it as `key.path=value`, such as `trace.split_count=3`"));
        };
        let place = Place::Override(index);
        let value = value.trim();
        let node = match DeValue::parse(value) {
            Ok(parsed) => {
                grow(parsed.into_inner(), &|_| place, place).map_err(|(_, fault)| fault)?
            }
            Err(_) => Self { value: Value::Text(value.to_owned()), place },
        };
        let keys: Vec<&str> = path.split('.').map(str::trim).collect();
        if keys.iter().any(|key| key.is_empty()) {
            return Err(Fault::new("a key is empty; write it as `key.path=value`"));
        }
        self.insert(&keys, node)
    }

    fn insert(&mut self, keys: &[&str], node: Self) -> Result<(), Fault> {
        let Some((key, inner_keys)) = keys.split_first() else {
            *self = node;
            return Ok(());
        };
        let place = node.place;
        let child = match &mut self.value {
            Value::Table(table) => table
                .entry((*key).to_owned())
                .or_insert_with(|| Self { value: Value::Table(BTreeMap::new()), place }),
            Value::Array(nodes) => {
                let count = nodes.len();
                key.parse().ok().and_then(|index: usize| nodes.get_mut(index)).ok_or_else(|| {
                    Fault::at(key, format!("there are {count} of these, counted from 0"))
                })?
            }
            other => {
                let kind = other.kind();
                return Err(Fault::at(key, format!("there is no such key inside {kind}")));
            }
        };
        // The member is now where the override put it, so that its faults name the override.
        if inner_keys.is_empty() {
            child.place = place;
        }
        child.insert(inner_keys, node).map_err(|fault| fault.under(key))
    }

    /// The place of the value at `path`, or of the innermost value on the way that exists.
    pub(super) fn place(&self, path: &[&str]) -> Place {
        let child = path.split_first().and_then(|(key, rest)| {
            let node = match &self.value {
                Value::Table(table) => table.get(*key)?,
                Value::Array(nodes) => nodes.get(key.parse::<usize>().ok()?)?,
                _ => return None,
            };
            Some(node.place(rest))
        });
        child.unwrap_or(self.place)
    }
}

impl Value {
    /// What kind of value it is, for the user.
    fn kind(&self) -> String {
        match self {
            Self::Text(text) => format!("the text {}", quoted(text)),
            Self::Integer(value) => format!("the number {value}"),
            Self::Float(value) => format!("the number {value:?}"),
            Self::Boolean(value) => value.to_string(),
            Self::Date(date) => format!("the date {date}"),
            Self::Array(_) => "an array".to_owned(),
            Self::Table(_) => "a table".to_owned(),
        }
    }
}

/// Builds the tree; `place_of` turns a span of the parser into a place. The parser bounds the
/// depth.
fn grow(
    value: DeValue<'_>,
    place_of: &impl Fn(std::ops::Range<usize>) -> Place,
    place: Place,
) -> Result<Node, Misplaced> {
    let fault = |message: String| (Some(place), Fault::new(message));
    let value = match value {
        DeValue::String(text) => Value::Text(text.into_owned()),
        DeValue::Boolean(value) => Value::Boolean(value),
        DeValue::Datetime(date) => Value::Date(date.to_string()),
        DeValue::Integer(integer) => i64::from_str_radix(integer.as_str(), integer.radix())
            .map(Value::Integer)
            .map_err(|_| fault(format!("{integer} is too large a number")))?,
        DeValue::Float(float) => match float.as_str().parse::<f64>() {
            Ok(number) if number.is_finite() => Value::Float(number),
            _ => return Err(fault(format!("found {float}, expected a finite number"))),
        },
        DeValue::Array(array) => Value::Array(
            array
                .into_iter()
                .map(|item| {
                    let place = place_of(item.span());
                    grow(item.into_inner(), place_of, place)
                })
                .collect::<Result<_, _>>()?,
        ),
        DeValue::Table(table) => Value::Table(
            table
                .into_iter()
                .map(|(key, item)| {
                    let place = place_of(key.span());
                    let node = grow(item.into_inner(), place_of, place)?;
                    Ok((key.into_inner().into_owned(), node))
                })
                .collect::<Result<_, Misplaced>>()?,
        ),
    };
    Ok(Node { value, place })
}

/// Line and column of a byte offset, counted from 1; the column in characters.
pub(super) fn line_and_column(text: &str, offset: usize) -> (usize, usize) {
    let offset = (0..=offset.min(text.len())).rev().find(|&at| text.is_char_boundary(at));
    let before = &text[..offset.unwrap_or(0)];
    let line = before.matches('\n').count() + 1;
    let start = before.rfind('\n').map_or(0, |newline| newline + 1);
    (line, before[start..].chars().count() + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_columns_count_from_one_in_characters() {
        let text = "a = 1\nµm = 2\n";
        assert_eq!(line_and_column(text, 0), (1, 1));
        assert_eq!(line_and_column(text, 6), (2, 1));
        assert_eq!(line_and_column(text, 7), (2, 1), "inside a character");
        assert_eq!(line_and_column(text, 8), (2, 2));
        assert_eq!(line_and_column(text, 999), (3, 1));
    }

    #[test]
    fn places_point_at_keys_and_overrides() {
        let mut tree = Node::parse("a = 1\n[[b]]\nc = 2\n[[b]]\nc = 3\n").unwrap();
        tree.apply_override(7, "b.1.c = 4").unwrap();
        assert_eq!(tree.place(&["b", "0", "c"]), Place::Text(12));
        assert_eq!(tree.place(&["b", "0", "missing"]), tree.place(&["b", "0"]));
        assert_eq!(tree.place(&["b", "1", "c"]), Place::Override(7));
    }
}
