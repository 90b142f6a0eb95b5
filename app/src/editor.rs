//! The document being edited: what it was, what it is, and where it is kept.

use std::path::{Path, PathBuf};

use brilliance_renderer::scene_file::Document;

use crate::history::History;

/// A document with its history and its file.
#[derive(Debug)]
pub struct Editor {
    /// As it is now.
    pub document: Document,
    /// As it was opened or last saved.
    baseline: Document,
    history: History<Document>,
    /// The scene file it is saved to.
    file: Option<PathBuf>,
    /// Where what was opened or saved last is.
    folder: Option<PathBuf>,
    name: String,
}

const UNTITLED: &str = "Untitled";

impl Editor {
    /// Begins with `document`, which came from `file`. Only a scene file is written back to; a
    /// mesh is not.
    pub fn new(document: Document, file: Option<&Path>) -> Self {
        // A file of the command line may be relative; what is shown and suggested is not.
        let file = file.map(|path| std::path::absolute(path).unwrap_or(path.to_owned()));
        let name = file.as_deref().and_then(Path::file_name);
        let name = name.map_or(UNTITLED.to_owned(), |name| name.to_string_lossy().into_owned());
        Self {
            baseline: document.clone(),
            history: History::new(document.clone()),
            document,
            folder: file.as_deref().and_then(Path::parent).map(Path::to_owned),
            file: file.filter(|path| is_scene_file(path)),
            name,
        }
    }

    /// A document without a file, called `name`.
    pub fn named(document: Document, name: &str) -> Self {
        Self { name: name.to_owned(), ..Self::new(document, None) }
    }

    /// As it was opened or last saved.
    pub fn baseline(&self) -> &Document {
        &self.baseline
    }

    /// The scene file it is saved to, if it has one.
    pub fn file(&self) -> Option<&Path> {
        self.file.as_deref()
    }

    /// Where what was opened or saved last is, if it is in a file.
    pub fn folder(&self) -> Option<&Path> {
        self.folder.as_deref()
    }

    /// Its name, with the ending of its file.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// True if it differs from what is in its file.
    pub fn edited(&self) -> bool {
        self.document != self.baseline
    }

    /// The name of the file with a mark if it is edited.
    pub fn title(&self) -> String {
        let mark = if self.edited() { "\u{2022} " } else { "" };
        format!("{mark}{}", self.name)
    }

    /// A name without its ending, for files made from it.
    pub fn stem(&self) -> &str {
        Path::new(&self.name).file_stem().and_then(|stem| stem.to_str()).unwrap_or(UNTITLED)
    }

    /// Notes that `saved` is now in `file`.
    pub fn mark_saved(&mut self, saved: Document, file: PathBuf) {
        self.name = file.file_name().unwrap_or(file.as_os_str()).to_string_lossy().into_owned();
        self.baseline = saved;
        self.folder = file.parent().map(Path::to_owned);
        self.file = Some(file);
    }

    /// Notes the document as it is at `seconds`, for undo.
    pub fn record(&mut self, seconds: f64, pointer_down: bool) {
        self.history.record(&self.document, seconds, pointer_down);
    }

    /// Takes the last step back.
    pub fn undo(&mut self) {
        if let Some(document) = self.history.undo() {
            self.document = document;
        }
    }

    /// Makes the undone step again.
    pub fn redo(&mut self) {
        if let Some(document) = self.history.redo() {
            self.document = document;
        }
    }

    /// Goes back to what was opened or last saved; can be undone.
    pub fn reset(&mut self) {
        self.document = self.baseline.clone();
    }

    /// True if there is a step to take back, and one to make again.
    pub fn has_past_and_future(&self) -> (bool, bool) {
        (self.history.has_past(), self.history.has_future())
    }
}

fn is_scene_file(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mesh_is_never_saved_over() {
        let editor = Editor::new(Document::default(), Some(Path::new("/gems/heart.glb")));
        assert_eq!(editor.file(), None);
        assert_eq!(editor.title(), "heart.glb");
        assert_eq!(editor.stem(), "heart");
    }

    #[test]
    fn edits_are_marked_until_saved_or_taken_back() {
        let mut editor = Editor::new(Document::default(), Some(Path::new("a.toml")));
        assert_eq!(editor.title(), "a.toml");
        editor.document.trace.bins = 32;
        editor.record(1.0, false);
        assert!(editor.edited());
        assert_eq!(editor.title(), "\u{2022} a.toml");
        editor.undo();
        assert!(!editor.edited());
        editor.redo();
        editor.mark_saved(editor.document.clone(), PathBuf::from("b.toml"));
        assert_eq!(editor.title(), "b.toml");
    }
}
