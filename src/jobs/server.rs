//! The side of a job: lets any number of screens follow it, and takes what they ask for. A screen that does not read is disconnected.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::Shutdown;
use std::os::unix::net::{UnixListener, UnixStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Duration;

use super::board::{Board, News};
use super::protocol::{FromJob, Hello, Rows, ToJob, line};
use super::status::VERSION;

/// How many may follow at a time.
const MOST: usize = 32;

/// How long a screen may leave messages unread.
const PATIENCE: Duration = Duration::from_secs(5);

/// The longest line that a screen may say \[bytes\].
const LONGEST: u64 = 1 << 12;

/// What those who follow a job share.
#[derive(Debug, Clone)]
pub(super) struct Server {
    pub(super) job: u64,
    pub(super) board: Arc<Board>,
    pub(super) cancel: Arc<AtomicBool>,
    pub(super) count: Arc<AtomicUsize>,
}

impl Server {
    /// Serves everyone who connects, on threads of its own, until the process ends.
    ///
    /// # Errors
    /// The system gives no thread.
    pub(super) fn start(self, listener: UnixListener) -> io::Result<()> {
        let accept = move || {
            for stream in listener.incoming().flatten() {
                // One who cannot be served tries again.
                let _ = self.clone().welcome(stream);
            }
        };
        thread("socket", accept)
    }

    fn welcome(self, stream: UnixStream) -> io::Result<()> {
        if self.count.fetch_add(1, Ordering::SeqCst) >= MOST {
            self.count.fetch_sub(1, Ordering::SeqCst);
            return Ok(());
        }
        stream.set_write_timeout(Some(PATIENCE))?;
        let heard = stream.try_clone()?;
        let follower = self.board.join();
        let listener = self.clone();
        thread("follower", move || {
            // However it ends, the other end notices and tries again.
            let _ = self.tell(&stream, follower);
            let _ = stream.shutdown(Shutdown::Both);
            self.board.leave(follower);
            self.count.fetch_sub(1, Ordering::SeqCst);
        })?;
        thread("listener", move || {
            listener.listen(&heard, follower);
            listener.board.leave(follower);
        })
    }

    /// Tells a follower what it has not heard, until it leaves or the job ends.
    fn tell(&self, mut stream: &UnixStream, follower: u64) -> io::Result<()> {
        let hello = FromJob::Hello(Hello {
            version: VERSION,
            program: crate::run::VERSION.to_owned(),
            job: self.job,
        });
        stream.write_all(line(&hello)?.as_bytes())?;
        while let Some(news) = self.board.news(follower) {
            let is_last = news.has_ended;
            for message in messages(news) {
                stream.write_all(line(&message)?.as_bytes())?;
            }
            if is_last {
                break;
            }
        }
        Ok(())
    }

    /// Does what a follower asks for, until it leaves.
    fn listen(&self, stream: &UnixStream, follower: u64) {
        let mut reader = BufReader::new(stream);
        loop {
            let mut said = String::new();
            match (&mut reader).take(LONGEST).read_line(&mut said) {
                Ok(0) | Err(_) => return,
                Ok(_) => {}
            }
            match serde_json::from_str(&said) {
                Ok(ToJob::Follow { version, rows }) if version == VERSION => {
                    self.board.want_rows(follower, rows);
                }
                Ok(ToJob::Cancel) => self.cancel.store(true, Ordering::SeqCst),
                Ok(ToJob::Follow { .. }) | Err(_) => {
                    // A line that is not understood comes from another version too.
                    let other = line(&FromJob::OtherVersion(VERSION)).unwrap_or_default();
                    let _ = (&mut &*stream).write_all(other.as_bytes());
                    return;
                }
                Ok(ToJob::Detach) => return,
            }
        }
    }
}

fn messages(news: News) -> Vec<FromJob> {
    let channels = news.channels.map(FromJob::Channels);
    let rows = news
        .rows
        .map(|record| FromJob::Rows(Rows::of_record(&record)));
    let status = news.status.map(|status| match news.has_ended {
        true => FromJob::Ended(status),
        false => FromJob::Status(status),
    });
    channels.into_iter().chain(rows).chain(status).collect()
}

fn thread(name: &str, work: impl FnOnce() + Send + 'static) -> io::Result<()> {
    let named = std::thread::Builder::new().name(name.to_owned());
    named.spawn(work).map(drop)
}
