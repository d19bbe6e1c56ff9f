//! What other threads say to the screen: messages, and a bell that wakes the waiting loop.

use std::io::{self, Read, Write};
use std::os::fd::{AsFd, BorrowedFd};
use std::os::unix::net::UnixStream;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crossbeam_channel::{Receiver, Sender, unbounded};

use crate::msg::Msg;

/// Where other threads send what happened.
#[derive(Debug, Clone)]
pub struct Outbox {
    sender: Sender<Msg>,
    bell: Arc<Bell>,
}

#[derive(Debug)]
struct Bell {
    rung: AtomicBool,
    socket: UnixStream,
}

impl Outbox {
    /// Sends a message; one that nobody listens to any more is dropped.
    pub fn send(&self, msg: Msg) {
        drop(self.sender.send(msg));
        self.wake();
    }

    /// Wakes the loop without a message.
    pub fn wake(&self) {
        if !self.bell.rung.swap(true, Ordering::SeqCst) {
            // A socket that is full has woken the loop already.
            drop((&self.bell.socket).write(&[1]));
        }
    }
}

/// Where the screen hears it.
#[derive(Debug)]
pub struct Inbox {
    receiver: Receiver<Msg>,
    bell: Arc<Bell>,
    socket: UnixStream,
}

impl Inbox {
    /// Both ends.
    ///
    /// # Errors
    /// The system gives no socket.
    pub fn new() -> io::Result<(Outbox, Self)> {
        let (sender, receiver) = unbounded();
        let (socket, ring) = UnixStream::pair()?;
        socket.set_nonblocking(true)?;
        ring.set_nonblocking(true)?;
        let bell = Arc::new(Bell {
            rung: AtomicBool::new(false),
            socket: ring,
        });
        let outbox = Outbox {
            sender,
            bell: Arc::clone(&bell),
        };
        let inbox = Self {
            receiver,
            bell,
            socket,
        };
        Ok((outbox, inbox))
    }

    /// Readable when something was sent.
    #[must_use]
    pub fn fd(&self) -> BorrowedFd<'_> {
        self.socket.as_fd()
    }

    /// What was sent since the last call.
    pub fn take(&mut self) -> Vec<Msg> {
        let mut buffer = [0_u8; 64];
        while matches!(self.socket.read(&mut buffer), Ok(n) if n > 0) {}
        // Before the messages: one that comes after them rings again.
        self.bell.rung.store(false, Ordering::SeqCst);
        self.receiver.try_iter().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::terminal::wait::wait;
    use std::time::{Duration, Instant};

    #[test]
    fn a_message_from_another_thread_wakes_the_loop_at_once() {
        let (outbox, mut inbox) = Inbox::new().unwrap();
        let (terminal, _other) = UnixStream::pair().unwrap();
        for round in 0..3 {
            let out = outbox.clone();
            let thread = std::thread::spawn(move || {
                for _ in 0..200 {
                    out.send(Msg::ChangedOnDisk);
                }
            });
            let mut heard = 0;
            let began = Instant::now();
            while heard < 200 && began.elapsed() < Duration::from_secs(60) {
                let fds = (terminal.as_fd(), terminal.as_fd(), inbox.fd());
                let woken = wait(fds.0, fds.1, fds.2, Some(Duration::from_secs(60))).unwrap();
                assert!(
                    woken.message,
                    "round {round}: the wait ended without a message"
                );
                heard += inbox.take().len();
            }
            assert_eq!(heard, 200);
            thread.join().unwrap();
            assert!(inbox.take().is_empty());
        }
    }
}
