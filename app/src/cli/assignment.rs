//! `KEY=VALUE`: a change to a value of the scene.

use std::str::FromStr;

/// A key of the scene file and its new value, as the user wrote them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Assignment {
    text: String,
    key_length: usize,
}

impl Assignment {
    /// The key, without blanks around it.
    pub(super) fn key(&self) -> &str {
        self.text[..self.key_length].trim()
    }

    /// The whole, `key=value`.
    pub(super) fn text(&self) -> &str {
        &self.text
    }
}

impl FromStr for Assignment {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.find('=') {
            Some(key_length) if !text[..key_length].trim().is_empty() => {
                Ok(Self { text: text.to_owned(), key_length })
            }
            _ => Err("give a key, an equals sign and a value, such as trace.max_depth=16".into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_key_ends_at_the_first_equals_sign() {
        let assignment: Assignment = "a.b = \"c=d\"".parse().unwrap();
        assert_eq!(assignment.key(), "a.b");
        assert_eq!(assignment.text(), "a.b = \"c=d\"");
    }

    #[test]
    fn a_key_is_needed() {
        assert!("".parse::<Assignment>().is_err());
        assert!("key".parse::<Assignment>().is_err());
        assert!(" =value".parse::<Assignment>().is_err());
    }
}
