//! Room on the disk that is held for the end of a run: given up when the disk is full, it holds a checkpoint and the last files.

use std::path::{Path, PathBuf};

use crate::files::disk::NewFile;

/// What is held at first, and the least that is of any use.
const AT_FIRST: usize = 256 << 10;
const LEAST: usize = 16 << 10;
/// Bytes of a checkpoint by node of a line, at most.
const BY_NODE: usize = 1 << 10;
/// Files of the size of a checkpoint that are written at the end: it is beside the one before until it takes its name, and the rows and
/// tables of the end come to another two.
const TIMES: usize = 4;

/// Room in a directory, held by a file without a name: the system frees it however the program ends.
#[derive(Debug)]
pub(super) struct Reserve {
    dir: PathBuf,
    file: Option<NewFile>,
    bytes: usize,
    given_up: bool,
}

impl Reserve {
    /// As much as is to be had.
    pub(super) fn in_folder(dir: &Path) -> Self {
        let mut reserve = Self {
            dir: dir.to_owned(),
            file: None,
            bytes: 0,
            given_up: false,
        };
        let mut bytes = AT_FIRST;
        while bytes >= LEAST && !reserve.grow(bytes) {
            bytes /= 2;
        }
        reserve
    }

    /// None, for a run that is not on the disk yet.
    pub(super) fn none() -> Self {
        Self {
            dir: PathBuf::new(),
            file: None,
            bytes: 0,
            given_up: true,
        }
    }

    /// Holds room for the end of a run with a checkpoint of so many bytes.
    pub(super) fn hold(&mut self, checkpoint: usize) {
        let bytes = TIMES * checkpoint;
        if bytes > self.bytes {
            self.grow(bytes + bytes / 2);
        }
    }

    /// The same for a line of so many nodes.
    pub(super) fn hold_checkpoint_of(&mut self, nodes: usize) {
        self.hold(BY_NODE * nodes);
    }

    /// Gives the room up; whether there was any.
    pub(super) fn release(&mut self) -> bool {
        self.given_up = true;
        self.file.take().is_some()
    }

    fn grow(&mut self, bytes: usize) -> bool {
        if self.given_up {
            return false;
        }
        if self.file.is_none() {
            self.file = NewFile::nameless_in(&self.dir).ok();
        }
        let Some(file) = &self.file else { return false };
        let held = file.hold(bytes as u64).is_ok();
        if held {
            self.bytes = bytes;
        } else if self.bytes == 0 {
            // What was had in part is of no use.
            self.file = None;
        }
        held
    }
}
