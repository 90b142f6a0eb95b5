//! Files that are read whole, and files that appear whole or not at all.

use std::fs::File;
use std::io::{self, BufWriter, ErrorKind, Read};
use std::path::Path;

use tempfile::NamedTempFile;

use crate::error::RendererError;

/// Reads a regular file of at most `max_bytes` bytes.
///
/// # Errors
/// There is no such file, it is no regular one, it is larger or can't be read.
pub fn read(path: &Path, max_bytes: u64) -> io::Result<Vec<u8>> {
    // Asked before opening: a pipe would block and a device never end.
    let metadata = std::fs::metadata(path)?;
    if !metadata.is_file() {
        return Err(io::Error::other("not a regular file"));
    }
    if metadata.len() > max_bytes {
        return Err(io::Error::other(format!(
            "{} bytes are too many; at most {max_bytes} are read, so make the file smaller",
            metadata.len()
        )));
    }
    let mut bytes = Vec::with_capacity(metadata.len() as usize);
    File::open(path)?.take(max_bytes).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Writes a file under a temporary name in the folder of `path` and renames it to `path` when it is
/// complete. If `write` fails, an old file stays as it was and nothing else is left behind.
///
/// # Errors
/// The file can't be written.
pub fn replace(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<&mut File>) -> io::Result<()>,
) -> Result<(), RendererError> {
    write_and_rename(path, write).map_err(|source| in_words(path, source))
}

/// Finds out whether [`replace`] can begin at `path`, to be told before long work rather than
/// after it. Leaves nothing behind.
///
/// # Errors
/// No file can be created there.
pub fn check(path: &Path) -> Result<(), RendererError> {
    create(path).map(drop).map_err(|source| in_words(path, source))
}

/// The folder in which `path` names a file; `.` for a bare name.
fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

fn write_and_rename(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<&mut File>) -> io::Result<()>,
) -> io::Result<()> {
    let mut temporary = create(path)?;
    let mut buffered = BufWriter::new(temporary.as_file_mut());
    write(&mut buffered)?;
    buffered.into_inner()?.sync_all()?;
    temporary.persist(path)?;
    Ok(())
}

/// A temporary file that can become `path`.
fn create(path: &Path) -> io::Result<NamedTempFile> {
    if path.is_dir() {
        return Err(ErrorKind::IsADirectory.into());
    }
    let mut builder = tempfile::Builder::new();
    builder.prefix(".brilliance-").suffix(".part");
    #[cfg(unix)]
    {
        // As for any other new file: the process's umask narrows it.
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(folder_of(path))
}

/// The error with its remedy, where there is one.
fn in_words(path: &Path, source: io::Error) -> RendererError {
    let folder = folder_of(path).display();
    let message = match source.kind() {
        ErrorKind::NotFound => {
            format!("the folder {folder} does not exist; create it or choose another")
        }
        ErrorKind::NotADirectory => format!("{folder} is not a folder; choose another"),
        ErrorKind::IsADirectory => "is a folder; choose the name of a file".into(),
        ErrorKind::PermissionDenied => {
            format!("no permission to write in the folder {folder}; choose another")
        }
        ErrorKind::ReadOnlyFilesystem => {
            format!("the folder {folder} can't be written to; choose another")
        }
        ErrorKind::StorageFull => "the disk is full; make room or choose another folder".into(),
        _ => return RendererError::Io { path: path.into(), source },
    };
    RendererError::File { path: path.into(), message }
}
