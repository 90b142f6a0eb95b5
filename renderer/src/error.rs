//! What can go wrong, in words for the user.

/// An error of the renderer. Its text names the thing and the remedy.
#[derive(Debug, thiserror::Error)]
pub enum RendererError {
    /// The job was cancelled.
    #[error("cancelled")]
    Cancelled,
    /// A file could not be read or written.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file.
        path: std::path::PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// A graphics device can't do what was asked, or has failed; the processor can take over.
    #[error("{0}")]
    Graphics(String),
    /// A value that makes no sense.
    #[error("{0}")]
    Invalid(String),
    /// A file with something wrong in it.
    #[error("{}: {message}", path.display())]
    File {
        /// The file.
        path: std::path::PathBuf,
        /// The place in the file, the fault and the remedy.
        message: String,
    },
}
