//! Samples that are read a second time once the first reading is complete: in memory while they are few, beyond that in a
//! file that has no name and goes with the process.

use std::io::{self, BufReader, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::PathBuf;

use crate::files::disk::NewFile;

/// Samples that are held in memory: one megabyte.
const HELD: usize = 1 << 16;

/// Samples (time \[s\], value), in the order in which they came.
#[derive(Debug, Default)]
pub(super) struct SpillBuffer {
    file: Option<NewFile>,
    held: Vec<(f64, f64)>,
}

impl SpillBuffer {
    /// Adds a sample.
    ///
    /// # Errors
    /// There is no room on disk.
    pub(super) fn push(&mut self, time: f64, value: f64) -> io::Result<()> {
        if self.held.len() == HELD {
            self.spill()?;
        }
        self.held.push((time, value));
        Ok(())
    }

    /// Reads all samples again.
    ///
    /// # Errors
    /// The disk fails.
    pub(super) fn each(&self, mut take: impl FnMut(f64, f64)) -> io::Result<()> {
        if let Some(file) = &self.file {
            let mut whole = file.open();
            whole.seek(SeekFrom::Start(0))?;
            let mut reader = BufReader::with_capacity(1 << 16, whole);
            let mut pair = [0_u8; 16];
            for _ in 0..file.open().metadata()?.len() / 16 {
                reader.read_exact(&mut pair)?;
                let number = |at: usize| {
                    let mut bytes = [0_u8; 8];
                    bytes.copy_from_slice(&pair[at..at + 8]);
                    f64::from_le_bytes(bytes)
                };
                take(number(0), number(8));
            }
        }
        self.held
            .iter()
            .for_each(|(time, value)| take(*time, *value));
        Ok(())
    }

    /// Appends the samples in memory to the file.
    fn spill(&mut self) -> io::Result<()> {
        let file = match &mut self.file {
            Some(file) => file,
            none => none.insert(nameless()?),
        };
        file.open().seek(SeekFrom::End(0))?;
        let mut writer = BufWriter::new(file);
        for (time, value) in self.held.drain(..) {
            writer.write_all(&time.to_le_bytes())?;
            writer.write_all(&value.to_le_bytes())?;
        }
        writer.flush()
    }
}

/// A file that nobody else sees. `/var/tmp` is on disk where `/tmp` may be in memory.
fn nameless() -> io::Result<NewFile> {
    let chosen = std::env::var_os("TMPDIR").map(PathBuf::from);
    let usual = [chosen, Some("/var/tmp".into()), Some(std::env::temp_dir())];
    let mut made = Err(io::Error::from(io::ErrorKind::NotFound));
    for dir in usual.iter().flatten() {
        made = NewFile::nameless_in(dir);
        if made.is_ok() {
            break;
        }
    }
    made
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_back_what_was_written_to_the_same_bits_more_than_once() {
        let mut samples = SpillBuffer::default();
        let count = 3 * HELD + 17;
        let sample = |i: usize| (i as f64 / 3.0, -(i as f64).sqrt());
        for i in 0..count {
            let (t, v) = sample(i);
            samples.push(t, v).unwrap();
            assert!(samples.held.len() <= HELD);
        }
        for _ in 0..2 {
            let mut i = 0;
            samples
                .each(|t, v| {
                    assert_eq!((t, v), sample(i));
                    i += 1;
                })
                .unwrap();
            assert_eq!(i, count);
        }
    }
}
