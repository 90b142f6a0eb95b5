//! `KEY=VALUE`: a change to a value of the scene.

use std::path::Path;
use std::str::FromStr;

use brilliance_renderer::error::RendererError;
use brilliance_renderer::scene_file::Document;

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
}

/// The document of a file with these changes.
///
/// # Errors
/// Those of [`Document::open_with`].
pub(super) fn open_with(
    scene: &Path,
    assignments: &[Assignment],
) -> Result<Document, RendererError> {
    let overrides: Vec<String> =
        assignments.iter().map(|assignment| assignment.text.clone()).collect();
    Document::open_with(scene, &overrides)
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
        assert_eq!(assignment.text, "a.b = \"c=d\"");
    }

    #[test]
    fn a_key_is_needed() {
        assert!("".parse::<Assignment>().is_err());
        assert!("key".parse::<Assignment>().is_err());
        assert!(" =value".parse::<Assignment>().is_err());
    }
}
