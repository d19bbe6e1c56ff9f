//! What the folder of a sweep keeps of its arrays: `slurm.toml`.

use std::io;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use serde::{Deserialize, Serialize};

use super::{Division, RECORD, SCRIPT, Script, check_option, job_name};
use crate::files::shallow::shallow;
use crate::files::{Existing, WriteTarget, read};
use crate::run::{VERSION, store};
use crate::study::sweep::SweepError;
use crate::visible;

/// An array that was submitted.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Submission {
    /// Number of its job.
    pub job: u64,
    /// When, as RFC 3339 in UTC.
    pub submitted: String,
    /// The tasks, as `sbatch --array` takes them.
    pub tasks: String,
}

impl Submission {
    /// One of this moment.
    #[must_use]
    pub fn now(job: u64, tasks: String) -> Self {
        let submitted = store::rfc3339(SystemTime::now());
        Self {
            job,
            submitted,
            tasks,
        }
    }
}

/// How the load cases are shared out, and what was submitted.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SlurmRecord {
    /// Version of the program.
    pub version: String,
    /// Name of the jobs.
    pub job_name: String,
    /// Load cases in all.
    pub load_cases: usize,
    /// Load cases of a task.
    pub cases_per_task: usize,
    /// Cores of a task.
    pub cores_per_task: u16,
    /// Options that `sbatch` gets as they are.
    pub options: Vec<String>,
    /// Whether the results were gathered since the last submission: no array is left.
    pub gathered: bool,
    /// The arrays, oldest first.
    #[serde(default)]
    pub submissions: Vec<Submission>,
}

impl SlurmRecord {
    /// That of a sweep whose folder is at this absolute place, before anything is submitted.
    #[must_use]
    pub fn new(dir: &Path, division: Division, cores: u16, options: Vec<String>) -> Self {
        Self {
            version: VERSION.to_owned(),
            job_name: job_name(dir),
            load_cases: division.load_cases,
            cases_per_task: division.by_task,
            cores_per_task: cores,
            options,
            gathered: false,
            submissions: Vec::new(),
        }
    }

    /// Which task computes which load cases.
    #[must_use]
    pub fn division(&self) -> Division {
        Division {
            load_cases: self.load_cases,
            by_task: self.cases_per_task,
        }
    }

    /// Reads a text.
    ///
    /// # Errors
    /// What is wrong with it, in words.
    fn parse(text: &str, load_cases: usize) -> Result<Self, String> {
        let record: Self = toml::from_str(shallow(text)).map_err(|error| error.to_string())?;
        let wrong = |what: String| Err(format!("it has {what}"));
        if record.load_cases != load_cases {
            return wrong(format!(
                "load_cases = {}, the sweep {load_cases}",
                record.load_cases
            ));
        }
        if !(1..=load_cases).contains(&record.cases_per_task) || record.cores_per_task == 0 {
            return wrong(
                "no load cases or no cores by task, or more load cases than there are".to_owned(),
            );
        }
        let name = record.job_name.bytes();
        if !name
            .clone()
            .all(|b| b.is_ascii_alphanumeric() || b"-_.".contains(&b))
            || name.len() == 0
        {
            return wrong("a job_name that is none".to_owned());
        }
        match record
            .options
            .iter()
            .find_map(|word| check_option(word).err())
        {
            Some(error) => wrong(format!("an option that sbatch cannot have: {error}")),
            None => Ok(record),
        }
    }
}

/// The record of a sweep as it stands in its folder.
#[derive(Debug)]
pub struct SlurmFile {
    file: PathBuf,
    /// The text as it was read or written last.
    text: Option<String>,
}

impl SlurmFile {
    /// Reads it; nothing where the sweep has none.
    ///
    /// # Errors
    /// It cannot be read or understood.
    pub fn of_folder(
        dir: &Path,
        load_cases: usize,
    ) -> Result<(Self, Option<SlurmRecord>), SweepError> {
        let file = dir.join(RECORD);
        let text = match read::run_text(&file) {
            Ok(text) => Some(text),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(source) => return Err(SweepError::Io { file, source }),
        };
        let record = text
            .as_deref()
            .map(|text| SlurmRecord::parse(text, load_cases));
        let record = record.transpose().map_err(|reason| SweepError::Damaged {
            file: file.clone(),
            reason: format!(
                "{}. Undo the change; or, once `squeue --me` shows no array of this sweep, remove the file",
                reason.trim_end()
            ),
        })?;
        Ok((Self { file, text }, record))
    }

    /// Writes it, unless another program has since.
    ///
    /// # Errors
    /// Another has, or the system refuses.
    pub fn write(&mut self, record: &SlurmRecord) -> Result<(), SweepError> {
        let text = toml::to_string(record).map_err(|error| SweepError::Damaged {
            file: self.file.clone(),
            reason: error.to_string(),
        })?;
        let text = visible::toml(&text).into_owned();
        let existing = self.text.as_deref();
        let target = WriteTarget {
            existing: existing.map_or(Existing::Keep, Existing::ReplaceIfUnchanged),
            ..WriteTarget::new(&self.file)
        };
        target.write(text.as_bytes())?;
        self.text = Some(text);
        Ok(())
    }

    /// Writes the script beside it.
    ///
    /// # Errors
    /// The system refuses, or a name cannot stand in the script.
    pub fn write_script(&self, script: &Script<'_>) -> Result<(), SweepError> {
        let text = script.text().map_err(SweepError::Script)?;
        let file = self.file.with_file_name(SCRIPT);
        Ok(WriteTarget::replacing(&file).write(text.as_bytes())?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record() -> SlurmRecord {
        let options = vec![
            "--partition=long".to_owned(),
            "--comment=it's \"mine\"".to_owned(),
        ];
        let mut record = SlurmRecord::new(Path::new("/runs/s"), Division::usual(200), 2, options);
        record
            .submissions
            .push(Submission::now(12, "0-199".to_owned()));
        record
    }

    #[test]
    fn it_is_read_back_and_not_written_over_what_another_wrote() {
        let dir = tempfile::tempdir().unwrap();
        let (mut file, none) = SlurmFile::of_folder(dir.path(), 200).unwrap();
        assert_eq!(none, None);
        let mut record = record();
        file.write(&record).unwrap();
        let (mut other, read) = SlurmFile::of_folder(dir.path(), 200).unwrap();
        assert_eq!(read.as_ref(), Some(&record));
        record.submissions.push(Submission::now(13, "7".to_owned()));
        file.write(&record).unwrap();
        let error = other.write(&record).unwrap_err().to_string();
        assert!(error.contains("has changed on disk"), "{error}");
    }

    #[test]
    fn what_was_changed_by_hand_is_refused_with_the_remedy() {
        let dir = tempfile::tempdir().unwrap();
        let text = toml::to_string(&record()).unwrap();
        for (from, to, why) in [
            (
                "load_cases = 200",
                "load_cases = 100",
                "load_cases = 100, the sweep 200",
            ),
            ("cases_per_task = 1", "cases_per_task = 0", "no load cases"),
            (
                "cases_per_task = 1",
                "cases_per_task = 1000",
                "more load cases",
            ),
            (
                "--partition=long",
                "-p long",
                "an option that sbatch cannot have",
            ),
            ("job_name = \"sea", "job_name = \"a b", "job_name"),
            ("job = 12", "job = -12", "job"),
            ("gathered = false", "gathered = false\nmine = 1", "mine"),
        ] {
            let changed = text.replace(from, to);
            assert_ne!(changed, text, "{from}");
            std::fs::write(dir.path().join(RECORD), changed).unwrap();
            let error = SlurmFile::of_folder(dir.path(), 200)
                .unwrap_err()
                .to_string();
            assert!(
                error.contains(why) && error.contains("remove the file"),
                "{to}: {error}"
            );
        }
    }
}
