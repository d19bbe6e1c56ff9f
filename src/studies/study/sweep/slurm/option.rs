//! Options that `sbatch` gets as they are, and what cannot stand in a script.

use crate::visible;

/// Options of `sbatch` that the program gives itself.
const OWN: [&str; 6] = ["array", "chdir", "job-name", "parsable", "wait", "wrap"];

/// Options of `sbatch` that say where, when and with what a job runs, and nothing else: those of a file do no harm.
const HARMLESS: [&str; 24] = [
    "account",
    "begin",
    "comment",
    "constraint",
    "deadline",
    "exclude",
    "exclusive",
    "gres",
    "hint",
    "hold",
    "licenses",
    "mem",
    "mem-per-cpu",
    "nice",
    "no-requeue",
    "nodelist",
    "partition",
    "qos",
    "requeue",
    "reservation",
    "threads-per-core",
    "time",
    "time-min",
    "tmp",
];

/// Why something cannot stand in a script.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Unfit {
    /// It has characters that a script is not readable with.
    #[error(
        "{what} {word} has bytes that are no text, or characters that show nothing, such as line feeds, which cannot stand in a script. {remedy}"
    )]
    Invisible {
        /// What it is.
        what: &'static str,
        /// As it can be shown.
        word: String,
        /// What would be right.
        remedy: &'static str,
    },
    /// It is no long option.
    #[error(
        "--slurm-option {0} is no option of sbatch in its long form with its value behind `=`; write --slurm-option=--partition=long"
    )]
    NoOption(String),
    /// It is an option that a file says, and may not.
    #[error(
        "slurm.toml says {0}, which is taken from the command line only: give all --slurm-option again."
    )]
    OfFile(String),
    /// It is an option that the program sets.
    #[error("--slurm-option {0}: this program gives --{1} to sbatch itself; leave it out")]
    Own(String, &'static str),
}

/// Checks an option for `sbatch`.
///
/// # Errors
/// It is none, or one that this program gives itself.
pub fn check_option(word: &str) -> Result<(), Unfit> {
    let shown = || visible::line(word).into_owned();
    if word.contains(visible::is_invisible) {
        return Err(Unfit::Invisible {
            what: "--slurm-option",
            word: shown(),
            remedy: "Leave them out.",
        });
    }
    let name = word.strip_prefix("--").filter(|rest| !rest.is_empty());
    let name = name.ok_or_else(|| Unfit::NoOption(shown()))?;
    let name = name.split('=').next().unwrap_or_default();
    if !name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'-') || name.is_empty() {
        return Err(Unfit::NoOption(shown()));
    }
    match OWN.iter().find(|own| **own == name) {
        Some(own) => Err(Unfit::Own(shown(), own)),
        None => Ok(()),
    }
}

/// Checks options that nobody but the file of a sweep says, which may come from elsewhere.
///
/// # Errors
/// One that could do more than say where, when and with what a job runs.
pub fn check_of_file(options: &[String]) -> Result<(), Unfit> {
    let name = |word: &str| {
        word.trim_start_matches("--")
            .split('=')
            .next()
            .map(str::to_owned)
    };
    let harmless = |word: &&String| name(word).is_some_and(|name| HARMLESS.contains(&&*name));
    match options.iter().find(|word| !harmless(word)) {
        Some(word) => Err(Unfit::OfFile(visible::line(word).into_owned())),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_are_long_ones_that_this_program_does_not_give() {
        for right in [
            "--partition=long",
            "--exclusive",
            "--mem-per-cpu=2G",
            "--comment=it's mine",
        ] {
            assert_eq!(check_option(right), Ok(()), "{right}");
        }
        for (wrong, why) in [
            ("-p long", "long form"),
            ("--partition long", "long form"),
            ("long", "long form"),
            ("--", "long form"),
            ("--=x", "long form"),
            ("--comment=a\nb", "line feeds"),
            ("--array=1-2", "--array to sbatch itself"),
            ("--job-name=x", "--job-name to sbatch itself"),
            ("--wait", "--wait to sbatch itself"),
        ] {
            let error = check_option(wrong).unwrap_err().to_string();
            assert!(error.contains(why), "{wrong}: {error}");
        }
    }

    #[test]
    fn a_file_says_where_and_when_and_writes_nowhere() {
        let words = |words: &[&str]| {
            words
                .iter()
                .map(|word| (*word).to_owned())
                .collect::<Vec<String>>()
        };
        assert_eq!(
            check_of_file(&words(&["--partition=long", "--exclusive"])),
            Ok(())
        );
        for wrong in [
            "--output=/home/ann/.profile",
            "--out=x",
            "--part=x",
            "--bbf=x",
            "--uid=0",
        ] {
            let error = check_of_file(&words(&["--mem=1G", wrong]))
                .unwrap_err()
                .to_string();
            assert!(error.contains(wrong) && error.contains("again"), "{error}");
        }
    }
}
