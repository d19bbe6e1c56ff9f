//! Where files are, what runs the programs, and what they cost.

use std::fs;
use std::path::{self, Path, PathBuf};
use std::process::Command;

const REPEATS: &str = "7";

/// A Python package of another program.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Peer {
    MoorDyn,
    MoorPy,
    CableDyn,
}

impl Peer {
    const ALL: [Self; 3] = [Self::MoorDyn, Self::MoorPy, Self::CableDyn];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::MoorDyn => "MoorDyn",
            Self::MoorPy => "MoorPy",
            Self::CableDyn => "CableDyn",
        }
    }

    fn package(self) -> String {
        self.name().to_lowercase()
    }
}

/// What a command takes \[s\].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cost {
    /// CPU time of the whole process.
    pub(crate) process: f64,
    /// CPU time of the calls inside it, where it says so.
    pub(crate) inside: Option<f64>,
}

impl Cost {
    /// The time that counts against another program.
    pub(crate) fn least(self) -> f64 {
        self.inside.unwrap_or(self.process)
    }
}

pub(crate) struct Place {
    folder: tempfile::TempDir,
    python: PathBuf,
    program: PathBuf,
    /// Packages that are installed, with their versions.
    versions: Vec<(Peer, String)>,
}

impl Place {
    pub(crate) fn new(python: &str) -> Self {
        let memory = Path::new("/dev/shm");
        let folder = if memory.is_dir() {
            tempfile::tempdir_in(memory)
        } else {
            tempfile::tempdir()
        };
        // Commands are run in the folder.
        let python = match python.contains('/') {
            true => path::absolute(python).unwrap(),
            false => PathBuf::from(python),
        };
        let program = std::env::var("SEACABLE_BINARY");
        let program = program.unwrap_or_else(|_| env!("CARGO_BIN_EXE_seacable").to_owned());
        let mut place = Self {
            folder: folder.unwrap(),
            python,
            program: path::absolute(program).unwrap(),
            versions: Vec::new(),
        };
        let mut asked = place.script("versions.py");
        let said = output(asked.args(Peer::ALL.map(Peer::package)));
        for peer in Peer::ALL {
            let package = peer.package();
            let mut rows = said.lines().filter_map(|row| row.split_once(' '));
            if let Some((_, version)) = rows.find(|(name, _)| *name == package) {
                place.versions.push((peer, version.to_owned()));
            }
        }
        place
    }

    /// Prints programs with their versions, the profile and the processor.
    pub(crate) fn introduce(&self) {
        let about = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        let model = about.lines().find(|line| line.starts_with("model name"));
        let processor = model.and_then(|line| line.split(':').nth(1));
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        println!(
            "{}, {cores} cores; {}, {}",
            processor.unwrap_or("an unknown processor").trim(),
            output(Command::new(&self.program).arg("--version")).trim(),
            match std::env::var_os("SEACABLE_BINARY") {
                Some(_) => "a build named by SEACABLE_BINARY",
                None => "profile bench, which is release",
            }
        );
        for peer in Peer::ALL {
            let found = self.versions.iter().find(|(other, _)| *other == peer);
            match found {
                Some((_, version)) => println!("{} {version}", peer.name()),
                None => println!("{} is left out: no package {}", peer.name(), peer.package()),
            }
        }
    }

    pub(crate) fn has(&self, peer: Peer) -> bool {
        self.versions.iter().any(|(other, _)| *other == peer)
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub(crate) fn write(&self, name: &str, text: &str) -> PathBuf {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, text).unwrap();
        path
    }

    /// The command that runs a script of this folder.
    pub(crate) fn script(&self, name: &str) -> Command {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/peers");
        let mut command = Command::new(&self.python);
        command
            .current_dir(self.folder.path())
            .arg(folder.join(name));
        command
    }

    /// The command that runs a file here.
    pub(crate) fn run(&self, file: &Path) -> Command {
        let mut command = Command::new(&self.program);
        command.current_dir(self.folder.path()).arg("run").arg(file);
        command
    }

    /// What a command prints, which is run once for all scenes that ask for it by this name.
    pub(crate) fn kept(&self, name: &str, command: &mut Command) -> String {
        let path = self.path(name);
        if let Ok(text) = fs::read_to_string(&path) {
            return text;
        }
        let text = output(command);
        fs::write(&path, &text).unwrap();
        text
    }

    /// What a command costs, the least of repeats.
    pub(crate) fn cost(&self, command: &Command) -> Cost {
        self.cost_of(command, REPEATS)
    }

    /// What a command costs that takes too long to be repeated.
    pub(crate) fn cost_once(&self, command: &Command) -> Cost {
        self.cost_of(command, "1")
    }

    fn cost_of(&self, command: &Command, repeats: &str) -> Cost {
        let mut timed = self.script("cost.py");
        timed.arg(repeats).arg(command.get_program());
        let said = output(timed.args(command.get_args()));
        let times: Vec<f64> = said
            .split_whitespace()
            .map(|word| word.parse().unwrap())
            .collect();
        Cost {
            process: times[0],
            inside: Some(times[1]).filter(|time| time.is_finite()),
        }
    }
}

pub(crate) fn output(command: &mut Command) -> String {
    let done = command.output().unwrap();
    let messages = String::from_utf8_lossy(&done.stderr);
    assert!(done.status.success(), "{command:?}: {messages}");
    String::from_utf8(done.stdout).unwrap()
}
