//! The side of a screen: connects with the process of a job, hears what it says, and asks it to stop.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::Shutdown;
use std::os::unix::net::UnixStream;
use std::time::Duration;

use super::folder::{JobFolder, JobFolderState};
use super::protocol::{FromJob, ToJob, line};
use super::socket;
use super::status::{JobPhase, JobStatus, VERSION};

/// The longest line that is read \[bytes\]: a long record, all at once.
const LONGEST: u64 = 1 << 28;

/// How long a job that hangs may leave messages unread.
const PATIENCE: Duration = Duration::from_secs(2);

/// A connection with a job.
#[derive(Debug)]
pub struct Connection {
    stream: UnixStream,
}

impl Connection {
    /// Connects with the process of a job.
    ///
    /// # Errors
    /// Nobody listens.
    pub fn open(folder: &JobFolder) -> io::Result<Self> {
        let stream = socket::connect(folder)?;
        stream.set_write_timeout(Some(PATIENCE))?;
        Ok(Self { stream })
    }

    /// What the job says, line by line.
    ///
    /// # Errors
    /// The system refuses.
    pub fn said(&self) -> io::Result<Said> {
        let stream = self.stream.try_clone()?;
        Ok(Said {
            reader: BufReader::new(stream),
        })
    }

    /// The same as bytes, to be counted.
    ///
    /// # Errors
    /// The system refuses.
    pub fn bytes(&self) -> io::Result<impl Read + use<>> {
        self.stream.try_clone()
    }

    /// Asks for the status and, where wanted, for what is recorded, from the beginning.
    ///
    /// # Errors
    /// The job has ended.
    pub fn follow(&self, rows: bool) -> io::Result<()> {
        let version = VERSION;
        self.say(&ToJob::Follow { version, rows })
    }

    /// Asks it to stop, with a checkpoint.
    ///
    /// # Errors
    /// The job has ended.
    pub fn cancel(&self) -> io::Result<()> {
        self.say(&ToJob::Cancel)
    }

    fn say(&self, message: &ToJob) -> io::Result<()> {
        (&self.stream).write_all(line(message)?.as_bytes())
    }
}

impl Drop for Connection {
    fn drop(&mut self) {
        // The job goes on; who reads ends.
        let _ = self.say(&ToJob::Detach);
        let _ = self.stream.shutdown(Shutdown::Both);
    }
}

/// What a job says.
#[derive(Debug)]
pub struct Said {
    reader: BufReader<UnixStream>,
}

impl Iterator for Said {
    type Item = FromJob;

    /// The next message; nothing once the job has left, or says what this version does not know.
    fn next(&mut self) -> Option<FromJob> {
        let mut text = String::new();
        let read = (&mut self.reader).take(LONGEST).read_line(&mut text);
        read.ok().filter(|bytes| *bytes > 0)?;
        match serde_json::from_str(&text).ok()? {
            FromJob::Hello(hello) if hello.version != VERSION => None,
            FromJob::OtherVersion(_) => None,
            message => Some(message),
        }
    }
}

/// How often, and how long, a process that has begun this moment is waited for until it listens.
const TRIES: usize = 100;
const PAUSE: Duration = Duration::from_millis(10);

/// Cancels a job, however it is found.
///
/// # Errors
/// It has ended, or does not hear, in words.
pub fn cancel(folder: &JobFolder) -> Result<(), String> {
    for _ in 0..TRIES {
        if Connection::open(folder)
            .and_then(|job| job.cancel())
            .is_ok()
        {
            return Ok(());
        }
        match folder.state() {
            JobFolderState::Ended(status) => {
                return Err(format!("it is {} already", status.phase.word()));
            }
            JobFolderState::Killed(_) => return Err("its process has ended already".to_owned()),
            // It has no socket, or one of another version: the signal says the same.
            JobFolderState::Held if folder.process().is_some_and(|process| process.terminate()) => {
                return Ok(());
            }
            JobFolderState::Held => std::thread::sleep(PAUSE),
            JobFolderState::NotBegun => {
                if withdraw(folder).map_err(|error| error.to_string())? {
                    return Ok(());
                }
            }
        }
    }
    Err("its process does not listen".to_owned())
}

/// Cancels a job that no process has begun; whether none has meanwhile.
fn withdraw(folder: &JobFolder) -> io::Result<bool> {
    let Some(_taken) = folder.take()? else {
        return Ok(false);
    };
    folder.write_status(&JobStatus::new(JobPhase::Cancelled))?;
    Ok(true)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::Hello;

    #[test]
    fn what_another_version_says_is_not_heard() {
        for (version, heard) in [(VERSION, 1), (VERSION + 1, 0)] {
            let dir = tempfile::tempdir().unwrap();
            let path = dir.path().join("7");
            std::fs::create_dir(&path).unwrap();
            let folder = JobFolder::open(&path).unwrap();
            let listener = socket::listen(&folder).unwrap();
            let connection = Connection::open(&folder).unwrap();
            let (mut job, _) = listener.accept().unwrap();
            let hello = FromJob::Hello(Hello {
                version,
                program: "9.9.9".to_owned(),
                job: 7,
            });
            job.write_all(line(&hello).unwrap().as_bytes()).unwrap();
            drop(job);
            assert_eq!(connection.said().unwrap().count(), heard);
        }
    }
}
