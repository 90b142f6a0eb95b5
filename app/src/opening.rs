//! The file of the command line, read while the window opens.

use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

use brilliance_renderer::error::RendererError;
use brilliance_renderer::scene_file::Document;

/// What the window begins with.
#[derive(Debug)]
pub enum Opening {
    /// A document and the file it came from.
    Read {
        /// The document.
        document: Box<Document>,
        /// Its file; none for the default stone.
        file: Option<PathBuf>,
    },
    /// A file that is still being read.
    Reading(Reading),
}

/// A file that a thread reads.
#[derive(Debug)]
pub struct Reading {
    path: PathBuf,
    answer: Receiver<Result<Document, RendererError>>,
}

impl Opening {
    /// Begins to read `path` and waits for at most `patience`, so that the fault of a file that
    /// can't be read is known before there is a window.
    ///
    /// # Errors
    /// As [`Document::open`], if the fault shows in time; or the system gives no thread.
    pub fn begin(path: &Path, patience: Duration) -> Result<Self, RendererError> {
        let reading = Reading::begin(path)?;
        match reading.answer.recv_timeout(patience) {
            Ok(read) => Ok(Self::Read { document: Box::new(read?), file: Some(path.to_owned()) }),
            Err(RecvTimeoutError::Timeout) => Ok(Self::Reading(reading)),
            Err(RecvTimeoutError::Disconnected) => Err(reading.broken()),
        }
    }
}

impl Default for Opening {
    /// The default stone.
    fn default() -> Self {
        Self::Read { document: Box::default(), file: None }
    }
}

impl Reading {
    fn begin(path: &Path) -> Result<Self, RendererError> {
        let (sender, answer) = channel();
        let file = path.to_owned();
        std::thread::Builder::new()
            .name("open".to_owned())
            .spawn(move || {
                // The window may have been closed; then nobody needs the document.
                let _ = sender.send(Document::open(&file));
            })
            .map_err(|fault| RendererError::File {
                path: path.to_owned(),
                message: format!("the system gives no thread to read it with: {fault}"),
            })?;
        Ok(Self { path: path.to_owned(), answer })
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Waits until the file is read.
    ///
    /// # Errors
    /// As [`Document::open`].
    pub fn finish(self) -> Result<Document, RendererError> {
        self.answer.recv().unwrap_or_else(|_| Err(self.broken()))
    }

    fn broken(&self) -> RendererError {
        RendererError::File {
            path: self.path.clone(),
            message: "the program failed while reading it; please report this file".to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_file_is_told_at_once() {
        let fault = Opening::begin(Path::new("/no/such/stone.toml"), Duration::from_mins(1));
        assert!(fault.unwrap_err().to_string().contains("/no/such/stone.toml"));
    }

    #[test]
    fn a_file_that_takes_longer_is_read_to_its_end() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("stone.toml");
        Document::default().save(&path).unwrap();
        let document = match Opening::begin(&path, Duration::ZERO).unwrap() {
            Opening::Read { document, .. } => *document,
            Opening::Reading(reading) => reading.finish().unwrap(),
        };
        assert_eq!(document.still, Document::default().still);
    }
}
