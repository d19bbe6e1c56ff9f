//! A file that grows while a run is computed: what a full disk refuses stays in memory, and can be written again. It may be made later than
//! its first rows.

use std::io::{self, Write};
use std::path::PathBuf;

use super::StoreError;
use super::table::CsvWriter;
use crate::files::disk::NewFile;
use crate::seal::Digest;

/// Bytes that may wait in memory.
const WAITING: usize = 1 << 16;

/// A file that grows while the run is computed.
#[derive(Debug)]
pub(super) struct GrowingFile {
    path: PathBuf,
    /// Nothing until it is made.
    file: Option<NewFile>,
    /// What is not written yet.
    waiting: Vec<u8>,
    /// That of the file with what waits.
    digest: Digest,
}

impl GrowingFile {
    /// A file to be made, with the names of its columns.
    pub(super) fn with_head(path: PathBuf, head: CsvWriter) -> Result<Self, StoreError> {
        let head = head.bytes()?;
        let mut stream = Self {
            path,
            file: None,
            waiting: Vec::with_capacity(2 * WAITING),
            digest: Digest::default(),
        };
        stream.push(&head);
        Ok(stream)
    }

    /// Makes the file.
    pub(super) fn create(&mut self) -> Result<(), StoreError> {
        let made = NewFile::create(&self.path).map_err(StoreError::io("Writing", &self.path))?;
        self.file = Some(made);
        Ok(())
    }

    /// What is not written yet: of a file that is not made, all of it.
    pub(super) fn waiting(&self) -> &[u8] {
        &self.waiting
    }

    /// Adds bytes, to be written when they are flushed.
    pub(super) fn push(&mut self, bytes: &[u8]) {
        self.waiting.extend_from_slice(bytes);
        self.digest.update(bytes);
    }

    /// Whether as much waits as may.
    pub(super) fn is_due(&self) -> bool {
        self.waiting.len() >= WAITING
    }

    /// Writes what waits, once the file is made. What could not be written goes on waiting.
    pub(super) fn flush(&mut self) -> Result<(), StoreError> {
        let Some(file) = &mut self.file else {
            return Ok(());
        };
        let mut written = 0;
        let result = loop {
            if written == self.waiting.len() {
                break Ok(());
            }
            match file.write(&self.waiting[written..]) {
                Ok(0) => break Err(io::ErrorKind::WriteZero.into()),
                Ok(more) => written += more,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => break Err(error),
            }
        };
        self.waiting.drain(..written);
        self.check(result)
    }

    /// Makes what is written survive a power cut.
    pub(super) fn sync(&self) -> Result<(), StoreError> {
        self.check(self.file.as_ref().map_or(Ok(()), NewFile::sync))
    }

    /// The digest of all that was added.
    pub(super) fn digest(&self) -> Digest {
        self.digest.clone()
    }

    fn check(&self, result: io::Result<()>) -> Result<(), StoreError> {
        result.map_err(|error| StoreError::io("Writing", &self.path)(error))
    }
}

impl Drop for GrowingFile {
    fn drop(&mut self) {
        // A run that is given up keeps what it can.
        let _ = self.flush();
    }
}
