//! The socket of a job, in its folder, which nobody else can enter.
//!
//! The name of a socket has room for 108 bytes. Where the path is longer, the folder is opened, and the socket named by way of the open
//! directory.

use std::io;
use std::os::fd::{AsRawFd, OwnedFd};
use std::os::unix::net::{UnixListener, UnixStream};
use std::path::{Path, PathBuf};

use rustix::fs::{Mode, OFlags, open};

use super::folder::JobFolder;
use super::jobs_dir::check_private;

/// The longest path of a socket that every system takes \[bytes\].
const LONGEST: usize = 100;

/// A name of a socket that is short enough, and what has to stay open meanwhile.
struct ShortName {
    path: PathBuf,
    _folder: Option<OwnedFd>,
}

impl ShortName {
    fn of_path(path: &Path) -> io::Result<Self> {
        let (Some(dir), Some(name)) = (path.parent(), path.file_name()) else {
            return Err(io::ErrorKind::InvalidInput.into());
        };
        if path.as_os_str().len() <= LONGEST {
            return Ok(Self {
                path: path.to_owned(),
                _folder: None,
            });
        }
        let flags = OFlags::DIRECTORY | OFlags::NOFOLLOW | OFlags::CLOEXEC | OFlags::RDONLY;
        let folder = open(dir, flags, Mode::empty())?;
        let open = PathBuf::from(format!("/proc/self/fd/{}", folder.as_raw_fd()));
        Ok(Self {
            path: open.join(name),
            _folder: Some(folder),
        })
    }
}

/// Listens for those who follow a job.
///
/// # Errors
/// The system gives no socket there.
pub(super) fn listen(folder: &JobFolder) -> io::Result<UnixListener> {
    let socket = folder.socket();
    // One of an earlier process of the job.
    let _ = crate::files::disk::remove_file(&socket);
    UnixListener::bind(ShortName::of_path(&socket)?.path.as_path())
}

/// Connects with the process of a job.
///
/// # Errors
/// Nobody listens, or the folder is not the user's own.
pub(super) fn connect(folder: &JobFolder) -> io::Result<UnixStream> {
    check_private(&folder.path).map_err(io::Error::other)?;
    let name = ShortName::of_path(&folder.socket())?;
    UnixStream::connect(&name.path)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{Read, Write};

    #[test]
    fn a_socket_is_reached_however_long_its_path_is() {
        for depth in [1, 20] {
            let dir = tempfile::tempdir().unwrap();
            let path = (0..depth).fold(dir.path().to_owned(), |dir, _| dir.join("a-long-name"));
            let path = path.join("7");
            std::fs::create_dir_all(&path).unwrap();
            let folder = JobFolder::open(&path).unwrap();
            let listener = listen(&folder).unwrap();
            let mut one = connect(&folder).unwrap();
            let (mut other, _) = listener.accept().unwrap();
            one.write_all(b"x").unwrap();
            let mut heard = [0_u8; 1];
            other.read_exact(&mut heard).unwrap();
            assert_eq!(&heard, b"x");
            // A second process of the same job takes its place.
            drop(listener);
            listen(&folder).unwrap();
        }
    }
}
