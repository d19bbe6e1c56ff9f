//! The script of the array, and words that a shell takes as they are.

use std::fmt::Write as _;
use std::path::Path;

use super::{Division, SCRIPT, Unfit};
use crate::run::VERSION;
use crate::seal::Digest;
use crate::visible::{self, quoted};

/// What the script says.
#[derive(Debug, Clone, Copy)]
pub struct Script<'a> {
    /// This program.
    pub program: &'a Path,
    /// The folder of the sweep, absolute.
    pub dir: &'a Path,
    /// Name of the job.
    pub job_name: &'a str,
    /// Which task computes which load cases.
    pub division: Division,
    /// Cores of a task.
    pub cores: u16,
    /// Further options of the program, such as limits that are lifted.
    pub options: &'a [String],
    /// Options of `sbatch`, for whoever submits by hand.
    pub slurm_options: &'a [String],
}

impl Script<'_> {
    /// The text, for the shell of POSIX.
    ///
    /// # Errors
    /// The program or the folder have a name that cannot stand in it.
    pub fn text(&self) -> Result<String, Unfit> {
        let remedy = "Give it another name.";
        let program = quoted(fit("the program", self.program, remedy)?);
        let dir = quoted(fit("the folder", self.dir, remedy)?);
        let Self {
            division, cores, ..
        } = self;
        let Division {
            load_cases,
            by_task,
        } = *division;
        let (tasks, last) = (division.tasks(), division.tasks().saturating_sub(1));
        let by_hand: String = self
            .slurm_options
            .iter()
            .map(|word| format!("{} ", quoted(word)))
            .collect();
        let options: String = self
            .options
            .iter()
            .map(|word| format!(" {}", quoted(word)))
            .collect();
        let mut text = String::from("#!/bin/sh\n");
        for line in [
            &*format!(
                "The load cases of a sweep as a job array of Slurm, written by seacable {VERSION} for `seacable sweep --slurm`."
            ),
            &format!(
                "{load_cases} load cases in {tasks} tasks, numbered from 0, of {by_task} each. What is stored is not computed again."
            ),
            "It may be submitted by hand, all of it or some tasks:",
            &format!("  cd {dir} && sbatch {by_hand}--array=0-{last} {SCRIPT}"),
            "`seacable sweep --resume FOLDER --slurm` then watches it and writes the table of results.",
        ] {
            // A string refuses nothing.
            let _ = writeln!(text, "# {line}");
        }
        let _ = write!(
            text,
            "#SBATCH --job-name={name}\n\
             #SBATCH --nodes=1 --ntasks=1 --cpus-per-task={cores}\n\
             #SBATCH --output=tasks/%A_%a.log\n\
             task=${{SLURM_ARRAY_TASK_ID:?is set by sbatch --array}}\n\
             first=$((task * {by_task} + 1))\n\
             last=$((first + {by_task} - 1))\n\
             exec {program} sweep --resume {dir} --part \"$first..$last\" --jobs {cores}{options}\n",
            name = self.job_name,
        );
        Ok(text)
    }
}

fn fit<'a>(what: &'static str, path: &'a Path, remedy: &'static str) -> Result<&'a str, Unfit> {
    let text = path
        .to_str()
        .filter(|text| !text.contains(visible::is_invisible));
    text.ok_or_else(|| Unfit::Invisible {
        what,
        word: visible::path(path),
        remedy,
    })
}

/// A name of the job by which it is found in the queue again: that of the folder, and a digest of its place.
#[must_use]
pub fn job_name(dir: &Path) -> String {
    const LONGEST: usize = 40;
    let name = dir.file_name().unwrap_or_default().to_string_lossy();
    let clean = |c: char| match c.is_ascii_alphanumeric() || "-_.".contains(c) {
        true => c,
        false => '-',
    };
    let name: String = name.chars().take(LONGEST).map(clean).collect();
    let digest = Digest::of_bytes(dir.as_os_str().as_encoded_bytes()).text();
    format!("seacable-{name}-{}", &digest[..8])
}

#[cfg(test)]
mod tests {
    use std::process::Command;

    use super::*;

    fn script<'a>(program: &'a Path, dir: &'a Path, options: &'a [String]) -> Script<'a> {
        Script {
            program,
            dir,
            job_name: "seacable-s-01234567",
            division: Division {
                load_cases: 11,
                by_task: 4,
            },
            cores: 2,
            options,
            slurm_options: options,
        }
    }

    #[test]
    fn the_script_is_a_text_that_a_user_reads() {
        let options = ["--limit-points=20000".to_owned()];
        let script = script(
            Path::new("/opt/seacable"),
            Path::new("/home/ann/runs/s"),
            &options,
        );
        let text = script.text().unwrap();
        for line in [
            "#!/bin/sh\n",
            "\n# 11 load cases in 3 tasks, numbered from 0, of 4 each. ",
            "\n#   cd /home/ann/runs/s && sbatch --limit-points=20000 --array=0-2 array.sh\n",
            "\n#SBATCH --job-name=seacable-s-01234567\n",
            "\n#SBATCH --nodes=1 --ntasks=1 --cpus-per-task=2\n",
            "\nexec /opt/seacable sweep --resume /home/ann/runs/s --part \"$first..$last\" --jobs 2 --limit-points=20000\n",
        ] {
            assert!(text.contains(line), "{line}: {text}");
        }
    }

    #[test]
    fn a_shell_runs_it_whatever_the_names() {
        let place = tempfile::tempdir().unwrap();
        let names = [
            "it's \"a\" $(touch x) `y` \\ *; & # %s",
            "-rf",
            " ",
            "é~!{a,b}",
        ];
        for name in names {
            let folder = place.path().join(name);
            let options = [format!("--x={name}")];
            let text = script(Path::new("printf"), &folder, &options)
                .text()
                .unwrap();
            let said = Command::new("sh")
                .args([
                    "-c",
                    &text.replace("exec printf sweep", "exec printf '%s|' sweep"),
                ])
                .env("SLURM_ARRAY_TASK_ID", "2")
                .current_dir(place.path())
                .output()
                .unwrap();
            let words = format!(
                "sweep|--resume|{}|--part|9..12|--jobs|2|{}|",
                folder.display(),
                options[0]
            );
            assert_eq!(String::from_utf8(said.stdout).unwrap(), words);
            assert_eq!(String::from_utf8(said.stderr).unwrap(), "");
            // Nothing of a name was run.
            assert_eq!(place.path().read_dir().unwrap().count(), 0);
        }
    }

    #[test]
    fn without_an_array_it_computes_nothing() {
        let text = script(Path::new("true"), Path::new("/s"), &[])
            .text()
            .unwrap();
        let done = Command::new("sh")
            .args(["-c", &text])
            .env_remove("SLURM_ARRAY_TASK_ID")
            .output()
            .unwrap();
        assert!(!done.status.success());
        assert!(
            String::from_utf8(done.stderr)
                .unwrap()
                .contains("is set by sbatch --array")
        );
    }

    #[test]
    fn names_that_begin_a_line_are_refused() {
        for name in ["/a\nb", "/a\rb", "/a\u{202e}b", "/a\u{7f}"] {
            let error = script(Path::new("/p"), Path::new(name), &[])
                .text()
                .unwrap_err();
            assert!(error.to_string().contains("such as line feeds"), "{error}");
        }
    }

    #[test]
    fn the_name_of_the_job_tells_folders_of_the_same_name_apart() {
        let [one, other] = ["/a/my sweep", "/b/my sweep"].map(|dir| job_name(Path::new(dir)));
        assert!(
            one.starts_with("seacable-my-sweep-") && one != other,
            "{one} {other}"
        );
        assert_eq!(one, job_name(Path::new("/a/my sweep")));
        assert!(job_name(Path::new(&format!("/{}", "x".repeat(200)))).len() < 64);
    }
}
