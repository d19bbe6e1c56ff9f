//! The runs of a sweep, beside its folder and under its name: which there are, and what they hold.

use std::path::{Path, PathBuf};
use std::{fs, io};

use super::{SweepError, SweepFolder};
use crate::run::RunState;
use crate::run::store::{self, StoreError};
use crate::study::points::PointRun;
use crate::visible;

impl SweepFolder {
    /// The directory of the run of a load case, by its place in the list.
    #[must_use]
    pub fn run(&self, index: usize) -> PathBuf {
        let mut name = self.dir().file_name().unwrap_or_default().to_owned();
        name.push(format!("-{:0digits$}", index + 1, digits = self.digits));
        self.dir().with_file_name(name)
    }

    /// Whether each load case has something at the place of its run, by one look at the directory in which they stand: opening it asks a
    /// server for its newest state, which looking at each run would not.
    ///
    /// # Errors
    /// The directory cannot be listed.
    pub fn places_taken(&self, load_cases: usize) -> Result<Vec<bool>, SweepError> {
        let parent = self.dir().parent();
        let parent = parent.filter(|dir| !dir.as_os_str().is_empty());
        let parent = parent.unwrap_or(Path::new("."));
        let wrong = |source: io::Error| SweepError::Io {
            file: parent.to_owned(),
            source,
        };
        let mut taken = vec![false; load_cases];
        for item in fs::read_dir(parent).map_err(wrong)? {
            let name = item.map_err(wrong)?.file_name();
            let number = name.to_str().and_then(|name| name.rsplit_once('-'));
            let number = number.and_then(|(_, number)| number.parse::<usize>().ok());
            let index = number.and_then(|number| number.checked_sub(1));
            // Runs of another sweep may end with the same number.
            if let Some(index) = index.filter(|index| *index < load_cases)
                && self.run(index).file_name() == Some(&name)
            {
                taken[index] = true;
            }
        }
        Ok(taken)
    }

    /// The run of a load case as it is stored, whatever became of it; nothing where there is none.
    ///
    /// # Errors
    /// The place is taken by something else, in words.
    pub(super) fn kept(
        &self,
        index: usize,
        overrides: &[String],
    ) -> Result<Option<PointRun>, String> {
        let dir = self.run(index);
        let taken = |error: StoreError| format!("its run cannot be read: {error}");
        let info = match store::read_info(&dir) {
            Err(StoreError::NotFound(_)) => return Ok(None),
            found => found.map_err(taken)?,
        };
        if info.overrides != overrides {
            let dir = visible::path(&dir);
            return Err(format!("{dir} is another run; move it away"));
        }
        let (info, summary) = match info.state {
            RunState::Done => store::read_results(&dir).map_err(taken)?,
            _ => (info, Vec::new()),
        };
        let dir = Some(dir);
        Ok(Some(PointRun { info, summary, dir }))
    }

    /// The run of a load case that is stored and done: nothing where it is to be computed, a run that was stopped being deleted.
    ///
    /// # Errors
    /// The place is taken by something else, in words.
    pub(super) fn stored(
        &self,
        index: usize,
        overrides: &[String],
    ) -> Result<Option<PointRun>, String> {
        let Some(run) = self.kept(index, overrides)? else {
            return Ok(None);
        };
        if run.info.state == RunState::Done {
            return Ok(Some(run));
        }
        let dir = self.run(index);
        if store::is_locked(&dir) {
            return Err(format!(
                "{} is being computed by another program",
                visible::path(&dir)
            ));
        }
        let deleted = store::delete(&dir);
        deleted.map_err(|error| format!("its run cannot be read: {error}"))?;
        Ok(None)
    }
}
