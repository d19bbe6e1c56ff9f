//! A cluster of Slurm for one test: an authentication server, a controller and two nodes of one processor each, all on this machine and as
//! this user, with settings, logs and state in a directory of the test.

use std::net::TcpListener;
use std::os::unix::fs::{DirBuilderExt, OpenOptionsExt};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, kill_process};

use crate::work::installed;

/// Far beyond what the servers need to be ready on a busy machine.
const PATIENCE: Duration = Duration::from_secs(60);

/// The servers; they end with the test, with all that they started.
pub(crate) struct Slurm {
    dir: PathBuf,
    munged: Child,
    controller: Child,
    nodes: [Option<Child>; 2],
}

impl Slurm {
    /// Servers with their files in a new folder of this directory, ready for jobs.
    pub(crate) fn start(place: &Path) -> Self {
        let dir = place.join("cluster");
        std::fs::DirBuilder::new().mode(0o700).create(&dir).unwrap();
        std::fs::create_dir(dir.join("state")).unwrap();
        let munged = authentication(&dir);
        // Another process may take a free port before its server does.
        let mut slurm = Self {
            munged,
            controller: Command::new("true").spawn().unwrap(),
            nodes: [None, None],
            dir,
        };
        for _ in 0..5 {
            slurm.settings();
            slurm.controller.wait().unwrap();
            slurm.controller = slurm.server("slurmctld", &["-D", "-c"]);
            slurm.nodes = [0, 1].map(|node| Some(slurm.node(node)));
            if slurm.is_ready() {
                return slurm;
            }
            slurm.end_nodes();
            drop(slurm.controller.kill());
        }
        let log = |name: &str| std::fs::read_to_string(slurm.dir.join(name)).unwrap_or_default();
        panic!(
            "Slurm does not start:\n{}\n{}",
            log("slurmctld.log"),
            log("slurmd-n1.log")
        );
    }

    /// The settings that Slurm's commands need, for the environment.
    pub(crate) fn settings_file(&self) -> PathBuf {
        self.dir.join("slurm.conf")
    }

    /// Whether the program computes on a node (1 or 2).
    pub(crate) fn is_at_work(&self, node: usize) -> bool {
        !self.tasks(Some(node)).is_empty()
    }

    /// A power cut of a node: its server, its watchers of jobs and the jobs end without a word.
    pub(crate) fn kill_node(&mut self, node: usize) {
        let mut server = self.nodes[node - 1].take().unwrap();
        server.kill().unwrap();
        server.wait().unwrap();
        let log = self.dir.join(format!("slurmd-n{node}.log"));
        self.end(|process| writes_to(process, &log));
        let tasks = self.tasks(Some(node));
        self.end(|process| tasks.contains(&process));
    }

    /// Starts the server of a node again.
    pub(crate) fn start_node(&mut self, node: usize) {
        self.nodes[node - 1] = Some(self.node(node - 1));
    }

    fn settings(&self) {
        let dir = self.dir.display();
        let host = rustix::system::uname()
            .nodename()
            .to_string_lossy()
            .into_owned();
        let host = host.split('.').next().unwrap().to_owned();
        let user = Command::new("id").arg("-un").output().unwrap().stdout;
        let user = String::from_utf8(user).unwrap().trim().to_owned();
        let ports: [u16; 3] = free_ports();
        let text = format!(
            "ClusterName=test\nSlurmctldHost={host}(127.0.0.1)\nSlurmctldPort={}\n\
             SlurmUser={user}\nSlurmdUser={user}\n\
             AuthType=auth/munge\nAuthInfo=socket={dir}/munge.socket\nCredType=cred/munge\n\
             StateSaveLocation={dir}/state\nSlurmdSpoolDir={dir}/spool-%n\n\
             SlurmctldPidFile={dir}/slurmctld.pid\nSlurmdPidFile={dir}/slurmd-%n.pid\n\
             SlurmctldLogFile={dir}/slurmctld.log\nSlurmdLogFile={dir}/slurmd-%n.log\n\
             ProctrackType=proctrack/linuxproc\nTaskPlugin=task/none\nSwitchType=switch/none\nMpiDefault=none\n\
             AccountingStorageType=accounting_storage/none\nJobAcctGatherType=jobacct_gather/none\n\
             SchedulerType=sched/builtin\nSelectType=select/cons_res\nSelectTypeParameters=CR_CPU\n\
             ReturnToService=2\nSlurmdTimeout=5\nSlurmctldTimeout=5\nKillWait=2\nJobRequeue=0\n\
             SlurmdParameters=config_overrides\n\
             NodeName=n1 NodeHostname={host} NodeAddr=127.0.0.1 Port={} CPUs=1\n\
             NodeName=n2 NodeHostname={host} NodeAddr=127.0.0.1 Port={} CPUs=1\n\
             PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP\n",
            ports[0], ports[1], ports[2],
        );
        std::fs::write(self.settings_file(), text).unwrap();
    }

    fn server(&self, name: &str, words: &[&str]) -> Child {
        Command::new(installed(name))
            .args(words)
            .env("SLURM_CONF", self.settings_file())
            .current_dir(&self.dir)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap()
    }

    fn node(&self, place: usize) -> Child {
        self.server("slurmd", &["-D", "-N", &format!("n{}", place + 1)])
    }

    /// Whether both nodes come up; not where a server ends instead.
    fn is_ready(&mut self) -> bool {
        let end = Instant::now() + PATIENCE;
        while Instant::now() < end && self.controller.try_wait().unwrap().is_none() {
            let said = Command::new(installed("sinfo"))
                .args(["--noheader", "--Node", "--format=%T"])
                .env("SLURM_CONF", self.settings_file())
                .output()
                .unwrap();
            let states = String::from_utf8_lossy(&said.stdout).into_owned();
            if states.split_whitespace().eq(["idle", "idle"]) {
                return true;
            }
            std::thread::sleep(Duration::from_millis(100));
        }
        false
    }

    /// Processes of jobs on a node, or on any.
    fn tasks(&self, node: Option<usize>) -> Vec<i32> {
        let settings = format!("SLURM_CONF={}", self.settings_file().display());
        let name = node.map(|node| format!("SLURMD_NODENAME=n{node}"));
        let is_task = |process: &i32| {
            let words = std::fs::read(format!("/proc/{process}/environ")).unwrap_or_default();
            let has = |word: &str| {
                words
                    .split(|b| *b == 0)
                    .any(|known| known == word.as_bytes())
            };
            has(&settings)
                && name
                    .as_ref()
                    .map_or_else(|| has_node(&words), |name| has(name))
        };
        processes().filter(is_task).collect()
    }

    /// Ends processes of the cluster.
    fn end(&self, which: impl Fn(i32) -> bool) {
        for process in processes().filter(|process| which(*process)) {
            // It may have ended by itself.
            let _ = kill_process(Pid::from_raw(process).unwrap(), Signal::KILL);
        }
    }

    fn end_nodes(&mut self) {
        for server in self.nodes.iter_mut().filter_map(Option::take) {
            let mut server = server;
            drop(server.kill());
            drop(server.wait());
        }
        for node in [1, 2] {
            let log = self.dir.join(format!("slurmd-n{node}.log"));
            self.end(|process| writes_to(process, &log));
        }
        let tasks = self.tasks(None);
        self.end(|process| tasks.contains(&process));
    }
}

impl Drop for Slurm {
    fn drop(&mut self) {
        drop(self.controller.kill());
        drop(self.controller.wait());
        self.end_nodes();
        drop(self.munged.kill());
        drop(self.munged.wait());
    }
}

/// The server by which Slurm's programs know each other, with a key of its own.
fn authentication(dir: &Path) -> Child {
    let key: Vec<u8> = (0..1024_u32).map(|n| (n * 167 % 251) as u8).collect();
    let mut options = std::fs::OpenOptions::new();
    let mut file = options
        .write(true)
        .create_new(true)
        .mode(0o400)
        .open(dir.join("munge.key"))
        .unwrap();
    std::io::Write::write_all(&mut file, &key).unwrap();
    let option = |name: &str, file: &str| format!("--{name}={}", dir.join(file).display());
    let mut server = Command::new(installed("munged"))
        .args(["--foreground", "--force", "--num-threads=2"])
        .args([
            option("key-file", "munge.key"),
            option("socket", "munge.socket"),
        ])
        .args([
            option("pid-file", "munge.pid"),
            option("seed-file", "munge.seed"),
        ])
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(std::fs::File::create(dir.join("munged.log")).unwrap())
        .spawn()
        .unwrap();
    let end = Instant::now() + PATIENCE;
    while !dir.join("munge.socket").exists() {
        let ended = server.try_wait().unwrap();
        if ended.is_some() || Instant::now() > end {
            drop(server.kill());
            drop(server.wait());
            let log = std::fs::read_to_string(dir.join("munged.log")).unwrap_or_default();
            panic!("munged does not start:\n{log}");
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    server
}

/// Ports that are free at the same time.
fn free_ports<const N: usize>() -> [u16; N] {
    let held = [(); N].map(|()| TcpListener::bind(("127.0.0.1", 0)).unwrap());
    held.each_ref()
        .map(|listener| listener.local_addr().unwrap().port())
}

fn processes() -> impl Iterator<Item = i32> {
    let all = std::fs::read_dir("/proc").unwrap().flatten();
    all.filter_map(|item| item.file_name().to_str()?.parse().ok())
}

/// Whether an environment is that of a job.
fn has_node(words: &[u8]) -> bool {
    words
        .split(|b| *b == 0)
        .any(|word| word.starts_with(b"SLURMD_NODENAME="))
}

/// Whether a process has a file open: the watchers of jobs write to the log of their node.
fn writes_to(process: i32, file: &Path) -> bool {
    let open = std::fs::read_dir(format!("/proc/{process}/fd"));
    let mut open = open.into_iter().flatten().flatten();
    open.any(|item| std::fs::read_link(item.path()).is_ok_and(|path| path == file))
}
